#pragma once

#include <components/arm_interface/arm_payloads.h>

#include <numbers>
#include <string>

namespace arm {

/// The default rest posture: elbow up, hand down, no joint near a limit.
inline constexpr JointVector kReadyPosture{0.0,
                                           -std::numbers::pi / 4,
                                           0.0,
                                           -3 * std::numbers::pi / 4,
                                           0.0,
                                           std::numbers::pi / 2,
                                           std::numbers::pi / 4};  // rad

inline constexpr double kLargestAngle = 1e3;    // rad; a larger angle is a mistake
inline constexpr double kMinLimit = 1e-3;       // rad/s, rad/s^2; minimum for a joint that moves
inline constexpr double kGreatestLimit = 1e3;   // rad/s, rad/s^2
inline constexpr double kMinBandwidth = 1e-3;   // rad/s
inline constexpr double kMaxBandwidth = 500.0;  // rad/s; stiffer joints need a step below 1 ms
inline constexpr double kMaxNoise = 1.0;        // rad

/// The configuration of a simulated arm. The defaults are the limits of a Franka Emika Panda:
/// https://frankaemika.github.io/docs/control_parameters.html
struct ArmConfiguration {
  JointVector home = kReadyPosture;  ///< rad; the posture at the start
  JointVector lower{-2.8973, -1.7628, -2.8973, -3.0718, -2.8973, -0.0175, -2.8973};  ///< rad
  JointVector upper{2.8973, 1.7628, 2.8973, -0.0698, 2.8973, 3.7525, 2.8973};        ///< rad
  JointVector velocity{2.175, 2.175, 2.175, 2.175, 2.61, 2.61, 2.61};  ///< maximum, rad/s
  JointVector acceleration{15.0, 7.5, 10.0, 12.5, 15.0, 20.0, 20.0};   ///< maximum, rad/s^2
  double bandwidth = 50.0;  ///< rad/s; how stiffly a joint follows its reference
  double noise = 0.0;       ///< rad; standard deviation of a measured position
};

/// Throws ConfigurationError if the configuration is invalid. The text names `component`, the field
/// and the mistake.
void RequireValid(const ArmConfiguration& configuration, const std::string& component);

}  // namespace arm

template <>
inline constexpr auto tendon::kPayload<arm::ArmConfiguration> = tendon::Describe(
    "arm.ArmConfiguration",
    tendon::Field{"home", &arm::ArmConfiguration::home, "rad"}
        .Within(-arm::kLargestAngle, arm::kLargestAngle)
        .Help("Initial position of each joint, between lower and upper."),
    tendon::Field{"lower", &arm::ArmConfiguration::lower, "rad"}
        .Within(-arm::kLargestAngle, arm::kLargestAngle)
        .Help("Lower limit of each joint, below upper."),
    tendon::Field{"upper", &arm::ArmConfiguration::upper, "rad"}.Within(-arm::kLargestAngle,
                                                                        arm::kLargestAngle),
    tendon::Field{"velocity", &arm::ArmConfiguration::velocity, "rad/s"}
        .Within(arm::kMinLimit, arm::kGreatestLimit)
        .Help("Maximum of each joint."),
    tendon::Field{"acceleration", &arm::ArmConfiguration::acceleration, "rad/s^2"}
        .Within(arm::kMinLimit, arm::kGreatestLimit)
        .Help("Maximum of each joint."),
    tendon::Field{"bandwidth", &arm::ArmConfiguration::bandwidth, "rad/s"}
        .Within(arm::kMinBandwidth, arm::kMaxBandwidth)
        .Help("Stiffness with which a joint follows its reference."),
    tendon::Field{"noise", &arm::ArmConfiguration::noise, "rad"}
        .Within(0.0, arm::kMaxNoise)
        .Help("Standard deviation of a measured position."));
