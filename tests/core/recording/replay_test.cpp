#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/folder.h>
#include <support/wait.h>
#include <tendon/gcm/global_manager.h>
#include <tendon/middleware/loopback.h>
#include <tendon/recording/recorder.h>
#include <tendon/recording/recording_selection.h>
#include <tendon/recording/recording_writer.h>
#include <tendon/recording/replay.h>
#include <tendon/task/periodic_task.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <fstream>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "recordings.h"
#include "tape.h"

namespace tendon::recording {

enum class Mode : std::int32_t { kIdle = 1, kMoving = 4 };

struct Point {
  std::array<double, 3> position{};
  std::string label;

  bool operator==(const Point&) const = default;
};

/// A structure with each kind of value.
struct Posture {
  Mode mode = Mode::kIdle;
  bool is_good = false;
  std::int8_t small = 0;
  std::uint64_t large = 0;
  float half = 0.0F;
  std::chrono::nanoseconds age{0};
  std::string text;
  std::vector<std::string> words;
  std::vector<Point> path;
  std::array<Mode, 2> modes{Mode::kIdle, Mode::kIdle};
  std::vector<double> numbers;

  bool operator==(const Posture&) const = default;
};

}  // namespace tendon::recording

template <>
inline constexpr auto tendon::kPayload<tendon::recording::Mode> =
    tendon::DescribeEnum("replay.Mode", tendon::Enumerator{"idle", tendon::recording::Mode::kIdle},
                         tendon::Enumerator{"moving", tendon::recording::Mode::kMoving});
template <>
inline constexpr auto tendon::kPayload<tendon::recording::Point> = tendon::Describe(
    "replay.Point", tendon::Field{"position", &tendon::recording::Point::position, "m"},
    tendon::Field{"label", &tendon::recording::Point::label});
template <>
inline constexpr auto tendon::kPayload<tendon::recording::Posture> =
    tendon::Describe("replay.Posture", tendon::Field{"mode", &tendon::recording::Posture::mode},
                     tendon::Field{"is_good", &tendon::recording::Posture::is_good},
                     tendon::Field{"small", &tendon::recording::Posture::small},
                     tendon::Field{"large", &tendon::recording::Posture::large},
                     tendon::Field{"half", &tendon::recording::Posture::half},
                     tendon::Field{"age", &tendon::recording::Posture::age},
                     tendon::Field{"text", &tendon::recording::Posture::text},
                     tendon::Field{"words", &tendon::recording::Posture::words},
                     tendon::Field{"path", &tendon::recording::Posture::path},
                     tendon::Field{"modes", &tendon::recording::Posture::modes},
                     tendon::Field{"numbers", &tendon::recording::Posture::numbers});

namespace tendon::recording {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using testing::ElementsAre;
using testing::HasSubstr;

/// Returns the posture of a cycle.
Posture PostureOf(std::uint64_t cycle) {
  const auto number = static_cast<double>(cycle);
  return {.mode = cycle % 2 == 0 ? Mode::kIdle : Mode::kMoving,
          .is_good = cycle % 3 == 0,
          .small = static_cast<std::int8_t>(cycle % 100),
          .large = ~cycle,
          .half = 0.5F * static_cast<float>(cycle),
          .age = std::chrono::milliseconds(cycle),
          .text = std::string(cycle % 7, 'x'),
          .words = std::vector<std::string>(cycle % 4, std::to_string(cycle)),
          .path = std::vector<Point>(cycle % 3, Point{{number, 1.0, -number}, "p"}),
          .modes = {Mode::kMoving, Mode::kIdle},
          .numbers = std::vector<double>(cycle % 5, number)};
}

/// A task with two tables and two events. One table has all kinds of values.
class Instrument final : public PeriodicTask {
 public:
  explicit Instrument(std::string name)
      : PeriodicTask(std::move(name), 1ms), slow_(AddStateTable("slow")) {
    state_table().Add(cycle_, "Number");
    state_table().Add(posture_, "Posture", 4096);
    state_table().Add(mode_, "Mode");
    slow_.Add(matrix_, "Matrix");
    slow_.Add(rare_, "Rare", 8);
    auto& control = AddProvidedInterface("Control");
    control.AddCommandWrite(&Instrument::Move, this, "Move");
    control.AddCommandReadState(state_table(), posture_, "GetPosture");
    control.AddEvent(reached_, "Reached");
    control.AddEvent(stopped_, "Stopped");
  }
  ~Instrument() override { Join(); }

