#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>

#include <csignal>
#include <fstream>

#include "gcm_console/system_fixture.h"

namespace {

using testing::HasSubstr;

class LcmTest : public SystemFixture {
 protected:
  std::string Write(const std::string& text) const {
    const std::string file = testing::TempDir() + "/lcm_test_" + port + ".json";
    std::ofstream(file) << text;
    return file;
  }
  /// Runs an LCM that is expected to give up.
  Outcome Refused(const std::string& name, const std::string& system) const {
    const auto lcm = StartLcm(name, system);
    const auto exit_code = lcm->Wait();
    return {exit_code.value_or(-1), lcm->out(), lcm->err()};
  }
};

TEST_F(LcmTest, WithoutAGcmItSaysSo) {
  const Outcome outcome = Refused("robot", demo);

  EXPECT_EQ(outcome.exit_code, program::kUnreachable);
  EXPECT_THAT(outcome.err, HasSubstr("no GCM at " + address));
}

TEST_F(LcmTest, ASecondProcessOfOneNameIsToldWhoHasIt) {
  StartGcm();
  const auto first = StartLcm("robot", demo);
  ASSERT_TRUE(EventuallySays({"ls"}, "robot\talive")) << first->err();

  const Outcome second = Refused("robot", demo);

  EXPECT_EQ(second.exit_code, program::kRefused);
  EXPECT_THAT(second.err, HasSubstr("'robot' is in use"));
  EXPECT_THAT(second.err, HasSubstr("pid " + std::to_string(first->pid())));
  EXPECT_THAT(Gcm({"ls"}).out, HasSubstr("robot\talive"));
}

TEST_F(LcmTest, AMissingPluginIsNamedAndNothingJoins) {
  StartGcm();
  const std::string file = Write(R"({"version": 1, "name": "x", "processes": [{"name": "robot",
    "components": [{"name": "arm", "class": "SimulatedArm", "library": "simulated_arn"}]}]})");

  const Outcome outcome = Refused("robot", file);

  EXPECT_EQ(outcome.exit_code, program::kNotFound);
  EXPECT_THAT(outcome.err, HasSubstr("no plug-in 'simulated_arn'; did you mean 'simulated_arm'?"));
  EXPECT_THAT(Gcm({"ls"}).out, Not(HasSubstr("robot")));
}

TEST_F(LcmTest, AMissingClassIsNamed) {
  StartGcm();
  const std::string file = Write(R"({"version": 1, "name": "x", "processes": [{"name": "robot",
    "components": [{"name": "arm", "class": "SimulatedArn", "library": "simulated_arm"}]}]})");

  const Outcome outcome = Refused("robot", file);

  EXPECT_EQ(outcome.exit_code, program::kNotFound);
  EXPECT_THAT(outcome.err, HasSubstr("did you mean 'SimulatedArm'?"));
}

TEST_F(LcmTest, AMistakeInTheSystemFileIsLocated) {
  const Outcome outcome = Refused("robot", Write("{\"version\": 1,\n  \"name\": ,}"));

  EXPECT_EQ(outcome.exit_code, program::kUsage);
  EXPECT_THAT(outcome.err, HasSubstr("line 2, column"));
}

TEST_F(LcmTest, AProcessThatTheFileDoesNotHaveIsRefused) {
  const Outcome outcome = Refused("robt", demo);

  EXPECT_EQ(outcome.exit_code, program::kNotFound);
  EXPECT_THAT(outcome.err, HasSubstr("has no process 'robt'; did you mean 'robot'?"));
}

TEST_F(LcmTest, ABadNameIsRefused) {
  StartGcm();

  const Outcome outcome = RunProgram({Binary("lcm"), "--name", "ro bot", "--gcm", address});

  EXPECT_EQ(outcome.exit_code, program::kUsage);
  EXPECT_THAT(outcome.err, HasSubstr("name 'ro bot' has ' ' at 3"));
}

TEST_F(LcmTest, EndsWhenToldAndSaysGoodBye) {
  StartGcm();
  const auto lcm = StartLcm("robot", demo);
  ASSERT_TRUE(EventuallySays({"ls"}, "robot\talive")) << lcm->err();

  lcm->Signal(SIGTERM);

  EXPECT_EQ(lcm->Wait(), program::kOk) << lcm->err();
  EXPECT_TRUE(EventuallySays({"ls"}, "robot\tleft"));
}

}  // namespace
