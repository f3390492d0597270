#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "gcm_console/system_fixture.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

/// The demo system, complete.
class ConsoleTest : public SystemFixture {
 protected:
  void SetUp() override {
    StartGcm();
    robot = StartLcm("robot", demo);
    desk = StartLcm("desk", demo);
    ASSERT_TRUE(EventuallySays({"ls", "robot"}, "arm\tactive")) << robot->err();
    ASSERT_TRUE(EventuallySays({"ls", "desk"}, "teleoperation\tactive")) << desk->err();
  }
  std::unique_ptr<Program> robot;
  std::unique_ptr<Program> desk;
};

TEST_F(ConsoleTest, ListsAndShowsTheSystem) {
  EXPECT_THAT(Gcm({"ls"}).out, HasSubstr("robot\talive"));
  EXPECT_THAT(Gcm({"ls", "robot/arm"}).out, HasSubstr("Control\tprovided"));
  EXPECT_THAT(Gcm({"ls", "robot/arm/Control"}).out,
              HasSubstr("MoveTo\twrite command\tarm.JointGoal"));
  EXPECT_THAT(Gcm({"tree"}).out, HasSubstr("Robot  required  not connected"));
  EXPECT_THAT(Gcm({"show", "robot/arm"}).out, HasSubstr("class\tSimulatedArm"));

  const json document = json::parse(Gcm({"ls", "--json"}).out);
  EXPECT_EQ(document["schema"], 1);
  EXPECT_EQ(document["processes"].size(), 2U);
}

TEST_F(ConsoleTest, ConnectsSetsTheArmInMotionAndDisconnects) {
  const Outcome connected = Gcm({"connect", "desk/teleoperation/Robot", "robot/arm/Control"});
  EXPECT_EQ(connected.exit_code, program::kOk) << connected.err;
  EXPECT_THAT(connected.out, HasSubstr("desk/teleoperation/Robot -> robot/arm/Control  active"));

  const auto velocity = [this] {
    const Outcome got = Gcm({"get", "robot/arm/state.Joints.velocity[0]"});
    EXPECT_EQ(got.exit_code, program::kOk) << got.err;
    return std::stod(got.out);
  };
  EXPECT_TRUE(EventuallyTrue([&] { return std::abs(velocity()) > 0.01; }));

  const Outcome disconnected = Gcm({"disconnect", "desk/teleoperation/Robot"});
  EXPECT_EQ(disconnected.exit_code, program::kOk) << disconnected.err;
  EXPECT_THAT(Gcm({"tree"}).out, HasSubstr("Robot  required  not connected"));
}

TEST_F(ConsoleTest, UndoTakesAConnectBack) {
  ASSERT_EQ(Gcm({"connect", "desk/teleoperation/Robot", "robot/arm/Control"}).exit_code, 0);

  const Outcome undone = Gcm({"undo"});

  EXPECT_EQ(undone.exit_code, program::kOk) << undone.err;
  EXPECT_THAT(Gcm({"tree"}).out, HasSubstr("Robot  required  not connected"));
}

TEST_F(ConsoleTest, CallsCommandsOfEveryKind) {
  const Outcome stop = Gcm({"call", "robot/arm/Control.Stop"});
  EXPECT_EQ(stop.exit_code, program::kOk) << stop.err;

  const Outcome move =
      Gcm({"call", "robot/arm/Control.MoveTo", R"({"position":[0.1,0,0,0,0,0,0],"duration":0.5})"});
  EXPECT_EQ(move.exit_code, program::kOk) << move.err;

  const Outcome joints = Gcm({"call", "robot/arm/Control.GetJoints"});
  ASSERT_EQ(joints.exit_code, program::kOk) << joints.err;
  EXPECT_EQ(json::parse(joints.out)["position"].size(), 7U);
}

TEST_F(ConsoleTest, WatchPrintsEveryRowInOrder) {
  const Outcome watched = Gcm({"watch", "robot/arm/state.Joints.position[0]", "--count", "500"});

  ASSERT_EQ(watched.exit_code, program::kOk) << watched.err;
  EXPECT_THAT(watched.err, HasSubstr("500 rows, 0 lost"));
  std::istringstream lines(watched.out);
  std::int64_t time = 0;
  std::uint64_t tick = 0;
  double value = 0.0;
  std::uint64_t last = 0;
  int rows = 0;
  while (lines >> time >> tick >> value) {
    ASSERT_TRUE(rows == 0 || tick == last + 1) << tick << " after " << last;
    ++rows;
    last = tick;
  }
  EXPECT_EQ(rows, 500);
}