  void Move(double /*distance*/) {}
  void Run() override {
    ++cycle_;
    posture_ = PostureOf(cycle_);
    mode_ = posture_.mode;
    matrix_[1][2] = static_cast<float>(cycle_);
    // Every second value is too large for the column.
    rare_ = cycle_ % 2 == 0 ? std::string("a") : std::string(20, 'b');
    if (cycle_ % 5 == 0) reached_(posture_);
    if (cycle_ % 10 == 0) stopped_();
    ProcessQueuedCommands();
  }

 private:
  StateTable& slow_;
  std::uint64_t cycle_ = 0;
  Posture posture_;
  Mode mode_ = Mode::kIdle;
  std::array<std::array<float, 3>, 2> matrix_{};
  std::string rare_;
  WriteEvent<Posture> reached_;
  VoidEvent stopped_;
};

/// Calls a command of the instrument.
class Mover final : public Component {
 public:
  explicit Mover(std::string name) : Component(std::move(name)) {
    AddRequiredInterface("Robot").AddFunction(move, "Move");
  }

  WriteFunction<double> move;
};

const InterfaceName kInstrument{"robot", "instrument", ""};

std::map<Fingerprint, Schema> Types() {
  return {{FingerprintOf<Posture>(), SchemaOf<Posture>()},
          {FingerprintOf<double>(), SchemaOf<double>()}};
}

/// A GCM over loopback, and recordings of `robot/instrument`.
class ReplayTest : public testing::Test {
 protected:
  ReplayTest() {
    auto gcm = GlobalManager::Start(
        Node(), {.address = "127.0.0.1:0", .state_folder = folder_.path() / "gcm"});
    EXPECT_TRUE(gcm) << gcm.error().message;
    gcm_ = *std::move(gcm);
  }

  std::shared_ptr<Middleware> Node() { return std::make_shared<LoopbackMiddleware>(network_); }
  std::unique_ptr<Process> MakeProcess(const std::string& name) {
    return std::make_unique<Process>(name,
                                     ProcessOptions{.middleware = Node(), .gcm = gcm_->address()});
  }
  [[nodiscard]] std::filesystem::path Path(const std::string& name) const {
    return folder_.path() / name;
  }

  /// Records a real instrument until it has written this number of rows.
  void Record(const std::string& name, std::uint64_t rows) {
    const auto robot = MakeProcess("robot");
    robot->Add<Instrument>("instrument");
    auto& mover = robot->Add<Mover>("mover");
    ASSERT_TRUE(robot->Connect({"mover", "Robot"}, {"instrument", "Control"}));
    ASSERT_TRUE(robot->StartAll());
    Tape tape(Node(), gcm_->address(), Path(name), kInstrument, Types());
    std::uint64_t synced = 0;
    double distance = 0.0;
    ASSERT_TRUE(EventuallyTrue([&] {
      (void)mover.move(distance += 0.5);
      const Counts counts = tape.Write();
      if (counts.rows >= synced + rows / 4) {  // begins a new chunk
        synced = counts.rows;
        tape.Sync();
      }
      return counts.rows >= rows && counts.events > 10 && counts.commands > 10;
    }));
    tape.Close();
  }

  std::unique_ptr<Replay> Open(const std::string& name, ReplayOptions options = {},
                               mcap::Query part = {}) {
    auto reader = mcap::Reader::Open(Path(name));
    EXPECT_TRUE(reader) << reader.error().message;
    auto replay = Replay::Open(*std::move(reader), std::move(part), std::move(options));
    EXPECT_TRUE(replay) << replay.error().message;
    return replay ? *std::move(replay) : nullptr;
  }
  void Start(Replay& replay) {
    const auto started = replay.Start([this](const std::string& process) {
      return Result<std::unique_ptr<Process>>(MakeProcess(process));
    });
    ASSERT_TRUE(started) << started.error().message;
    ASSERT_TRUE(replay.WaitUntilJoined(30s));
  }
  /// Plays the replay. Time advances as fast as `is_taken(status)` allows.
  template <typename IsTaken>
  static void PlayAll(Replay& replay, IsTaken is_taken) {
    SteadyTime now = SteadyClock().Now();
    for (int i = 0; const auto next = replay.Play(now); ++i) {
      now = *next;
      if (i % 50 == 49) {
        ASSERT_TRUE(EventuallyTrue([&] { return is_taken(replay.status()); }));
      }
    }
    ASSERT_TRUE(EventuallyTrue([&] { return is_taken(replay.status()); }));
  }

