#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>

#include <cstdlib>
#include <sstream>

#include "gcm_console/system_fixture.h"
#include "support/program.h"

namespace {

using testing::HasSubstr;

/// Loads the completion files into the real shells. There is no GCM.
class CompletionFiles : public SystemFixture {
 protected:
  static bool IsInstalled(const std::string& shell) {
    return RunProgram({"/bin/sh", "-c", "command -v " + shell}).exit_code == 0;
  }
  /// Runs a script in a shell that finds the built `gcm`. Returns its output.
  Outcome Run(const Program::Words& shell, const std::string& script) const {
    Program::Words words = {"/usr/bin/env"};
    words.insert(words.end(), shell.begin(), shell.end());
    words.push_back(script);
    const char* path = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe): read only
    return RunProgram(words,
                      {{"TENDON_GCM", address}, {"PATH", Built("bin") + ":" + (path ? path : "")}});
  }
};

TEST_F(CompletionFiles, BashLoadsItsFile) {
  if (!IsInstalled("bash")) GTEST_SKIP() << "bash is not installed: its file was not tried";

  const Outcome registered =
      Run({"bash", "--norc", "-c"}, "eval \"$(gcm completion bash)\"; complete -p gcm");

  EXPECT_EQ(registered.out, "complete -F _gcm gcm\n") << registered.err;
  EXPECT_EQ(registered.err, "");
}

TEST_F(CompletionFiles, ZshCompletesAWord) {
  if (!IsInstalled("zsh")) GTEST_SKIP() << "zsh is not installed: its file was not tried";
  const auto completed = [&](const std::string& words, int current) {
    const Outcome outcome = Run(
        {"zsh", "-f", "-c"},
        "compdef() { :; }; _files() { print -r -- FILES; }; "
        "compadd() { while [[ $1 != -- ]] shift; shift; [[ $# = 0 ]] || print -rl -- \"$@\"; }; "
        "eval \"$(gcm completion zsh)\"; words=(" +
            words + "); CURRENT=" + std::to_string(current) + "; _gcm");
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  };

  EXPECT_EQ(completed("gcm wat", 2), "watch\n");
  EXPECT_THAT(completed("gcm watch --c", 3), HasSubstr("--count\n"));
  EXPECT_EQ(completed("gcm plan ''", 3), "FILES\n");
}

TEST_F(CompletionFiles, FishCompletesAWord) {
  if (!IsInstalled("fish")) GTEST_SKIP() << "fish is not installed: its file was not tried";
  const auto completed = [&](const std::string& line) {
    const Outcome outcome = Run({"fish", "--no-config", "-c"},
                                "gcm completion fish | source; complete -C '" + line + "'");
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  };

  EXPECT_THAT(completed("gcm wat"), testing::StartsWith("watch\t"));
  EXPECT_THAT(completed("gcm watch --c"), HasSubstr("--count\t"));
}

TEST_F(CompletionFiles, OfferEveryLongOption) {
  const auto names = [&](const Program::Words& words) {
    std::string all;
    std::istringstream lines(Typed(words).out);
    for (std::string line; std::getline(lines, line);) all += line.substr(0, line.find('\t')) + ' ';
    return all;
  };

  EXPECT_EQ(names({"complete", "ls", "--js"}), "--json --jsonl ");
  EXPECT_EQ(names({"complete", "ls", "--lo"}), "--long ");
  EXPECT_THAT(names({"complete", "undo", "--"}), HasSubstr("--json --jsonl "));
}

TEST_F(CompletionFiles, AnUnknownShellIsRejected) {
  const Outcome outcome = Typed({"completion", "tcsh"});

  EXPECT_EQ(outcome.exit_code, program::kUsage);
  EXPECT_THAT(outcome.err, HasSubstr("tcsh"));
}

}  // namespace
