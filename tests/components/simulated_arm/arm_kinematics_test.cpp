#include <components/simulated_arm/arm_configuration.h>
#include <components/simulated_arm/arm_kinematics.h>
#include <gtest/gtest.h>

#include <cmath>

namespace arm {
namespace {

Pose PoseOf(const JointVector& position, LinkId link) {
  Pose pose;
  LinkPose({.position = position, .velocity = {}}, link, pose);
  return pose;
}

void ExpectPosition(const Pose& pose, double x, double y, double z) {
  EXPECT_NEAR(pose.position.x, x, 1e-6);
  EXPECT_NEAR(pose.position.y, y, 1e-6);
  EXPECT_NEAR(pose.position.z, z, 1e-6);
}

/// Returns the direction of the frame's x axis.
std::array<double, 3> AxisX(const Pose& pose) {
  const auto& [x, y, z, w] = pose.orientation;
  return {1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w), 2.0 * (x * z - y * w)};
}

TEST(ArmKinematics, TheBaseIsTheOrigin) {
  ExpectPosition(PoseOf(kReadyPosture, LinkId::kBase), 0.0, 0.0, 0.0);
}

TEST(ArmKinematics, AtZeroTheHandPointsDownFromTheOutstretchedArm) {
  const Pose flange = PoseOf({}, LinkId::kFlange);

  ExpectPosition(flange, 0.088, 0.0, 0.333 + 0.316 + 0.384 - 0.107);
  EXPECT_NEAR(std::abs(flange.orientation.x), 1.0, 1e-9);  // a rotation by 180 degrees about x
}

TEST(ArmKinematics, ReadyPostureMatchesThePandaArm) {
  const Pose flange = PoseOf(kReadyPosture, LinkId::kFlange);

  ExpectPosition(flange, 0.306891, 0.0, 0.590282);
  EXPECT_NEAR(AxisX(flange)[0], std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(AxisX(flange)[1], -std::sqrt(0.5), 1e-6);
}

TEST(ArmKinematics, AgreesWithTheProductOfMatricesForAnOddPosture) {
  // The expected numbers come from a calculation with 4x4 matrices outside of this program.
  const Pose flange = PoseOf({0.3, -0.5, 0.2, -1.8, 0.4, 1.7, -0.6}, LinkId::kFlange);

  ExpectPosition(flange, 0.313557, 0.250018, 0.766198);
  EXPECT_NEAR(AxisX(flange)[0], 0.388264, 1e-6);
  EXPECT_NEAR(AxisX(flange)[1], 0.791924, 1e-6);
  EXPECT_NEAR(AxisX(flange)[2], 0.471283, 1e-6);
}

TEST(ArmKinematics, AJointMovesOnlyDistalLinks) {
  JointVector turned = kReadyPosture;
  turned[3] += 0.5;

  EXPECT_EQ(PoseOf(turned, LinkId::kLink3).position,
            PoseOf(kReadyPosture, LinkId::kLink3).position);
  EXPECT_NE(PoseOf(turned, LinkId::kLink5).position,
            PoseOf(kReadyPosture, LinkId::kLink5).position);
}

TEST(ArmKinematics, OrientationsAreUnitQuaternions) {
  for (std::int32_t link = 0; link <= static_cast<std::int32_t>(LinkId::kFlange); ++link) {
    const Pose pose = PoseOf({0.3, -0.5, 0.2, -1.8, 0.4, 1.7, -0.6}, static_cast<LinkId>(link));
    const auto& [x, y, z, w] = pose.orientation;
    EXPECT_NEAR(x * x + y * y + z * z + w * w, 1.0, 1e-12) << link;
  }
}

}  // namespace
}  // namespace arm
