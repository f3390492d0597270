#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <tendon/base/log.h>
#include <tendon/gcm/supervisor/lcm_launcher.h>
#include <tests/support/folder.h>
#include <tests/support/wait.h>
#include <unistd.h>

#include <memory>

namespace tendon::server {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using testing::HasSubstr;

class LcmLauncherTest : public testing::Test {
 protected:
  /// Writes a script that replaces lcm.
  void Script(const std::string& text) const {
    home_.Write("lcm", "#!/bin/sh\n" + text + "\n");
    std::filesystem::permissions(home_.path() / "lcm", std::filesystem::perms::owner_all);
  }
  [[nodiscard]] LcmLauncher Make(const std::string& gcm = "127.0.0.1:1") const {
    return {{.program = home_.path() / "lcm",
             .options =
                 [](const std::string& process) {
                   return std::vector<std::string>{"--certificate", process + ".crt"};
                 }},
            gcm,
            home_.path() / "state"};
  }
  static ProcessEnd WaitForEndOf(StartedProcess& process) {
    std::optional<ProcessEnd> end;
    EXPECT_TRUE(EventuallyTrue([&] { return (end = process.Ended()).has_value(); }));
    return end.value_or(ProcessEnd());
  }

  const test::Folder home_;
};

TEST_F(LcmLauncherTest, StartsTheProgramAndKeepsItsOutput) {
  Script("echo \"$*\"; echo 'no GCM' >&2; exit 3");
  LcmLauncher launcher = Make("0.0.0.0:10705");

  const auto process = launcher.Start({.process = "robot", .timeout = 2s});

  ASSERT_TRUE(process) << process.error().message;
  const ProcessEnd end = WaitForEndOf(**process);
  EXPECT_TRUE(end.is_failure);
  EXPECT_EQ(end.how, "ended with exit code 3");
  EXPECT_EQ(launcher.LogOf("robot").last_lines,
            "--name robot --gcm 127.0.0.1:10705 --timeout 2000 --certificate robot.crt | no GCM");
  EXPECT_EQ(launcher.LogOf("robot").path, (home_.path() / "state" / "robot.log").string());
  struct stat status {};
  ASSERT_EQ(stat((home_.path() / "state" / "robot.log").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0600U);
}

TEST_F(LcmLauncherTest, StartsAProgramInItsOwnSessionAndEndsIt) {
  Script("exec sleep 1000");
  LcmLauncher launcher = Make();

  const auto process = launcher.Start({.process = "robot", .timeout = 2s});
  ASSERT_TRUE(process) << process.error().message;
  const auto pid = static_cast<pid_t>((*process)->pid());
  EXPECT_TRUE(EventuallyTrue([&] { return getsid(pid) == pid; }));
  EXPECT_EQ((*process)->Ended(), std::nullopt);

  (*process)->Terminate();
  EXPECT_EQ(WaitForEndOf(**process).how, "was ended by SIGTERM");
}

TEST_F(LcmLauncherTest, PassesTheSystemFileAndKeepsTheFormerLog) {
  Script("echo \"$*\"");
  LcmLauncher launcher = Make();
  const auto first = launcher.Start({.process = "robot", .timeout = 2s});
  ASSERT_TRUE(first);
  EXPECT_FALSE(WaitForEndOf(**first).is_failure);
  SystemFile system;
  system.processes.push_back({.name = "robot", .components = {}});

  const auto process = launcher.Start({.process = "robot", .timeout = 2s, .system = system});

  ASSERT_TRUE(process) << process.error().message;
  WaitForEndOf(**process);
  const std::string file = (home_.path() / "state" / "robot.json").string();
  EXPECT_THAT(home_.Read("state/robot.log"), HasSubstr("--system " + file + "\n"));
  EXPECT_THAT(home_.Read("state/robot.log.1"), HasSubstr("--name robot"));
  EXPECT_NE(ReadSystemFile(file)->FindProcess("robot"), nullptr);
}

TEST_F(LcmLauncherTest, RotatesALongLogOfARunningProgram) {
  const std::string fifo = (home_.path() / "fifo").string();
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  Script("echo 'a long line'; read -r go < " + fifo + "; echo more; exec sleep 1000");
  LcmLauncher launcher({.program = home_.path() / "lcm", .longest_log = 8}, "127.0.0.1:1",
                       home_.path() / "state");
  const auto process = launcher.Start({.process = "robot", .timeout = 2s});
  ASSERT_TRUE(process) << process.error().message;
  ASSERT_TRUE(EventuallyTrue([&] { return home_.Read("state/robot.log") == "a long line\n"; }));

  launcher.ShortenLog("robot");

  EXPECT_EQ(home_.Read("state/robot.log"), "");
  EXPECT_EQ(home_.Read("state/robot.log.1"), "a long line\n");
  EXPECT_EQ(launcher.LogOf("robot").last_lines, "a long line");
  home_.Write("fifo", "go\n");
  EXPECT_TRUE(EventuallyTrue([&] { return home_.Read("state/robot.log") == "more\n"; }));
  launcher.ShortenLog("robot");  // although the log is short
  EXPECT_EQ(home_.Read("state/robot.log"), "more\n");
  EXPECT_EQ(launcher.LogOf("robot").last_lines, "more");
  (*process)->Kill();
  EXPECT_EQ(WaitForEndOf(**process).how, "was ended by SIGKILL");
}

TEST_F(LcmLauncherTest, TruncatesALogThatCannotBeRotated) {
  Script("echo 'a long line'; exec sleep 1000");
  LcmLauncher launcher({.program = home_.path() / "lcm", .longest_log = 8}, "127.0.0.1:1",
                       home_.path() / "state");
  const auto process = launcher.Start({.process = "robot", .timeout = 2s});
  ASSERT_TRUE(process) << process.error().message;
  const std::string log = (home_.path() / "state" / "robot.log").string();
  ASSERT_TRUE(EventuallyTrue([&] { return home_.Read("state/robot.log") == "a long line\n"; }));
  std::filesystem::create_directories(log + ".1/full");  // a folder at the path of the file
  // Shared, because the log sink outlives this test.
  const auto logged = std::make_shared<std::string>();
  AddLogSink([logged](LogLevel, std::string_view, std::string_view text) { *logged += text; });

  launcher.ShortenLog("robot");

  EXPECT_THAT(*logged,
              testing::StartsWith("the log of process 'robot', " + log +
                                  ", is too long and could not be kept as " + log + ".1 ("));
  EXPECT_THAT(*logged, HasSubstr("), so the previous log is lost; free some disk space, or"));
  EXPECT_EQ(home_.Read("state/robot.log"), "");
  logged->clear();
  home_.Write("state/robot.log", "another long line\n");
  launcher.ShortenLog("robot");
  EXPECT_EQ(*logged, "");

  const auto second = launcher.Start({.process = "robot", .timeout = 2s});
  ASSERT_TRUE(second) << second.error().message;
  EXPECT_THAT(*logged, HasSubstr("the previous log of process 'robot', " + log +
                                 ", could not be kept as " + log + ".1: "));
  (*process)->Kill();
  (*second)->Kill();
}

TEST_F(LcmLauncherTest, ReportsAMissingProgramOrAddress) {
  LcmLauncher launcher = Make();
  const auto missing = launcher.Start({.process = "robot"});
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().message,
            "there is no " + (home_.path() / "lcm").string() +
                ": a GCM starts the program lcm from the folder that contains the program of the "
                "GCM; install lcm in that folder");

  home_.Write("lcm", "no program");
  const auto refused = launcher.Start({.process = "robot"});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("could not be started with the log file"));

  LcmLauncher without({}, "127.0.0.1:1", home_.path());
  EXPECT_EQ(without.Start({.process = "robot"}).error().message,
            "this GCM cannot start processes; to start this process yourself: lcm --name robot");
}

}  // namespace
}  // namespace tendon::server
