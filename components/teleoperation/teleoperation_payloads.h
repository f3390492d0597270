#pragma once

#include <components/arm_interface/arm_payloads.h>

namespace arm {

inline constexpr double kShortestTour = 4.0;    // s
inline constexpr double kLongestTour = 3600.0;  // s
inline constexpr double kMaxAmplitude = 3.0;

/// The configuration of the tour.
struct TeleoperationConfiguration {
  double period = 12.0;    ///< s for one round
  double amplitude = 1.0;  ///< amplitude of the joints; above 1, they can reach their limits
};

/// The desired posture of the arm.
struct Target {
  JointVector position{};  ///< rad
};

/// The error with which the arm follows the target.
struct Tracking {
  JointVector error{};  ///< rad; target minus actual
  double worst = 0.0;   ///< rad; the largest absolute error
};

}  // namespace arm

template <>
inline constexpr auto tendon::kPayload<arm::TeleoperationConfiguration> = tendon::Describe(
    "arm.TeleoperationConfiguration",
    tendon::Field{"period", &arm::TeleoperationConfiguration::period, "s"}
        .Within(arm::kShortestTour, arm::kLongestTour)
        .Help("Duration of one round."),
    tendon::Field{"amplitude", &arm::TeleoperationConfiguration::amplitude}
        .Within(0, arm::kMaxAmplitude)
        .Help("Amplitude of the joints; above 1, the joints can reach their limits."));

template <>
inline constexpr auto tendon::kPayload<arm::Target> =
    tendon::Describe("arm.Target", tendon::Field{"position", &arm::Target::position, "rad"});

template <>
inline constexpr auto tendon::kPayload<arm::Tracking> =
    tendon::Describe("arm.Tracking", tendon::Field{"error", &arm::Tracking::error, "rad"},
                     tendon::Field{"worst", &arm::Tracking::worst, "rad"});
