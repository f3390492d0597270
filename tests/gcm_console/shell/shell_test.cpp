#include <fcntl.h>
#include <gcm_console/shell/shell.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>
#include <pthread.h>
#include <sys/ioctl.h>
#include <tendon/base/os/output_buffer.h>
#include <tendon/base/os/termination.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <fstream>
#include <future>
#include <ostream>
#include <sstream>
#include <thread>

#include "gcm_console/demo_fixture.h"
#include "gcm_console/terminal.h"
#include "support/program.h"

namespace {

using testing::HasSubstr;

/// A user types commands in the shell.
class ShellTest : public DemoFixture {
 protected:
  std::string Command() const {
    return Binary("gcm") + " --gcm " + address + " --timeout " + kTestTimeout +
           " --color never shell";
  }
  std::map<std::string, std::string> Environment() const {
    return {{"XDG_STATE_HOME", home.path().string()}, {"HOME", home.path().string()}};
  }
  Outcome Script(const std::string& text, const Program::Words& more = {}) const {
    const std::string file = (home.path() / "test.gcm").string();
    std::ofstream(file) << text;
    Program::Words words = {"run", file};
    words.insert(words.end(), more.begin(), more.end());
    return Gcm(words);
  }
};

TEST_F(ShellTest, RunsVerbsAndChangesThePath) {
  Terminal terminal(Command(), Environment());
  ASSERT_TRUE(terminal.Shows("gcm> ")) << terminal.seen();

  terminal.Type("cd robot/arm\r");
  ASSERT_TRUE(terminal.Shows("robot/arm> ")) << terminal.seen();
  terminal.Type("ls\r");
  EXPECT_TRUE(terminal.Shows("desk/supervisor/Robot")) << terminal.seen();
  EXPECT_TRUE(terminal.Shows("\r\nrobot/arm> ")) << terminal.seen();
  terminal.Type("get state.Joints.position[0]; ls /desk # and so on\r");
  EXPECT_TRUE(terminal.Shows("teleoperation")) << terminal.seen();
  EXPECT_TRUE(terminal.Shows("\r\nrobot/arm> ")) << terminal.seen();
  terminal.Type("..\r");
  EXPECT_TRUE(terminal.Shows("robot> ")) << terminal.seen();
  terminal.Type("lss\r");
  EXPECT_TRUE(terminal.Shows("no verb 'lss'; did you mean 'ls'?")) << terminal.seen();
  terminal.Type("exit\r");

  EXPECT_EQ(terminal.program().Wait(), program::kOk);
}

TEST_F(ShellTest, ExpandsShortenedNamesAndPrintsThem) {
  Terminal terminal(Command(), Environment());
  ASSERT_TRUE(terminal.Shows("gcm> "));
  terminal.Type("status\r");  // the prompt shows the output when the catalogue has arrived
  ASSERT_TRUE(terminal.Shows("see gcm doctor\r\ngcm> ")) << terminal.seen();

  terminal.Type("get r/a/s.J.position[0]\r");
  EXPECT_TRUE(terminal.Shows("gcm: r/a/s.J.position[0] is robot/arm/state.Joints.position[0]\r\n"))
      << terminal.seen();
  terminal.Type("cd desk; get robot/arm/state.Joints.position[0]; cd robot/arm\r");
  EXPECT_TRUE(
      terminal.Shows("gcm: robot/arm/state.Joints.position[0] is "
                     "/robot/arm/state.Joints.position[0]\r\n"))
      << terminal.seen();
  EXPECT_TRUE(terminal.Shows("\r\nrobot/arm> ")) << terminal.seen();
  terminal.Type("cd /; show d/nothing\r");
  EXPECT_TRUE(terminal.Shows("no process 'd'")) << terminal.seen();
}

TEST_F(ShellTest, AScriptNeedsFullNames) {
  EXPECT_THAT(Script("get r/a/s.J.position[0]\n").err, HasSubstr("no process 'r'"));
}

TEST_F(ShellTest, TabCompletesVerbsAndPathsFromTheLiveCatalogue) {
  Terminal terminal(Command(), Environment());
  ASSERT_TRUE(terminal.Shows("gcm> "));
  terminal.Type("status\r");  // the prompt shows the output when the catalogue has arrived
  ASSERT_TRUE(terminal.Shows("see gcm doctor\r\ngcm> ")) << terminal.seen();

  terminal.Type("sho\trob\t/ar\t/Con\t.MoveT\t\r");
  EXPECT_TRUE(terminal.Shows("gcm call robot/arm/Control.MoveTo '")) << terminal.seen();
  terminal.Type("cd rob\t/ar\t\r");
  EXPECT_TRUE(terminal.Shows("robot/arm> ")) << terminal.seen();
  terminal.Type("get state.Jo\t\r");
  EXPECT_TRUE(terminal.Shows("\"velocity\":")) << terminal.seen();
  terminal.Type("connect /desk/\t");  // two components match
  EXPECT_TRUE(terminal.Shows("/desk/supervisor/")) << terminal.seen();
  EXPECT_TRUE(terminal.Shows("/desk/teleoperation/")) << terminal.seen();
}

TEST_F(ShellTest, AnInterruptAtThePromptDiscardsTheLine) {
  Terminal terminal(Command(), Environment());
  ASSERT_TRUE(terminal.Shows("gcm> "));

  terminal.Type("frobnicate\x03");
  EXPECT_TRUE(terminal.Shows("^C\r\ngcm> ")) << terminal.seen();
  terminal.Type("\x03");  // Ctrl-C on an empty line
  EXPECT_TRUE(terminal.Shows("^C\r\ngcm> ")) << terminal.seen();
  terminal.Type("version\r");

  EXPECT_TRUE(terminal.Shows("protocol")) << terminal.seen();
}

TEST_F(ShellTest, SigtermAtThePromptEndsTheShell) {
  Terminal terminal(Command(), Environment());
  ASSERT_TRUE(terminal.Shows("gcm> "));

  terminal.program().Signal(SIGTERM);

  EXPECT_EQ(terminal.program().Wait(), 128 + SIGTERM);
}

TEST_F(ShellTest, AfterAnInterruptAScriptRunsNothingMore) {
  Terminal terminal(Binary("gcm") + " --gcm " + address + " run -", Environment());
  terminal.Type("version\r");
  ASSERT_TRUE(terminal.Shows("protocol")) << terminal.seen();

  terminal.program().Signal(SIGINT);
  terminal.Type("status\r");

  EXPECT_EQ(terminal.program().Wait(), program::kInterrupted);
  EXPECT_THAT(terminal.seen(), testing::Not(HasSubstr("with a problem")));
}

TEST_F(ShellTest, ARecursiveScriptIsStopped) {
  const Outcome outcome = Script("run " + (home.path() / "test.gcm").string() + "\n");

  EXPECT_NE(outcome.exit_code, program::kOk);
  EXPECT_THAT(outcome.err, HasSubstr("check whether a script runs itself"));
}

TEST_F(ShellTest, AcceptsAbsolutePathsAtTheTop) {
  const Outcome outcome = Script("ls /desk\n");

  EXPECT_EQ(outcome.exit_code, program::kOk) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("teleoperation"));
}

