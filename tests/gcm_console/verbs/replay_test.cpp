#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>
#include <tendon/recording/mcap/reader.h>
#include <tendon/recording/recording_format.h>

#include <csignal>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gcm_console/system_fixture.h"

namespace {

namespace mcap = tendon::mcap;
using nlohmann::json;
using testing::HasSubstr;

/// Runs `gcm replay` with a real GCM, and with a recording of `robot/odometer` that an LCM has
/// made.
class ReplayVerbTest : public SystemFixture {
 protected:
  void SetUp() override {
    StartGcm();
    robot = StartOne("robot", "odometer", "Odometer", "odometer");
    ASSERT_TRUE(EventuallySays({"ls", "robot"}, "odometer\tactive")) << robot->err();
    const Outcome recorded = Gcm({"record", "robot", "-o", file, "--for", "1500ms"});
    ASSERT_EQ(recorded.exit_code, program::kOk) << recorded.err;
  }
  /// Ends the process, so that the replay can use its name.
  void EndRobot() const {
    robot->Signal(SIGTERM);
    ASSERT_TRUE(robot->Wait());
  }
  [[nodiscard]] std::unique_ptr<Program> Replay(Program::Words words) const {
    words.insert(words.begin(),
                 {Binary("gcm"), "--gcm", address, "--timeout", kPatience, "replay", file});
    return std::make_unique<Program>(words);
  }
  [[nodiscard]] std::string Path(const std::string& name) const {
    return (home.path() / name).string();
  }

  /// Returns the bodies of the messages on a topic, by sequence number.
  static std::map<std::uint32_t, std::vector<std::byte>> BodiesOf(const std::string& name,
                                                                  const std::string& topic) {
    std::map<std::uint32_t, std::vector<std::byte>> bodies;
    const auto reader = mcap::Reader::Open(std::filesystem::path(name));
    EXPECT_TRUE(reader) << reader.error().message;
    if (!reader) return bodies;
    auto messages = (*reader)->Messages();
    while (const auto message = messages.Next()) {
      if ((*reader)->FindChannel(message->channel_id)->topic != topic) continue;
      bodies[message->sequence] = {message->data.begin(), message->data.end()};
    }
    return bodies;
  }

