#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>
#include <tendon/base/os/process.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>

#include "gcm_console/system_fixture.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class LogTest : public SystemFixture {
 protected:
  void SetUp() override { StartGcm(); }

  [[nodiscard]] std::unique_ptr<Program> Follow(Program::Words words = {}) const {
    words.insert(words.begin(),
                 {Binary("gcm"), "--gcm", address, "--timeout", kTestTimeout, "log", "--follow"});
    return std::make_unique<Program>(words);
  }
};

TEST_F(LogTest, ShowsTheLogOfAllProcesses) {
  const auto robot = StartLcm("robot", demo);
  ASSERT_TRUE(EventuallySays({"log"}, "\tinfo\trobot\truns 2 components")) << robot->err();
  ASSERT_TRUE(EventuallySays({"log"}, "\tinfo\tgcm\tprocess 'robot' is available"));

  const Outcome from = Gcm({"log", "--from", "gcm"});
  EXPECT_EQ(from.exit_code, program::kOk) << from.err;
  EXPECT_THAT(from.out, HasSubstr("process 'robot' is available"));
  EXPECT_THAT(from.out, Not(HasSubstr("runs 2 components")));
  EXPECT_THAT(Gcm({"log", "--from", "ro*/robot"}).out, HasSubstr("runs 2 components"));
  const Outcome errors = Gcm({"log", "--level", "error"});
  EXPECT_EQ(errors.exit_code, program::kOk) << errors.err;
  EXPECT_THAT(errors.out, Not(HasSubstr("\tinfo\t")));

  const Outcome nobody = Gcm({"log", "--from", "robt"});
  EXPECT_EQ(nobody.exit_code, program::kNotFound);
  EXPECT_EQ(nobody.out, "");
  EXPECT_EQ(nobody.err, "gcm: no process 'robt'; did you mean 'robot'?\n");
  const Outcome silent = Gcm({"log", "--from", "robot/arm", "--level", "error"});
  EXPECT_EQ(silent.exit_code, program::kOk);
  EXPECT_EQ(silent.err, "gcm: the GCM keeps no record from 'robot/arm' at level error or above\n");

  std::istringstream lines(Gcm({"--json", "log", "--from", "robot"}).out);
  std::string line;
  std::int64_t before = 0;
  ASSERT_TRUE(std::getline(lines, line));
  do {
    const json record = json::parse(line);
    EXPECT_EQ(record["schema"], 1);
    EXPECT_EQ(record["process"], "robot");
    EXPECT_NE(record["text"], "");
    EXPECT_THAT(record["level"], testing::AnyOf("debug", "info", "warning", "error"));
    EXPECT_GT(record["time_ns"], std::int64_t{1'600'000'000} * 1'000'000'000);
    EXPECT_GE(record["time_ns"], before);
    before = record["time_ns"];
  } while (std::getline(lines, line));
}

TEST_F(LogTest, FollowsWhileProcessesAndGcmsComeAndGo) {
  const auto follow = Follow();
  const auto heard = [&](const std::string& text) {
    return EventuallyTrue([&] { return follow->out().find(text) != std::string::npos; });
  };
  const auto robot = StartLcm("robot", demo);
  ASSERT_TRUE(heard("\trobot\truns 2 components")) << follow->err();

  gcm->Signal(SIGKILL);
  ASSERT_TRUE(EventuallyTrue([&] { return follow->err().find("no GCM at") != std::string::npos; }));
  StartGcm();
  const auto desk = StartLcm("desk", demo);

  EXPECT_TRUE(heard("\tdesk\truns 3 components")) << follow->err();
  EXPECT_TRUE(heard("keeps running and tries to reconnect")) << follow->err();
  follow->Signal(SIGINT);
  EXPECT_EQ(follow->Wait(), program::kInterrupted);
}

TEST_F(LogTest, SurvivesALogFlood) {
  const auto chatter = StartOne("hall", "chatterbox", "Chatterbox", "chatterbox");
  ASSERT_TRUE(EventuallySays({"log", "--from", "hall/chatterbox"}, "suppressed "))
      << chatter->err().substr(0, 1000);

  // Records of other processes still arrive.
  const auto follow = Follow({"--from", "robot"});
  const auto robot = StartLcm("robot", demo);
  EXPECT_TRUE(EventuallyTrue([&] {
    return follow->out().find("runs 2 components") != std::string::npos;
  })) << follow->err();
  EXPECT_TRUE(EventuallySays({"ls"}, "hall\talive"));
}

TEST_F(LogTest, SetsLogLevelsRemotely) {
  const auto chatter = StartOne("hall", "chatterbox", "Chatterbox", "chatterbox");
  const Program::Words log = {"log", "--from", "hall/chatterbox"};
  ASSERT_TRUE(EventuallySays(log, "another thing"));

  const Outcome set = Gcm({"log-level", "hall", "error"});
  EXPECT_EQ(set.exit_code, program::kOk) << set.err;
  EXPECT_EQ(set.out, "hall  logs error and above\n");
  EXPECT_TRUE(EventuallyTrue([&] { return Gcm(log).out == Gcm(log).out; }));
  EXPECT_TRUE(EventuallySays({"log", "--from", "gcm"},
                             "gcm log-level of " + tendon::os::UserAtHost() +
                                 " has set the log level of process 'hall' to error"));

  const std::string silent = Gcm(log).out;
  const json result = json::parse(Gcm({"--json", "log-level", "hall", "info"}).out);
  EXPECT_EQ(result["process"], "hall");
  EXPECT_EQ(result["level"], "info");
  EXPECT_TRUE(EventuallyTrue([&] { return Gcm(log).out != silent; }));
}

TEST_F(LogTest, ExplainsRefusals) {
  const auto robot = StartLcm("robot", demo);
  ASSERT_TRUE(EventuallySays({"ls"}, "robot\talive"));

  const Outcome misspelt = Gcm({"log-level", "robt", "debug"});
  EXPECT_EQ(misspelt.exit_code, program::kNotFound);
  EXPECT_THAT(misspelt.err, HasSubstr("did you mean 'robot'?"));
  const Outcome loud = Gcm({"log-level", "robot", "loud"});
  EXPECT_EQ(loud.exit_code, program::kUsage);
  EXPECT_THAT(loud.err, HasSubstr("{debug,info,warning,error}"));
  EXPECT_EQ(Gcm({"log", "--level", "loud"}).exit_code, program::kUsage);
}

}  // namespace
