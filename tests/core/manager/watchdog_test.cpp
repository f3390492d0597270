#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/manager/watchdog.h>

#include "core/task/scripted.h"
#include "support/wait.h"

namespace {

using tendon::Watchdog;
using tendon_test::Main;
using tendon_test::Periodic;
using tendon_test::Script;
using testing::MatchesRegex;
using namespace std::chrono_literals;

TEST(Watchdog, ATaskIsOverdueAfterThreePeriodsAndAGrace) {
  EXPECT_FALSE(Watchdog::IsOverdue(10ms, 30ms + Watchdog::kGrace));
  EXPECT_TRUE(Watchdog::IsOverdue(10ms, 31ms + Watchdog::kGrace));
  EXPECT_FALSE(Watchdog::IsOverdue(0s, 1h));  // without a period
}

TEST(Watchdog, OnlyAnActiveTaskCanBeOverdue) {
  Main task("servo", 10ms);
  const auto in_an_hour = [&task] { return task.SinceLastCycle(tendon::SteadyClock().Now() + 1h); };
  task.Seal();
  EXPECT_EQ(in_an_hour(), 0ns);
  ASSERT_TRUE(task.Start().ok());
  EXPECT_GE(in_an_hour(), 1h);
  ASSERT_TRUE(task.Suspend().ok());
  EXPECT_EQ(in_an_hour(), 0ns);
  ASSERT_TRUE(task.Start().ok());
  ASSERT_TRUE(task.Stop().ok());
  EXPECT_EQ(in_an_hour(), 0ns);
}

TEST(Watchdog, NamesOnlyTheTaskWhoseCycleBlocks) {
  tendon::LocalManager manager;
  auto& servo = manager.Add<Periodic>("servo", 10ms);
  auto& other = manager.Add<Periodic>("other", 10ms);
  ASSERT_TRUE(manager.StartAll().ok());
  const auto warning = [&manager](std::size_t i) { return manager.components()[i].warning; };
  servo.blocks = Script::kRun;

  ASSERT_TRUE(EventuallyTrue([&] { return !warning(0).empty(); }));

  EXPECT_THAT(warning(0), MatchesRegex("missed [0-9]+ x 10 ms"));
  EXPECT_EQ(servo.state(), tendon::ComponentState::kActive);
  const std::uint64_t runs = other.runs;
  EXPECT_TRUE(EventuallyTrue([&] { return other.runs > runs + 3; }));
  servo.blocks = Script::kNone;
  EXPECT_TRUE(EventuallyTrue([&] { return warning(0).empty(); }));
}

TEST(Watchdog, NotifiesItsOwnerOfBothChanges) {
  tendon::LocalManager manager;
  auto& servo = manager.Add<Periodic>("servo", 10ms);
  std::atomic<int> changes = 0;
  Watchdog watchdog([&changes] { ++changes; });
  watchdog.Watch(servo);
  ASSERT_TRUE(manager.StartAll().ok());
  servo.blocks = Script::kRun;
  ASSERT_TRUE(EventuallyTrue([&] { return !watchdog.WarningOf(servo).empty() && changes >= 1; }));
  servo.blocks = Script::kNone;

  EXPECT_TRUE(EventuallyTrue([&] { return watchdog.WarningOf(servo).empty() && changes >= 2; }));
  watchdog.Forget(servo);
}

}  // namespace
