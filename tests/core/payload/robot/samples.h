#pragma once

#include <tendon/payload/robot/geometry.h>
#include <tendon/payload/robot/image.h>
#include <tendon/payload/robot/joints.h>
#include <tendon/payload/robot/joystick.h>
#include <tendon/payload/robot/transforms.h>

/// One value of each standard payload. No field has its default value.
namespace tendon::robot {

inline Header SampleHeader() {
  return {std::chrono::sys_time<std::chrono::nanoseconds>(std::chrono::nanoseconds(1'500'000'042)),
          "base"};
}
inline Quaternion SampleRotation() { return {0.5, -0.5, 0.5, -0.5}; }

template <typename T>
T Sample();

template <>
inline Point Sample() {
  return {1, -2, 3};
}
template <>
inline Vector3 Sample() {
  return {0.25, -4, 5};
}
template <>
inline Quaternion Sample() {
  return SampleRotation();
}
template <>
inline Pose Sample() {
  return {{1, -2, 3}, SampleRotation()};
}
template <>
inline Transform Sample() {
  return {{1, -2, 3}, SampleRotation()};
}
template <>
inline Twist Sample() {
  return {{1, -2, 3}, {-4, 5, -6}};
}
template <>
inline Wrench Sample() {
  return {{10, -20, 30}, {-0.4, 0.5, -0.6}};
}
template <>
inline JointState<2> Sample() {
  return {{1, -2}, {0.25, 4}, {-5, 6}};
}
template <>
inline JointControl Sample() {
  return JointControl::kEffort;
}
template <>
inline JointCommand<2> Sample() {
  return {JointControl::kVelocity, {1, -2}, {0.25, 4}, {-5, 6}};
}
template <>
inline NamedJointState Sample() {
  return {SampleHeader(), {"shoulder", "slide"}, {0.5, -0.25}, {1, 2}, {}};
}
template <>
inline Header Sample() {
  return SampleHeader();
}
template <>
inline TransformStamped Sample() {
  return {SampleHeader(), "tool", Sample<Transform>()};
}
template <>
inline Transforms Sample() {
  TransformStamped camera = Sample<TransformStamped>();
  camera.child_frame_id = "camera";
  return {{Sample<TransformStamped>(), camera}};
}
template <>
inline Joystick Sample() {
  return {SampleHeader(), {-1, 0.5F, 1}, {0, 1, 1, 0}};
}
template <>
inline Image Sample() {
  return {SampleHeader(), 2, 1, "rgb8", 1, 4, {1, 2, 3, 0, 255, 254, 253, 0}};
}

}  // namespace tendon::robot
