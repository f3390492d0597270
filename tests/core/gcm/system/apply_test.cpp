#include <gmock/gmock.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/system/client_executor.h>
#include <tendon/gcm/system/comparison.h>
#include <tendon/gcm/system/running_system.h>
#include <tests/core/gcm/gcm_fixture.h>

namespace tendon {
namespace {

using test::kControl;
using test::kRobot;
using test::Teleoperation;

class ApplyPlan : public test::DeskAndRobot {
 protected:
  /// Makes a plan for the file, and executes it.
  PlanOutcome Apply(const SystemFile& wanted) {
    ClientExecutor executor(*client_, kLong);
    return ExecutePlan(MakePlan(gcm_->catalogue(), wanted), executor, AfterError::kStop,
                       [](std::size_t, const PlanStep& step, const StepOutcome& outcome) {
                         EXPECT_EQ(outcome, StepOutcome()) << ToString(step) << outcome.reason;
                       });
  }
  [[nodiscard]] SystemFile Running() const { return SystemOf(gcm_->catalogue(), "x").file; }
  [[nodiscard]] std::vector<SystemDifference> DifferencesFrom(const SystemFile& wanted) const {
    return CompareSystems(wanted, Running(), StartComparison::kIgnore).differences;
  }
};

INSTANTIATE_TEST_SUITE_P(Over, ApplyPlan, testing::Values("loopback", "tcp"),
                         test::NameOfParameter);

TEST_P(ApplyPlan, AppliesConnectionsUntilNothingDiffers) {
  robot_->Add(test::Arm("spare"));
  ASSERT_TRUE(EventuallyTrue([&] { return gcm_->catalogue().FindComponent("robot", "spare"); }));
  const SystemFile bare = Running();
  SystemFile wired = bare;
  wired.connections.push_back({kRobot, kControl});
  SystemFile rewired = bare;
  rewired.connections.push_back({kRobot, {"robot", "spare", "Control"}});

  for (const SystemFile& wanted : {wired, rewired, bare}) {
    EXPECT_EQ(Apply(wanted).done, 1U);

    EXPECT_THAT(DifferencesFrom(wanted), testing::IsEmpty());
    EXPECT_EQ(Apply(wanted), PlanOutcome());  // no step is left
  }

  const auto steps = Steps(*client_);
  ASSERT_EQ(steps.size(), 3U);
  EXPECT_EQ(steps[1].verb, "replace");
  for (std::size_t i = 0; i < steps.size(); ++i) ASSERT_TRUE(Undo(*client_));
  EXPECT_THAT(DifferencesFrom(bare), testing::IsEmpty());
}

TEST_P(ApplyPlan, RefusesAStepForARestartedProcess) {
  SystemFile wanted = Running();
  wanted.connections.push_back({kRobot, kControl});
  const Plan plan = MakePlan(client_->catalogue(), wanted);
  ASSERT_EQ(plan.steps.size(), 1U);
  desk_.reset();
  desk_ = Join("desk", {Teleoperation()});
  const std::uint64_t instance = desk_->description().instance;
  ASSERT_TRUE(EventuallyTrue([&] { return InstanceOf(client_->catalogue(), "desk") == instance; }));
  ClientExecutor executor(*client_, kLong);

  const auto made = executor.Execute(plan.steps[0]);

  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().message,
            "process 'desk' was restarted or has ended since the plan was made; make another "
            "plan");
  EXPECT_TRUE(desk_->orders().empty());
}

TEST_P(ApplyPlan, StartsNothingThatLacksAConnection) {
  PlanStep step{.kind = PlanStep::Kind::kStart, .process = "desk", .needs = {{kRobot, kControl}}};
  step.component.name = "teleoperation";
  ClientExecutor executor(*client_, std::chrono::seconds(1));

  const auto alone = executor.Execute(step);
  ASSERT_FALSE(alone);
  EXPECT_EQ(alone.error().message,
            "not started, because desk/teleoperation/Robot is not connected to robot/arm/Control");

  desk_->set_manners(test::FakeProcess::Manners::kMissTheNextProvider);
  ASSERT_TRUE(Connect(*client_));
  const auto pending = executor.Execute(step);
  ASSERT_FALSE(pending);
  EXPECT_EQ(pending.error().message,
            "not started, because desk/teleoperation/Robot is not connected to robot/arm/Control: "
            "nobody answers");
}

}  // namespace
}  // namespace tendon
