#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>

#include "core/task/scripted.h"
#include "support/wait.h"

namespace {

using tendon::ComponentState;
using tendon::Status;
using tendon_test::Callback;
using tendon_test::Client;
using tendon_test::Continuous;
using tendon_test::Main;
using tendon_test::Script;
using tendon_test::Signal;
using tendon_test::Threadless;
using namespace std::chrono_literals;

TEST(ContinuousTask, StartsACycleWhenTheLastEnds) {
  tendon::LocalManager manager;
  auto& task = manager.Add<Continuous>("task");
  auto& client = manager.Add<Client>("client");
  ASSERT_TRUE(manager.Connect({"client", "Server"}, {"task", "Control"}).ok());
  ASSERT_TRUE(manager.StartAll().ok());

  EXPECT_EQ(client.poke(), Status::kQueued);

  EXPECT_TRUE(EventuallyTrue([&] { return task.runs >= 10000 && task.pokes == 1; }));
  EXPECT_EQ(task.period(), 0.0);
}

/// Returns true if there are rows, and more cycles than rows, even without the running cycle.
bool MakesCyclesWithoutARow(std::uint64_t cycles, const tendon::StateTable& table) {
  const std::uint64_t rows = table.next_tick();
  return rows >= 5 && cycles > rows + 1;
}

TEST(ContinuousTask, WritesAtMostOneRowPerMillisecond) {
  tendon::LocalManager manager;
  auto& task = manager.Add<Continuous>("task");
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_TRUE(manager.StartAll().ok());
  ASSERT_TRUE(EventuallyTrue([&] { return MakesCyclesWithoutARow(task.runs, task.table()); }));
  ASSERT_TRUE(manager.StopAll().ok());

  const auto elapsed = std::chrono::steady_clock::now() - begin;
  EXPECT_LE(task.table().next_tick(), static_cast<std::uint64_t>(elapsed / 1ms) + 1);
  EXPECT_GT(task.runs, task.table().next_tick());
}

TEST(ContinuousTask, LimitsRowsOfItsOtherTables) {
  class Two final : public tendon::ContinuousTask {
   public:
    explicit Two(std::string name) : ContinuousTask(std::move(name)) { AddStateTable("more"); }
    std::atomic<std::uint64_t> runs = 0;

   private:
    void Run() override { ++runs; }
  };
  tendon::LocalManager manager;
  auto& task = manager.Add<Two>("task");
  ASSERT_TRUE(manager.StartAll().ok());
  ASSERT_TRUE(EventuallyTrue([&] { return MakesCyclesWithoutARow(task.runs, *task.tables()[1]); }));
  ASSERT_TRUE(manager.StopAll().ok());

  EXPECT_EQ(task.tables()[1]->next_tick(), task.tables()[0]->next_tick());
  EXPECT_GT(task.runs, task.tables()[1]->next_tick());
}

TEST(SignalTask, RunsOnlyWhenACommandIsQueued) {
  tendon::LocalManager manager;
  auto& task = manager.Add<Signal>("task");
  auto& client = manager.Add<Client>("client");
  ASSERT_TRUE(manager.Connect({"client", "Server"}, {"task", "Control"}).ok());
  ASSERT_TRUE(manager.StartAll().ok());
  EXPECT_EQ(task.runs, 0U);

  for (int i = 1; i <= 100; ++i) {
    ASSERT_EQ(client.poke(), Status::kQueued);
    ASSERT_TRUE(EventuallyTrue([&] { return task.pokes == i; })) << "post " << i;
  }

  ASSERT_TRUE(manager.StopAll().ok());
  EXPECT_EQ(task.runs, 100U);
}

TEST(SignalTask, RunsWhenAnEventIsQueued) {
  class Listener final : public tendon::SignalTask {
   public:
    explicit Listener(std::string name) : SignalTask(std::move(name)) {
      AddRequiredInterface("Source").AddEventHandlerVoid(&Listener::OnPoked, this, "Poked");
    }
    std::atomic<int> heard = 0;

   private:
    void Run() override { ProcessQueuedCommands(); }
    void OnPoked() { ++heard; }
  };
  tendon::LocalManager manager;
  auto& source = manager.Add<Threadless>("source");
  auto& listener = manager.Add<Listener>("listener");
  ASSERT_TRUE(manager.Connect({"listener", "Source"}, {"source", "Control"}).ok());
  ASSERT_TRUE(manager.StartAll().ok());

  source.poked();

  EXPECT_TRUE(EventuallyTrue([&] { return listener.heard == 1; }));
}

TEST(SignalTask, CanBeStoppedWhileSleeping) {
  tendon::LocalManager manager;
  auto& task = manager.Add<Signal>("task");
  ASSERT_TRUE(manager.StartAll().ok());

  EXPECT_TRUE(manager.StopAll().ok());

  EXPECT_EQ(task.cleanups, 1);
  EXPECT_EQ(task.runs, 0U);
}

TEST(SignalTask, ExecutesCallsQueuedDuringSuspension) {
  tendon::LocalManager manager;
  auto& task = manager.Add<Signal>("task");
  auto& client = manager.Add<Client>("client");
  ASSERT_TRUE(manager.Connect({"client", "Server"}, {"task", "Control"}).ok());
  ASSERT_TRUE(manager.StartAll().ok());
  task.blocks = Script::kHandler;
  EXPECT_EQ(client.poke(), Status::kQueued);
  ASSERT_TRUE(EventuallyTrue([&] { return task.pokes == 1; }));
  EXPECT_EQ(client.poke(), Status::kQueued);
  ASSERT_TRUE(manager.Suspend("task", tendon::kNoWait).ok());
  task.blocks = Script::kNone;
  ASSERT_TRUE(manager.WaitFor("task", ComponentState::kSuspended, 20s).ok());
  EXPECT_EQ(task.pokes, 1);

  ASSERT_TRUE(manager.Start("task").ok());

  EXPECT_TRUE(EventuallyTrue([&] { return task.pokes == 2; }));
}

TEST(CallbackTask, RunsACycleInTheCallersThread) {
  tendon::LocalManager manager;
  auto& task = manager.Add<Callback>("task");
  auto& client = manager.Add<Client>("client");
  ASSERT_TRUE(manager.Connect({"client", "Server"}, {"task", "Control"}).ok());
  EXPECT_FALSE(task.Cycle());
  ASSERT_TRUE(manager.StartAll().ok());
  EXPECT_EQ(client.poke(), Status::kQueued);

  EXPECT_TRUE(task.Cycle());

  EXPECT_EQ(task.thread.load(), std::this_thread::get_id());
  EXPECT_EQ(task.pokes, 1);
  EXPECT_EQ(task.table().next_tick(), 1U);
  ASSERT_TRUE(manager.Suspend("task").ok());
  EXPECT_FALSE(task.Cycle());
  ASSERT_TRUE(manager.Start("task").ok());
  EXPECT_TRUE(task.Cycle());
  ASSERT_TRUE(manager.StopAll().ok());
  EXPECT_FALSE(task.Cycle());
  EXPECT_EQ(task.runs, 2U);
  EXPECT_EQ(task.cleanups, 1);
}

TEST(CallbackTask, RefusesAConcurrentCycle) {
  tendon::LocalManager manager;
  auto& task = manager.Add<Callback>("task");
  ASSERT_TRUE(manager.StartAll().ok());
  task.blocks = Script::kRun;
  auto first = std::async(std::launch::async, [&] { return task.Cycle(); });
  ASSERT_TRUE(EventuallyTrue([&] { return task.runs == 1; }));

  EXPECT_FALSE(task.Cycle());

  task.blocks = Script::kNone;
  EXPECT_TRUE(first.get());
  EXPECT_EQ(task.runs, 1U);
}

TEST(CallbackTask, AStopWaitsForTheCycle) {
  tendon::LocalManager manager;
  auto& task = manager.Add<Callback>("task");
  ASSERT_TRUE(manager.StartAll().ok());
  task.blocks = Script::kRun;
  auto cycle = std::async(std::launch::async, [&] { return task.Cycle(); });
  ASSERT_TRUE(EventuallyTrue([&] { return task.runs == 1; }));

  EXPECT_FALSE(manager.Stop("task", 20ms).ok());
  EXPECT_EQ(task.cleanups, 0);
  task.blocks = Script::kNone;

  EXPECT_TRUE(cycle.get());
  EXPECT_TRUE(manager.WaitFor("task", ComponentState::kFinished, 20s).ok());
  EXPECT_EQ(task.cleanups, 1);
}

TEST(MainTask, RunsInTheLentThreadUntilStopped) {
  tendon::LocalManager manager;
  auto& task = manager.Add<Main>("task", 100us);
  auto& client = manager.Add<Client>("client");
  ASSERT_TRUE(manager.Connect({"client", "Server"}, {"task", "Control"}).ok());
  ASSERT_TRUE(manager.StartAll().ok());
  const std::thread::id lender = std::this_thread::get_id();
  std::thread other([&] {
    (void)client.poke();
    EXPECT_TRUE(EventuallyTrue([&] { return task.runs >= 20 && task.pokes == 1; }));
    EXPECT_TRUE(manager.Suspend("task").ok());
    EXPECT_TRUE(manager.Start("task").ok());
    EXPECT_TRUE(EventuallyTrue([&, before = task.runs.load()] { return task.runs > before; }));
    EXPECT_EQ(task.thread.load(), lender);
    EXPECT_TRUE(manager.StopAll().ok());
  });

  task.RunInThisThread();

  other.join();
  EXPECT_EQ(task.state(), ComponentState::kFinished);
  EXPECT_EQ(task.period(), 1e-4);
}

TEST(MainTask, ReturnsTheThreadAfterAFault) {
  tendon::LocalManager manager;
  auto& task = manager.Add<Main>("task", 100us);
  task.throws = Script::kRun;
  ASSERT_TRUE(manager.StartAll().ok());

  task.RunInThisThread();

  EXPECT_EQ(task.fault(), "Run: cable cut");
}

TEST(Task, AComponentWithoutAThreadExecutesItsCommandsInTheCallersThread) {
  tendon::LocalManager manager;
  auto& component = manager.Add<Threadless>("component");
  auto& client = manager.Add<Client>("client");
  ASSERT_TRUE(manager.Connect({"client", "Server"}, {"component", "Control"}).ok());
  ASSERT_TRUE(manager.StartAll().ok());

  EXPECT_EQ(client.poke(), Status::kDone);

  EXPECT_EQ(component.thread.load(), std::this_thread::get_id());
  EXPECT_EQ(component.pokes, 1);
}

}  // namespace