  std::map<std::string, std::vector<mcap::StoredMessage>> ByTopic(const std::string& name) {
    std::map<std::string, std::vector<mcap::StoredMessage>> all;
    const auto reader = mcap::Reader::Open(Path(name));
    EXPECT_TRUE(reader) << reader.error().message;
    if (!reader) return all;
    for (auto& message : mcap::ReadAll(**reader, {.order = mcap::Query::Order::kFile})) {
      if (message.topic.starts_with("robot/")) all[message.topic].push_back(std::move(message));
    }
    return all;
  }

  const std::shared_ptr<LoopbackNetwork> network_ = std::make_shared<LoopbackNetwork>();
  const test::Folder folder_;
  std::unique_ptr<GlobalManager> gcm_;
};

TEST_F(ReplayTest, ARecordingOfAReplayHasTheSameRowsEventsAndCallsAsTheRecording) {
  Record("first.mcap", 400);
  {
    const auto replay = Open("first.mcap");
    Start(*replay);
    Tape tape(Node(), gcm_->address(), Path("second.mcap"), kInstrument, Types());
    PlayAll(*replay, [&](const ReplayStatus& status) {
      const Counts counts = tape.Write();
      return counts.rows == status.rows && counts.events == status.events &&
             counts.commands == status.commands;
    });
    tape.Close();
    EXPECT_EQ(replay->status().rows, replay->contained().rows);
    EXPECT_EQ(replay->status().events, replay->contained().events);
    EXPECT_EQ(replay->status().commands, replay->contained().commands);
    EXPECT_EQ(replay->contained().left_out, 0U);
  }

  auto first = ByTopic("first.mcap");
  auto second = ByTopic("second.mcap");
  ASSERT_TRUE(first.contains("robot/instrument/state/Posture"));
  ASSERT_TRUE(first.contains("robot/instrument/state-slow/Matrix"));
  ASSERT_TRUE(first.contains("robot/instrument/Control/Reached"));
  ASSERT_TRUE(first.contains("robot/instrument/Control/Stopped"));
  ASSERT_TRUE(first.contains("robot/instrument/Control/Move"));
  ASSERT_EQ(first.size(), second.size());
  for (const auto& [topic, messages] : first) {
    const auto& again = second[topic];
    ASSERT_EQ(messages.size(), again.size()) << topic;
    const bool is_event = topic.find("/Control/") != topic.npos;
    for (std::size_t i = 0; i < messages.size(); ++i) {
      ASSERT_EQ(messages[i].data, again[i].data) << topic << " " << i;
      if (is_event) continue;
      ASSERT_EQ(messages[i].sequence, again[i].sequence) << topic << " " << i;
      if (i == 0) continue;
      ASSERT_EQ(again[i].publish_time - again[i - 1].publish_time,
                messages[i].log_time - messages[i - 1].log_time)
          << topic << " " << i;
    }
  }
  EXPECT_GT(first["robot/instrument/state/Posture"].front().sequence, 0U)
      << "the recording begins while the instrument runs, so the first tick is not 0";
}

TEST_F(ReplayTest, AReplayThatEndsAfterAllIsSentHasLostNothing) {
  Record("first.mcap", 200);
  Counts counts;
  ReplayStatus played;
  {
    auto replay = Open("first.mcap");
    Start(*replay);
    Tape tape(Node(), gcm_->address(), Path("second.mcap"), kInstrument, Types());
    SteadyTime now = SteadyClock().Now();
    const auto is_sent = [&] { return replay->HasSentAll(); };
    for (int i = 0; const auto next = replay->Play(now); ++i) {
      now = *next;
      if (i % 50 == 49) {
        ASSERT_TRUE(EventuallyTrue(is_sent));
      }
    }
    played = replay->status();

    EXPECT_TRUE(EventuallyTrue(is_sent));
    replay.reset();

    EXPECT_TRUE(EventuallyTrue([&] {
      counts = tape.Write();
      return counts.rows == played.rows && counts.events == played.events;
    })) << counts.rows
        << " of " << played.rows << ", " << counts.events << " of " << played.events;
    tape.Close();
  }
}

/// Uses the replayed instrument like a real one.
class Client final : public Component {
 public:
  explicit Client(std::string name) : Component(std::move(name)) {
    auto& robot = AddRequiredInterface("Robot");
    robot.AddFunction(move, "Move");
    robot.AddFunction(get_posture, "GetPosture");
    robot.AddEventHandlerWrite(&Client::OnReached, this, "Reached");
    auto& state = AddRequiredInterface("State");
    state.AddFunction(number, "Number");
    state.AddFunction(mode, "Mode");
  }

