#include <tendon/payload/json.h>
#include <tests/core/gcm/supervisor/supervisor_fixture.h>

namespace tendon::server {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using testing::HasSubstr;

TEST_F(SupervisorTest, ChecksTheLogOfARunningProcessEachSecond) {
  Run(RestartPolicy::kNever);
  const std::size_t before = launcher_->shortened().size();

  clock_.Advance(1s);
  EXPECT_TRUE(Comes([&] { return launcher_->shortened().size() == before + 1; }));
  Tick();
  Tick();
  clock_.Advance(1s);
  EXPECT_TRUE(Comes([&] { return launcher_->shortened().size() == before + 2; }));
  EXPECT_EQ(launcher_->shortened().back(), "robot");
}

TEST_F(SupervisorTest, AStartCompletesWhenTheProcessJoins) {
  const auto reply = Order(ProcessVerb::kStart);
  ASSERT_TRUE(Comes([this] { return launcher_->starts() == 1; }));
  EXPECT_FALSE(launcher_->order().system);
  EXPECT_EQ(launcher_->order().timeout, 5s);
  EXPECT_FALSE(reply->is_here);

  Join();

  EXPECT_TRUE(IsAnswered(reply));
  EXPECT_EQ(reply->text, "");
  ASSERT_EQ(history_.steps().entries.size(), 1U);
  EXPECT_EQ(ToString(history_.steps().entries[0]), "start robot");
  EXPECT_EQ(history_.steps().entries[0].who, "test");
}

TEST_F(SupervisorTest, ANamesakeIsNotTakenForTheStartedProcess) {
  const auto reply = Order(ProcessVerb::kStart);
  ASSERT_TRUE(Comes([this] { return launcher_->starts() == 1; }));
  Locked([this] {
    ASSERT_TRUE(registry_.Join({test::ProcessNamed("robot", 9), {}, {}}, 0, nullptr));
    launcher_->process()->end = {true, "ended with exit code 1"};
  });

  ASSERT_TRUE(IsAnswered(reply));
  EXPECT_EQ(reply->text,
            "process 'robot' ended with exit code 1 before it had joined; its last output: alas; "
            "its log: "
            "robot.log");
  EXPECT_THAT(history_.steps().entries, testing::IsEmpty());
}

TEST_F(SupervisorTest, ReportsProcessesThatCannotBeStarted) {
  launcher_->refusal = "no such program";
  const auto reply = Order(ProcessVerb::kStart);
  ASSERT_TRUE(IsAnswered(reply));
  EXPECT_EQ(reply->text, "no such program");

  Locked([this] {
    launcher_->refusal = "";
    ASSERT_TRUE(registry_.Join({test::ProcessNamed("robot", 9), {}, {}}, 0, nullptr));
  });
  const auto taken = Order(ProcessVerb::kStart);
  EXPECT_THAT(TextOf(taken), testing::StartsWith("process 'robot' is already running: host "));
  const auto alien = Order(ProcessVerb::kKill);
  EXPECT_THAT(TextOf(alien),
              HasSubstr("was not started by this GCM: end the process where it was started"));
}

TEST_F(SupervisorTest, EndsAProcessThatNeverJoins) {
  const auto reply = Order(ProcessVerb::kStart);
  ASSERT_TRUE(Comes([this] { return launcher_->starts() == 1; }));
  ASSERT_TRUE(Comes([this] {
    clock_.Advance(1s);
    return launcher_->process()->terminated;
  }));
  EXPECT_FALSE(reply->is_here);
  EXPECT_FALSE(launcher_->process()->killed);
  EXPECT_THAT(TextOf(Order(ProcessVerb::kStart)), HasSubstr("was already started as pid 1"));

  clock_.Advance(2s);
  Tick();
  EXPECT_TRUE(launcher_->process()->killed);
  Locked([this] { launcher_->process()->end = kKilled; });

  ASSERT_TRUE(IsAnswered(reply));
  EXPECT_EQ(reply->text,
            "process 'robot' has not joined within 5000 ms, so the GCM has ended it; its last "
            "output: alas; its log: robot.log");
}

TEST_F(SupervisorTest, RestartsAFailedProcessWithItsComponents) {
  Run(RestartPolicy::kOnFailure);
  ThreadOptions thread;
  thread.lock_memory = true;
  ComponentDescription made = test::Arm();
  made.thread = {thread};
  ComponentDescription follower = test::Arm("filter");
  follower.thread = {ThreadOptions()};
  follower.leader = "arm";
  Locked([&] {
    supervisor_.NoteChange("robot");
    ASSERT_TRUE(registry_.Report(
        session_, {{{.kind = CatalogueChange::Kind::kComponent, .components = {made}},
                    {.kind = CatalogueChange::Kind::kComponent, .components = {follower}}}}));
  });

  End(kKilled);

  ASSERT_TRUE(Comes([this] { return ReasonNow().find("SIGKILL") != std::string::npos; }));
  EXPECT_EQ(Reason(), "was ended by SIGKILL; its log: robot.log; it is restarted in 500 ms");
  clock_.Advance(499ms);
  Tick();
  EXPECT_EQ(launcher_->starts(), 1U);
  clock_.Advance(1ms);
  ASSERT_TRUE(Comes([this] { return launcher_->starts() == 2; }));
  const auto system = launcher_->order().system;
  ASSERT_TRUE(system);
  const auto* const arm = system->FindComponent("robot", "arm");
  ASSERT_NE(arm, nullptr);
  EXPECT_EQ(arm->class_name, "SimulatedArm");
  EXPECT_EQ(arm->state, ComponentState::kActive);
  EXPECT_EQ(arm->thread, thread);
  EXPECT_EQ(system->FindComponent("robot", "filter")->runs_after, "arm");
}

/// Otherwise a process that fails while its components start would return without running
/// components, or a stopped component would run again.
TEST_F(SupervisorTest, ARestartRestoresTheLastOrderedStates) {
  ComponentDescription resting = test::Arm();
  resting.state = ComponentState::kConstructed;
  const auto state = [this] {
    return launcher_->order().system->FindComponent("robot", "arm")->state;
  };
  Run(RestartPolicy::kOnFailure, {test::Arm()});
  FailOnce(500ms, {resting});  // its start has begun

  FailOnce(1s, {resting});
  EXPECT_EQ(state(), ComponentState::kActive);

  Locked([this] { supervisor_.NoteChange("robot"); });  // another program has stopped the component
  FailOnce(2s, {resting});
  EXPECT_EQ(state(), ComponentState::kConstructed);
}

TEST_F(SupervisorTest, GivesUpAfterRepeatedFailures) {
  Run(RestartPolicy::kOnFailure);
  for (const auto pause : {500ms, 1000ms, 2000ms, 4000ms}) FailOnce(pause, {});

  End(kKilled);

  ASSERT_TRUE(Comes([this] { return ReasonNow().find("not restarted") != std::string::npos; }));
  EXPECT_EQ(Reason(),
            "was ended by SIGKILL; its log: robot.log; it is not restarted, because it has failed "
            "5 times within a minute; to start it when the fault is repaired: gcm apply");
  clock_.Advance(1h);
  Tick();
  EXPECT_EQ(launcher_->starts(), 5U);
  (void)Order(ProcessVerb::kStart);
  EXPECT_TRUE(Comes([this] { return launcher_->starts() == 6; }));
}

TEST_F(SupervisorTest, DoesNotRestartAfterANormalEnd) {
  Run(RestartPolicy::kOnFailure);
  End({false, "ended with exit code 0"}, ProcessState::kLeft);
  ASSERT_TRUE(Comes([this] { return ReasonNow() == "ended with exit code 0 by itself"; }));

  const auto again = Order(ProcessVerb::kStart);
  ASSERT_TRUE(Comes([this] { return launcher_->starts() == 2; }));
  Join();
  ASSERT_TRUE(IsAnswered(again));
  const auto killed = Order(ProcessVerb::kKill);
  EXPECT_TRUE(launcher_->process()->terminated);
  EXPECT_EQ(TextOf(Order(ProcessVerb::kKill)), "process 'robot' is already being ended");
  clock_.Advance(5s);
  Tick();
  EXPECT_TRUE(launcher_->process()->killed);
  End(kKilled);
  ASSERT_TRUE(IsAnswered(killed));
  EXPECT_EQ(killed->text, "");

  clock_.Advance(1h);
  Tick();
  EXPECT_EQ(launcher_->starts(), 2U);
  EXPECT_EQ(TextOf(Order(ProcessVerb::kKill)), "process 'robot' is already gone");
}

TEST_F(SupervisorTest, DoesNotRestartUnderThePolicyNever) {
  Run(RestartPolicy::kNever);

  End(kKilled);

  EXPECT_TRUE(Comes([this] {
    return ReasonNow() ==
           "was ended by SIGKILL; its log: robot.log; it is not restarted (restart never)";
  }));
}

TEST_F(SupervisorTest, APendingRestartCanBeCancelled) {
  Run(RestartPolicy::kOnFailure);
  End(kKilled);
  ASSERT_TRUE(Comes([this] { return ReasonNow().find("restarted in") != std::string::npos; }));

  const auto reply = Order(ProcessVerb::kKill);

  EXPECT_EQ(TextOf(reply), "");
  clock_.Advance(1h);
  Tick();
  EXPECT_EQ(launcher_->starts(), 1U);
  EXPECT_EQ(Reason(), "was ended on request, and is not restarted");
}

TEST_F(SupervisorTest, AStartCanBeUndoneWhileTheProcessIsEmpty) {
  Run(RestartPolicy::kOnFailure, {test::Arm()});
  const auto step = history_.steps().entries.at(0);
  EXPECT_EQ(supervisor_.CheckUndo(step).error().message,
            "process 'robot' now has components, such as arm");
  Locked([this] {
    ASSERT_TRUE(registry_.Report(session_, {{{.kind = CatalogueChange::Kind::kComponentRemoved,
                                              .process = "robot",
                                              .component = "arm"}}}));
  });
  EXPECT_TRUE(supervisor_.CheckUndo(step));

  Locked([&] { supervisor_.Undo(step, 1s, [](const auto& /*done*/) {}); });

  EXPECT_TRUE(launcher_->process()->terminated);
}

}  // namespace
}  // namespace tendon::server