TEST_F(ConsoleTest, AnInterruptedWatchSummarisesAndSaysSo) {
  Program watch({Binary("gcm"), "--gcm", address, "watch", "robot/arm/state.Joints"});
  ASSERT_TRUE(EventuallyTrue([&] { return !watch.out().empty(); })) << watch.err();

  watch.Signal(SIGINT);

  EXPECT_EQ(watch.Wait(), program::kInterrupted);
  EXPECT_THAT(watch.err(), HasSubstr(" rows, 0 lost"));
}

TEST_F(ConsoleTest, RefusalsHaveOneSentenceAndTheirExitCode) {
  struct Case {
    Program::Words words;
    int exit_code;
    std::string sentence;
  };
  const std::vector<Case> cases = {
      {{"conect"}, program::kUsage, "no verb 'conect'; did you mean 'connect'?"},
      {{"ls", "--jsn"}, program::kUsage, "--jsn"},
      {{"connect", "desk/teleoperation/Robot"}, program::kUsage, "provided"},
      {{"ls", "robt"}, program::kNotFound, "no process 'robt'; did you mean 'robot'?"},
      {{"connect", "desk/teleop/Robot", "robot/arm/Control"}, program::kNotFound, "no component 'desk/teleop'; there is"},
      {{"connect", "desk/teleoperation/Robot", "robot/arn/Control"},
       program::kNotFound,
       "did you mean 'arm'?"},
      {{"connect", "desk/teleoperation", "robot/arm/Control"},
       program::kUsage,
       "expected process/component/interface"},
      {{"connect", "desk/teleoperation/Robot", "desk/old_arm/Control"},
       program::kIncompatible,
       "does not fit"},
      {{"disconnect", "desk/teleoperation/Robot"}, program::kRefused, "not connected"},
      {{"call", "robot/arm/Control.MoveTo", R"({"position":[0.1,0,0,0,0,0,"x"],"duration":1})"},
       program::kUsage,
       "position[6]"},
      {{"call", "robot/arm/Control.Mov"}, program::kNotFound, "no command 'robot/arm/Control.Mov'"},
      {{"get", "robot/arm/state.Jonts"}, program::kNotFound, "did you mean 'Joints'?"},
      {{"get", "robot/arm/Control.Stop"}, program::kUsage, "use gcm call"},
      {{"watch", "robot/arm/Control.GetJoints"}, program::kNotFound, "no column"},
  };
  for (const Case& one : cases) {
    const Outcome outcome = Gcm(one.words);
    EXPECT_EQ(outcome.exit_code, one.exit_code) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(one.sentence));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_THAT(Gcm({"tree"}).out, HasSubstr("Robot  required  not connected"));
}

TEST_F(ConsoleTest, AProcessThatDiesIsLostAndComesBack) {
  robot->Signal(SIGKILL);
  ASSERT_TRUE(EventuallySays({"ls"}, "robot\tlost"));

  robot = StartLcm("robot", demo);

  ASSERT_TRUE(EventuallySays({"ls"}, "robot\talive"));
}

TEST_F(SystemFixture, WithoutAGcmEveryVerbSaysHowToStartOne) {
  const Outcome outcome = Gcm({"ls"});

  EXPECT_EQ(outcome.exit_code, program::kUnreachable);
  EXPECT_THAT(outcome.err, HasSubstr("no GCM at " + address));
  EXPECT_THAT(outcome.err, HasSubstr("gcm serve"));
}

TEST_F(SystemFixture, ASecondGcmOnOnePortIsRefused) {
  StartGcm();

  const Outcome second = Gcm({"serve"});

  EXPECT_EQ(second.exit_code, program::kRefused);
  EXPECT_THAT(second.err, HasSubstr(address + " is in use"));
}

TEST_F(SystemFixture, APortThatIsNoneIsRefused) {
  for (const char* bad : {"127.0.0.1:abc", "127.0.0.1:65536", "127.0.0.1:-1"}) {
    const Outcome outcome = RunProgram({Binary("gcm"), "--gcm", bad, "ls"});
    EXPECT_EQ(outcome.exit_code, program::kUsage) << bad;
    EXPECT_THAT(outcome.err, HasSubstr("expected 1..65535")) << bad;
  }
}

TEST_F(SystemFixture, AnAddressOffThisMachineNeedsInsecure) {
  const Outcome outcome = RunProgram({Binary("gcm"), "--gcm", "192.0.2.1:10705", "ls"});

  EXPECT_EQ(outcome.exit_code, program::kDenied);
  EXPECT_THAT(outcome.err, HasSubstr("--insecure"));
}

TEST_F(SystemFixture, OutputThatCannotBeWrittenIsAFailure) {
  StartGcm();

  const Outcome outcome =
      RunProgram({"/bin/sh", "-c", Binary("gcm") + " --gcm " + address + " ls --json > /dev/full"});

  EXPECT_EQ(outcome.exit_code, program::kRefused);
  EXPECT_THAT(outcome.err, HasSubstr("cannot write"));
}

}  // namespace
