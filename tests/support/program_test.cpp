#include "support/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>

#include "support/folder.h"

namespace {

Outcome Shell(const std::string& script,
              const std::map<std::string, std::string>& environment = {}) {
  return RunProgram({"/bin/sh", "-c", script}, environment);
}

TEST(Program, DoesNotUseTheFoldersOfTheUser) {
  for (const std::string name : {"XDG_STATE_HOME", "XDG_CACHE_HOME", "XDG_RUNTIME_DIR"}) {
    const Outcome told = Shell("printf %s \"$" + name + "\"; test -d \"$" + name + "\"");

    EXPECT_EQ(told.exit_code, 0) << name;
    const char* const of_user = std::getenv(name.c_str());
    EXPECT_NE(told.out, of_user == nullptr ? "" : of_user);
    EXPECT_THAT(told.out, testing::StartsWith(std::filesystem::temp_directory_path().string()));
  }
}

TEST(Program, ProgramsOfATestShareARuntimeFolder) {
  const std::string print = "printf %s \"$XDG_RUNTIME_DIR\"";

  EXPECT_EQ(Shell(print).out, Shell(print).out);
}

TEST(Program, TheGivenEnvironmentWins) {
  EXPECT_EQ(Shell("printf %s \"$XDG_STATE_HOME\"", {{"XDG_STATE_HOME", "/here"}}).out, "/here");
}

TEST(Program, ReportsTheSignalThatEndedIt) { EXPECT_EQ(Shell("kill -9 $$").exit_code, 128 + 9); }

TEST(Program, EndsWhenItsTestIsKilled) {
  const tendon::test::Folder folder;  // the killed test cannot remove the files in its folder
  int ends[2];                        // the forked test and its program keep the other end open
  ASSERT_EQ(pipe(ends), 0);

  const pid_t test = fork();
  if (test == 0) {
    setenv("TMPDIR", folder.path().c_str(), 1);
    const Program program({"/bin/sleep", "60"});
    raise(SIGKILL);
  }
  close(ends[1]);
  int status = 0;
  ASSERT_EQ(waitpid(test, &status, 0), test);

  constexpr int kTestTimeout = 30'000;  // ms
  pollfd all_gone{.fd = ends[0], .events = 0, .revents = 0};
  EXPECT_EQ(poll(&all_gone, 1, kTestTimeout), 1);
  EXPECT_EQ(status, SIGKILL);
  close(ends[0]);
}

TEST(FreePort, ReturnsEachPortOnce) {
  std::vector<int> ports(200);
  for (int& port : ports) port = FreePort();

  for (const int port : ports) EXPECT_EQ(std::count(ports.begin(), ports.end(), port), 1) << port;
}

TEST(Folder, RemovesItselfWithItsContents) {
  std::filesystem::path path;
  {
    const tendon::test::Folder folder;
    path = folder.path();
    folder.Write("file", "text");
    ASSERT_EQ(folder.Read("file"), "text");
  }

  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
