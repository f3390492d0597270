#include <tendon/gcm/lookup.h>
#include <tendon/gcm/system/client_executor.h>
#include <tendon/gcm/system/comparison.h>
#include <tendon/gcm/system/running_system.h>
#include <tendon/payload/json.h>

#include "core/process/lifecycle/lifecycle_fixture.h"

namespace {

using tendon::LifecycleVerb;
using tendon::SystemFile;

/// A component that continues to run when it is told to suspend.
class Restless final : public tendon::Component {
 public:
  using Component::Component;

 private:
  void Pause() override {}
};

/// Applies system files to existing processes.
class LifecycleApply : public LifecycleFixture {
 protected:
  tendon::PlanOutcome Apply(const SystemFile& wanted) {
    const tendon::Plan plan = MakePlan(gcm().catalogue(), wanted);
    EXPECT_THAT(plan.obstacles, testing::IsEmpty());
    tendon::ClientExecutor executor(*client_, kLong);
    return ExecutePlan(plan, executor, tendon::AfterError::kStop,
                       [](std::size_t, const tendon::PlanStep& step, const auto& outcome) {
                         EXPECT_EQ(outcome.state, tendon::StepOutcome::State::kDone)
                             << ToString(step) << ": " << outcome.reason;
                       });
  }
  /// Returns the saved system as it would be read from a file.
  SystemFile Saved() {
    const auto text = SystemFileText(SystemOf(gcm().catalogue(), "lamps").file);
    EXPECT_TRUE(text);
    const auto file = tendon::ParseSystemFile(*text, "saved");
    EXPECT_TRUE(file) << file.error().message;
    return file ? *file : SystemFile();
  }
  void ExpectRuns(const SystemFile& wanted) {
    const auto comparison = CompareSystems(wanted, SystemOf(gcm().catalogue(), "").file,
                                           tendon::StartComparison::kIgnore);
    for (const auto& one : comparison.differences) ADD_FAILURE() << one.what << ": " << one.how;
  }
  /// Creates a lamp and its switch, a suspended component, and one that was never started.
  void MakeLamps() {
    ASSERT_EQ(Reason(Create("Lamp", "lamp", R"({"brightness":0.7})")), "");
    ASSERT_EQ(Reason(Create("Lamp", "night")), "");
    ASSERT_EQ(Reason(Create("Lamp", "spare")), "");
    ASSERT_EQ(Reason(Create("Switch", "switch")), "");
    const auto connected = tendon::Wait<tendon::ConnectionDescription>(kLong, [&](auto handler) {
      client_->Connect({"robot", "switch", "Lamp"}, {"robot", "lamp", "Control"}, handler);
    });
    ASSERT_TRUE(connected) << connected.error().message;
    for (const std::string name : {"lamp", "night", "switch"}) {
      ASSERT_EQ(Reason(Order(LifecycleVerb::kStart, name)), "");
    }
    ASSERT_EQ(Reason(Order(LifecycleVerb::kSuspend, "night")), "");
  }
  void RestartEmpty() {
    tendon::ProcessOptions options = Options();
    options.loader = LoaderOfLamps();
    robot_.reset();
    robot_ = std::make_unique<tendon::Process>("robot", options);
    ASSERT_TRUE(robot_->WaitUntilJoined(kLong).ok());
    ASSERT_TRUE(EventuallyTrue([&] {  // wait until the client has received the change, too
      const tendon::Catalogue known = client_->catalogue();
      const tendon::Catalogue now = gcm().catalogue();
      return InstanceOf(known, "robot") == InstanceOf(now, "robot");
    }));
  }
};

INSTANTIATE_TEST_SUITE_P(Over, LifecycleApply, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

TEST_P(LifecycleApply, RestoresASavedSystemInAnEmptyProcess) {
  MakeLamps();
  const tendon::Fingerprint before = gcm().catalogue().ContentHash();
  const SystemFile saved = Saved();
  RestartEmpty();
  ASSERT_TRUE(robot_->components().empty());

  const tendon::PlanOutcome applied = Apply(saved);

  EXPECT_EQ(applied.failed, 0U);
  EXPECT_EQ(gcm().catalogue().ContentHash(), before);
  ExpectRuns(saved);
  EXPECT_EQ(Apply(saved), tendon::PlanOutcome());  // no step is left
}

TEST_P(LifecycleApply, RestoresThreadsAndLeaders) {
  MakeLamps();
  tendon::message::LifecycleOrder follower{.verb = LifecycleVerb::kCreate,
                                           .process = "robot",
                                           .component = "a-follower",
                                           .class_name = "Lamp",
                                           .library = "lamps",
                                           .leader = "lamp"};
  follower.thread = ToJson(tendon::ThreadOptions{.spin = std::chrono::microseconds(20)});
  ASSERT_EQ(Reason(Execute(*client_, follower)), "");
  ASSERT_EQ(Reason(Order(LifecycleVerb::kStart, "a-follower")), "");
  const tendon::Fingerprint before = gcm().catalogue().ContentHash();
  const SystemFile saved = Saved();
  EXPECT_EQ(saved.FindComponent("robot", "a-follower")->runs_after, "lamp");
  RestartEmpty();

  EXPECT_EQ(Apply(saved).failed, 0U);

  EXPECT_EQ(gcm().catalogue().ContentHash(), before);
  EXPECT_EQ(robot_->SettingsOf("a-follower")->leader, "lamp");
  EXPECT_EQ(robot_->SettingsOf("a-follower")->thread->spin, std::chrono::microseconds(20));
  EXPECT_EQ(Apply(saved), tendon::PlanOutcome());

  SystemFile other = saved;  // the leader and its followers are created again
  for (auto& component : other.processes[0].components) {
    if (component.name == "lamp") component.configuration = R"({"brightness":0.2})";
  }
  EXPECT_EQ(Apply(other).failed, 0U);
  EXPECT_EQ(robot_->SettingsOf("a-follower")->leader, "lamp");
  ExpectRuns(other);
  EXPECT_EQ(Apply(saved).failed, 0U);
  EXPECT_EQ(gcm().catalogue().ContentHash(), before);
}

TEST_P(LifecycleApply, ReconfiguringKeepsTheConnections) {
  MakeLamps();
  SystemFile wanted = Saved();
  for (auto& component : wanted.processes[0].components) {
    if (component.name == "lamp") component.configuration = R"({"brightness":0.1})";
    if (component.name == "switch") component.state = tendon::ComponentState::kFinished;
  }
  std::erase_if(wanted.processes[0].components,
                [](const auto& component) { return component.name == "spare"; });

  EXPECT_EQ(Apply(wanted).failed, 0U);

  ExpectRuns(wanted);
  EXPECT_EQ(Known("lamp").configuration, R"({"brightness":0.1})");
  EXPECT_EQ(Known("spare").name, "");
}

TEST_P(LifecycleApply, StopsAComponentThatCannotBeSuspended) {
  robot_->Add<Restless>("arm");
  ASSERT_TRUE(EventuallyTrue([&] { return Known("arm").name == "arm"; }));
  SystemFile wanted = Saved();
  wanted.processes[0].components[0].state = tendon::ComponentState::kSuspended;
  const tendon::Plan plan = MakePlan(gcm().catalogue(), wanted);
  ASSERT_EQ(plan.steps.size(), 1U);
  constexpr std::chrono::milliseconds kSoon(2000);  // the wait is expected to time out
  tendon::GcmClient client(NewMiddleware(),
                           {.name = "test", .address = gcm().address(), .timeout = kSoon});
  ASSERT_TRUE(client.WaitUntilWatching());
  tendon::ClientExecutor executor(client, kSoon);

  const auto made = executor.Execute(plan.steps[0]);

  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message, testing::StartsWith("the component could not be suspended: "));
  EXPECT_THAT(made.error().message, testing::EndsWith("; it was stopped instead"));
  EXPECT_EQ(robot_->Find("arm")->state(), tendon::ComponentState::kFinished);
}

TEST_P(LifecycleApply, RefusesAStepForARestartedProcess) {
  MakeLamps();
  SystemFile wanted = Saved();
  RestartEmpty();
  const tendon::Plan plan = MakePlan(gcm().catalogue(), wanted);
  ASSERT_FALSE(plan.steps.empty());
  RestartEmpty();
  tendon::ClientExecutor executor(*client_, kLong);

  const auto made = executor.Execute(plan.steps[0]);

  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message, testing::HasSubstr("process 'robot' was restarted"));
  EXPECT_TRUE(robot_->components().empty());
}