  const std::string file = Path("run.mcap");
  std::unique_ptr<Program> robot;
};

TEST_F(ReplayVerbTest, AReplayedComponentIsReadLikeTheRealOneButExecutesNoCommands) {
  EndRobot();
  const auto replay = Replay({"--loop"});
  ASSERT_TRUE(EventuallySays({"ls", "robot"}, "odometer\tactive")) << replay->err();

  ASSERT_TRUE(EventuallyTrue([&] {
    return Gcm({"get", "robot/odometer/state.Count"}).exit_code == program::kOk;
  })) << replay->err();
  const json value = json::parse(Gcm({"--json", "get", "robot/odometer/state.Edges"}).out);
  EXPECT_THAT(value.dump(), HasSubstr("-inf"));
  EXPECT_THAT(Gcm({"show", "robot/odometer"}).out, HasSubstr("replay of run.mcap"));
  const Outcome called = Gcm({"call", "robot/odometer/Control.SetCount", "5"});
  EXPECT_EQ(called.exit_code, program::kRefused);
  EXPECT_THAT(called.err, HasSubstr("this is a replay of run.mcap"));
  replay->Signal(SIGINT);
  EXPECT_EQ(replay->Wait(), program::kInterrupted) << replay->err();
  EXPECT_THAT(replay->err(), HasSubstr("gcm: replaying run.mcap as robot: "));
  EXPECT_THAT(replay->err(), HasSubstr("gcm: replayed "));
}

TEST_F(ReplayVerbTest, ARecordingOfAReplayHasTheRecordedTicksAndValues) {
  const std::string second = Path("second.mcap");
  Program record({Binary("gcm"), "--gcm", address, "--timeout", kPatience, "record", "rehearsal",
                  "-o", second});
  ASSERT_TRUE(EventuallyTrue([&] { return record.err().find("recording") != std::string::npos; }));

  const auto replay = Replay({"--as", "rehearsal", "--delay", "2s"});
  EXPECT_EQ(replay->Wait(), program::kOk) << replay->err();
  record.Signal(SIGINT);
  ASSERT_EQ(record.Wait(), program::kInterrupted) << record.err();

  for (const std::string column : {"Count", "Mode", "Edges", "Ready"}) {
    const auto expected = BodiesOf(file, "robot/odometer/state/" + column);
    const auto found = BodiesOf(second, "rehearsal/odometer/state/" + column);
    ASSERT_FALSE(found.empty()) << column;
    for (const auto& [tick, body] : found) {
      ASSERT_TRUE(expected.contains(tick)) << column << " " << tick;
      ASSERT_EQ(body, expected.at(tick)) << column << " " << tick;
    }
  }
}

TEST_F(ReplayVerbTest, ANameThatIsTakenIsRefusedAndAnotherOneIsNot) {
  const Outcome taken = Gcm({"replay", file});
  EXPECT_EQ(taken.exit_code, program::kRefused);
  EXPECT_THAT(taken.err, HasSubstr("cannot replay 'robot' of run.mcap"));
  EXPECT_THAT(taken.err, HasSubstr("--as NAME"));

  const Outcome other = Gcm({"--json", "replay", file, "--as", "rehearsal", "--delay", "10ms",
                             "--rate", "10", "--from", "200ms", "--to", "700ms"});
  ASSERT_EQ(other.exit_code, program::kOk) << other.err;
  const json end = json::parse(other.out);
  EXPECT_EQ(end["processes"], json({"rehearsal"}));
  EXPECT_GT(end["rows"], 10);
  EXPECT_EQ(end["passes"], 1);
}

TEST_F(ReplayVerbTest, ADamagedFileIsReplayedAndWhatIsMissingIsSaid) {
  std::string bytes = home.Read("run.mcap");
  bytes.resize(bytes.size() - 100);  // removes the end of the summary
  home.Write("cut-off.mcap", bytes);

  const Outcome replayed =
      Gcm({"replay", Path("cut-off.mcap"), "--as", "rehearsal", "--delay", "10ms", "--rate", "10"});

  EXPECT_EQ(replayed.exit_code, program::kPartial) << replayed.err;
  EXPECT_THAT(replayed.err, HasSubstr("gcm: replayed "));
  EXPECT_THAT(replayed.err, HasSubstr("cut off"));
}

TEST_F(ReplayVerbTest, ATeleoperationConnectsToAReplayedArm) {
  const std::string arm_file = Path("arm.mcap");
  const auto lab = StartOne("lab", "arm", "SimulatedArm", "simulated_arm");
  ASSERT_TRUE(EventuallySays({"ls", "lab"}, "arm\tactive")) << lab->err();
  const Outcome recorded =
      Gcm({"record", "lab/arm/state.Joints", "-o", arm_file, "--for", "1500ms"});
  ASSERT_EQ(recorded.exit_code, program::kOk) << recorded.err;
  lab->Signal(SIGTERM);
  ASSERT_TRUE(lab->Wait());
  Program replay(
      {Binary("gcm"), "--gcm", address, "--timeout", kPatience, "replay", arm_file, "--loop"});
  ASSERT_TRUE(EventuallySays({"ls", "lab"}, "arm\tactive")) << replay.err();
  const auto desk = StartOne("desk", "teleoperation", "Teleoperation", "teleoperation");
  ASSERT_TRUE(EventuallySays({"ls", "desk"}, "teleoperation")) << desk->err();

  const Outcome connected = Gcm({"connect", "desk/teleoperation/Robot", "lab/arm/Control"});

  EXPECT_EQ(connected.exit_code, program::kOk) << connected.err;
  ASSERT_TRUE(EventuallyTrue([&] {
    return Gcm({"call", "lab/arm/Control.GetJoints"}).exit_code == program::kOk;
  })) << replay.err();
  const Outcome moved = Gcm({"call", "lab/arm/Control.MoveTo", R"({"duration": 1})"});
  EXPECT_EQ(moved.exit_code, program::kRefused) << moved.err;
  EXPECT_THAT(moved.err, HasSubstr("this is a replay of arm.mcap"))
      << "also if the type of the argument is not in the recording";
}

TEST_F(ReplayVerbTest, APathThatFitsNothingAndAFileThatIsMissingAreNamed) {
  const Outcome nothing = Gcm({"replay", file, "--paths", "desk"});
  EXPECT_EQ(nothing.exit_code, program::kNotFound);
  EXPECT_THAT(nothing.err, HasSubstr("matches 'desk'"));
  EXPECT_EQ(Gcm({"replay", Path("none.mcap")}).exit_code, program::kNotFound);
  EXPECT_EQ(Gcm({"replay", file, "--rate", "0"}).exit_code, program::kUsage);
}

}  // namespace
