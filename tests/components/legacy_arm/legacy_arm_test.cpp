#include <components/legacy_arm/legacy_arm.h>
#include <components/teleoperation/teleoperation.h>
#include <gtest/gtest.h>
#include <tendon/interface/function.h>
#include <tendon/manager/local_manager.h>

#include <vector>

#include "components/stepped.h"

namespace legacy {
namespace {

using tendon_test::Stepped;

/// A client that also uses degrees.
class LegacyClient : public tendon::Component {
 public:
  explicit LegacyClient(std::string name) : Component(std::move(name)) {
    auto& robot = AddRequiredInterface("Robot");
    robot.AddFunction(move_to, "MoveTo");
    robot.AddFunction(stop, "Stop");
    robot.AddFunction(get_joints, "GetJoints");
    robot.AddEventHandlerWrite(&LegacyClient::OnLimitExceeded, this, "LimitExceeded");
  }

  tendon::WriteFunction<JointGoal> move_to;
  tendon::VoidFunction stop;
  tendon::ReadFunction<JointState> get_joints;
  std::vector<LimitFault> faults;

 private:
  void OnLimitExceeded(const LimitFault& fault) { faults.push_back(fault); }
};

struct Pair {
  Pair() {
    EXPECT_TRUE(manager.Connect({"client", "Robot"}, {"arm", "Control"}));
    EXPECT_TRUE(manager.StartAll());
  }
  JointState Joints() {
    JointState joints;
    EXPECT_TRUE(client.get_joints(joints));
    return joints;
  }

  tendon::LocalManager manager;
  Stepped<LegacyArm>& arm = manager.Add<Stepped<LegacyArm>>("arm");
  LegacyClient& client = manager.Add<LegacyClient>("client");
};

TEST(LegacyArm, RefusesATeleoperationWithEveryReason) {
  tendon::LocalManager manager;
  manager.Add<LegacyArm>("old_arm");
  manager.Add<arm::Teleoperation>("teleoperation");

  const auto connected = manager.Connect({"teleoperation", "Robot"}, {"old_arm", "Control"});

  ASSERT_FALSE(connected);
  EXPECT_EQ(connected.error().code, tendon::ErrorCode::kIncompatible);
  EXPECT_EQ(connected.error().message,
            "teleoperation/Robot does not fit old_arm/Control: "
            "needs write command 'MoveTo' of arm.JointGoal, but the provider offers another "
            "arm.JointGoal "
            "(position of arm.JointGoal: float64[7] in rad needed, float64[7] in deg offered); "
            "needs read command 'GetJoints' of arm.JointState, but the provider offers another "
            "arm.JointState "
            "(position of arm.JointState: float64[7] in rad needed, float64[7] in deg offered); "
            "missing void event 'GoalReached'; "
            "needs write event 'LimitExceeded' of arm.LimitFault, but the provider offers another "
            "arm.LimitFault (position of arm.LimitFault: float64 in rad needed, float64 in deg "
            "offered)");
  EXPECT_TRUE(manager.connections().empty());
}

TEST(LegacyArm, MovesAtConstantSpeedInDegrees) {
  Pair pair;
  JointGoal goal{.position = {90.0, -30.0}, .duration = 3.0};

  EXPECT_TRUE(pair.client.move_to(goal));
  pair.arm.Cycle(150);

  EXPECT_NEAR(pair.Joints().position[0], 45.0, 1e-6);
  EXPECT_NEAR(pair.Joints().velocity[0], 30.0, 1e-6);
  EXPECT_NEAR(pair.Joints().position[1], -15.0, 1e-6);
  pair.arm.Cycle(160);
  EXPECT_NEAR(pair.Joints().position[0], 90.0, 1e-9);
  EXPECT_NEAR(pair.Joints().velocity[0], 0.0, 1e-9);
}

TEST(LegacyArm, RespectsItsVelocityLimit) {
  Pair pair;

  EXPECT_TRUE(pair.client.move_to({.position = {90.0}, .duration = 0.0}));
  pair.arm.Cycle(10);

  EXPECT_NEAR(pair.Joints().velocity[0], 60.0, 1e-6);
}

TEST(LegacyArm, StopHoldsTheCurrentPosition) {
  Pair pair;
  EXPECT_TRUE(pair.client.move_to({.position = {90.0}, .duration = 2.0}));
  pair.arm.Cycle(50);

  EXPECT_TRUE(pair.client.stop());
  pair.arm.Cycle(100);

  EXPECT_NEAR(pair.Joints().position[0], 22.5, 1e-6);
}

TEST(LegacyArm, ClampsAGoalAtTheLimitAndRaisesAFault) {
  Pair pair;

  EXPECT_TRUE(pair.client.move_to({.position = {0.0, 0.0, 500.0}, .duration = 1.0}));
  pair.arm.Cycle(400);

  ASSERT_EQ(pair.client.faults.size(), 1U);
  EXPECT_EQ(pair.client.faults[0].joint, 2);
  EXPECT_EQ(pair.client.faults[0].position, 500.0);
  EXPECT_EQ(pair.Joints().position[2], 120.0);
}

}  // namespace
}  // namespace legacy
