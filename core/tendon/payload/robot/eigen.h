#pragma once

#include <tendon/payload/robot/geometry.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

/// Converts the types of geometry.h to Eigen types and back. The program must link tendon::eigen.
/// Allocates nothing. A Vector6 holds the linear and then the angular part of a twist, or the force
/// and then the torque of a wrench.
namespace tendon::robot {

using Vector6 = Eigen::Matrix<double, 6, 1>;

inline Eigen::Vector3d ToEigen(const Point& point) { return {point.x, point.y, point.z}; }
inline Eigen::Vector3d ToEigen(const Vector3& vector) { return {vector.x, vector.y, vector.z}; }
/// The result is not normalised.
inline Eigen::Quaterniond ToEigen(const Quaternion& q) { return {q.w, q.x, q.y, q.z}; }

/// The rotation is normalised; a quaternion of zeros gives not-a-number.
inline Eigen::Isometry3d ToEigen(const Transform& transform) {
  return Eigen::Translation3d(ToEigen(transform.translation)) *
         ToEigen(transform.rotation).normalized();
}
/// Maps coordinates in the frame with this pose to the frame in which the pose is given.
inline Eigen::Isometry3d ToEigen(const Pose& pose) {
  return Eigen::Translation3d(ToEigen(pose.position)) * ToEigen(pose.orientation).normalized();
}
inline Vector6 ToEigen(const Twist& twist) {
  return (Vector6() << ToEigen(twist.linear), ToEigen(twist.angular)).finished();
}
inline Vector6 ToEigen(const Wrench& wrench) {
  return (Vector6() << ToEigen(wrench.force), ToEigen(wrench.torque)).finished();
}

inline Point ToPoint(const Eigen::Vector3d& point) { return {point.x(), point.y(), point.z()}; }
inline Vector3 ToVector3(const Eigen::Vector3d& vector) {
  return {vector.x(), vector.y(), vector.z()};
}
inline Quaternion ToQuaternion(const Eigen::Quaterniond& q) { return {q.x(), q.y(), q.z(), q.w()}; }
inline Transform ToTransform(const Eigen::Isometry3d& isometry) {
  return {ToVector3(isometry.translation()), ToQuaternion(Eigen::Quaterniond(isometry.linear()))};
}
inline Pose ToPose(const Eigen::Isometry3d& isometry) {
  return {ToPoint(isometry.translation()), ToQuaternion(Eigen::Quaterniond(isometry.linear()))};
}
inline Twist ToTwist(const Vector6& twist) {
  return {ToVector3(twist.head<3>()), ToVector3(twist.tail<3>())};
}
inline Wrench ToWrench(const Vector6& wrench) {
  return {ToVector3(wrench.head<3>()), ToVector3(wrench.tail<3>())};
}

}  // namespace tendon::robot
