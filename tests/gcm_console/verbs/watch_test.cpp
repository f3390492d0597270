#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "gcm_console/system_fixture.h"

namespace {

/// Returns the tick in one line of the output of `gcm watch`.
std::uint64_t TickAt(const std::string& out, std::size_t line) {
  unsigned long tick = 0;
  if (std::sscanf(out.c_str() + line, "%*d\t%lu", &tick) != 1) return 0;
  return tick;
}
std::uint64_t FirstTick(const std::string& out) { return TickAt(out, 0); }
std::uint64_t LastTick(const std::string& out) {
  const std::size_t end = out.rfind('\n');
  if (end == std::string::npos || end == 0) return 0;
  const std::size_t before = out.rfind('\n', end - 1);
  return TickAt(out, before == std::string::npos ? 0 : before + 1);
}

class WatchTest : public SystemFixture {
 protected:
  void SetUp() override {
    StartGcm();
    robot = StartLcm("robot", demo);
    ASSERT_TRUE(EventuallySays({"get", column}, "0")) << robot->err();
  }

  [[nodiscard]] std::unique_ptr<Program> Watch(Program::Words options = {}) const {
    options.insert(options.begin(), {Binary("gcm"), "--gcm", address, "--timeout", kTestTimeout,
                                     "watch", column, "--hz", "50"});
    return std::make_unique<Program>(options);
  }
  /// Waits until more output is printed than now.
  static bool GoesOn(const Program& watch) {
    const std::size_t before = watch.out().size();
    return EventuallyTrue([&] { return watch.out().size() > before; });
  }

  const std::string column = "robot/arm/state.Joints.position[0]";
  std::unique_ptr<Program> robot;
};

TEST_F(WatchTest, AStoppedWatchCountsEveryLostRow) {
  // The table has 1000 rows per second.
  const char* const rows_meanwhile =
      std::getenv("TENDON_FULL_FAULTS") == nullptr ? "5000" : "60000";
  Program watch({Binary("gcm"), "--gcm", address, "watch", column});
  ASSERT_TRUE(EventuallyTrue([&] { return LastTick(watch.out()) > 0; })) << watch.err();

  watch.Signal(SIGSTOP);
  Program other({Binary("gcm"), "--gcm", address, "watch", column, "--count", rows_meanwhile});
  EXPECT_EQ(other.Wait(std::chrono::seconds(300)), program::kOk) << other.err();
  watch.Signal(SIGCONT);
  ASSERT_TRUE(EventuallyTrue([&] { return LastTick(watch.out()) > LastTick(other.out()); }))
      << watch.err();
  watch.Signal(SIGINT);
  ASSERT_EQ(watch.Wait(), program::kInterrupted);

  unsigned long printed = 0;
  unsigned long lost = 0;
  const std::size_t summary = watch.err().rfind("gcm: ");
  ASSERT_NE(summary, std::string::npos);
  ASSERT_EQ(std::sscanf(watch.err().c_str() + summary, "gcm: %lu rows, %lu lost", &printed, &lost),
            2)
      << watch.err();
  EXPECT_EQ(printed + lost, LastTick(watch.out()) - FirstTick(watch.out()) + 1) << watch.err();
}

TEST_F(WatchTest, ContinuesAfterARestartOfGcmAndProcess) {
  const auto watch = Watch();
  ASSERT_TRUE(GoesOn(*watch)) << watch->err();

  gcm->Signal(SIGKILL);
  gcm->Wait();
  EXPECT_TRUE(GoesOn(*watch)) << watch->err();
  StartGcm();
  ASSERT_TRUE(EventuallySays({"ls"}, "robot\talive"));
  EXPECT_TRUE(GoesOn(*watch)) << watch->err();

  robot->Signal(SIGKILL);
  robot->Wait();
  ASSERT_TRUE(EventuallyTrue([&] {
    return watch->err().find("gcm: process 'robot'") != std::string::npos;
  })) << watch->err();
  robot = StartLcm("robot", demo);
  EXPECT_TRUE(GoesOn(*watch)) << watch->err();

  watch->Signal(SIGINT);
  EXPECT_EQ(watch->Wait(), program::kInterrupted);
}

TEST_F(WatchTest, NoReconnectEndsWhenTheGcmIsLost) {
  const auto watch = Watch({"--no-reconnect"});
  ASSERT_TRUE(GoesOn(*watch)) << watch->err();

  gcm->Signal(SIGKILL);

  EXPECT_EQ(watch->Wait(), program::kUnreachable);
  EXPECT_THAT(watch->err(), testing::ContainsRegex("gcm: [0-9]+ rows?, .*\ngcm: no GCM at "));
}

TEST_F(WatchTest, NoReconnectEndsWhenTheProcessIsLost) {
  const auto watch = Watch({"--no-reconnect"});
  ASSERT_TRUE(GoesOn(*watch)) << watch->err();

  robot->Signal(SIGKILL);

  EXPECT_EQ(watch->Wait(), program::kUnreachable);
  EXPECT_THAT(watch->err(), testing::ContainsRegex("gcm: [0-9]+ rows?, .*\ngcm: process 'robot'"));
}

TEST_F(WatchTest, MarksValuesOfASuspendedComponentAsOld) {
  const auto watch = Watch();
  ASSERT_TRUE(GoesOn(*watch)) << watch->err();
  EXPECT_EQ(Gcm({"get", column}).err, "");

  ASSERT_EQ(Gcm({"suspend", "robot/arm"}).exit_code, program::kOk);
  EXPECT_TRUE(EventuallyTrue([&] {
    return watch->err().find("gcm: robot/arm is suspended: ") != std::string::npos;
  })) << watch->err();
  EXPECT_THAT(Gcm({"get", column}).err,
              testing::MatchesRegex("gcm: robot/arm is suspended: [0-9]+ s old\n"));
  EXPECT_THAT(Gcm({"get", "robot/arm/Control.GetJoints"}).err,
              testing::HasSubstr("robot/arm is suspended: "));
  EXPECT_THAT(Gcm({"--json", "get", column}).out,
              testing::AllOf(testing::HasSubstr("\"why\": \"suspended\""),
                             testing::HasSubstr("\"age_s\": ")));
  EXPECT_THAT(Gcm({"top"}).out, testing::ContainsRegex("robot/arm\tsuspended [0-9]+ s\t-\t-\t"));

  ASSERT_EQ(Gcm({"start", "robot/arm"}).exit_code, program::kOk);
  EXPECT_TRUE(EventuallyTrue([&] {
    return watch->err().find("gcm: robot/arm runs again") != std::string::npos;
  })) << watch->err();
  EXPECT_TRUE(GoesOn(*watch)) << watch->err();
  EXPECT_EQ(Gcm({"get", column}).err, "");
}

}  // namespace
