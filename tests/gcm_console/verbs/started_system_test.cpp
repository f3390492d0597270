#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>
#include <tendon/base/os/process.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "gcm_console/system_fixture.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

/// A GCM that starts the processes of a system file.
class StartedSystemTest : public SystemFixture {
 protected:
  void SetUp() override {
    home.Write("lab.json", R"({"version": 1, "name": "lab", "processes": [
        {"name": "robot", "start": {"restart": "on-failure"}, "components": [
          {"name": "arm", "class": "SimulatedArm", "library": "simulated_arm",
           "thread": {"cpus": []}},
          {"name": "ticks", "class": "Counter", "library": "counter", "state": "constructed"}]},
        {"name": "desk", "start": {"restart": "never"}, "components": [
          {"name": "supervisor", "class": "ArmSupervisor", "library": "arm_supervisor"}]}],
        "connections": [
          {"required": "desk/supervisor/Robot", "provided": "robot/arm/Control"}]})");
    StartGcm();
  }

  /// Ends the processes that the GCM has started; otherwise they would continue.
  void TearDown() override {
    SystemFixture::TearDown();
    gcm.reset();  // ends first, because the GCM would start the processes again
    for (const auto& folder : std::filesystem::directory_iterator("/proc")) {
      std::ifstream file(folder.path() / "cmdline", std::ios::binary);
      const std::string words(std::istreambuf_iterator<char>(file), {});
      const bool is_lcm = words.find("/lcm") != std::string::npos;
      if (is_lcm && words.find(address) != std::string::npos) {
        kill(std::stoi(folder.path().filename().string()), SIGKILL);
      }
    }
  }

  [[nodiscard]] std::string File() const { return (home.path() / "lab.json").string(); }
  void Apply() const {
    const Outcome applied = Gcm({"apply", File()});
    ASSERT_EQ(applied.exit_code, program::kOk) << applied.out << applied.err;
  }
  [[nodiscard]] int PidOf(const std::string& process) const {
    const std::string shown = Gcm({"show", process}).out;
    const std::string before = "\npid\t";
    const std::size_t at = shown.find(before);
    return at == shown.npos ? 0 : std::stoi(shown.substr(at + before.size()));
  }
  /// Kills a process and returns its former pid.
  int Kill(const std::string& process, int signal = SIGKILL) const {
    const int pid = PidOf(process);
    if (pid <= 1) throw std::runtime_error("no process " + process);
    kill(pid, signal);
    return pid;
  }
  /// Kills a process, and waits until the GCM has started it again.
  void KillAndAwait(const std::string& process) const {
    const int pid = Kill(process);
    ASSERT_TRUE(EventuallyTrue([&] {
      return PidOf(process) != pid &&
             Gcm({"ls"}).out.find(process + "\talive") != std::string::npos;
    })) << Gcm({"show", process}).out;
  }
};

TEST_F(StartedSystemTest, SaveRecordsProcessesThatTheGcmStarted) {
  Apply();
  const auto other =
      std::make_unique<Program>(Program::Words{Binary("lcm"), "--name", "spare", "--gcm", address});
  ASSERT_TRUE(EventuallySays({"ls"}, "spare\talive")) << other->err();
  const std::string fresh = (home.path() / "fresh.json").string();

  ASSERT_EQ(Gcm({"save", fresh}).exit_code, program::kOk);

  std::ifstream file(fresh);
  const json saved = json::parse(file);
  ASSERT_EQ(saved["processes"].size(), 3U);
  EXPECT_EQ(saved["processes"][0]["start"]["restart"], "never") << "desk";
  EXPECT_EQ(saved["processes"][1]["start"]["restart"], "on-failure") << "robot";
  EXPECT_FALSE(saved["processes"][2].contains("start")) << "spare";
}

