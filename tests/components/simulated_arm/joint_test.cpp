#include <components/simulated_arm/joint.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace arm {
namespace {

constexpr JointLimits kNarrow{-1.0, 2.0, 2.0, 8.0};
constexpr double kBandwidth = 50.0;  // rad/s
constexpr double kPeriod = 1e-3;     // s

void ExpectWithinLimits(const Joint& joint) {
  ASSERT_GE(joint.point().position, kNarrow.lower);
  ASSERT_LE(joint.point().position, kNarrow.upper);
  ASSERT_LE(std::abs(joint.point().velocity), kNarrow.velocity + 1e-9);
  ASSERT_LE(std::abs(joint.point().acceleration), kNarrow.acceleration + 1e-6);
}

/// Makes `steps` steps towards a position. Returns how often the joint entered a limit.
int Drive(Joint& joint, double position, int steps) {
  int entered = 0;
  for (int i = 0; i < steps; ++i) {
    joint.Step({position, 0.0, 0.0}, kPeriod);
    entered += joint.has_entered_limit() ? 1 : 0;
  }
  return entered;
}

TEST(Joint, ReachesTheReferenceWithoutOvershoot) {
  Joint joint(kNarrow, kBandwidth, 0.0);
  double furthest = 0.0;

  for (int i = 0; i < 400; ++i) {
    joint.Step({0.001, 0.0, 0.0}, kPeriod);
    furthest = std::max(furthest, joint.point().position);
  }

  EXPECT_NEAR(joint.point().position, 0.001, 1e-6);
  EXPECT_LE(furthest, 0.001 + 1e-6);
}

TEST(Joint, KeepsAllLimitsForRandomReferences) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-30.0, 30.0);
  std::uniform_int_distribution<int> steps(1, 700);
  Joint joint(kNarrow, kBandwidth, 0.5);

  for (int change = 0; change < 2000; ++change) {
    const JointPoint reference{any(random), any(random), 10.0 * any(random)};
    for (int i = steps(random); i > 0; --i) {
      joint.Step(reference, kPeriod);
      ASSERT_NO_FATAL_FAILURE(ExpectWithinLimits(joint)) << "change " << change;
    }
  }
}

TEST(Joint, BrakesBeforeItReachesTheLimit) {
  // Checks the invariant behind the previous test: braking always suffices, so the position is
  // never clamped.
  Joint joint(kNarrow, kBandwidth, -1.0);

  for (int i = 0; i < 3000; ++i) {
    const double position = joint.point().position;
    joint.Step({100.0, 0.0, 0.0}, kPeriod);
    ASSERT_NEAR(joint.point().position, position + joint.point().velocity * kPeriod, 1e-12) << i;
  }

  EXPECT_NEAR(joint.point().position, kNarrow.upper, 1e-6);
  EXPECT_NEAR(joint.point().velocity, 0.0, 1e-6);
}

TEST(Joint, ReportsReachingALimitOnce) {
  Joint joint(kNarrow, kBandwidth, 0.0);

  EXPECT_EQ(Drive(joint, 5.0, 4000), 1);
  EXPECT_EQ(Drive(joint, 5.0, 4000), 0);
}

TEST(Joint, ReportsALimitAgainOnlyAfterLeavingIt) {
  Joint joint(kNarrow, kBandwidth, 0.0);
  Drive(joint, 5.0, 4000);

  EXPECT_EQ(Drive(joint, kNarrow.upper - 0.005, 2000), 0);
  EXPECT_EQ(Drive(joint, 5.0, 2000), 0);
  EXPECT_EQ(Drive(joint, 0.0, 4000), 0);
  EXPECT_EQ(Drive(joint, 5.0, 4000), 1);
  EXPECT_EQ(Drive(joint, -5.0, 4000), 1);
}

TEST(Joint, StartingAtALimitIsNotReported) {
  Joint joint(kNarrow, kBandwidth, kNarrow.lower);

  EXPECT_EQ(Drive(joint, -5.0, 100), 0);
}

TEST(Joint, RestStopsTheJointAtItsPosition) {
  Joint joint(kNarrow, kBandwidth, 0.0);
  Drive(joint, 1.0, 200);
  const double position = joint.point().position;

  joint.Rest();

  EXPECT_EQ(joint.point().position, position);
  EXPECT_EQ(joint.point().velocity, 0.0);
}

}  // namespace
}  // namespace arm