TEST_F(ShellTest, KeepsAHistoryAcrossShells) {
  {
    Terminal terminal(Command(), Environment());
    ASSERT_TRUE(terminal.Shows("gcm> "));
    terminal.Type("ls robot/host_monitor\r");
    ASSERT_TRUE(terminal.Shows("state"));
    ASSERT_TRUE(terminal.Shows("\r\ngcm> ")) << terminal.seen();
    terminal.Type("\x04");  // Ctrl-D
    EXPECT_EQ(terminal.program().Wait(), program::kOk);
  }
  Terminal terminal(Command(), Environment());
  ASSERT_TRUE(terminal.Shows("gcm> "));

  terminal.Type("\x1b[A");  // arrow up

  EXPECT_TRUE(terminal.Shows("ls robot/host_monitor")) << terminal.seen();
  EXPECT_TRUE(std::filesystem::exists(home.path() / "gcm" / "history"));
}

TEST_F(ShellTest, AnInterruptEndsTheWatchAndNotTheShell) {
  Terminal terminal(Command(), Environment());
  ASSERT_TRUE(terminal.Shows("gcm> "));
  for (int round = 0; round < 2; ++round) {
    terminal.Type("watch robot/arm/state.Joints.position[0] --hz 50\r");
    ASSERT_TRUE(terminal.Shows("TIME/ns        \tTICK\trobot/arm/state.Joints.position[0]\r\n"));
    ASSERT_TRUE(terminal.Shows("\t0\r\n")) << terminal.seen();

    terminal.Type("\x03");

    EXPECT_TRUE(terminal.ShowsMatch("gcm: [1-9][0-9]* rows?, [0-9]+ lost")) << terminal.seen();
    EXPECT_TRUE(terminal.Shows("gcm> ")) << terminal.seen();
  }
  terminal.Type("version\r");
  EXPECT_TRUE(terminal.Shows("protocol")) << terminal.seen();
}