TEST_F(StartedSystemTest, ApplyStartsAWholeSystem) {
  const Outcome planned = Gcm({"plan", File()});
  EXPECT_EQ(planned.exit_code, program::kOk) << planned.err;
  EXPECT_EQ(planned.out,
            "  start process robot (restart on-failure)\n"
            "  start process desk (restart never)\n"
            "  create robot/arm (SimulatedArm of simulated_arm)\n"
            "  create robot/ticks (Counter of counter)\n"
            "  create desk/supervisor (ArmSupervisor of arm_supervisor)\n"
            "  connect desk/supervisor/Robot -> robot/arm/Control\n"
            "  start robot/arm\n"
            "  start desk/supervisor\n");

  const Outcome applied = Gcm({"apply", File()});

  EXPECT_EQ(applied.exit_code, program::kOk) << applied.err;
  EXPECT_THAT(applied.out,
              testing::StartsWith("1/8  ok   start process robot (restart on-failure)\n"));
  EXPECT_TRUE(EventuallySays({"get", "robot/arm/state.Joints"}, "position"));
  EXPECT_TRUE(EventuallySays({"ls", "desk/supervisor"}, "-> robot/arm/Control\n"));
  EXPECT_EQ(Gcm({"apply", File()}).out, "");
  EXPECT_EQ(Gcm({"diff", File()}).out, "");
  EXPECT_THAT(Gcm({"history"}).out, HasSubstr("\tgcm apply of " + tendon::os::UserAtHost() + "\t"));
  EXPECT_THAT(Gcm({"history"}).out, HasSubstr("start robot\n"));
  ASSERT_EQ(Gcm({"save", File()}).exit_code, program::kOk);
  const json saved = json::parse(home.Read("lab.json"));
  EXPECT_EQ(saved["processes"][1]["start"], (json{{"restart", "on-failure"}}));
}

TEST_F(StartedSystemTest, AKilledProcessRestartsWithItsState) {
  Apply();
  ASSERT_EQ(Gcm({"start", "robot/ticks"}).exit_code, program::kOk);
  ASSERT_EQ(Gcm({"suspend", "robot/arm"}).exit_code, program::kOk);
  const std::string before = Gcm({"tree"}).out;

  KillAndAwait("robot");

  EXPECT_TRUE(EventuallyTrue([&] { return Gcm({"tree"}).out == before; }))
      << before << "became" << Gcm({"tree"}).out;
  EXPECT_THAT(Gcm({"log"}).out, HasSubstr("was ended by SIGKILL"));
  EXPECT_TRUE(EventuallySays({"ls", "desk/supervisor"}, "-> robot/arm/Control\n"));
  KillAndAwait("robot");  // this time, there was no order between two starts
  EXPECT_TRUE(EventuallyTrue([&] { return Gcm({"tree"}).out == before; })) << Gcm({"tree"}).out;
}

TEST_F(StartedSystemTest, AProcessWithRestartNeverIsNotRestarted) {
  Apply();

  Kill("desk");

  EXPECT_TRUE(EventuallySays({"show", "desk"}, "it is not restarted (restart never)"));
  Apply();
  EXPECT_TRUE(EventuallySays({"ls", "desk/supervisor"}, "-> robot/arm/Control\n"));
}

TEST_F(StartedSystemTest, KillEndsAProcessForGood) {
  Apply();
  EXPECT_EQ(Gcm({"kill", "robot", "--dry-run"}).out, "robot\twould be ended\n");

  const Outcome killed = Gcm({"kill", "robot", "rob"});

  EXPECT_EQ(killed.exit_code, program::kPartial);
  EXPECT_EQ(killed.out, "robot\tended\n");
  EXPECT_THAT(killed.err, HasSubstr("gcm: rob: no process 'rob'"));
  EXPECT_THAT(Gcm({"ls"}).out, HasSubstr("robot\tleft"));
  EXPECT_EQ(Gcm({"kill", "robot"}).err, "gcm: robot: process 'robot' is already gone\n");
  EXPECT_EQ(Gcm({"forget", "robot", "--dry-run"}).out, "robot\twould be forgotten\n");
  EXPECT_EQ(Gcm({"forget", "robot"}).out, "robot\tforgotten\n");
  EXPECT_THAT(Gcm({"ls"}).out, testing::Not(HasSubstr("robot")));
  EXPECT_EQ(
      Gcm({"forget", "desk"}).err,
      "gcm: desk: process 'desk' is not gone; only a process that is gone can be forgotten\n");
  EXPECT_EQ(Gcm({"--read-only", "kill", "desk"}).exit_code, program::kDenied);
  Apply();
  EXPECT_TRUE(EventuallySays({"ls", "desk/supervisor"}, "-> robot/arm/Control\n"));
}

