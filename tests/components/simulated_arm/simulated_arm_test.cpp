#include <components/simulated_arm/simulated_arm.h>
#include <gtest/gtest.h>
#include <support/allocation_guard.h>
#include <support/refusal.h>
#include <support/wait.h>
#include <tendon/manager/local_manager.h>

#include <algorithm>
#include <cmath>

#include "components/arm_client.h"
#include "components/stepped.h"

namespace arm {
namespace {

using tendon::AllocationGuard;
using tendon::Status;
using tendon_test::ArmClient;
using tendon_test::Stepped;

constexpr JointVector kGoal{0.8, -0.2, 0.3, -1.6, -0.4, 1.9, 0.1};

/// An arm that the test steps, and a client of the arm's Control.
class SteppedArm : public testing::Test {
 protected:
  explicit SteppedArm(const ArmConfiguration& configuration = {})
      : arm_(manager_.Add<Stepped<SimulatedArm>>("arm", configuration)),
        client_(manager_.Add<ArmClient>("client")) {
    EXPECT_TRUE(manager_.Connect({"client", "Robot"}, {"arm", "Control"}));
    EXPECT_TRUE(manager_.StartAll());
  }

  JointState Joints() {
    JointState joints;
    EXPECT_EQ(client_.get_joints(joints), Status::kDone);
    return joints;
  }