  [[nodiscard]] std::vector<Posture> reached() const {
    const std::scoped_lock lock(mutex_);
    return reached_;
  }

  WriteFunction<double> move;
  ReadFunction<Posture> get_posture;
  ReadFunction<std::uint64_t> number;
  ReadFunction<Mode> mode;

 private:
  void OnReached(const Posture& posture) {
    const std::scoped_lock lock(mutex_);
    reached_.push_back(posture);
  }

  mutable std::mutex mutex_;
  std::vector<Posture> reached_;
};

TEST_F(ReplayTest, AComponentReadsValuesAndHandlesEventsOfAReplayedOne) {
  Record("run.mcap", 100);
  const auto replay = Open("run.mcap");
  Start(*replay);
  const auto desk = MakeProcess("desk");
  auto& client = desk->Add<Client>("client");
  ASSERT_TRUE(desk->StartAll());
  ASSERT_TRUE(desk->WaitUntilJoined(30s));
  ASSERT_TRUE(desk->Connect({"client", "Robot"}, {"robot", "instrument", "Control"}));
  ASSERT_TRUE(desk->Connect({"client", "State"}, {"robot", "instrument", "state"}));
  ASSERT_TRUE(EventuallyTrue([&] {
    const auto all = desk->connections();
    return all.size() == 2 && std::ranges::all_of(all, [](const auto& connection) {
             return connection.state == ConnectionState::kActive;
           });
  }));
  std::uint64_t number = 0;
  EXPECT_EQ(client.number(number), Status(Status::kNoSample)) << "no row is replayed yet";

  PlayAll(*replay, [&](const ReplayStatus& /*status*/) { return true; });

  auto topics = ByTopic("run.mcap");
  const auto last = mcap::ValueOf<std::uint64_t>(topics["robot/instrument/state/Number"].back());
  ASSERT_TRUE(EventuallyTrue([&] { return client.number(number) && number == last; }));
  Posture posture;
  ASSERT_TRUE(
      EventuallyTrue([&] { return client.get_posture(posture) && posture == PostureOf(last); }));
  Mode mode{};
  ASSERT_TRUE(client.mode(mode));
  EXPECT_EQ(mode, PostureOf(last).mode);
  const auto& reached = topics["robot/instrument/Control/Reached"];
  ASSERT_TRUE(EventuallyTrue([&] { return client.reached().size() == reached.size(); }));
  for (std::size_t i = 0; i < reached.size(); ++i) {
    EXPECT_EQ(client.reached()[i], mcap::ValueOf<Posture>(reached[i]));
  }
}

TEST_F(ReplayTest, ACommandIsRefusedWithASentenceThatNamesTheRecording) {
  Record("run.mcap", 20);
  const auto replay = Open("run.mcap", {.as = "rehearsal"});
  Start(*replay);
  GcmClient client(Node(), {.name = "viewer", .address = gcm_->address()});
  ASSERT_TRUE(client.WaitUntilWatching());
  ASSERT_TRUE(EventuallyTrue(
      [&] { return client.catalogue().FindComponent("rehearsal", "instrument") != nullptr; }));

  const auto reply = Wait<std::string>(
      30s, [&](auto handler) { client.Call("rehearsal/instrument/Control.Move", "1.5", handler); });

  ASSERT_FALSE(reply);
  EXPECT_THAT(reply.error().message, HasSubstr("this is a replay of run.mcap"));
  const Catalogue catalogue = client.catalogue();
  EXPECT_EQ(catalogue.FindComponent("rehearsal", "instrument")->library, "replay of run.mcap");
}

TEST_F(ReplayTest, ADamagedFileIsReplayedUpToItsLastCompleteChunk) {
  Record("run.mcap", 200);
  const auto reader = mcap::Reader::Open(Path("run.mcap"));
  ASSERT_TRUE(reader);
  ASSERT_GE((*reader)->blocks().size(), 2U);
  std::string bytes = folder_.Read("run.mcap");
  bytes.resize((*reader)->blocks()[(*reader)->blocks().size() / 2].index.chunk_start_offset + 20);
  folder_.Write("cut-off.mcap", bytes);

  const auto replay = Open("cut-off.mcap");
  Start(*replay);
  PlayAll(*replay, [](const ReplayStatus& /*status*/) { return true; });

  EXPECT_GT(replay->status().rows, 0U);
  EXPECT_EQ(replay->status().rows, replay->contained().rows);
  EXPECT_GT(replay->reader().problems().count(), 0U);
  const auto whole = ByTopic("run.mcap");
  EXPECT_LT(ByTopic("cut-off.mcap")["robot/instrument/state/Number"].size(),
            whole.at("robot/instrument/state/Number").size());
}

/// A recording that is written record by record: rows of `robot/arm/state.Number`.
class HandmadeRecording {
 public:
  explicit HandmadeRecording(const std::filesystem::path& file) {
    auto writer = mcap::Writer::Create(file, {.profile = kProfile});
    EXPECT_TRUE(writer);
    writer_ = *std::move(writer);
  }
  mcap::ChannelId AddColumn(const std::string& path, const std::string& epoch) {
    const auto schema = writer_->AddSchema("uint64", kSchemaEncoding, "uint64 data");
    return *writer_->AddChannel(*schema, path, kMessageEncoding,
                                {{kKindKey, kColumnKind},
                                 {kPathKey, path},
                                 {kSchemaKey, SchemaOf<std::uint64_t>().TextWithHelp()},
                                 {kEpochKey, epoch}});
  }
  void AddRow(mcap::ChannelId column, std::uint32_t tick, mcap::Timestamp time,
              std::uint64_t value) {
    std::vector<std::byte> encoded;
    Encode(value, encoded);
    mcap::Buffer data;
    Encapsulate(encoded, data);
    EXPECT_TRUE(writer_->Write(mcap::Message{column, tick, time, time, data}));
  }
  void AddLog(const RosLog& record, mcap::Timestamp time) {
    const auto schema = writer_->AddSchema("rcl_interfaces/msg/Log", kSchemaEncoding, "");
    const auto channel =
        *writer_->AddChannel(*schema, kLogTopic, kMessageEncoding, {{kKindKey, kOtherKind}});
    std::vector<std::byte> encoded;
    Encode(record, encoded);
    mcap::Buffer data;
    Encapsulate(encoded, data);
    EXPECT_TRUE(writer_->Write(mcap::Message{channel, 0, time, time, data}));
  }
  void Close() const { EXPECT_TRUE(writer_->Close()); }

