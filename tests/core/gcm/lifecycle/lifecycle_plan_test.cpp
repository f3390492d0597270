#include <gtest/gtest.h>
#include <tendon/gcm/lifecycle/lifecycle_plan.h>
#include <tendon/process/lifecycle/configuration_base.h>
#include <tests/core/gcm/samples.h>

namespace tendon {
namespace {

using Kind = CatalogueChange::Kind;
using message::HistoryEntry;
using message::LifecycleOrder;

/// Process robot has an active arm that was created from a class. Process desk has a constructed
/// component that was not created from a class.
class LifecyclePlan : public testing::Test {
 protected:
  LifecyclePlan() {
    ComponentDescription own = test::Teleoperation("own");
    own.class_name.clear();
    own.state = ComponentState::kConstructed;
    Apply("desk", {.kind = Kind::kProcess, .processes = {test::ProcessNamed("desk", 1)}});
    Apply("desk", {.kind = Kind::kComponent, .components = {own}});
    Apply("robot", {.kind = Kind::kProcess, .processes = {test::ProcessNamed("robot", 2)}});
    Apply("robot", {.kind = Kind::kComponent, .components = {test::Arm()}});
  }

  void Apply(const std::string& process, CatalogueChange change) {
    change.process = process;
    change.revision = catalogue_.revision() + 1;
    ASSERT_TRUE(catalogue_.Apply(change));
  }
  void SetState(ComponentState state) {
    ComponentDescription arm = test::Arm();
    arm.state = state;
    Apply("robot", {.kind = Kind::kComponent, .components = {arm}});
  }

  /// Returns the message of a dry run; empty if the order is possible.
  [[nodiscard]] std::string Refusal(const LifecycleOrder& order) const {
    const auto checked = CheckLifecycleOrder(catalogue_, order);
    return checked ? "" : checked.error().message;
  }
  [[nodiscard]] std::string Found(const std::string& pattern) const {
    const auto found = LookUpComponents(catalogue_, pattern);
    if (!found) return found.error().message;
    std::string all;
    for (const Path& path : *found) all += (all.empty() ? "" : " ") + ToString(path);
    return all;
  }
  /// Returns the verbs that undo a step of the arm. `before` is the state of the arm before the
  /// step.
  static std::string Unmaking(LifecycleVerb verb, ComponentState before) {
    const HistoryEntry step{.verb = std::string(ToString(verb)),
                            .lifecycle = {.process = "robot", .component = "arm", .state = before}};
    const UndoPlan plan = PlanUndo(step, std::chrono::seconds(1));
    std::vector<LifecycleOrder> orders = plan.first;
    orders.insert(orders.end(), plan.then.begin(), plan.then.end());
    std::string verbs;
    for (const LifecycleOrder& order : orders) {
      EXPECT_EQ(order.component, "arm");
      verbs += (verbs.empty() ? "" : " ") + std::string(ToString(order.verb));
    }
    return verbs;
  }

  [[nodiscard]] HistoryEntry StepOfArm(const std::string& verb) const {
    const auto* arm = catalogue_.FindComponent("robot", "arm");
    return {.verb = verb,
            .lifecycle = {.process = "robot",
                          .component = "arm",
                          .class_name = arm->class_name,
                          .library = arm->library}};
  }

