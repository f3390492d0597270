#pragma once

#include <tendon/payload/payload.h>

/// Types that the parts of a robot send to each other, under their usual names. README.md in this
/// folder lists the types of CRTK commands and the equivalent ROS 2 messages.
///
/// Lengths are in metres, angles in radians, forces in newtons; axes are right-handed. All types of
/// this header have a fixed size and need no allocation. eigen.h converts them to Eigen types.
namespace tendon::robot {

/// A position.
struct Point {
  double x = 0;
  double y = 0;
  double z = 0;

  bool operator==(const Point&) const = default;
};

/// A direction and a length; the name of the field says which quantity it is.
struct Vector3 {
  double x = 0;
  double y = 0;
  double z = 0;

  bool operator==(const Vector3&) const = default;
};

/// A rotation, as a unit quaternion. The default value is no rotation.
struct Quaternion {
  double x = 0;
  double y = 0;
  double z = 0;
  double w = 1;

  bool operator==(const Quaternion&) const = default;
};

/// Position and orientation of a frame in the coordinates of another frame.
struct Pose {
  Point position{};
  Quaternion orientation{};

  bool operator==(const Pose&) const = default;
};

/// Maps coordinates in one frame to another: rotates, then translates.
struct Transform {
  Vector3 translation{};
  Quaternion rotation{};

  bool operator==(const Transform&) const = default;
};

/// The velocity of a frame.
struct Twist {
  Vector3 linear{};
  Vector3 angular{};

  bool operator==(const Twist&) const = default;
};

/// Force and torque at the origin of a frame.
struct Wrench {
  Vector3 force{};
  Vector3 torque{};

  bool operator==(const Wrench&) const = default;
};

}  // namespace tendon::robot

namespace tendon {

template <>
inline constexpr auto kPayload<robot::Point> = Describe("geometry_msgs.Point",
                                                        Field{"x", &robot::Point::x},
                                                        Field{"y", &robot::Point::y},
                                                        Field{"z", &robot::Point::z});

template <>
inline constexpr auto kPayload<robot::Vector3> = Describe("geometry_msgs.Vector3",
                                                          Field{"x", &robot::Vector3::x},
                                                          Field{"y", &robot::Vector3::y},
                                                          Field{"z", &robot::Vector3::z});

template <>
inline constexpr auto kPayload<robot::Quaternion> = Describe("geometry_msgs.Quaternion",
                                                             Field{"x", &robot::Quaternion::x},
                                                             Field{"y", &robot::Quaternion::y},
                                                             Field{"z", &robot::Quaternion::z},
                                                             Field{"w", &robot::Quaternion::w});

template <>
inline constexpr auto kPayload<robot::Pose> =
    Describe("geometry_msgs.Pose", Field{"position", &robot::Pose::position, "m"},
             Field{"orientation", &robot::Pose::orientation}.Help("A unit quaternion."));

template <>
inline constexpr auto kPayload<robot::Transform> =
    Describe("geometry_msgs.Transform", Field{"translation", &robot::Transform::translation, "m"},
             Field{"rotation", &robot::Transform::rotation}.Help("A unit quaternion."));

template <>
inline constexpr auto kPayload<robot::Twist> =
    Describe("geometry_msgs.Twist", Field{"linear", &robot::Twist::linear, "m/s"},
             Field{"angular", &robot::Twist::angular, "rad/s"});

template <>
inline constexpr auto kPayload<robot::Wrench> = Describe("geometry_msgs.Wrench",
                                                         Field{"force", &robot::Wrench::force, "N"},
                                                         Field{"torque", &robot::Wrench::torque,
                                                               "N m"});

}  // namespace tendon
