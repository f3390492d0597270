#include <components/simulated_arm/arm_motion.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace arm {
namespace {

constexpr double kStep = 1e-3;  // s

/// An arm that checks every limit after each step.
struct WatchedArm {
  explicit WatchedArm(const ArmConfiguration& arm = {}) : configuration(arm), motion(arm, kStep) {}

  void Run(double seconds) {
    const auto steps = static_cast<int>(std::lround(seconds / kStep));
    for (int i = 0; i < steps && !testing::Test::HasFatalFailure(); ++i) Step();
  }
  void Step() {
    const JointState before = motion.state();
    const ArmMotion::StepEvents events = motion.Step();
    const JointState after = motion.state();
    goals += events.goal_reached ? 1 : 0;
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      limits += events.limit_entered[joint] ? 1 : 0;
      const double acceleration = (after.velocity[joint] - before.velocity[joint]) / kStep;
      ASSERT_GE(after.position[joint], configuration.lower[joint]) << joint;
      ASSERT_LE(after.position[joint], configuration.upper[joint]) << joint;
      ASSERT_LE(std::abs(after.velocity[joint]), configuration.velocity[joint] + 1e-9) << joint;
      ASSERT_LE(std::abs(acceleration), configuration.acceleration[joint] + 1e-6) << joint;
    }
    time += kStep;
  }
  [[nodiscard]] double DistanceTo(const JointVector& posture) const {
    double greatest = 0.0;
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      greatest = std::max(greatest, std::abs(motion.state().position[joint] - posture[joint]));
    }
    return greatest;
  }
  [[nodiscard]] double speed() const {
    double greatest = 0.0;
    for (const double velocity : motion.state().velocity) {
      greatest = std::max(greatest, std::abs(velocity));
    }
    return greatest;
  }

  ArmConfiguration configuration;
  ArmMotion motion;
  double time = 0.0;
  int goals = 0;
  int limits = 0;
};

constexpr JointVector kPosture{0.8, -0.2, 0.3, -1.6, -0.4, 1.9, 0.1};

TEST(ArmMotion, StartsAtRestAtHome) {
  WatchedArm arm;

  arm.Run(0.5);

  EXPECT_EQ(arm.motion.state().position, kReadyPosture);
  EXPECT_EQ(arm.speed(), 0.0);
  EXPECT_EQ(arm.goals, 0);
}

TEST(ArmMotion, ReachesAGoalInTimeAndReportsItOnce) {
  WatchedArm arm;

  ASSERT_TRUE(arm.motion.MoveTo({kPosture, 2.0}));
  arm.Run(1.995);
  EXPECT_EQ(arm.goals, 0);
  arm.Run(0.1);
  EXPECT_EQ(arm.goals, 1);
  arm.Run(3.0);

  EXPECT_EQ(arm.goals, 1);
  EXPECT_LT(arm.DistanceTo(kPosture), 1e-4);
  EXPECT_LT(arm.speed(), 1e-4);
}

TEST(ArmMotion, ExtendsTheDurationToKeepTheLimits) {
  WatchedArm arm;

  ASSERT_TRUE(arm.motion.MoveTo({kPosture, 0.0}));
  const double needed = arm.motion.goal().duration;
  EXPECT_GT(needed, 0.3);
  arm.Run(needed + 0.2);

  EXPECT_EQ(arm.goals, 1);
  EXPECT_LT(arm.DistanceTo(kPosture), 1e-3);
}

TEST(ArmMotion, AllJointsArriveTogether) {
  WatchedArm arm;
  JointVector posture = kReadyPosture;
  posture[0] += 2.0;
  posture[6] += 0.1;

  ASSERT_TRUE(arm.motion.MoveTo({posture, 3.0}));
  arm.Run(1.5);

  EXPECT_NEAR(arm.motion.state().position[0] - kReadyPosture[0], 1.0, 0.01);
  EXPECT_NEAR(arm.motion.state().position[6] - kReadyPosture[6], 0.05, 0.001);
}