 private:
  std::unique_ptr<mcap::Writer> writer_;
};

constexpr mcap::Timestamp kRecordedAt = 1'700'000'000'000'000'000;

TEST_F(ReplayTest, TheTimesBetweenRowsAreDividedByTheRate) {
  HandmadeRecording recording(Path("run.mcap"));
  const auto column = recording.AddColumn("robot/arm/state.Number", "1");
  recording.AddRow(column, 1, kRecordedAt, 1);
  recording.AddRow(column, 2, kRecordedAt + 10'000'000, 2);
  recording.AddRow(column, 3, kRecordedAt + 40'000'000, 3);
  recording.Close();
  const auto replay = Open("run.mcap", {.rate = 2.0, .delay = 1s});
  Start(*replay);

  ManualClock clock;
  const SteadyTime begin = clock.Now();
  std::vector<std::chrono::nanoseconds> due;
  while (const auto next = replay->Play(clock.Now())) {
    due.push_back(*next - begin);
    EXPECT_EQ(replay->status().rows, due.size() - 1);
    clock.Advance(*next - clock.Now());
  }

  EXPECT_THAT(due, ElementsAre(1s, 1s + 5ms, 1s + 20ms));
  EXPECT_EQ(replay->status().rows, 3U);
  EXPECT_EQ(replay->status().extended, 0ns);
}

TEST_F(ReplayTest, AReplayThatIsTooLateTakesLongerAndLeavesNothingOut) {
  HandmadeRecording recording(Path("run.mcap"));
  const auto column = recording.AddColumn("robot/arm/state.Number", "1");
  for (std::uint32_t i = 0; i < 10; ++i)
    recording.AddRow(column, i, kRecordedAt + i * 10'000'000, i);
  recording.Close();
  const auto replay = Open("run.mcap");
  Start(*replay);

  ManualClock clock;
  ASSERT_TRUE(replay->Play(clock.Now()));
  clock.Advance(5s);
  const auto next = replay->Play(clock.Now());

  ASSERT_TRUE(next);
  EXPECT_EQ(*next - clock.Now(), 10ms) << "the pace stays";
  EXPECT_EQ(replay->status().rows, 2U);
  EXPECT_EQ(replay->status().extended, 5s - 10ms);
}

TEST_F(ReplayTest, ALoopBeginsAgainAndItsTicksGoOn) {
  HandmadeRecording recording(Path("run.mcap"));
  const auto column = recording.AddColumn("robot/arm/state.Number", "1");
  for (std::uint32_t i = 0; i < 3; ++i)
    recording.AddRow(column, 7 + i, kRecordedAt + i * 1'000'000, i);
  recording.Close();
  const auto replay = Open("run.mcap", {.loops = true});
  Start(*replay);

  ManualClock clock;
  while (replay->status().rows < 7) {
    const auto next = replay->Play(clock.Now());
    ASSERT_TRUE(next);
    clock.Advance(*next - clock.Now());
  }

  EXPECT_EQ(replay->status().passes, 2U);
}

TEST_F(ReplayTest, TheLogIsSentAgainAsThatOfTheReplayedProcess) {
  HandmadeRecording recording(Path("run.mcap"));
  const auto column = recording.AddColumn("robot/arm/state.Number", "1");
  recording.AddRow(column, 1, kRecordedAt, 1);
  recording.AddLog({.level = 30, .name = "robot/arm", .msg = "the goal is far away"},
                   kRecordedAt + 1);
  recording.AddLog({.level = 20, .name = "desk/pedal", .msg = "pressed"}, kRecordedAt + 2);
  recording.Close();
  const auto replay = Open("run.mcap", {.as = "rehearsal"});
  Start(*replay);
  const auto queue = std::make_shared<RecordingQueue>();
  GcmClient client(Node(), {.name = "viewer", .address = gcm_->address()}, queue);
  ASSERT_TRUE(client.WaitUntilWatching());
  client.WatchLog();

  PlayAll(*replay, [](const ReplayStatus& /*status*/) { return true; });

  std::vector<message::LogRecord> found;
  ASSERT_TRUE(EventuallyTrue([&] {
    for (const RecordingEntry& entry : queue->Take(1ms)) {
      const auto* log = std::get_if<LogEntry>(&entry);
      if (log != nullptr && log->record.text == "the goal is far away")
        found.push_back(log->record);
    }
    return !found.empty();
  }));
  EXPECT_EQ(found[0].process, "rehearsal");
  EXPECT_EQ(found[0].source, "arm");
  EXPECT_EQ(found[0].level, LogLevel::kWarning);
  EXPECT_EQ(replay->status().log, 1U);
  EXPECT_EQ(replay->status().log_left_out, 1U) << "no process stands for desk";
}

TEST_F(ReplayTest, AnotherNameIsForOneProcessOnly) {
  HandmadeRecording recording(Path("run.mcap"));
  const auto robot = recording.AddColumn("robot/arm/state.Number", "1");
  const auto desk = recording.AddColumn("desk/pedal/state.Number", "1");
  recording.AddRow(robot, 1, kRecordedAt, 1);
  recording.AddRow(desk, 1, kRecordedAt, 1);
  recording.Close();
  auto reader = mcap::Reader::Open(Path("run.mcap"));
  ASSERT_TRUE(reader);

  const auto refused = Replay::Open(*std::move(reader), {}, {.as = "rehearsal"});

  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("has several: desk, robot"));
  EXPECT_THAT(Open("run.mcap")->processes(), ElementsAre("desk", "robot"));
}