/// The shell runs in a separate thread that blocks signals.
TEST(ShellOutput, AnInterruptedCommandDoesNotSilenceTheNext) {
  constexpr auto kGoOn = tendon::AfterError::kGoOn;
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
  const int room = fcntl(ends[1], F_SETPIPE_SZ, 1);
  std::promise<int> interrupted;
  int exit_code = -1;
  std::size_t whole = 0;
  std::ostringstream err;
  std::thread typist([&] {
    console::Shell shell({});
    std::ostringstream help;
    shell.Run("help", {help, err}, kGoOn);
    whole = help.str().size();
    tendon::os::OutputBuffer buffer(ends[1]);
    std::ostream out(&buffer);
    interrupted.set_value(shell.Run("help", {out, err}, kGoOn));
    tendon::os::ForgetInterrupt();  // the prompt does the same
    exit_code = shell.Run("version", {out, err}, kGoOn);
    close(ends[1]);
  });

  int waiting = 0;  // number of bytes in the pipe that nobody reads
  EXPECT_TRUE(
      EventuallyTrue([&] { return ioctl(ends[0], FIONREAD, &waiting) == 0 && waiting > 0; }));
  pthread_kill(typist.native_handle(), SIGINT);
  EXPECT_EQ(interrupted.get_future().get(), program::kInterrupted);
  std::string seen;
  std::array<char, 4096> some{};
  for (ssize_t size = 1; size > 0;) {
    size = read(ends[0], some.data(), some.size());
    if (size > 0) seen.append(some.data(), static_cast<std::size_t>(size));
  }
  typist.join();
  close(ends[0]);

  ASSERT_GT(whole, static_cast<std::size_t>(room)) << "the first command has to wait";
  EXPECT_EQ(exit_code, program::kOk) << err.str();
  EXPECT_THAT(seen, HasSubstr("protocol"));
}

TEST_F(ShellTest, RefusesAShellInAShell) {
  const Outcome outcome = RunProgram(
      {"/bin/sh", "-c", "printf 'shell\\nversion\\nshell' | " + Command()}, Environment());

  EXPECT_EQ(outcome.exit_code, program::kUsage);
  EXPECT_THAT(outcome.out, HasSubstr("protocol"));
  EXPECT_EQ(outcome.err,
            "gcm: this is already gcm shell; to leave gcm shell: exit\ngcm: this is already gcm "
            "shell; to leave gcm shell: exit\n");
}

