#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>

#include <csignal>

#include "gcm_console/demo_fixture.h"

namespace {

using testing::HasSubstr;

/// How `gcm` ends where it is not the command line that is wrong, but what runs.
class ExitCodeTest : public DemoFixture {};

TEST_F(ExitCodeTest, ACallThatIsNotAnsweredInTimeHasACodeOfItsOwn) {
  Outcome called;

  // On a machine that stands still, the GCM itself may answer too late, or take the process for
  // lost.
  const bool is_timeout = EventuallyTrue([&] {
    if (!EventuallySays({"ls"}, "robot\talive")) return false;
    robot->Signal(SIGSTOP);
    called = RunProgram(
        {Binary("gcm"), "--gcm", address, "--timeout", "300", "call", "robot/arm/Control.Stop"});
    robot->Signal(SIGCONT);
    return called.exit_code == program::kTimeout;
  });

  EXPECT_TRUE(is_timeout) << called.exit_code << ": " << called.err;
  EXPECT_EQ(called.out, "");
  EXPECT_THAT(called.err, testing::StartsWith("gcm: "));
}

TEST_F(ExitCodeTest, WhatIsSaidOfALostProcessIsNoLackOfAGcm) {
  robot->Signal(SIGKILL);
  ASSERT_TRUE(EventuallySays({"ls"}, "robot\tlost"));

  const Outcome explained = Gcm({"explain", "desk/supervisor/Robot"});

  EXPECT_EQ(explained.exit_code, program::kRefused) << explained.out << explained.err;
  EXPECT_THAT(explained.out, HasSubstr("  1 BAD process 'robot' is lost"));
  EXPECT_EQ(Gcm({"call", "robot/arm/Control.Stop"}).exit_code, program::kRefused);
  gcm->Signal(SIGKILL);
  ASSERT_TRUE(gcm->Wait());
  EXPECT_EQ(Gcm({"explain", "desk/supervisor/Robot"}).exit_code, program::kUnreachable);
}

}  // namespace
