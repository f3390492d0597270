#include <gtest/gtest.h>
#include <program/exit_code.h>

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "gcm_console/system_fixture.h"

namespace {

/// In a line of what `gcm watch` prints.
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

class StoppedWatch : public SystemFixture {
 protected:
  void SetUp() override {
    StartGcm();
    robot = StartLcm("robot", demo);
    ASSERT_TRUE(EventuallySays({"get", column}, "0")) << robot->err();
  }

  const std::string column = "robot/arm/state.Joints.position[0]";
  std::unique_ptr<Program> robot;
};

TEST_F(StoppedWatch, MissesNoRowThatItDoesNotKnowOf) {
  // A thousand rows a second.
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

}  // namespace
