#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>
#include <sys/stat.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "gcm_console/system_fixture.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

/// A GCM and a process without components. The test types commands like a user.
class LifecycleVerbsTest : public SystemFixture {
 protected:
  void SetUp() override {
    StartGcm();
    robot = StartEmpty("robot");
    ASSERT_TRUE(EventuallySays({"ls"}, "robot\talive")) << robot->err();
  }
  std::unique_ptr<Program> StartEmpty(const std::string& name) const {
    return std::make_unique<Program>(
        Program::Words{Binary("lcm"), "--name", name, "--gcm", address, "--timeout", kTestTimeout});
  }
  void Create(const Program::Words& names) const {
    for (const std::string& name : names) {
      const Outcome created = Gcm({"create", "Counter", name, "--library", "counter"});
      ASSERT_EQ(created.exit_code, program::kOk) << created.err;
    }
  }
  std::unique_ptr<Program> robot;
};

TEST_F(LifecycleVerbsTest, VerbsDriveAComponentThroughItsLifecycle) {
  EXPECT_EQ(Gcm({"load", "simulated_arm"}).out, "robot simulated_arm\tloaded\n");
  EXPECT_THAT(Gcm({"classes"}).out,
              HasSubstr("SimulatedArm\tsimulated_arm\tarm.ArmConfiguration\t"));
  EXPECT_THAT(Gcm({"classes", "robot", "SimulatedArm"}).out, HasSubstr("bandwidth: float64"));

  EXPECT_EQ(Gcm({"create", "SimulatedArm", "arm", "--arg", R"({"noise": 0.001})"}).out,
            "robot/arm\tcreated\n");
  EXPECT_EQ(Gcm({"start", "robot/arm"}).out, "robot/arm\tstarted\n");
  EXPECT_TRUE(EventuallySays({"get", "robot/arm/state.Joints"}, "position"));
  EXPECT_EQ(Gcm({"suspend", "robot/arm"}).out, "robot/arm\tsuspended\n");
  EXPECT_EQ(Gcm({"restart", "robot/arm"}).out, "robot/arm\trestarted\n");
  EXPECT_EQ(Gcm({"stop", "robot/arm"}).out, "robot/arm\tstopped\n");
  EXPECT_EQ(Gcm({"configure", "robot/arm", "--arg", R"({"noise": 0})"}).out,
            "robot/arm\tconfigured\n");
  EXPECT_EQ(Gcm({"rm", "robot/arm"}).out, "robot/arm\tremoved\n");

  EXPECT_THAT(Gcm({"tree"}).out, testing::Not(HasSubstr("arm")));
}

TEST_F(LifecycleVerbsTest, AGlobSkipsComponentsInOtherStates) {
  Create({"one", "two", "three"});
  ASSERT_EQ(Gcm({"start", "robot/one"}).exit_code, program::kOk);

  const Outcome started = Gcm({"start", "robot/*"});
  EXPECT_EQ(started.exit_code, program::kOk) << started.err;
  EXPECT_EQ(started.out, "robot/three\tstarted\nrobot/two\tstarted\n");
  EXPECT_EQ(started.err,
            "gcm: 1 match is skipped, because it cannot be started in its current state\n");

  const Outcome removed = Gcm({"rm", "**"});
  EXPECT_EQ(removed.out, "robot/one\tremoved\nrobot/three\tremoved\nrobot/two\tremoved\n");
  EXPECT_EQ(Gcm({"rm", "**"}).exit_code, program::kNotFound);
}

TEST_F(LifecycleVerbsTest, ADryRunReportsChangesAndMakesNone) {
  Create({"one", "two"});
  ASSERT_EQ(Gcm({"start", "robot/one"}).exit_code, program::kOk);

  EXPECT_EQ(Gcm({"stop", "robot/*", "--dry-run"}).out, "robot/one\twould be stopped\n");
  EXPECT_EQ(Gcm({"rm", "robot/one", "--dry-run"}).out, "robot/one\twould be removed\n");
  const Outcome refused = Gcm({"stop", "robot/two", "--dry-run"});
  EXPECT_EQ(refused.exit_code, program::kRefused);
  EXPECT_EQ(
      refused.err,
      "gcm: robot/two: component 'two' is constructed and not active; there is nothing to stop\n");
  EXPECT_EQ(Gcm({"create", "Counter", "one", "--dry-run"}).exit_code, program::kRefused);

  EXPECT_THAT(Gcm({"ls", "robot"}).out, HasSubstr("one\tactive"));
}

TEST_F(LifecycleVerbsTest, APartialSuccessHasItsOwnExitCode) {
  Create({"one", "two"});
  ASSERT_EQ(Gcm({"start", "robot/one"}).exit_code, program::kOk);

  const Outcome stopped = Gcm({"--json", "stop", "robot/one", "robot/two"});

  EXPECT_EQ(stopped.exit_code, program::kPartial) << stopped.err;
  const json results = json::parse(stopped.out)["results"];
  EXPECT_EQ(results[0]["path"], "robot/one");
  EXPECT_EQ(results[0]["done"], true);
  EXPECT_EQ(results[1]["done"], false);
  EXPECT_THAT(results[1]["reason"], HasSubstr("there is nothing to stop"));
}