  tendon::LocalManager manager_;
  Stepped<SimulatedArm>& arm_;
  ArmClient& client_;
};
using SimulatedArmTest = SteppedArm;

TEST_F(SimulatedArmTest, HasNoSampleBeforeItsFirstCycle) {
  JointState joints;

  EXPECT_EQ(client_.get_joints(joints), Status::kNoSample);
}

TEST_F(SimulatedArmTest, MovesToAGoalAndRaisesGoalReachedOnce) {
  EXPECT_EQ(client_.move_to({kGoal, 1.0}), Status::kQueued);
  arm_.Cycle(2000);

  const JointState joints = Joints();
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    EXPECT_NEAR(joints.position[joint], kGoal[joint], 1e-3) << joint;
    EXPECT_NEAR(joints.velocity[joint], 0.0, 1e-3) << joint;
  }
  EXPECT_EQ(client_.goals_reached, 1);
  EXPECT_TRUE(client_.faults.empty());
}

TEST_F(SimulatedArmTest, RecordsTheCurrentGoal) {
  EXPECT_TRUE(client_.move_to({kGoal, 4.0}));
  arm_.Cycle();

  EXPECT_EQ(arm_.Read<JointGoal>("Goal").position, kGoal);
  EXPECT_EQ(arm_.Read<JointGoal>("Goal").duration, 4.0);
}

TEST_F(SimulatedArmTest, RaisesLimitExceededOnceWithTheJointAndItsPosition) {
  JointVector beyond = kReadyPosture;
  beyond[0] = 4.0;

  EXPECT_TRUE(client_.move_to({beyond, 2.0}));
  arm_.Cycle(8000);

  ASSERT_EQ(client_.faults.size(), 1U);
  EXPECT_EQ(client_.faults[0].joint, 0);
  EXPECT_NEAR(client_.faults[0].position, ArmConfiguration().upper[0], 2e-3);
  EXPECT_EQ(client_.goals_reached, 0);
}

TEST_F(SimulatedArmTest, StopHaltsTheArm) {
  EXPECT_TRUE(client_.move_to({kGoal, 1.0}));
  arm_.Cycle(500);
  ASSERT_GT(std::abs(Joints().velocity[0]), 0.1);

  EXPECT_EQ(client_.stop(), Status::kQueued);
  arm_.Cycle(1000);

  EXPECT_NEAR(Joints().velocity[0], 0.0, 1e-6);
  EXPECT_LT(Joints().position[0], kGoal[0] - 0.1);
  EXPECT_EQ(client_.goals_reached, 0);
}

TEST_F(SimulatedArmTest, CountsInvalidGoalsAsRefused) {
  EXPECT_TRUE(client_.move_to({kGoal, std::nan("")}));
  arm_.Cycle(10);

  EXPECT_EQ(arm_.Read<std::uint64_t>("Refused"), 1U);
  EXPECT_EQ(Joints().position, kReadyPosture);
}

TEST_F(SimulatedArmTest, ReportsLinkPoses) {
  arm_.Cycle();
  Pose pose;

  EXPECT_EQ(client_.get_link_pose(LinkId::kFlange, pose), Status::kDone);

  EXPECT_NEAR(pose.position.x, 0.306891, 1e-6);
  EXPECT_NEAR(pose.position.z, 0.590282, 1e-6);
}

TEST_F(SimulatedArmTest, ACycleAllocatesNothing) {
  JointVector beyond = kReadyPosture;
  beyond[0] = 4.0;
  arm_.Cycle(10);

  const AllocationGuard guard;
  EXPECT_TRUE(client_.move_to({kGoal, 0.3}));
  arm_.Cycle(2000);
  EXPECT_TRUE(client_.move_to({beyond, 0.3}));
  arm_.Cycle(4000);
  EXPECT_TRUE(client_.stop());
  arm_.Cycle(10);
  EXPECT_EQ(client_.goals_reached, 1);
  EXPECT_EQ(client_.faults.size(), 1U);
}

TEST_F(SimulatedArmTest, MotionCommandsAreMarkedAsHazards) {
  for (const auto& command : arm_.FindProvided("Control")->description().commands) {
    EXPECT_EQ(command.hazard, command.name.starts_with("Move") ? "motion" : "") << command.name;
    EXPECT_EQ(command.expires_after, command.name == "MoveAt" ? 0.1 : 0.0) << command.name;
  }
}

TEST_F(SimulatedArmTest, HoldsItsPositionWhenResumed) {
  EXPECT_TRUE(client_.move_to({kGoal, 3.0}));
  arm_.Cycle(1000);
  const JointVector on_the_way = Joints().position;
  ASSERT_TRUE(manager_.Suspend("arm"));
  ASSERT_TRUE(manager_.Start("arm"));

  arm_.Cycle(3000);

  EXPECT_EQ(Joints().position, on_the_way);
  EXPECT_EQ(client_.goals_reached, 0);
}

TEST_F(SimulatedArmTest, MovesAtAVelocityWithoutAJerk) {
  JointVector velocity{};
  velocity[0] = 0.5;
  double greatest = 0.0;
  double before = 0.0;

  EXPECT_TRUE(client_.move_at({velocity}));
  for (int i = 0; i < 80; ++i) {  // the command does not expire during these cycles
    arm_.Cycle();
    greatest = std::max(greatest, std::abs(Joints().velocity[0] - before) / 1e-3);
    before = Joints().velocity[0];
  }

  EXPECT_GT(before, 0.2);
  EXPECT_LE(greatest, 0.3 * ArmConfiguration().acceleration[0]);
}

TEST_F(SimulatedArmTest, AnInvalidVelocityStopsTheMotion) {
  JointVector velocity{};
  velocity[0] = 0.5;
  JointVector wrong = velocity;
  wrong[3] = std::nan("");
  EXPECT_TRUE(client_.move_at({velocity}));
  arm_.Cycle(80);
  ASSERT_GT(Joints().velocity[0], 0.2);

  for (int i = 0; i < 100; ++i) {  // valid calls at this rate would keep the arm in motion
    EXPECT_TRUE(client_.move_at({wrong}));
    arm_.Cycle(10);
  }

  EXPECT_EQ(arm_.Read<std::uint64_t>("Refused"), 100U);
  EXPECT_NEAR(Joints().velocity[0], 0.0, 1e-6);
}

TEST_F(SimulatedArmTest, AVelocityExpiresIfItIsNotRenewed) {
  JointVector velocity{};
  velocity[0] = 0.5;

  EXPECT_TRUE(client_.move_at({velocity}));
  const bool came_to_rest = EventuallyTrue([&] {
    arm_.Cycle();
    return arm_.Read<JointGoal>("Goal").duration > 0.0 && std::abs(Joints().velocity[0]) < 1e-6;
  });

  EXPECT_TRUE(came_to_rest);
}

TEST_F(SimulatedArmTest, AnExpiredVelocityDoesNotCancelALaterGoal) {
  JointVector velocity{};
  velocity[0] = 0.1;
  EXPECT_TRUE(client_.move_at({velocity}));
  arm_.Cycle();
  const auto since = std::chrono::steady_clock::now();

  EXPECT_TRUE(client_.move_to({kGoal, 2.0}));
  const bool is_over = EventuallyTrue(
      [&] { return std::chrono::steady_clock::now() - since > std::chrono::milliseconds(110); });
  arm_.Cycle(3000);

  EXPECT_TRUE(is_over);
  EXPECT_EQ(client_.goals_reached, 1);
}

TEST_F(SimulatedArmTest, RejectsAVelocityThatIsNotANumber) {
  JointVector velocity{};
  velocity[3] = std::nan("");

  EXPECT_TRUE(client_.move_at({velocity}));
  arm_.Cycle(10);

  EXPECT_EQ(arm_.Read<std::uint64_t>("Refused"), 1U);
  EXPECT_EQ(Joints().position, kReadyPosture);
}

class NoisyArm : public SteppedArm {
 protected:
  NoisyArm() : SteppedArm(Noisy()) {}
  static ArmConfiguration Noisy() {
    ArmConfiguration configuration;
    configuration.noise = 0.01;
    return configuration;
  }
};

TEST_F(NoisyArm, MeasuresPositionWithNoiseWhileAtRest) {
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kSamples = 4000;

  for (int i = 0; i < kSamples; ++i) {
    arm_.Cycle();
    const double deviation = Joints().position[1] - kReadyPosture[1];
    sum += deviation;
    squares += deviation * deviation;
  }

  EXPECT_NEAR(sum / kSamples, 0.0, 0.001);
  EXPECT_NEAR(std::sqrt(squares / kSamples), 0.01, 0.001);
  EXPECT_EQ(Joints().velocity[1], 0.0);
}

std::string RefusalOf(const ArmConfiguration& configuration) {
  return tendon::test::Refusal([&] { SimulatedArm arm("arm", configuration); });
}

TEST(SimulatedArmConfiguration, TheDefaultsAreAccepted) { EXPECT_EQ(RefusalOf({}), ""); }

TEST(SimulatedArmConfiguration, ReportsInvalidNumbers) {
  ArmConfiguration crossed;
  crossed.lower[3] = 1.0;
  ArmConfiguration outside;
  outside.home[0] = 3.0;
  ArmConfiguration frozen;
  frozen.velocity[6] = 0.0;
  ArmConfiguration blurred;
  blurred.noise = std::nan("");

  EXPECT_EQ(RefusalOf(crossed),
            "configuration of 'arm': lower[3] is 1, which is not below upper[3] is "
            "-0.0698");
  EXPECT_EQ(RefusalOf(outside),
            "configuration of 'arm': home[0] is 3, expected -2.8973 to 2.8973 rad, the lower and "
            "the upper limit of this joint");
  EXPECT_EQ(RefusalOf(frozen),
            "configuration of 'arm': velocity[6] is 0, expected 0.001 to 1000 rad/s");
  EXPECT_EQ(RefusalOf(blurred), "configuration of 'arm': noise is nan, expected 0 to 1 rad");
}

TEST(SimulatedArmThread, RunsInRealTimeAndRestartsAtRest) {
  tendon::LocalManager manager;
  auto& arm = manager.Add<SimulatedArm>("arm");
  auto& client = manager.Add<ArmClient>("client");
  ASSERT_TRUE(manager.Connect({"client", "Robot"}, {"arm", "Control"}));
  ASSERT_TRUE(manager.StartAll());
  const auto speed = [&client] {
    JointState joints;
    return client.get_joints(joints) ? std::abs(joints.velocity[0]) : 0.0;
  };

  ASSERT_TRUE(client.move_to({kGoal, 3.0}));
  ASSERT_TRUE(EventuallyTrue([&] { return speed() > 0.05; }));
  ASSERT_TRUE(manager.Stop("arm"));
  const std::uint64_t rows = arm.tables().front()->next_tick();
  ASSERT_TRUE(manager.Start("arm"));

  ASSERT_TRUE(EventuallyTrue([&] { return arm.tables().front()->next_tick() > rows; }));
  EXPECT_EQ(speed(), 0.0);
}

}  // namespace
}  // namespace arm
