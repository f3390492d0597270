#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>

#include <nlohmann/json.hpp>

#include "gcm_console/demo_fixture.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

/// Tests patterns that match several objects.
class GlobTest : public DemoFixture {
 protected:
  void ExpectError(const Program::Words& words, int exit_code, const std::string& sentence) const {
    const Outcome outcome = Gcm(words);
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.out << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(sentence));
    EXPECT_EQ(outcome.out, "");
  }
};

TEST_F(GlobTest, LsListsMatches) {
  const std::string parts = Gcm({"ls", "robot/*"}).out;
  EXPECT_THAT(parts, HasSubstr("robot/arm\tcomponent\t"));
  EXPECT_THAT(parts, HasSubstr("robot/host_monitor\tcomponent\t"));
  EXPECT_THAT(parts, Not(HasSubstr("robot/arm/Control")));

  EXPECT_THAT(Gcm({"ls", "-R", "robot/a*"}).out, HasSubstr("robot/arm/Control.MoveTo\tcommand\t"));
  const std::string required = Gcm({"ls", "--type", "req", "d*"}).out;
  EXPECT_THAT(required, HasSubstr("desk/supervisor/Robot\trequired interface\t"));
  EXPECT_THAT(required, Not(HasSubstr("component")));
  ExpectError({"ls", "nobody/*"}, program::kNotFound,
              "nothing matches 'nobody/*'; to list all names: gcm ls -R");
}

TEST_F(GlobTest, ShowPrintsEachMatchUnderItsPath) {
  const Outcome shown = Gcm({"show", "desk/*/Robot"});

  EXPECT_EQ(shown.exit_code, program::kOk) << shown.err;
  EXPECT_THAT(shown.out, testing::StartsWith("desk/supervisor/Robot:\n"));
  EXPECT_THAT(shown.out, HasSubstr("\n\ndesk/teleoperation/Robot:\n"));
  EXPECT_EQ(json::parse(Gcm({"show", "desk/*/Robot", "--json"}).out)["things"].size(), 2U);
  ExpectError({"show", "desk/*/Robt"}, program::kNotFound, "nothing matches 'desk/*/Robt'");
}

TEST_F(GlobTest, GetPrintsEachMatchWithItsPath) {
  const Outcome joint = Gcm({"get", "robot/*/state.Joints.position[0]"});
  EXPECT_EQ(joint.exit_code, program::kOk) << joint.err;
  EXPECT_THAT(joint.out, testing::StartsWith("robot/arm/state.Joints.position[0]\t"));

  const Outcome commands = Gcm({"get", "*/arm/Control.*"});
  EXPECT_EQ(commands.exit_code, program::kOk) << commands.err;
  EXPECT_THAT(commands.out, HasSubstr("robot/arm/Control.GetJoints\t{\"position\""));
  EXPECT_THAT(commands.out, Not(HasSubstr("Stop")));
  const json document = json::parse(Gcm({"get", "robot/*/state.Joints", "--json"}).out);
  EXPECT_EQ(document["values"][0]["path"], "robot/arm/state.Joints");
  ExpectError({"get", "robot/*/Control.Stop"}, program::kNotFound,
              "matches no value that can be read");
  ExpectError({"get", "nobody/*/state.Joints"}, program::kNotFound, "no column matches");
}

TEST_F(GlobTest, DisconnectEndsAllMatches) {
  ASSERT_EQ(Gcm({"connect", "desk/teleoperation/Robot", "robot/arm/Control"}).exit_code, 0);
  EXPECT_EQ(Gcm({"disconnect", "desk/*/Robot", "--dry-run"}).out,
            "desk/supervisor/Robot -> robot/arm/Control\twould be disconnected\n"
            "desk/teleoperation/Robot -> robot/arm/Control\twould be disconnected\n");
  const auto type = [this](const std::string& words) {
    const std::string line = Binary("gcm") + " --gcm " + address + " --timeout " + kTestTimeout;
    return RunProgram(
        {"/bin/sh", "-c", "echo n | script -qec \"" + line + " " + words + "\" /dev/null"});
  };

  const Outcome declined = type("disconnect 'desk/*/Robot'");
  EXPECT_THAT(declined.out, HasSubstr("disconnect 2 interfaces: desk/supervisor/Robot "
                                      "desk/teleoperation/Robot? [y/N] "));
  EXPECT_EQ(declined.exit_code, program::kRefused);
  const Outcome ended = type("disconnect 'desk/*/Robot' --yes");

  EXPECT_EQ(ended.exit_code, program::kOk) << ended.out;
  EXPECT_THAT(Gcm({"show", "desk/supervisor/Robot"}).out, HasSubstr("not connected"));
  EXPECT_THAT(Gcm({"show", "desk/teleoperation/Robot"}).out, HasSubstr("not connected"));
  ExpectError({"disconnect", "desk/*/Robot"}, program::kNotFound,
              "no interface that matches 'desk/*/Robot' is connected");
}

TEST_F(GlobTest, LogLevelIsSetInAllMatches) {
  EXPECT_EQ(Gcm({"log-level", "*", "info", "--dry-run"}).out,
            "desk\twould be set to log info and above\n"
            "robot\twould be set to log info and above\n");
  EXPECT_EQ(Gcm({"log-level", "r*", "info"}).out, "robot\tset to log info and above\n");
  ExpectError({"log-level", "x*", "info"}, program::kNotFound, "no available process matches 'x*'");
}

TEST_F(GlobTest, VerbsForOneNameRejectAGlob) {
  const std::vector<Program::Words> lines = {
      {"hz", "robot/*"},   {"candidates", "robot/*"},       {"explain", "robot/*"},
      {"call", "robot/*"}, {"explain", "a/b/C", "robot/*"}, {"classes", "robot/*"}};
  for (const Program::Words& words : lines) {
    ExpectError(words, program::kUsage,
                "gcm: 'robot/*' may match several objects, but gcm " + words[0] +
                    " needs exactly one name; to list the matches: gcm find 'robot/*'\n");
  }
  ExpectError({"connect", "desk/*/Robot", "robot/arm/Control"}, program::kUsage,
              "gcm connect without --match needs exactly one name");
}

}  // namespace