TEST_F(ShellTest, ReadsCommandsFromAPipe) {
  const Outcome outcome = RunProgram(
      {"/bin/sh", "-c", "printf 'cd robot\\nls\\nls nobody' | " + Command()}, Environment());

  EXPECT_THAT(outcome.out, HasSubstr("arm\tactive\tSimulatedArm"));
  EXPECT_THAT(outcome.err, HasSubstr("no component 'robot/nobody'"));
  EXPECT_EQ(outcome.exit_code, program::kNotFound);
}

TEST_F(ShellTest, AScriptStopsAtItsFirstErrorUnlessKeepGoing) {
  const std::string text = "cd desk # where\n\nls nobody; ls old_arm\nls old_arm\n";

  const Outcome stopped = Script(text);
  EXPECT_EQ(stopped.exit_code, program::kNotFound);
  EXPECT_EQ(stopped.out, "");
  EXPECT_THAT(
      stopped.err,
      HasSubstr(
          "test.gcm, line 3: failed with exit code 4; the following lines were not executed"));

  const Outcome went_on = Script(text, {"--keep-going"});
  EXPECT_THAT(went_on.out, HasSubstr("Control\tprovided"));
  // The exit code of the first command that failed.
  EXPECT_EQ(went_on.exit_code, program::kNotFound);
}

TEST_F(ShellTest, ReportsAnUnreadableScript) {
  EXPECT_THAT(Gcm({"run", home.path().string()}).err, HasSubstr("is a folder"));
  const Outcome missing = Gcm({"run", "nowhere.gcm"});
  EXPECT_EQ(missing.exit_code, program::kNotFound);
  EXPECT_EQ(missing.err, "gcm: cannot read nowhere.gcm: there is no such file\n");
}

TEST_F(ShellTest, UnreadableInputFails) {
  const std::string folder = home.path().string();
  EXPECT_EQ(Shell("shell < " + folder).exit_code, program::kUsage);
  EXPECT_EQ(Shell("run - < " + folder).err,
            "gcm: standard input, after line 0: the standard input could not be read completely: "
            "use a file or a pipe\n");
  EXPECT_EQ(Shell("run - < /dev/zero").err,
            "gcm: standard input, after line 0: a line is longer than 1 MiB: check that the input "
            "is a text\n");
  const Outcome endless = Shell("call robot/arm/Control.MoveTo - < /dev/zero");
  EXPECT_EQ(endless.exit_code, program::kUsage);
  EXPECT_EQ(endless.err, "gcm: the input is over 16 MiB: give a smaller input\n");
  EXPECT_EQ(Shell("call robot/arm/Control.MoveTo - < " + folder).exit_code, program::kUsage);
}

TEST_F(ShellTest, RunsALastLineWithoutANewline) {
  EXPECT_THAT(Script("version\nversion").out, testing::MatchesRegex("gcm [^\n]*\ngcm [^\n]*\n"));
}

TEST_F(ShellTest, BashCompletesWithThePrintedFile) {
  const auto completed_line = [&](const std::string& line, const std::string& words, int index) {
    const std::string script = "PATH=" + Built("bin") +
                               ":$PATH; source <(gcm completion bash); compopt() { :; }; "
                               "COMP_WORDS=(" +
                               words + "); COMP_CWORD=" + std::to_string(index) + "; COMP_LINE='" +
                               line + "'; _gcm; printf '%s\\n' \"${COMPREPLY[@]}\"";
    return RunProgram({"/bin/bash", "-c", script}, {{"TENDON_GCM", address}}).out;
  };

  const auto completed = [&](const std::string& words, int index) {
    return completed_line(words, words, index);
  };

  EXPECT_EQ(completed("gcm wat", 1), "watch\n");
  EXPECT_THAT(completed("gcm watch --c", 2), HasSubstr("--count\n"));
  EXPECT_EQ(completed("gcm --color n", 2), "never\n");
  EXPECT_TRUE(EventuallyTrue(
      [&] { return completed("gcm connect desk/tel", 2) == "desk/teleoperation/\n"; }));
  EXPECT_TRUE(EventuallyTrue(
      [&] { return completed("gcm get robot/arm/state.Jo", 2) == "robot/arm/state.Joints\n"; }));
  // bash splits words at : and =.
  const std::string parted = "127.0.0.1 : " + port;
  EXPECT_TRUE(EventuallyTrue([&] {
    return completed_line("gcm --gcm " + address + " ls rob", "gcm --gcm " + parted + " ls rob", 6)
        .starts_with("robot");
  }));
  EXPECT_TRUE(EventuallyTrue([&] {
    return completed_line("gcm --gcm=" + address + " ls rob", "gcm --gcm = " + parted + " ls rob",
                          7)
        .starts_with("robot");
  }));
  EXPECT_EQ(completed_line("gcm --color=n", "gcm --color = n", 3), "never\n");
  EXPECT_EQ(completed("gcm events robot/arm/C", 2), "robot/arm/Control\nrobot/arm/Control.\n");
}

