#include <components/simulated_arm/joint_path.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace arm {
namespace {

constexpr JointLimits kLimits{-2.9, 2.9, 2.0, 8.0};
constexpr double kSample = 1e-3;  // s

/// Calls `visit(time, point)` for each millisecond from 0 to slightly after the end of the path.
template <typename Visitor>
void Follow(const JointPath& path, Visitor visit) {
  const int steps = static_cast<int>(path.duration() / kSample) + 10;
  for (int i = 0; i <= steps; ++i) visit(i * kSample, path.At(i * kSample));
}

TEST(JointPath, StartsFromTheCurrentMotionOfTheJoint) {
  const JointPoint start{0.3, -0.7, 1.9};

  const JointPoint begin = JointPath::MoveTo(start, 1.0, 2.0, kLimits).At(0.0);

  EXPECT_DOUBLE_EQ(begin.position, start.position);
  EXPECT_DOUBLE_EQ(begin.velocity, start.velocity);
  EXPECT_DOUBLE_EQ(begin.acceleration, start.acceleration);
}

TEST(JointPath, EndsAtRestAtTheGoal) {
  const JointPath path = JointPath::MoveTo({0.3, -0.7, 1.9}, 1.0, 2.0, kLimits);

  const JointPoint end = path.At(2.0 - 1e-9);

  EXPECT_NEAR(end.position, 1.0, 1e-9);
  EXPECT_NEAR(end.velocity, 0.0, 1e-6);
  EXPECT_NEAR(end.acceleration, 0.0, 1e-6);
  EXPECT_EQ(path.At(1e6).position, 1.0);
}

TEST(JointPath, VelocityAndAccelerationAreTheDerivatives) {
  const JointPath path = JointPath::MoveTo({-0.4, 1.1, -2.0}, 1.5, 1.7, kLimits);
  constexpr double kSmall = 1e-5;  // s

  for (double time = 0.01; time < 1.69; time += 0.01) {
    const JointPoint before = path.At(time - kSmall);
    const JointPoint point = path.At(time);
    const JointPoint after = path.At(time + kSmall);
    EXPECT_NEAR(point.velocity, (after.position - before.position) / (2 * kSmall), 1e-6) << time;
    EXPECT_NEAR(point.acceleration, (after.velocity - before.velocity) / (2 * kSmall), 1e-3)
        << time;
  }
}

TEST(JointPath, IsMinimumJerkWhenStartingFromRest) {
  // The path is 10 s^3 - 15 s^4 + 6 s^5. Its value is 0.10352 at a quarter of the duration and 0.5
  // in the middle. The velocity in the middle is 15/8 of the mean.
  const JointPath path = JointPath::MoveTo({0.0, 0.0, 0.0}, 2.0, 4.0, kLimits);

  EXPECT_NEAR(path.At(1.0).position, 2.0 * 0.103515625, 1e-12);
  EXPECT_NEAR(path.At(2.0).position, 1.0, 1e-12);
  EXPECT_NEAR(path.At(2.0).velocity, 15.0 / 8.0 * 0.5, 1e-12);
}

TEST(JointPath, BoundsTheJerkWhenStartingFromRest) {
  // The jerk of a minimum-jerk motion is greatest at both ends: 60 distance / duration^3.
  const JointPath path = JointPath::MoveTo({0.0, 0.0, 0.0}, 2.0, 2.0, kLimits);
  double jerk = 0.0;
  double before = 0.0;

  Follow(path, [&](double /*time*/, const JointPoint& point) {
    jerk = std::max(jerk, std::abs(point.acceleration - before) / kSample);
    before = point.acceleration;
  });

  EXPECT_LE(jerk, 60.0 * 2.0 / 8.0 * 1.001);
  EXPECT_GT(jerk, 60.0 * 2.0 / 8.0 * 0.9);
}

TEST(JointPath, ALongDurationDoesNotMakeAMovingJointOvershoot) {
  const JointPath path = JointPath::MoveTo({0.0, 1.5, 0.0}, 0.5, 30.0, kLimits);
  double furthest = 0.0;

  Follow(path, [&](double /*time*/, const JointPoint& point) {
    furthest = std::max(furthest, point.position);
  });

  EXPECT_LE(furthest, 0.5);
}

TEST(JointPath, LengthenedKeepsVelocityAndAccelerationWithinTheLimits) {
  for (const double goal : {-2.5, -0.1, 0.4, 2.8}) {
    const JointPoint start{};
    const double duration = JointPath::Lengthened(start, goal, 0.0, kLimits);
    Follow(JointPath::MoveTo(start, goal, duration, kLimits), [&](double time,
                                                                  const JointPoint& point) {
      EXPECT_LE(std::abs(point.velocity), kLimits.velocity + 1e-9) << goal << " " << time;
      EXPECT_LE(std::abs(point.acceleration), kLimits.acceleration + 1e-9) << goal << " " << time;
    });
  }
}

TEST(JointPath, LengthenedKeepsASufficientDuration) {
  EXPECT_EQ(JointPath::Lengthened({}, 1.0, 5.0, kLimits), 5.0);
}

TEST(JointPath, StopDoesNotReverseTheMotion) {
  const JointPath path = JointPath::Stop({0.0, -1.6, 0.0}, kLimits);

  Follow(path, [&](double time, const JointPoint& point) {
    EXPECT_LE(point.velocity, 1e-12) << time;
    EXPECT_LE(std::abs(point.acceleration), kLimits.acceleration) << time;
  });
  EXPECT_LT(path.goal(), 0.0);
  EXPECT_EQ(path.At(path.duration()).velocity, 0.0);
  EXPECT_LE(path.duration(), 2.0 * 1.6 / kLimits.acceleration);
}

TEST(JointPath, StoppingAJointAtRestKeepsItsPosition) {
  EXPECT_EQ(JointPath::Stop({0.7, 0.0, 0.0}, kLimits).At(0.02).position, 0.7);
  EXPECT_EQ(JointPath(0.7).At(0.0).position, 0.7);
}

}  // namespace
}  // namespace arm