TEST_F(LifecycleVerbsTest, AsksForConfirmationAtATerminalBeforeAGlob) {
  Create({"one", "two"});
  const auto type = [this](const std::string& words, const std::string& answer) {
    const std::string gcm_words =
        Binary("gcm") + " --gcm " + address + " --timeout " + kTestTimeout + " " + words;
    return RunProgram({"/bin/sh", "-c",
                       "printf '" + answer + "\\n' | script -qec \"" + gcm_words + "\" /dev/null"});
  };

  const Outcome declined = type("start 'robot/*'", "n");
  EXPECT_THAT(declined.out, HasSubstr("start 2 components: robot/one robot/two? [y/N] "));
  EXPECT_EQ(declined.exit_code, program::kRefused) << declined.out;
  EXPECT_THAT(Gcm({"ls", "robot"}).out, testing::Not(HasSubstr("active")));

  EXPECT_EQ(type("start 'robot/*'", "y").exit_code, program::kOk);
  EXPECT_THAT(Gcm({"ls", "robot"}).out, HasSubstr("two\tactive"));
  EXPECT_THAT(type("stop 'robot/*' --yes", "n").out, testing::Not(HasSubstr("[y/N]")));
  EXPECT_THAT(Gcm({"ls", "robot"}).out, testing::Not(HasSubstr("active")));
}

TEST_F(LifecycleVerbsTest, ExplainsMistakes) {
  const std::string file = (home.path() / "arm.json").string();
  std::ofstream(file) << R"({"nois": 0.5})";

  EXPECT_THAT(Gcm({"load", "simulated_am"}).err,
              HasSubstr("no plug-in 'simulated_am'; did you mean 'simulated_arm'?"));
  const Outcome created = Gcm(
      {"create", "SimulatedArm", "robot/arm", "--library", "simulated_arm", "--configure", file});
  EXPECT_EQ(created.exit_code, program::kUsage);
  EXPECT_THAT(created.err, HasSubstr("did you mean 'noise'?"));
  EXPECT_EQ(Gcm({"create", "SimulatedArm", "arm", "--configure", "missing.json"}).exit_code,
            program::kNotFound);
  EXPECT_EQ(Gcm({"create", "SimulatedArm", "arm", "--in", "robbot"}).err,
            "gcm: no process 'robbot'; did you mean 'robot'?\n");
  EXPECT_EQ(Gcm({"start", "robot"}).exit_code, program::kUsage);
  EXPECT_EQ(Gcm({"--read-only", "create", "Counter", "one", "--library", "counter"}).exit_code,
            program::kDenied);

  const auto desk = StartEmpty("desk");
  ASSERT_TRUE(EventuallySays({"ls"}, "desk\talive")) << desk->err();
  EXPECT_EQ(Gcm({"load", "counter"}).err,
            "gcm: there are several processes; give one of these: desk, robot\n");
}

TEST_F(LifecycleVerbsTest, ReadsAConfigurationOnlyFromARegularFile) {
  Create({"one"});
  const std::string pipe = (home.path() / "pipe.json").string();
  // No program writes to the pipe: opening it would block forever.
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string folder = home.path().string();

  for (const Program::Words& words : {Program::Words{"create", "Counter", "robot/two"},
                                      Program::Words{"configure", "robot/one"}}) {
    const auto from = [&](const std::string& file) {
      Program::Words all = words;
      all.insert(all.end(), {"--configure", file});
      return Gcm(all);
    };
    EXPECT_EQ(from(pipe).err, "gcm: " + pipe + ": is not a regular file\n");
    EXPECT_EQ(from(folder).err, "gcm: " + folder + ": is a folder, not a file\n");
    EXPECT_EQ(from(pipe).exit_code, program::kUsage);
    EXPECT_EQ(from(home.path() / "missing.json").exit_code, program::kNotFound);
  }
}

TEST_F(LifecycleVerbsTest, UndoWorksAfterARestartOfTheGcm) {
  Create({"one"});
  ASSERT_EQ(Gcm({"start", "robot/one"}).exit_code, program::kOk);
  ASSERT_EQ(Gcm({"rm", "robot/one"}).exit_code, program::kOk);
  gcm.reset();
  StartGcm();
  ASSERT_TRUE(EventuallySays({"ls"}, "robot\talive"));

  EXPECT_EQ(Gcm({"undo"}).out, "undone: remove robot/one\n");
  EXPECT_THAT(Gcm({"ls", "robot"}).out, HasSubstr("one\tactive"));
  EXPECT_EQ(Gcm({"undo"}).out, "undone: start robot/one\n");
  EXPECT_EQ(Gcm({"undo"}).out, "undone: create robot/one\n");
  EXPECT_THAT(Gcm({"ls", "robot"}).out, testing::Not(HasSubstr("one")));
}

}  // namespace
