#include <gtest/gtest.h>
#include <tendon/payload/eigen.h>
#include <tendon/payload/fingerprint.h>

#include <numbers>

#include "samples.h"

namespace tendon::robot {
namespace {

/// Returns a rotation by 90 degrees about z.
Quaternion Quarter() { return {0, 0, std::sqrt(0.5), std::sqrt(0.5)}; }

TEST(RobotEigen, RoundTrips) {
  EXPECT_EQ(ToPoint(ToEigen(Sample<Point>())), Sample<Point>());
  EXPECT_EQ(ToVector3(ToEigen(Sample<Vector3>())), Sample<Vector3>());
  EXPECT_EQ(ToQuaternion(ToEigen(Sample<Quaternion>())), Sample<Quaternion>());
  EXPECT_EQ(ToTwist(ToEigen(Sample<Twist>())), Sample<Twist>());
  EXPECT_EQ(ToWrench(ToEigen(Sample<Wrench>())), Sample<Wrench>());
  EXPECT_TRUE(ToEigen(ToPose(ToEigen(Sample<Pose>()))).isApprox(ToEigen(Sample<Pose>()), 1e-12));
  EXPECT_TRUE(ToEigen(ToTransform(ToEigen(Sample<Transform>())))
                  .isApprox(ToEigen(Sample<Transform>()), 1e-12));
}

TEST(RobotEigen, APoseTransformsCoordinatesOutOfItsFrame) {
  const Pose pose{{1, 2, 3}, Quarter()};

  const Eigen::Vector3d outside = ToEigen(pose) * Eigen::Vector3d::UnitX();

  EXPECT_TRUE(outside.isApprox(Eigen::Vector3d(1, 3, 3), 1e-12)) << outside;
}

TEST(RobotEigen, NormalisesAnUnnormalisedRotation) {
  Quaternion twice = Quarter();
  twice.z *= 2;
  twice.w *= 2;

  const Eigen::Isometry3d isometry = ToEigen(Transform{{}, twice});

  EXPECT_NEAR(isometry.linear().determinant(), 1.0, 1e-12);
}

TEST(RobotEigen, SixNumbersAreLinearThenAngular) {
  Vector6 expected;
  expected << 1, -2, 3, -4, 5, -6;

  EXPECT_EQ(ToEigen(Sample<Twist>()), expected);
}

TEST(RobotEigen, AnIsometryConnectsToATransform) {
  EXPECT_EQ(FingerprintOf<Eigen::Isometry3d>(), FingerprintOf<Transform>());
  EXPECT_EQ(FingerprintOf<Eigen::Quaterniond>(), FingerprintOf<Quaternion>());
}

}  // namespace
}  // namespace tendon::robot
