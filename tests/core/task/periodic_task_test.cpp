#include <gtest/gtest.h>

#include "core/task/scripted.h"
#include "support/refusal.h"
#include "support/wait.h"

namespace {

using tendon::ComponentState;
using tendon::CycleStatistics;
using tendon::kNoWait;
using tendon_test::Periodic;
using tendon_test::Script;
using namespace std::chrono_literals;

/// The due time of a row: its time minus its lateness, which is a point of the grid.
struct Row {
  double due = 0.0;  // ns
  CycleStatistics cycle;
};

Row ReadRow(const tendon::StateTable& table, std::uint64_t tick) {
  std::vector<std::uint64_t> words(table.row_words());
  std::int64_t time = 0;
  EXPECT_EQ(table.CopyRow(tick, words, time), tendon::RowResult::kDone);
  Row row;
  EXPECT_TRUE(tendon::Decode(table.cell(words, 0), row.cycle));
  row.due = static_cast<double>(time) - row.cycle.lateness * 1e9;
  return row;
}

TEST(PeriodicTask, RunsCyclesAndPublishesEachAsARow) {
  tendon::LocalManager manager;
  auto& task = manager.Add<Periodic>("task", 1ms);

  ASSERT_TRUE(manager.StartAll().ok());
  EXPECT_EQ(task.state(), ComponentState::kActive);
  ASSERT_TRUE(EventuallyTrue([&] { return task.table().next_tick() >= 20; }));
  ASSERT_TRUE(manager.StopAll().ok());

  EXPECT_EQ(task.state(), ComponentState::kFinished);
  EXPECT_EQ(task.startups, 1);
  EXPECT_EQ(task.cleanups, 1);
  EXPECT_EQ(task.table().next_tick(), task.runs);
}

TEST(PeriodicTask, KeepsItsTimeGrid) {
  tendon::LocalManager manager;
  auto& task = manager.Add<Periodic>("task", 1ms);
  task.on_run = [&task] {
    // Ends the task, so that no row is overwritten.
    if (task.runs > 200) task.throws = Script::kRun;
  };
  ASSERT_TRUE(manager.StartAll(kNoWait).ok());
  ASSERT_TRUE(manager.WaitForAll(ComponentState::kFaulted, 20s).ok());

  const Row first = ReadRow(task.table(), 0);
  for (std::uint64_t tick = 1; tick < 200; ++tick) {
    const Row row = ReadRow(task.table(), tick);
    const double cycles = static_cast<double>(tick + row.cycle.overruns);
    EXPECT_NEAR(row.due, first.due + cycles * 1e6, 10.0) << "row " << tick;
  }
}

TEST(PeriodicTask, CountsAndSkipsOverrunCycles) {
  tendon::LocalManager manager;
  auto& task = manager.Add<Periodic>("task", 1ms);
  task.on_run = [&task] {
    const auto end = std::chrono::steady_clock::now() + 10ms;
    while (task.runs == 5 && std::chrono::steady_clock::now() < end) {
    }
    if (task.runs > 12) task.throws = Script::kRun;
  };
  ASSERT_TRUE(manager.StartAll(kNoWait).ok());
  ASSERT_TRUE(manager.WaitForAll(ComponentState::kFaulted, 20s).ok());

  const Row during = ReadRow(task.table(), 4);
  const Row after = ReadRow(task.table(), 5);
  EXPECT_GE(after.cycle.overruns - during.cycle.overruns, 8U);
  EXPECT_GE(after.cycle.compute, 0.010);
  EXPECT_GE(after.cycle.load, 10.0);
  // No point of the grid occurs twice, and skipped points are not made up.
  for (std::uint64_t tick = 5; tick < 12; ++tick) {
    EXPECT_GE(ReadRow(task.table(), tick).due - ReadRow(task.table(), tick - 1).due, 0.99e6);
  }
}

TEST(PeriodicTask, StartsANewGridAfterResuming) {
  tendon::LocalManager manager;
  auto& task = manager.Add<Periodic>("task", 1ms);
  std::atomic<bool> resumed = false;
  int cycles = 0;
  task.on_run = [&] {
    if (resumed && ++cycles > 3) task.throws = Script::kRun;
  };
  ASSERT_TRUE(manager.StartAll().ok());
  ASSERT_TRUE(EventuallyTrue([&] { return task.runs >= 3; }));
  ASSERT_TRUE(manager.Suspend("task").ok());
  const std::uint64_t tick = task.table().next_tick();
  const auto end = std::chrono::steady_clock::now() + 20ms;
  ASSERT_TRUE(EventuallyTrue([&] { return std::chrono::steady_clock::now() > end; }));

  resumed = true;
  const std::chrono::duration<double, std::nano> goes_on =
      tendon::SteadyClock().Now().time_since_epoch();
  ASSERT_TRUE(manager.Start("task", kNoWait).ok());
  ASSERT_TRUE(manager.WaitFor("task", ComponentState::kFaulted, 20s).ok());

  const Row first = ReadRow(task.table(), tick);
  EXPECT_EQ(first.cycle.period, 0.0);
  EXPECT_GT(first.due, goes_on.count());
}

TEST(PeriodicTask, RefusesAPeriodOutOfRange) {
  const auto refusal = [](std::chrono::nanoseconds period) {
    return tendon::test::Refusal([&] { const Periodic task("arm", period); });
  };
  const std::string sentence = "period of 'arm' must be 10 us..3600 s, got ";

  EXPECT_EQ(refusal(0ns), sentence + "0 ns");
  EXPECT_EQ(refusal(-1ms), sentence + "-1000000 ns");
  EXPECT_EQ(refusal(1ns), sentence + "1 ns");
  EXPECT_EQ(refusal(2h), sentence + "7200000000000 ns");
  EXPECT_EQ(refusal(10us), "");
}

TEST(PeriodicTask, ALongPeriodDelaysNoStopOrSuspend) {
  tendon::LocalManager manager;
  auto& task = manager.Add<Periodic>("slow", 1h);
  ASSERT_TRUE(manager.StartAll().ok());

  EXPECT_TRUE(manager.SuspendAll().ok());
  EXPECT_TRUE(manager.StartAll().ok());
  EXPECT_TRUE(manager.StopAll().ok());

  EXPECT_EQ(task.state(), ComponentState::kFinished);
}

}  // namespace
