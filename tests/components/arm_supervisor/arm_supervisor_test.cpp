#include <components/arm_supervisor/arm_supervisor.h>
#include <components/simulated_arm/simulated_arm.h>
#include <gtest/gtest.h>
#include <support/allocation_guard.h>
#include <tendon/manager/local_manager.h>

#include "components/arm_client.h"
#include "components/stepped.h"

namespace arm {
namespace {

using tendon_test::ArmClient;
using tendon_test::Stepped;

/// An arm, a component that moves the arm, and the supervisor that watches the arm.
struct Watched {
  Watched() { EXPECT_TRUE(manager.StartAll()); }
  void Connect() {
    EXPECT_TRUE(manager.Connect({"client", "Robot"}, {"arm", "Control"}));
    EXPECT_TRUE(manager.Connect({"supervisor", "Robot"}, {"arm", "Control"}));
  }
  void Run(int cycles) {
    for (int i = 0; i < cycles; ++i) {
      arm.Cycle(20);
      supervisor.Cycle();
    }
  }

  tendon::LocalManager manager;
  Stepped<SimulatedArm>& arm = manager.Add<Stepped<SimulatedArm>>("arm");
  ArmClient& client = manager.Add<ArmClient>("client");
  Stepped<ArmSupervisor>& supervisor = manager.Add<Stepped<ArmSupervisor>>("supervisor");
};

TEST(ArmSupervisor, ReadsZerosUntilConnected) {
  Watched watched;

  watched.Run(5);

  EXPECT_EQ(watched.supervisor.Read<Activity>("Activity").energy, 0.0);
}

TEST(ArmSupervisor, MeasuresTheMotionOfTheArm) {
  Watched watched;
  watched.Connect();
  JointVector posture = kReadyPosture;
  posture[0] += 1.0;

  EXPECT_TRUE(watched.client.move_to({posture, 2.0}));
  watched.Run(50);  // in the middle of a minimum-jerk motion, the velocity is 15/8 of the mean

  const auto activity = watched.supervisor.Read<Activity>("Activity");
  EXPECT_NEAR(activity.speed, 15.0 / 8.0 * 0.5, 0.01);
  EXPECT_NEAR(activity.energy, 0.5 * 1.2 * activity.speed * activity.speed, 0.01);
}

TEST(ArmSupervisor, ReadsTheFlangePose) {
  Watched watched;
  watched.Connect();

  watched.Run(1);

  EXPECT_NEAR(watched.supervisor.Read<Pose>("Flange").position.x, 0.306891, 1e-6);
}

TEST(ArmSupervisor, CountsGoalsAndLimits) {
  Watched watched;
  watched.Connect();
  JointVector beyond = kReadyPosture;
  beyond[6] = 4.0;

  EXPECT_TRUE(watched.client.move_to({kReadyPosture, 0.2}));
  watched.Run(50);
  EXPECT_TRUE(watched.client.move_to({beyond, 1.0}));
  watched.Run(300);

  const auto events = watched.supervisor.Read<EventCounts>("Events");
  EXPECT_EQ(events.goals, 1U);
  EXPECT_EQ(events.limits, 1U);
}

TEST(ArmSupervisor, ACycleAllocatesNothing) {
  Watched watched;
  watched.Connect();
  watched.Run(2);

  const tendon::AllocationGuard guard;
  watched.Run(50);
}

}  // namespace
}  // namespace arm