TEST(ArmMotion, TheJerkOfAMotionIsBounded) {
  WatchedArm arm;
  ASSERT_TRUE(arm.motion.MoveTo({kPosture, 2.0}));
  const double bound = 60.0 * arm.DistanceTo(kPosture) / (2.0 * 2.0 * 2.0);
  JointVector velocity{};
  JointVector acceleration{};
  double jerk = 0.0;

  for (int i = 0; i < 2500; ++i) {
    arm.Step();
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      const double next = (arm.motion.state().velocity[joint] - velocity[joint]) / kStep;
      jerk = std::max(jerk, std::abs(next - acceleration[joint]) / kStep);
      velocity[joint] = arm.motion.state().velocity[joint];
      acceleration[joint] = next;
    }
  }

  EXPECT_LE(jerk, 1.2 * bound);
  EXPECT_GT(jerk, 0.0);
}

TEST(ArmMotion, KeepsItsLimitsForRandomGoalsAndStops) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> position(-4.0, 4.0);
  std::uniform_real_distribution<double> duration(0.0, 1.5);
  std::uniform_real_distribution<double> pause(0.001, 1.0);
  WatchedArm arm;

  for (int i = 0; i < 300 && !HasFatalFailure(); ++i) {
    JointGoal goal{.position = {}, .duration = duration(random)};
    for (double& one : goal.position) one = position(random);
    ASSERT_TRUE(arm.motion.MoveTo(goal));
    if (i % 7 == 0) arm.motion.Stop();
    arm.Run(pause(random));
  }
}

TEST(ArmMotion, AGoalMayBeReplacedInTheMiddleOfTheMotion) {
  WatchedArm arm;
  ASSERT_TRUE(arm.motion.MoveTo({kPosture, 2.0}));
  arm.Run(1.0);

  ASSERT_TRUE(arm.motion.MoveTo({kReadyPosture, 2.0}));
  arm.Run(2.1);

  EXPECT_EQ(arm.goals, 1);
  EXPECT_LT(arm.DistanceTo(kReadyPosture), 1e-3);
}

TEST(ArmMotion, AnUnreachableGoalEndsAtTheLimitAndReportsItOnce) {
  WatchedArm arm;
  JointVector posture = kReadyPosture;
  posture[2] = 5.0;

  ASSERT_TRUE(arm.motion.MoveTo({posture, 2.0}));
  arm.Run(10.0);

  EXPECT_EQ(arm.limits, 1);
  EXPECT_EQ(arm.goals, 0);
  EXPECT_NEAR(arm.motion.state().position[2], arm.configuration.upper[2], 1e-4);
  EXPECT_LT(arm.speed(), 1e-3);
}

TEST(ArmMotion, StopHaltsQuicklyAndCancelsTheGoal) {
  WatchedArm arm;
  ASSERT_TRUE(arm.motion.MoveTo({kPosture, 1.5}));
  arm.Run(0.75);
  ASSERT_GT(arm.speed(), 0.5);
  const JointVector at_stop = arm.motion.state().position;

  arm.motion.Stop();
  arm.Run(0.6);
  const JointVector at_rest = arm.motion.state().position;
  arm.Run(2.0);

  EXPECT_LT(arm.speed(), 1e-6);
  EXPECT_LT(arm.DistanceTo(at_rest), 1e-4);
  EXPECT_LT(arm.DistanceTo(at_stop), 0.25);
  EXPECT_EQ(arm.goals, 0);
}

TEST(ArmMotion, RejectsInvalidGoals) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  WatchedArm arm;
  JointVector not_a_number = kPosture;
  not_a_number[4] = kNan;
  JointVector endless = kPosture;
  endless[0] = kInfinity;

  EXPECT_FALSE(arm.motion.MoveTo({not_a_number, 1.0}));
  EXPECT_FALSE(arm.motion.MoveTo({endless, 1.0}));
  EXPECT_FALSE(arm.motion.MoveTo({kPosture, kNan}));
  EXPECT_FALSE(arm.motion.MoveTo({kPosture, kInfinity}));
  EXPECT_FALSE(arm.motion.MoveTo({kPosture, -1.0}));
  arm.Run(1.0);

  EXPECT_EQ(arm.motion.state().position, kReadyPosture);
}

}  // namespace
}  // namespace arm
