#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/task/scripted.h"
#include "support/wait.h"

namespace {

using tendon::ComponentState;
using tendon::CycleStatistics;
using tendon::kNoWait;
using tendon_test::Callback;
using tendon_test::Client;
using tendon_test::Continuous;
using tendon_test::Periodic;
using tendon_test::Script;
using tendon_test::Signal;
using tendon_test::Threadless;
using namespace std::chrono_literals;

struct RunAfter : testing::Test {
  tendon::LocalManager manager;
  // The follower is added first. StartAll() must still start its leader first.
  Periodic& follower = manager.Add<Periodic>("follower", 1h);
  Periodic& leader = manager.Add<Periodic>("leader", 1ms);

  void SetUp() override { ASSERT_TRUE(manager.RunAfter("follower", "leader").ok()); }

  static bool MakesCycles(const Script& task, std::uint64_t count = 5) {
    const std::uint64_t runs = task.runs;
    return EventuallyTrue([&] { return task.runs >= runs + count; });
  }
};

TEST_F(RunAfter, SharesTheThreadAndTheCycleOfTheLeader) {
  std::atomic<int> out_of_step = 0;
  std::uint64_t seen = 0;
  follower.on_run = [&] {
    if (leader.runs == std::exchange(seen, leader.runs.load())) ++out_of_step;
  };
  ASSERT_TRUE(manager.StartAll().ok());
  ASSERT_TRUE(MakesCycles(follower, 20));
  ASSERT_TRUE(manager.StopAll().ok());

  EXPECT_EQ(follower.thread.load(), leader.thread.load());
  EXPECT_EQ(out_of_step, 0);
  EXPECT_EQ(follower.period(), 1e-3);
  EXPECT_EQ(follower.table().next_tick(), follower.runs);
  EXPECT_GT(follower.Newest<CycleStatistics>("Cycle").period, 0.0);
}

TEST_F(RunAfter, IsKnownForDirectAndIndirectLeaders) {
  auto& last = manager.Add<Periodic>("last", 1h);
  ASSERT_TRUE(manager.RunAfter("last", "follower").ok());

  EXPECT_TRUE(tendon::RunsAfter(follower, leader));
  EXPECT_TRUE(tendon::RunsAfter(last, leader));
  EXPECT_FALSE(tendon::RunsAfter(leader, last));
  EXPECT_FALSE(tendon::RunsAfter(leader, leader));
}

TEST_F(RunAfter, RunsOneCycleAfterEachOfTheLeader) {
  tendon::LocalManager other;
  auto& driver = other.Add<Callback>("driver");
  auto& first = other.Add<Signal>("first");
  auto& second = other.Add<Continuous>("second");
  std::string order;
  driver.on_run = [&] { order += 'd'; };
  first.on_run = [&] { order += '1'; };
  second.on_run = [&] { order += '2'; };
  ASSERT_TRUE(other.RunAfter("first", "driver").ok());
  ASSERT_TRUE(other.RunAfter("second", "first").ok());
  ASSERT_TRUE(other.Start("driver").ok());
  ASSERT_TRUE(other.Start("first", kNoWait).ok());
  ASSERT_TRUE(other.Start("second", kNoWait).ok());

  for (int i = 0; i < 3; ++i) EXPECT_TRUE(driver.Cycle());

  EXPECT_EQ(order, "d12d12d12");
  EXPECT_TRUE(other.StopAll().ok());
}

TEST_F(RunAfter, ItsFaultDoesNotStopTheLeader) {
  ASSERT_TRUE(manager.StartAll().ok());
  follower.throws = Script::kRun;
  ASSERT_TRUE(manager.WaitFor("follower", ComponentState::kFaulted, 20s).ok());

  EXPECT_EQ(follower.fault(), "Run: cable cut");
  EXPECT_TRUE(MakesCycles(leader));
  EXPECT_EQ(leader.state(), ComponentState::kActive);
  follower.throws = Script::kNone;
  ASSERT_TRUE(manager.Start("follower").ok());
  EXPECT_TRUE(MakesCycles(follower));
}

TEST_F(RunAfter, CanBeControlledSeparately) {
  ASSERT_TRUE(manager.StartAll().ok());

  ASSERT_TRUE(manager.Suspend("follower").ok());
  const std::uint64_t runs = follower.runs;
  EXPECT_TRUE(MakesCycles(leader));
  EXPECT_EQ(follower.runs, runs);
  ASSERT_TRUE(manager.Start("follower").ok());
  EXPECT_TRUE(MakesCycles(follower));
  ASSERT_TRUE(manager.Stop("follower").ok());

  EXPECT_EQ(follower.cleanups, 1);
  EXPECT_TRUE(MakesCycles(leader));
}

TEST_F(RunAfter, AStoppedLeaderStopsIt) {
  ASSERT_TRUE(manager.StartAll().ok());

  ASSERT_TRUE(manager.Stop("leader").ok());

  EXPECT_EQ(follower.state(), ComponentState::kFinished);
  EXPECT_EQ(follower.cleanups, 1);
}

TEST_F(RunAfter, AFaultedLeaderStopsIt) {
  ASSERT_TRUE(manager.StartAll().ok());
  leader.throws = Script::kRun;

  EXPECT_TRUE(manager.WaitFor("follower", ComponentState::kFinished, 20s).ok());

  EXPECT_EQ(leader.state(), ComponentState::kFaulted);
  leader.throws = Script::kNone;
  ASSERT_TRUE(manager.StartAll().ok());
  EXPECT_TRUE(MakesCycles(follower));
}

TEST_F(RunAfter, SuspendsAndResumesWithTheLeader) {
  auto& client = manager.Add<Client>("client");
  ASSERT_TRUE(manager.Connect({"client", "Server"}, {"follower", "Control"}).ok());
  ASSERT_TRUE(manager.StartAll().ok());

  ASSERT_TRUE(manager.Suspend("leader").ok());
  EXPECT_EQ(follower.state(), ComponentState::kSuspended);
  EXPECT_EQ(client.poke(), tendon::Status::kNotActive);
  const auto started = manager.Start("follower");
  ASSERT_FALSE(started.ok());
  EXPECT_EQ(started.error().message,
            "component 'follower' runs after 'leader', which is suspended; start 'leader' first");
  ASSERT_TRUE(manager.Start("leader").ok());

  EXPECT_TRUE(manager.WaitFor("follower", ComponentState::kActive, 20s).ok());
  EXPECT_TRUE(MakesCycles(follower));
}

TEST_F(RunAfter, StaysSuspendedWhenTheLeaderResumes) {
  ASSERT_TRUE(manager.StartAll().ok());
  ASSERT_TRUE(manager.Suspend("follower").ok());
  ASSERT_TRUE(manager.Suspend("leader").ok());

  ASSERT_TRUE(manager.Start("leader").ok());

  EXPECT_TRUE(MakesCycles(leader));
  EXPECT_EQ(follower.state(), ComponentState::kSuspended);
}

TEST_F(RunAfter, CanBeStoppedWhileTheLeaderIsSuspended) {
  ASSERT_TRUE(manager.StartAll().ok());
  ASSERT_TRUE(manager.Suspend("leader").ok());

  EXPECT_TRUE(manager.Stop("follower").ok());

  EXPECT_EQ(leader.state(), ComponentState::kSuspended);
}

TEST_F(RunAfter, RefusesAWaitForATaskInTheSameThread) {
  class Asking final : public tendon::PeriodicTask {
   public:
    explicit Asking(std::string name) : PeriodicTask(std::move(name), 1ms) {
      AddRequiredInterface("Server").AddFunction(poke_, "Poke");
    }
    std::atomic<int> answer = -1;

   private:
    void Run() override {
      if (answer < 0) answer = static_cast<int>(poke_.Wait(1h).code());
    }
    tendon::VoidFunction poke_;
  };
  auto& asking = manager.Add<Asking>("asking");
  ASSERT_TRUE(manager.RunAfter("asking", "leader").ok());
  ASSERT_TRUE(manager.Connect({"asking", "Server"}, {"leader", "Control"}).ok());

  ASSERT_TRUE(manager.StartAll().ok());

  ASSERT_TRUE(EventuallyTrue([&] { return asking.answer >= 0; }));
  EXPECT_EQ(asking.answer, static_cast<int>(tendon::Status::kWouldDeadlock));
}

TEST_F(RunAfter, CannotStartBeforeTheLeader) {
  const auto started = manager.Start("follower");

  ASSERT_FALSE(started.ok());
  EXPECT_EQ(started.error().message,
            "component 'follower' runs after 'leader', which is constructed; start 'leader' first");
}

TEST_F(RunAfter, RefusesARingNamingItsMembers) {
  manager.Add<Periodic>("third", 1ms);
  ASSERT_TRUE(manager.RunAfter("third", "follower").ok());

  const auto ring = manager.RunAfter("leader", "third");
  const auto self = manager.RunAfter("third", "third");

  ASSERT_FALSE(ring.ok());
  EXPECT_EQ(ring.error().message,
            "component 'leader' cannot run after 'third': they would wait for each other: leader "
            "after third, which runs after follower, which runs after leader");
  ASSERT_FALSE(self.ok());
  EXPECT_EQ(self.error().message,
            "component 'third' cannot run after 'third': they would wait for each other: third "
            "after third");
}

TEST_F(RunAfter, NeedsAThreadAndALeaderWithCycles) {
  manager.Add<Threadless>("threadless");
  manager.Add<Callback>("callback");

  const auto no_thread = manager.RunAfter("callback", "leader");
  const auto no_cycles = manager.RunAfter("leader", "threadless");

  ASSERT_FALSE(no_thread.ok());
  EXPECT_EQ(no_thread.error().message,
            "component 'callback' cannot run after 'leader': 'callback' has no thread");
  ASSERT_FALSE(no_cycles.ok());
  EXPECT_EQ(
      no_cycles.error().message,
      "component 'leader' cannot run after 'threadless': 'threadless' does not run in cycles");
}

TEST_F(RunAfter, ARunningTaskCannotChangeItsThread) {
  manager.Add<Periodic>("other", 1ms);
  ASSERT_TRUE(manager.StartAll().ok());

  const auto moved = manager.RunAfter("follower", "other");

  ASSERT_FALSE(moved.ok());
  EXPECT_EQ(moved.error().message,
            "component 'follower' cannot run after 'other': 'follower' is active; stop it first");
  ASSERT_TRUE(manager.Stop("follower").ok());
  EXPECT_TRUE(manager.RunAfter("follower", "other").ok());  // while both leaders run
  EXPECT_TRUE(manager.Start("follower").ok());
}

/// The cycle of another follower hangs.
struct RunAfterHungTask : RunAfter {
  Periodic& third = manager.Add<Periodic>("third", 1ms);