TEST_P(LifecycleApply, RefusesAStepForAChangedConfiguration) {
  ASSERT_EQ(Reason(Create("Lamp", "lamp", R"({"brightness":0.7})")), "");
  SystemFile wanted = Saved();
  wanted.processes[0].components[0].configuration = R"({"brightness":0.1})";
  const tendon::Plan plan = MakePlan(gcm().catalogue(), wanted);
  ASSERT_EQ(plan.steps.size(), 1U);
  ASSERT_EQ(Reason(Configure("lamp", R"({"brightness":0.3})")), "");
  tendon::ClientExecutor executor(*client_, kLong);

  const auto made = executor.Execute(plan.steps[0]);

  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message,
              testing::StartsWith("the configuration of robot/lamp was changed meanwhile by test"));
  EXPECT_EQ(Known("lamp").configuration, R"({"brightness":0.3})");
  EXPECT_EQ(Apply(wanted).failed, 0U);  // after a new plan
  EXPECT_EQ(Known("lamp").configuration, R"({"brightness":0.1})");
}

TEST_P(LifecycleApply, AnAppliedPlanCanBeUndoneStepByStep) {
  MakeLamps();
  const SystemFile saved = Saved();
  const tendon::Fingerprint before = gcm().catalogue().ContentHash();
  SystemFile wanted = saved;
  wanted.connections.clear();
  wanted.processes[0].components[0].state = tendon::ComponentState::kSuspended;
  wanted.processes[0].components.push_back({"extra", "Lamp", "lamps", R"({"brightness":0.2})"});
  const tendon::PlanOutcome applied = Apply(wanted);
  ASSERT_EQ(applied.failed, 0U);

  for (std::size_t i = 0; i < applied.done; ++i) {
    const auto undone = tendon::Wait<tendon::message::HistoryEntry>(
        2 * kLong, [&](auto handler) { client_->Undo(handler); });
    ASSERT_TRUE(undone) << undone.error().message;
  }

  ExpectRuns(saved);
  EXPECT_EQ(gcm().catalogue().ContentHash(), before);
}

}  // namespace
