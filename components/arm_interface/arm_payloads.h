#pragma once

#include <tendon/payload/payload.h>
#include <tendon/payload/robot/geometry.h>

#include <array>
#include <cstddef>
#include <cstdint>

/// The payloads that arms with seven joints share with their clients.
namespace arm {

inline constexpr std::size_t kJoints = 7;

/// One number per joint, from the base to the hand.
using JointVector = std::array<double, kJoints>;

/// The positions and velocities of the joints.
struct JointState {
  JointVector position{};  ///< rad
  JointVector velocity{};  ///< rad/s
};

/// A posture in which the arm comes to rest, and the duration of the motion. The arm takes longer
/// if its limits require it.
struct JointGoal {
  JointVector position{};  ///< rad
  double duration = 1.0;   ///< s
};

/// The velocities with which the joints move from now on.
struct JointVelocity {
  JointVector velocity{};  ///< rad/s
};

/// A joint has reached the end of its range.
struct LimitFault {
  std::int32_t joint = 0;  ///< 0 to 6
  double position = 0.0;   ///< rad
};

/// The frame of a link: kLink1 turns with joint 0, and so on; kFlange carries the tool.
enum class LinkId : std::int32_t {
  kBase,
  kLink1,
  kLink2,
  kLink3,
  kLink4,
  kLink5,
  kLink6,
  kLink7,
  kFlange,
};

/// The pose of a frame in the base frame.
using tendon::robot::Pose;

}  // namespace arm

template <>
inline constexpr auto tendon::kPayload<arm::JointState> =
    tendon::Describe("arm.JointState", tendon::Field{"position", &arm::JointState::position, "rad"},
                     tendon::Field{"velocity", &arm::JointState::velocity, "rad/s"});

template <>
inline constexpr auto tendon::kPayload<arm::JointGoal> =
    tendon::Describe("arm.JointGoal", tendon::Field{"position", &arm::JointGoal::position, "rad"},
                     tendon::Field{"duration", &arm::JointGoal::duration, "s"});

template <>
inline constexpr auto tendon::kPayload<arm::JointVelocity> = tendon::Describe(
    "arm.JointVelocity", tendon::Field{"velocity", &arm::JointVelocity::velocity, "rad/s"});

template <>
inline constexpr auto tendon::kPayload<arm::LimitFault> =
    tendon::Describe("arm.LimitFault", tendon::Field{"joint", &arm::LimitFault::joint},
                     tendon::Field{"position", &arm::LimitFault::position, "rad"});

template <>
inline constexpr auto tendon::kPayload<arm::LinkId> =
    tendon::DescribeEnum("arm.LinkId", tendon::Enumerator{"base", arm::LinkId::kBase},
                         tendon::Enumerator{"link_1", arm::LinkId::kLink1},
                         tendon::Enumerator{"link_2", arm::LinkId::kLink2},
                         tendon::Enumerator{"link_3", arm::LinkId::kLink3},
                         tendon::Enumerator{"link_4", arm::LinkId::kLink4},
                         tendon::Enumerator{"link_5", arm::LinkId::kLink5},
                         tendon::Enumerator{"link_6", arm::LinkId::kLink6},
                         tendon::Enumerator{"link_7", arm::LinkId::kLink7},
                         tendon::Enumerator{"flange", arm::LinkId::kFlange});
