#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>

#include <csignal>

#include "gcm_console/demo_fixture.h"

namespace {

using testing::HasSubstr;

/// Tests the exit codes of `gcm` for failures of the running system.
class ExitCodeTest : public DemoFixture {};

TEST_F(ExitCodeTest, ATimedOutCallHasItsOwnExitCode) {
  Outcome called;

  // On a machine that stalls, the GCM itself may answer too late, or may consider the process lost.
  // Tries again.
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

TEST_F(ExitCodeTest, ALostProcessDiffersFromAnUnreachableGcm) {
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

/// A process that advertises an address at which it is not reachable.
class WrongAddressTest : public DemoFixture {
 protected:
  void SetUp() override {
    DemoFixture::SetUp();
    home.Write("far.json", R"({"version": 1, "name": "far", "processes": [{"name": "far",
        "components": [{"name": "arm", "class": "SimulatedArm", "library": "simulated_arm"}]}]})");
    far = std::make_unique<Program>(Program::Words{Binary("lcm"), "--name", "far", "--gcm", address,
                                                   "--advertise", "127.0.0.1:9", "--system",
                                                   (home.path() / "far.json").string()});
    ASSERT_TRUE(EventuallySays({"ls", "far"}, "arm\tactive")) << far->err();
  }

  std::unique_ptr<Program> far;
};

TEST_F(WrongAddressTest, DoctorReportsTheUnreachableAddress) {
  const Outcome doctor = Gcm({"doctor"});

  EXPECT_EQ(doctor.exit_code, program::kRefused);
  EXPECT_THAT(doctor.out, testing::ContainsRegex("BAD  process far .*process 'far' does not answer "
                                                 "at 127.0.0.1:9: .*\n.*fix: .*--advertise"));
  EXPECT_THAT(doctor.out, testing::ContainsRegex("ok   process robot .*, answers within "));
  EXPECT_THAT(
      doctor.out,
      testing::ContainsRegex(
          "-    plug-in far simulated_arm .*, according to the last report of the process"));
}

TEST_F(WrongAddressTest, ExplainIsTheSameBeforeAndAfterAConnect) {
  const Program::Words words = {"explain", "desk/teleoperation/Robot", "far/arm/Control"};
  const Outcome before = Gcm(words);
  Gcm({"connect", "desk/teleoperation/Robot", "far/arm/Control"});
  const Outcome after = Gcm(words);

  for (const Outcome& outcome : {before, after}) {
    EXPECT_EQ(outcome.exit_code, program::kRefused);
    EXPECT_THAT(outcome.out,
                testing::ContainsRegex("  5 BAD .*127.0.0.1:9.*\n *fix: .*--advertise"));
    EXPECT_THAT(outcome.out, HasSubstr("\n  7 -   "));
  }
}

TEST_F(WrongAddressTest, RequestsDoNotReportAnUnreachableGcm) {
  for (const Program::Words& words : {Program::Words{"get", "far/arm/state.Joints"},
                                      {"call", "far/arm/Control.Stop"},
                                      {"show", "far/arm/Control.MoveTo"}}) {
    EXPECT_NE(Gcm(words).exit_code, program::kUnreachable) << words[0];
  }
  EXPECT_EQ(Gcm({"get", "far/arm/state.Joints"}).exit_code, program::kRefused);
}

}  // namespace