class RecordingReaderTest : public ReplayTest {};

TEST_F(RecordingReaderTest, AreInTheOrderOfTimeAndTicksGoOnAfterARestart) {
  HandmadeRecording recording(Path("run.mcap"));
  const auto first = recording.AddColumn("robot/arm/state.Number", "1");
  const auto other = recording.AddColumn("desk/pedal/state.Number", "1");
  recording.AddRow(first, 0xffffffff, kRecordedAt, 1);
  recording.AddRow(first, 0, kRecordedAt + 2, 2);
  recording.AddRow(first, 4, kRecordedAt + 4, 3);  // three rows are lost before
  recording.AddRow(other, 9, kRecordedAt + 1, 4);
  recording.AddRow(other, 10, kRecordedAt + 5, 5);
  const auto restarted = recording.AddColumn("robot/arm/state.Number", "2");
  recording.AddRow(restarted, 0, kRecordedAt + 6, 6);
  recording.Close();
  const auto reader = mcap::Reader::Open(Path("run.mcap"));
  ASSERT_TRUE(reader);

  const auto items = RecordingReader::Open(**reader, {});
  ASSERT_TRUE(items) << items.error().message;
  std::vector<std::pair<std::string, std::uint64_t>> ticks;
  std::vector<mcap::Timestamp> times;
  while (const auto item = (*items)->Next()) {
    const auto& source = (*items)->sources()[item->source];
    ticks.emplace_back(source.name.process, std::get<RecordedRow>(item->content).tick);
    times.push_back(item->time - kRecordedAt);
  }

  EXPECT_THAT(times, ElementsAre(0U, 1U, 2U, 4U, 5U, 6U));
  constexpr std::uint64_t kFirst = 0xffffffff;
  EXPECT_THAT(ticks, ElementsAre(std::pair("robot", kFirst), std::pair("desk", 9U),
                                 std::pair("robot", kFirst + 1), std::pair("robot", kFirst + 5),
                                 std::pair("desk", 10U), std::pair("robot", kFirst + 6)));
}