TEST_F(ShellTest, CompletionUsesTheGcmOfTheCommandLine) {
  const auto completed = [&](const Program::Words& options) {
    Program::Words words = {Binary("gcm"), "complete"};
    words.insert(words.end(), options.begin(), options.end());
    words.insert(words.end(), {"ls", "rob"});
    return RunProgram(words, {{"TENDON_GCM", "127.0.0.1:1"}}).out;
  };

  EXPECT_TRUE(EventuallyTrue([&] { return completed({"--gcm=" + address}) != ""; }));
  EXPECT_TRUE(EventuallyTrue([&] { return completed({"--gcm", address}) != ""; }));
  EXPECT_EQ(completed({}), "");
  // Without a readable certificate, no request is sent.
  EXPECT_EQ(completed({"--gcm=" + address, "--certificate=nowhere.crt"}), "");
  EXPECT_EQ(completed({"--gcm=" + address, "--certificate", "nowhere.crt", "--ca=nowhere"}), "");
}

TEST_F(ShellTest, TwoShellsShareOneHistory) {
  {
    Terminal first(Command(), Environment());
    Terminal second(Command(), Environment());
    ASSERT_TRUE(first.Shows("gcm> "));
    ASSERT_TRUE(second.Shows("gcm> "));
    first.Type("status # first of all\r");
    ASSERT_TRUE(first.Shows("\r\ngcm> ")) << first.seen();
    second.Type("status # 'second' \\of\\ all\r");
    ASSERT_TRUE(second.Shows("\r\ngcm> ")) << second.seen();
    first.Type("\x04");  // Ctrl-D
    EXPECT_EQ(first.program().Wait(), program::kOk);
    second.Type("\x04");
    EXPECT_EQ(second.program().Wait(), program::kOk);
  }
  Terminal third(Command(), Environment());
  ASSERT_TRUE(third.Shows("gcm> "));

  third.Type("\x1b[A");  // arrow up
  EXPECT_TRUE(third.Shows("status # 'second' \\of\\ all")) << third.seen();
  third.Type("\x1b[A");
  EXPECT_TRUE(third.Shows("first of all")) << third.seen();
}

TEST_F(ShellTest, TabQuotesNamesWithBlanks) {
  home.Write("my lab; new.json", R"({"version": 1, "name": "lab", "processes": []})");
  Terminal terminal(Command(), Environment());
  ASSERT_TRUE(terminal.Shows("gcm> "));

  terminal.Type("plan " + home.path().string() + "/my\t\r");
  EXPECT_TRUE(terminal.Shows("\\ lab\\;\\ new.json")) << terminal.seen();
  EXPECT_TRUE(terminal.Shows("gcm: 0 steps, ")) << terminal.seen();
  terminal.Type("plan " + home.path().string() + "/'my l\t\r");
  EXPECT_TRUE(terminal.Shows("gcm: 0 steps, ")) << terminal.seen();
}

}  // namespace