TEST_F(StartedSystemTest, KillAndForgetByGlobNeedConfirmation) {
  Apply();
  const auto type = [this](const std::string& words, const std::string& answer) {
    const std::string line =
        Binary("gcm") + " --gcm " + address + " --timeout " + kTestTimeout + " " + words;
    return RunProgram(
        {"/bin/sh", "-c", "printf '" + answer + "\\n' | script -qec \"" + line + "\" /dev/null"});
  };
  EXPECT_EQ(Gcm({"kill", "*", "--dry-run"}).out, "desk\twould be ended\nrobot\twould be ended\n");
  EXPECT_EQ(Gcm({"kill", "x*"}).err,
            "gcm: no process matches 'x*'; to list all processes: gcm ls\n");
  EXPECT_EQ(Gcm({"kill", "x*"}).exit_code, program::kNotFound);

  const Outcome declined = type("kill '*'", "n");
  EXPECT_THAT(declined.out, HasSubstr("kill 2 processes: desk robot? [y/N] "));
  EXPECT_EQ(declined.exit_code, program::kRefused) << declined.out;
  EXPECT_TRUE(EventuallySays({"ls"}, "robot\talive"));

  EXPECT_EQ(Gcm({"kill", "desk"}).exit_code, program::kOk);
  const Outcome killed = Gcm({"kill", "*"});
  EXPECT_EQ(killed.exit_code, program::kOk) << killed.err;
  EXPECT_EQ(killed.out, "robot\tended\n");
  EXPECT_EQ(killed.err,
            "gcm: 1 match is skipped, because it cannot be ended in its current state\n");
  EXPECT_THAT(type("forget '*' --yes", "n").out, testing::Not(HasSubstr("[y/N]")));
  EXPECT_EQ(Gcm({"ls"}).out, "");
}

TEST_F(StartedSystemTest, KillByGlobEndsAHangingProcess) {
  Apply();
  Kill("robot", SIGSTOP);
  ASSERT_TRUE(EventuallySays({"ls"}, "robot\tlost"));

  EXPECT_EQ(Gcm({"kill", "*", "--dry-run"}).out, "desk\twould be ended\nrobot\twould be ended\n");
  // The stopped process does not receive the order to end. gcm waits three times the time-out.
  const Outcome killed = Typed({"--timeout", "3000", "kill", "rob*"});

  EXPECT_EQ(killed.out, "robot\tended\n") << killed.err;
  EXPECT_EQ(Gcm({"forget", "robot"}).out, "robot\tforgotten\n");
}

TEST_F(StartedSystemTest, StartedProcessesOutliveTheGcm) {
  Apply();
  const int robot = PidOf("robot");
  gcm->Signal(SIGTERM);
  ASSERT_EQ(gcm->Wait(), 0) << gcm->err();

  StartGcm();

  ASSERT_TRUE(EventuallySays({"ls"}, "robot\talive"));
  ASSERT_TRUE(EventuallySays({"ls", "desk/supervisor"}, "-> robot/arm/Control\n"));
  EXPECT_EQ(PidOf("robot"), robot);
  EXPECT_EQ(Gcm({"apply", File()}).out, "");
  const Outcome refused = Gcm({"kill", "robot"});
  EXPECT_EQ(refused.exit_code, program::kRefused);
  EXPECT_THAT(refused.err,
              HasSubstr("was not started by this GCM: end the process where it was started"));
  EXPECT_THAT(refused.err, HasSubstr("by: kill " + std::to_string(robot)));
}

TEST_F(StartedSystemTest, UndoRevertsAnApplyIncludingItsProcess) {
  json file = json::parse(home.Read("lab.json"));
  file["processes"].erase(1);
  file["connections"] = json::array();
  home.Write("lab.json", file.dump());
  Apply();

  const Outcome undone = Gcm({"undo", "4"});

  EXPECT_EQ(undone.exit_code, program::kOk) << undone.err;
  EXPECT_EQ(undone.out,
            "undone: start robot/arm\nundone: create robot/ticks\nundone: create robot/arm\n"
            "undone: start robot\n");
  EXPECT_THAT(Gcm({"ls"}).out, HasSubstr("robot\tleft"));
}

TEST_F(StartedSystemTest, AFailedProcessStartNamesItsLog) {
  const auto other = std::make_unique<Program>(
      Program::Words{Binary("lcm"), "--name", "desk", "--gcm", address, "--timeout", kTestTimeout});
  ASSERT_TRUE(EventuallySays({"ls"}, "desk\talive"));
  const auto folder = home.path() / "tendon" / ("processes-127.0.0.1-" + port);
  // A folder with the name of the log file.
  std::filesystem::create_directories(folder / "robot.log");
  std::filesystem::create_directories(folder / "robot.log.1" / "full");

  const Outcome applied = Gcm({"apply", File()});

  EXPECT_EQ(applied.exit_code, program::kRefused) << applied.err;
  EXPECT_THAT(applied.out, HasSubstr("1/7  BAD  start process robot (restart on-failure): "));
  EXPECT_THAT(applied.out, HasSubstr("robot.log"));
  EXPECT_THAT(applied.out, HasSubstr("2/7  left create robot/arm"));
}

}  // namespace