TEST_F(RecordingReaderTest, MoreTablesThanAMachineHoldsAreRefused) {
  HandmadeRecording recording(Path("run.mcap"));
  for (std::size_t i = 0; i <= RecordingReader::kMaxSources; ++i) {
    recording.AddColumn("robot/arm" + std::to_string(i) + "/state.Number", "1");
  }
  recording.Close();
  const auto reader = mcap::Reader::Open(Path("run.mcap"));
  ASSERT_TRUE(reader);

  const auto items = RecordingReader::Open(**reader, {});

  ASSERT_FALSE(items);
  EXPECT_THAT(items.error().message, HasSubstr("4097 state tables and interfaces with events"));
}

TEST_F(ReplayTest, RefusesAReplayOfMoreThanTenYears) {
  HandmadeRecording recording(Path("run.mcap"));
  const auto column = recording.AddColumn("robot/arm/state.Number", "1");
  recording.AddRow(column, 1, 1, 1);
  recording.AddRow(column, 2, kRecordedAt, 2);
  recording.Close();
  auto reader = mcap::Reader::Open(Path("run.mcap"));
  ASSERT_TRUE(reader);

  const auto replay = Replay::Open(*std::move(reader), {}, {.rate = 0.001});

  ASSERT_FALSE(replay);
  EXPECT_THAT(replay.error().message, HasSubstr("days, more than 3650; choose a smaller part"));
}

TEST_F(RecordingReaderTest, APartWithoutRowsAndEventsIsRefused) {
  HandmadeRecording recording(Path("run.mcap"));
  const auto column = recording.AddColumn("robot/arm/state.Number", "1");
  recording.AddRow(column, 1, kRecordedAt, 1);
  recording.Close();
  const auto reader = mcap::Reader::Open(Path("run.mcap"));
  ASSERT_TRUE(reader);

  const auto none = RecordingReader::Open(**reader, {.from = kRecordedAt + 1});

  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message,
              HasSubstr("has no row of a Tendon table, no event and no command"));
}

}  // namespace
}  // namespace tendon::recording
