#pragma once

#include <tendon/payload/robot/header.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tendon::robot {

/// The state of an arm's revolute joints, either measured (measured_js) or desired (setpoint_js).
/// It suits control loops, because it has a fixed size and needs no allocation.
template <std::size_t kJoints>
struct JointState {
  std::array<double, kJoints> position{};  ///< rad
  std::array<double, kJoints> velocity{};  ///< rad/s
  std::array<double, kJoints> effort{};    ///< N m

  bool operator==(const JointState&) const = default;
};

/// The quantity that the joint drives regulate: servo_jp, servo_jv and servo_jf.
enum class JointControl : std::int32_t { kPosition, kVelocity, kEffort };

/// Moves revolute joints; sent once per cycle. The members after the controlled one are
/// feed-forward values: velocity and effort in position control, effort in velocity control. The
/// members before the controlled one are ignored.
template <std::size_t kJoints>
struct JointCommand {
  JointControl control = JointControl::kPosition;
  std::array<double, kJoints> position{};  ///< rad
  std::array<double, kJoints> velocity{};  ///< rad/s
  std::array<double, kJoints> effort{};    ///< N m

  bool operator==(const JointCommand&) const = default;
};

/// The state of joints of any kind and number, by name. Each list has as many items as `name`, or
/// is empty if its values are unknown. The units are rad, rad/s and N m for a revolute joint, and
/// m, m/s and N for a prismatic joint.
struct NamedJointState {
  Header header{};
  std::vector<std::string> name{};
  std::vector<double> position{};
  std::vector<double> velocity{};
  std::vector<double> effort{};

  bool operator==(const NamedJointState&) const = default;
};

}  // namespace tendon::robot

namespace tendon {

template <std::size_t kJoints>
inline constexpr auto kPayload<robot::JointState<kJoints>> =
    Describe("robot.JointState", Field{"position", &robot::JointState<kJoints>::position, "rad"},
             Field{"velocity", &robot::JointState<kJoints>::velocity, "rad/s"},
             Field{"effort", &robot::JointState<kJoints>::effort, "N m"});

template <>
inline constexpr auto kPayload<robot::JointControl> =
    DescribeEnum("robot.JointControl", Enumerator{"position", robot::JointControl::kPosition},
                 Enumerator{"velocity", robot::JointControl::kVelocity},
                 Enumerator{"effort", robot::JointControl::kEffort});

template <std::size_t kJoints>
inline constexpr auto kPayload<robot::JointCommand<kJoints>> = Describe(
    "robot.JointCommand",
    Field{"control", &robot::JointCommand<kJoints>::control}.Help(
        "The controlled quantity; later fields are feed-forward, earlier fields are ignored."),
    Field{"position", &robot::JointCommand<kJoints>::position, "rad"},
    Field{"velocity", &robot::JointCommand<kJoints>::velocity, "rad/s"},
    Field{"effort", &robot::JointCommand<kJoints>::effort, "N m"});

template <>
inline constexpr auto kPayload<robot::NamedJointState> =
    Describe("sensor_msgs.JointState", Field{"header", &robot::NamedJointState::header},
             Field{"name", &robot::NamedJointState::name}.Help("The name of each joint."),
             Field{"position", &robot::NamedJointState::position, "rad or m"},
             Field{"velocity", &robot::NamedJointState::velocity, "rad/s or m/s"},
             Field{"effort", &robot::NamedJointState::effort, "N m or N"});

}  // namespace tendon
