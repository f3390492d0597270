#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "gcm_console/demo_fixture.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

/// Tests verbs with --dry-run, which print their actions but do not execute them.
class DryRunTest : public DemoFixture {
 protected:
  [[nodiscard]] std::string InHome(const std::string& name) const {
    return (home.path() / name).string();
  }
  /// Expects that the real command would be refused with this exit code and sentence.
  void ExpectRefusal(const Program::Words& words, int exit_code, const std::string& sentence) {
    const Outcome refused = Gcm(words);
    EXPECT_EQ(refused.exit_code, exit_code) << refused.out;
    EXPECT_THAT(refused.err, HasSubstr(sentence));
    EXPECT_EQ(refused.out, "");
  }
};

TEST_F(DryRunTest, UndoListsTheStepsItWouldRevert) {
  ExpectRefusal({"undo", "--dry-run"}, program::kRefused, "there is nothing to undo");
  ASSERT_EQ(Gcm({"stop", "robot/host_monitor"}).exit_code, program::kOk);
  ASSERT_EQ(Gcm({"disconnect", "desk/supervisor/Robot"}).exit_code, program::kOk);

  const Outcome undone = Gcm({"undo", "5", "--dry-run"});

  EXPECT_EQ(undone.exit_code, program::kOk) << undone.err;
  EXPECT_EQ(undone.out,
            "would be undone: disconnect desk/supervisor/Robot robot/arm/Control\n"
            "would be undone: stop robot/host_monitor\n");
  const json document = json::parse(Gcm({"undo", "--dry-run", "--json"}).out);
  EXPECT_EQ(document["dry_run"], true);
  EXPECT_EQ(document["undone"].size(), 1U);
  EXPECT_THAT(Gcm({"history"}).out, testing::Not(HasSubstr("\tundone\t")));
  EXPECT_THAT(Gcm({"show", "desk/supervisor/Robot"}).out, HasSubstr("not connected"));
  ExpectRefusal({"undo", "--step", "1", "--dry-run"}, program::kRefused, "is not the newest");
}

TEST_F(DryRunTest, UndoGivesTheSameRefusal) {
  ASSERT_EQ(Gcm({"disconnect", "desk/supervisor/Robot"}).exit_code, program::kOk);
  desk->Signal(SIGKILL);
  ASSERT_TRUE(EventuallySays({"ls"}, "desk\tlost"));
  desk = StartLcm("desk", demo);
  ASSERT_TRUE(EventuallySays({"ls", "desk/supervisor"}, "-> robot/arm/Control\n"));

  const Outcome dry = Gcm({"undo", "--dry-run"});

  EXPECT_EQ(dry.exit_code, program::kRefused) << dry.out;
  EXPECT_THAT(dry.err, HasSubstr("process 'desk' was restarted since"));
  EXPECT_EQ(dry.err, Gcm({"undo"}).err);
}

TEST_F(DryRunTest, CallChecksTheArgument) {
  const std::string move = "robot/arm/Control.MoveTo";
  const std::string goal = R"({"position": [0.1, 0, 0, -1, 0, 1, 0], "duration": 0.2})";

  EXPECT_EQ(Gcm({"call", move, goal, "--dry-run"}).out, move + "\twould be called\n");
  EXPECT_EQ(Gcm({"call", "robot/arm/Control.Stop", "--dry-run"}).exit_code, program::kOk);
  ExpectRefusal({"call", move, R"({"positon": []})", "--dry-run"}, program::kUsage, "positon");
  ExpectRefusal({"call", "robot/arm/Control.Stop", "3", "--dry-run"}, program::kUsage,
                "takes no argument");
  ExpectRefusal({"call", "robot/arm/Control.Mov", "--dry-run"}, program::kNotFound, "no command");
  EXPECT_EQ(json::parse(Gcm({"call", move, goal, "--dry-run", "--json"}).out)["dry_run"], true);
}

TEST_F(DryRunTest, KillRefusesAProcessNotStartedByTheGcm) {
  for (const Program::Words& words :
       {Program::Words{"kill", "robot"}, {"kill", "robot", "--dry-run"}}) {
    ExpectRefusal(words, program::kRefused, "process 'robot' was not started by this GCM");
  }
}