  Catalogue catalogue_;
};

TEST_F(LifecyclePlan, AGlobMatchesComponentsOfPresentProcesses) {
  EXPECT_EQ(Found("robot/arm"), "robot/arm");
  EXPECT_EQ(Found("**"), "desk/own robot/arm");
  EXPECT_EQ(Found("*/a*"), "robot/arm");
  EXPECT_EQ(Found("robot/arn"), "no component 'robot/arn'; did you mean 'arm'?");
  EXPECT_EQ(Found("robot"),
            "'robot' does not name a component: expected process/component, or a pattern such as "
            "process/*");
  EXPECT_EQ(Found("robot/x*"), "no component matches 'robot/x*'; to list all names: gcm ls -R");

  ProcessDescription robot = test::ProcessNamed("robot", 2);
  robot.state = ProcessState::kLost;
  Apply("robot", {.kind = Kind::kProcess, .processes = {robot}});
  EXPECT_EQ(Found("**"), "desk/own");
}

TEST_F(LifecyclePlan, OneComponentIsFoundOnlyIfNoOtherMatches) {
  const auto one = LookUpOneComponent(catalogue_, "*/a*");
  ASSERT_TRUE(one) << one.error().message;
  EXPECT_EQ(ToString(*one), "robot/arm");

  const auto several = LookUpOneComponent(catalogue_, "**");
  ASSERT_FALSE(several);
  EXPECT_EQ(several.error().code, ErrorCode::kInvalid);
  EXPECT_EQ(several.error().message, "'**' matches 2 components; give one component");

  const auto none = LookUpOneComponent(catalogue_, "robot/arn");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().message, "no component 'robot/arn'; did you mean 'arm'?");
}

TEST_F(LifecyclePlan, ADryRunReportsTheRefusalOfTheProcess) {
  const LifecycleOrder arm{.process = "robot", .component = "arm"};
  const auto of = [](LifecycleOrder order, LifecycleVerb verb) {
    order.verb = verb;
    return order;
  };
  EXPECT_EQ(Refusal(of(arm, LifecycleVerb::kStart)),
            "component 'arm' is active already; to start it again, stop it first");
  EXPECT_EQ(Refusal(of(arm, LifecycleVerb::kConfigure)),
            "component 'arm' is active; stop it first to configure it again");
  for (const LifecycleVerb verb : {LifecycleVerb::kStop, LifecycleVerb::kSuspend,
                                   LifecycleVerb::kRestart, LifecycleVerb::kRemove}) {
    EXPECT_EQ(Refusal(of(arm, verb)), "");
  }
  EXPECT_EQ(Refusal(of(arm, LifecycleVerb::kCreate)),
            "component 'arm' already exists in process 'robot'");
  EXPECT_EQ(
      Refusal({.verb = LifecycleVerb::kRemove, .process = "desk", .component = "own"}),
      "component 'own' was created by the program of process 'desk' itself, not from a class");
  EXPECT_EQ(Refusal({.process = "robbot", .component = "arm"}),
            "no process 'robbot'; did you mean 'robot'?");
}

TEST_F(LifecyclePlan, AStepIsUndoneByItsOpposite) {
  using enum ComponentState;
  EXPECT_EQ(Unmaking(LifecycleVerb::kCreate, kConstructed), "remove");
  EXPECT_EQ(Unmaking(LifecycleVerb::kRemove, kFinished), "create");
  EXPECT_EQ(Unmaking(LifecycleVerb::kRemove, kActive), "create start");
  EXPECT_EQ(Unmaking(LifecycleVerb::kRemove, kSuspended), "create start suspend");
  EXPECT_EQ(Unmaking(LifecycleVerb::kStart, kReady), "stop");
  EXPECT_EQ(Unmaking(LifecycleVerb::kStart, kSuspended), "suspend");
  EXPECT_EQ(Unmaking(LifecycleVerb::kSuspend, kActive), "start");
  EXPECT_EQ(Unmaking(LifecycleVerb::kStop, kActive), "start");
  EXPECT_EQ(Unmaking(LifecycleVerb::kStop, kSuspended), "start suspend");
  EXPECT_EQ(Unmaking(LifecycleVerb::kConfigure, kFinished), "configure");
}

TEST_F(LifecyclePlan, UndoingAStopRestartsItsFollowers) {
  const auto follow = [&](const std::string& name, const std::string& leader,
                          ComponentState state) {
    ComponentDescription one = test::Arm();
    one.name = name;
    one.leader = leader;
    one.state = state;
    Apply("robot", {.kind = Kind::kComponent, .components = {one}});
  };
  follow("brush", "gripper", ComponentState::kSuspended);
  follow("gripper", "arm", ComponentState::kSuspended);
  follow("camera", "arm", ComponentState::kActive);
  follow("lamp", "arm", ComponentState::kFinished);
  follow("other", "", ComponentState::kActive);
  HistoryEntry step = StepOfArm("stop");
  step.lifecycle =
      StepOf(catalogue_, {.verb = LifecycleVerb::kStop, .process = "robot", .component = "arm"});
  AddOutcome({.state = ComponentState::kActive}, step);

  std::string orders;
  for (const LifecycleOrder& order : PlanUndo(step, std::chrono::seconds(1)).then) {
    orders += std::string(ToString(order.verb)) + " " + order.component + "; ";
  }

  EXPECT_EQ(orders, "start arm; start camera; start gripper; start brush; suspend gripper; ");
}

TEST_F(LifecyclePlan, UndoingAStopOfAnOldJournalStartsOnlyIt) {
  SetState(ComponentState::kFinished);
  HistoryEntry step = StepOfArm("stop");
  step.lifecycle.state = ComponentState::kActive;
  for (const std::string former : {"", R"({"noise":1})", "[]", "[7]", "[[]]", "nonsense"}) {
    step.lifecycle.former = former;

    EXPECT_TRUE(CheckUndo(catalogue_, step)) << former;
    const auto orders = PlanUndo(step, std::chrono::seconds(1)).then;
    ASSERT_EQ(orders.size(), 1U) << former;
    EXPECT_EQ(orders[0].verb, LifecycleVerb::kStart);
    EXPECT_EQ(orders[0].component, "arm");
  }
}

TEST_F(LifecyclePlan, AnOrderIsAnsweredWithinTheRemainingTime) {
  using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
  EXPECT_EQ(TimeoutWithin(1s, 1min), 1s);
  EXPECT_EQ(TimeoutWithin(1s, 1500ms), 1s);
  EXPECT_EQ(TimeoutWithin(1s, 600ms), 400ms);
  EXPECT_EQ(TimeoutWithin(1s, 1ms), std::nullopt);
  EXPECT_EQ(TimeoutWithin(1s, -1s), std::nullopt);
}

TEST_F(LifecyclePlan, AnUndoIsRefusedIfTheComponentHasChanged) {
  HistoryEntry step = StepOfArm("start");
  const auto refusal = [&] {
    const auto checked = CheckUndo(catalogue_, step);
    return checked ? "" : checked.error().message;
  };
  EXPECT_EQ(refusal(), "");
  SetState(ComponentState::kFaulted);
  EXPECT_EQ(refusal(), "robot/arm is faulted now");

  step.verb = "create";
  step.lifecycle.class_name = "OtherArm";
  EXPECT_EQ(refusal(), "robot/arm is of class SimulatedArm now");
  step.lifecycle.class_name = "SimulatedArm";
  EXPECT_EQ(refusal(), "");
  step.verb = "remove";
  EXPECT_EQ(refusal(), "robot/arm exists again");
  step.verb = "create";
  step.lifecycle.component = "other";
  EXPECT_EQ(refusal(), "robot/other no longer exists");
}

TEST_F(LifecyclePlan, UndoingAnUnconfirmedStepRequiresItsEffect) {
  HistoryEntry step = StepOfArm("start");
  step.lifecycle.state = ComponentState::kActive;
  EXPECT_TRUE(CheckUndo(catalogue_, step));
  step.is_unknown = true;

  EXPECT_EQ(CheckUndo(catalogue_, step).error().message, "robot/arm was active before");
}

TEST_F(LifecyclePlan, ARestartIsAStepOnlyIfItStarts) {
  const LifecycleOrder restart{
      .verb = LifecycleVerb::kRestart, .process = "robot", .component = "arm"};
  for (const ComponentState resting : {ComponentState::kReady, ComponentState::kSuspended,
                                       ComponentState::kFinished, ComponentState::kFaulted}) {
    SetState(resting);
    EXPECT_EQ(StepOf(catalogue_, restart).state, resting);
    EXPECT_EQ(StepOf(catalogue_, restart).component, "arm");
  }
  EXPECT_EQ(StepVerbOf(restart), "start");

  HistoryEntry step = StepOfArm(StepVerbOf(restart));
  step.lifecycle.state = ComponentState::kSuspended;
  EXPECT_FALSE(LeavesAsItWas(step));
  step.lifecycle.state = ComponentState::kActive;
  EXPECT_TRUE(LeavesAsItWas(step));
}

TEST_F(LifecyclePlan, AnUndoIsRefusedIfTheConfigurationDiffers) {
  SetState(ComponentState::kFinished);
  HistoryEntry step = StepOfArm("configure");
  EXPECT_TRUE(CheckUndo(catalogue_, step));
  step.lifecycle.configuration = "{}";

  EXPECT_EQ(CheckUndo(catalogue_, step).error().message, "robot/arm has another configuration now");
}

TEST_F(LifecyclePlan, RevertsAConfigurationOnlyFromTheStepsResult) {
  HistoryEntry step = StepOfArm("configure");
  step.lifecycle.configuration = R"({"noise":0})";
  step.lifecycle.former = R"({"noise":1})";

  const UndoPlan plan = PlanUndo(step, std::chrono::seconds(1));

  ASSERT_EQ(plan.first.size(), 1U);
  EXPECT_EQ(plan.first[0].configuration, R"({"noise":1})");
  EXPECT_EQ(plan.first[0].based_on, BaseOf(R"({"noise":0})"));
}

}  // namespace
}  // namespace tendon
