#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>
#include <tendon/recording/mcap/reader.h>
#include <tendon/recording/recording_format.h>

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "gcm_console/system_fixture.h"

namespace {

namespace mcap = tendon::mcap;
namespace recording = tendon::recording;
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
                 {Binary("gcm"), "--gcm", address, "--timeout", kTestTimeout, "replay", file});
    return std::make_unique<Program>(words);
  }
  [[nodiscard]] std::string Path(const std::string& name) const {
    return (home.path() / name).string();
  }

  [[nodiscard]] std::unique_ptr<Program> StartRecording(const std::string& path,
                                                        const std::string& name) const {
    auto record = std::make_unique<Program>(Program::Words{Binary("gcm"), "--gcm", address,
                                                           "--timeout", kTestTimeout, "--jsonl",
                                                           "record", path, "-o", name});
    EXPECT_TRUE(EventuallyTrue([&] {
      return record->err().find("gcm: recording ") != std::string::npos;
    })) << record->err();
    return record;
  }
  /// Returns the latest figures of a recording; an empty object if there are none yet.
  static json FiguresOf(const Program& record) {
    json last = json::object();
    std::istringstream lines(record.out());
    for (std::string line; std::getline(lines, line);) {
      auto figures = json::parse(line, nullptr, false);
      if (figures.is_object()) last = std::move(figures);
    }
    return last;
  }
  static std::uint64_t LostRows(const json& figures) {
    return figures.value("lost_table", std::uint64_t{0}) +
           figures.value("lost_network", std::uint64_t{0}) +
           figures.value("lost_recorder", std::uint64_t{0});
  }
  /// Returns the number of lost rows that a recording has counted, by the topic of a column.
  std::map<std::string, std::uint64_t> LossesOf(const std::string& name) const {
    std::map<std::string, std::uint64_t> losses;
    const json info = json::parse(Gcm({"--json", "info", name}).out);
    for (const json& topic : info["topics"]) losses[topic["topic"]] = topic["lost"];
    return losses;
  }

  /// A message of a recording. Rows have the tick as the sequence; events and calls have none.
  using Sent = std::pair<std::uint32_t, std::vector<std::byte>>;
  /// Returns the messages of a process by topic, in the order of the file.
  static std::map<std::string, std::vector<Sent>> MessagesOf(const std::string& name,
                                                             const std::string& process) {
    std::map<std::string, std::vector<Sent>> topics;
    const auto reader = mcap::Reader::Open(std::filesystem::path(name));
    EXPECT_TRUE(reader) << reader.error().message;
    if (!reader) return topics;
    auto messages = (*reader)->Messages({.order = mcap::Query::Order::kFile});
    while (const auto message = messages.Next()) {
      const mcap::Channel& channel = *(*reader)->FindChannel(message->channel_id);
      if (!channel.topic.starts_with(process + "/")) continue;
      const bool is_row = recording::MetadataValue(channel, recording::kKindKey) == "column";
      topics[channel.topic].emplace_back(
          is_row ? message->sequence : 0,
          std::vector<std::byte>(message->data.begin(), message->data.end()));
    }
    return topics;
  }
  /// Makes a recording of `lab` with rows of an arm and an odometer, calls and events.
  void RecordLab(const std::string& name) const {
    home.Write("lab.json", R"({"version": 1, "name": "lab", "processes": [{"name": "lab",
      "components": [{"name": "arm", "class": "SimulatedArm", "library": "simulated_arm"},
                     {"name": "odometer", "class": "Odometer", "library": "odometer"}]}]})");
    const auto lab = StartLcm("lab", Path("lab.json"));
    ASSERT_TRUE(EventuallySays({"ls", "lab"}, "arm\tactive")) << lab->err();
    ASSERT_TRUE(EventuallySays({"ls", "lab"}, "odometer\tactive")) << lab->err();
    const auto record = StartRecording("lab", name);
    ASSERT_TRUE(EventuallyTrue([&] { return FiguresOf(*record).value("rows", 0) > 500; }));
    for (int i = 1; i <= 3; ++i) {
      const std::string goal = R"({"position": [0.)" + std::to_string(i) +
                               R"(, 0, 0, -1.5, 0, 1.5, 0], "duration": 0.05})";
      ASSERT_EQ(Gcm({"call", "lab/odometer/Control.SetCount", std::to_string(1000 * i)}).exit_code,
                program::kOk);
      ASSERT_EQ(Gcm({"call", "lab/arm/Control.MoveTo", goal}).exit_code, program::kOk);
      ASSERT_TRUE(EventuallyTrue([&] {
        const json figures = FiguresOf(*record);
        return figures.value("commands", 0) >= 2 * i && figures.value("events", 0) >= i;
      })) << record->out();
    }
    record->Signal(SIGINT);
    ASSERT_EQ(record->Wait(), program::kInterrupted) << record->err();
    lab->Signal(SIGTERM);
    ASSERT_TRUE(lab->Wait());
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