TEST_F(DryRunTest, LogLevelIsNotSet) {
  EXPECT_EQ(Gcm({"log-level", "robot", "debug", "--dry-run"}).out,
            "robot  would log debug and above\n");
  ExpectRefusal({"log-level", "robt", "debug", "--dry-run"}, program::kNotFound,
                "did you mean 'robot'?");
}

TEST_F(DryRunTest, RefusesUnknownClassesAndPlugins) {
  ExpectRefusal({"load", "nope", "--in", "robot", "--dry-run"}, program::kNotFound,
                "no plug-in 'nope'");
  EXPECT_EQ(Gcm({"load", "counter", "--in", "robot", "--dry-run"}).exit_code, program::kOk);
  ExpectRefusal({"create", "SimulatedAm", "robot/new", "--dry-run"}, program::kNotFound,
                "did you mean 'SimulatedArm'?");
  ExpectRefusal({"create", "Counter", "robot/new", "--library", "couter", "--dry-run"},
                program::kNotFound, "no plug-in 'couter'; did you mean 'counter'?");
  ExpectRefusal({"create", "Countr", "robot/new", "--library", "simulated_arm", "--dry-run"},
                program::kNotFound, "has no class 'Countr' in simulated_arm");
  EXPECT_EQ(Gcm({"create", "Counter", "robot/new", "--library", "counter", "--dry-run"}).out,
            "robot/new\twould be created\n");
}

TEST_F(DryRunTest, ChecksAConfigurationAgainstItsClass) {
  const std::string bad = R"({"nois": 1})";
  const std::string good = R"({"noise": 0.001})";

  ExpectRefusal({"create", "SimulatedArm", "robot/new", "--arg", bad, "--dry-run"}, program::kUsage,
                "did you mean 'noise'?");
  ExpectRefusal({"create", "SimulatedArm", "robot/new", "--arg", "{", "--dry-run"}, program::kUsage,
                "its configuration is not valid JSON");
  ExpectRefusal({"create", "SimulatedArm", "robot/new", "--arg", "[]", "--dry-run"},
                program::kUsage, "must be a JSON object");
  EXPECT_EQ(Gcm({"create", "SimulatedArm", "robot/new", "--arg", good, "--dry-run"}).exit_code,
            program::kOk);
  ASSERT_EQ(Gcm({"stop", "robot/arm"}).exit_code, program::kOk);
  ExpectRefusal({"configure", "robot/arm", "--arg", bad, "--dry-run"}, program::kUsage,
                "did you mean 'noise'?");
  EXPECT_EQ(Gcm({"configure", "robot/arm", "--arg", good, "--dry-run"}).out,
            "robot/arm\twould be configured\n");
}

TEST_F(DryRunTest, DeniesAViewerLikeTheRealCommand) {
  const std::vector<Program::Words> orders = {
      {"stop", "robot/arm"},
      {"forget", "robot"},
      {"load", "counter", "--in", "robot"},
      {"create", "Counter", "robot/new", "--library", "counter"},
      {"connect", "desk/teleoperation/Robot", "robot/arm/Control"},
      {"disconnect", "desk/supervisor/Robot"},
      {"log-level", "robot", "debug"},
      {"call", "robot/arm/Control.Stop"},
      {"undo"}};
  for (Program::Words words : orders) {
    words.insert(words.begin(), "--read-only");
    words.push_back("--dry-run");
    ExpectRefusal(words, program::kDenied, "gcm " + words[1] + " needs the role operator");
  }
}

TEST_F(DryRunTest, NoFileIsWritten) {
  home.Write("cisst.json", R"({"components": [{"class-name": "mtsArm",
      "constructor-arg": {"Name": "arm"}}]})");

  EXPECT_EQ(Gcm({"save", InHome("saved.json"), "--dry-run"}).out,
            InHome("saved.json") + "  2 processes, 5 components, 1 connection; would be written\n");
  const Outcome imported = Gcm({"import", InHome("cisst.json"), InHome("new.json"), "--process",
                                "robot", "--dry-run", "--json"});

  EXPECT_EQ(imported.exit_code, program::kOk) << imported.err;
  EXPECT_EQ(json::parse(imported.out)["dry_run"], true);
  EXPECT_FALSE(std::filesystem::exists(InHome("saved.json")));
  EXPECT_FALSE(std::filesystem::exists(InHome("new.json")));
}

}  // namespace