  void SetUp() override {
    RunAfter::SetUp();
    ASSERT_TRUE(manager.RunAfter("third", "leader").ok());
    ASSERT_TRUE(manager.StartAll().ok());
    ASSERT_TRUE(manager.Stop("third").ok());
    follower.blocks = Script::kRun;
    ASSERT_TRUE(EventuallyTrue([this] { return follower.is_blocked.load(); }));
  }
  void TearDown() override { follower.blocks = Script::kNone; }
};

TEST_F(RunAfterHungTask, ANewFollowerStartsWhenTheHungOneContinues) {
  auto& fresh = manager.Add<Periodic>("new", 1ms);

  EXPECT_TRUE(manager.RunAfter("new", "leader", kNoWait).ok());

  EXPECT_TRUE(manager.Start("new", kNoWait).ok());
  EXPECT_EQ(fresh.startups, 0);
  follower.blocks = Script::kNone;
  ASSERT_TRUE(manager.WaitFor("new", ComponentState::kActive, 20s).ok());
  EXPECT_TRUE(MakesCycles(fresh));
  EXPECT_EQ(fresh.thread.load(), leader.thread.load());
}

TEST_F(RunAfterHungTask, ANewFollowerCanBeRemovedLater) {
  manager.Add<Periodic>("new", 1ms);
  ASSERT_TRUE(manager.RunAfter("new", "leader", kNoWait).ok());

  const auto refused = manager.Remove("new", 50ms);

  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, tendon::ErrorCode::kTimeout);
  follower.blocks = Script::kNone;
  EXPECT_TRUE(manager.Remove("new").ok());
  EXPECT_TRUE(MakesCycles(follower));
}