TEST_F(ReplayVerbTest, ARecordingOfAReplayHasEachRowEventAndCallThatItDoesNotCountAsLost) {
  const std::string first = Path("first.mcap");
  const std::string second = Path("second.mcap");
  ASSERT_NO_FATAL_FAILURE(RecordLab(first));
  const auto record = StartRecording("rehearsal", second);
  // The delay is the time in which the recorder finds the tables and subscribes to them.
  Program replay({Binary("gcm"), "--gcm", address, "--timeout", kTestTimeout, "--json", "replay",
                  first, "--as", "rehearsal", "--delay",
                  tendon::test::IsSanitized() ? "20s" : "8s"});
  ASSERT_EQ(replay.Wait(), program::kOk) << replay.err();
  const json replayed = json::parse(replay.out());
  EXPECT_TRUE(EventuallyTrue([&] {
    const json figures = FiguresOf(*record);
    return figures.value("rows", std::uint64_t{0}) + LostRows(figures) >= replayed["rows"] &&
           figures.value("events", 0) + figures.value("commands", 0) +
                   figures.value("lost_events", 0) >=
               replayed["events"].get<int>() + replayed["commands"].get<int>();
  })) << "replayed: "
      << replayed.dump() << "; recorded: " << FiguresOf(*record).dump();
  record->Signal(SIGINT);
  ASSERT_EQ(record->Wait(), program::kInterrupted) << record->err();

  const auto recorded = MessagesOf(first, "lab");
  auto again = MessagesOf(second, "rehearsal");
  for (const char* topic :
       {"arm/state/Joints", "odometer/state/Count", "odometer/state/Edges",
        "arm/Control/GoalReached", "arm/Control/MoveTo", "odometer/Control/SetCount"}) {
    EXPECT_TRUE(recorded.contains(std::string("lab/") + topic)) << topic;
  }
  EXPECT_EQ(again.size(), recorded.size());
  auto lost_rows = LossesOf(second);
  const std::uint64_t lost_events = FiguresOf(*record)["lost_events"];
  std::uint64_t missing_events = 0;
  for (const auto& [topic, expected] : recorded) {
    const std::string other = "rehearsal" + topic.substr(topic.find('/'));
    const auto& found = again[other];
    // Each message is one of the recorded ones, in their order and not twice.
    auto next = expected.begin();
    for (const Sent& message : found) {
      next = std::find(next, expected.end(), message);
      ASSERT_NE(next, expected.end()) << other << " " << message.first;
      ++next;
    }
    const std::uint64_t missing = expected.size() - found.size();
    if (topic.find("/Control/") != std::string::npos) {
      missing_events += missing;
    } else {
      EXPECT_LE(missing, lost_rows[other]) << other << " of " << expected.size();
    }
  }
  EXPECT_LE(missing_events, lost_events);
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
      {Binary("gcm"), "--gcm", address, "--timeout", kTestTimeout, "replay", arm_file, "--loop"});
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
