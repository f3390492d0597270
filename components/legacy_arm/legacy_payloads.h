#pragma once

#include <tendon/payload/payload.h>

#include <array>
#include <cstddef>
#include <cstdint>

/// The payloads of an arm as an older program defines them: with the same names as in
/// arm_interface, but in degrees.
namespace legacy {

inline constexpr std::size_t kJoints = 7;
using JointVector = std::array<double, kJoints>;

struct JointState {
  JointVector position{};  ///< deg
  JointVector velocity{};  ///< deg/s
};

struct JointGoal {
  JointVector position{};  ///< deg
  double duration = 1.0;   ///< s
};

struct LimitFault {
  std::int32_t joint = 0;  ///< 0 to 6
  double position = 0.0;   ///< deg
};

}  // namespace legacy

template <>
inline constexpr auto tendon::kPayload<legacy::JointState> = tendon::Describe(
    "arm.JointState", tendon::Field{"position", &legacy::JointState::position, "deg"},
    tendon::Field{"velocity", &legacy::JointState::velocity, "deg/s"});

template <>
inline constexpr auto tendon::kPayload<legacy::JointGoal> = tendon::Describe(
    "arm.JointGoal", tendon::Field{"position", &legacy::JointGoal::position, "deg"},
    tendon::Field{"duration", &legacy::JointGoal::duration, "s"});

template <>
inline constexpr auto tendon::kPayload<legacy::LimitFault> =
    tendon::Describe("arm.LimitFault", tendon::Field{"joint", &legacy::LimitFault::joint},
                     tendon::Field{"position", &legacy::LimitFault::position, "deg"});