TEST_F(RunAfterHungTask, RefusesToMoveAnotherFollower) {
  manager.Add<Periodic>("other", 1ms);
  ASSERT_TRUE(manager.Start("other").ok());

  const auto refused = manager.RunAfter("third", "other", 50ms);

  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, tendon::ErrorCode::kTimeout);
  EXPECT_EQ(refused.error().message,
            "component 'third' cannot run after 'other': the cycle of 'leader' does not end; this "
            "task, or a task that runs after it, is busy in Run()");
  EXPECT_TRUE(manager.Start("third", kNoWait).ok());
  follower.blocks = Script::kNone;
  ASSERT_TRUE(manager.WaitFor("third", ComponentState::kActive, 20s).ok());
  EXPECT_TRUE(MakesCycles(third));
  EXPECT_EQ(third.thread.load(), leader.thread.load());
}

TEST_F(RunAfterHungTask, RefusesToRemoveAnotherFollower) {
  const auto refused = manager.Remove("third", 50ms);

  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, tendon::ErrorCode::kTimeout);
  EXPECT_EQ(refused.error().message,
            "component 'third' is not removed: the cycle of 'leader' does not end; this task, or a "
            "task that runs after it, is busy in Run()");
  EXPECT_EQ(manager.Find("third"), &third);
  follower.blocks = Script::kNone;
  EXPECT_TRUE(manager.Remove("third").ok());
  EXPECT_TRUE(MakesCycles(follower));
}

TEST_F(RunAfterHungTask, RefusesToRemoveTheHungFollower) {
  const auto refused = manager.Remove("follower", 50ms);

  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, tendon::ErrorCode::kTimeout);
  EXPECT_THAT(refused.error().message,
              testing::HasSubstr("component 'follower' is not removed, because it runs: "));
}

TEST_F(RunAfter, LeaderAndFollowerCanBeRemoved) {
  auto& third = manager.Add<Periodic>("third", 1ms);
  ASSERT_TRUE(manager.RunAfter("third", "follower").ok());
  ASSERT_TRUE(manager.StartAll().ok());

  ASSERT_TRUE(manager.Remove("follower").ok());
  EXPECT_TRUE(MakesCycles(leader));
  EXPECT_EQ(third.state(), ComponentState::kFinished);

  ASSERT_TRUE(manager.Start("third").ok());  // the task has its own thread again
  EXPECT_TRUE(MakesCycles(third));
  EXPECT_NE(third.thread.load(), leader.thread.load());
}

}  // namespace
