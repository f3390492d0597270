#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/machine/stall_meter.h>
#include <tendon/recording/recorder.h>
#include <tendon/recording/recording_selection.h>
#include <tendon/task/component.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "recorder_fixture.h"

namespace tendon::recording {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

TEST_F(RecorderTest, RecordsEachRowOfAllColumnsOnce) {
  const auto robot = StartProcess("robot");
  StartRecorder({.patterns = {"robot/odometer/state"}}, {"robot"});
  ASSERT_TRUE(EventuallyRows(500));
  ASSERT_TRUE(recorder_->Stop());
  const RecorderStatus status = recorder_->status();

  const auto reader = Open();
  auto topics = ByTopic(*reader);
  const auto& numbers = topics["robot/odometer/state/Number"];
  const auto& halves = topics["robot/odometer/state/Half"];
  EXPECT_EQ(numbers.size(), status.counts.rows);
  ExpectEachRowOnce(numbers);
  ASSERT_EQ(halves.size(), numbers.size());
  for (std::size_t i = 0; i < halves.size(); ++i) {
    ASSERT_EQ(halves[i].sequence, numbers[i].sequence);
    ASSERT_EQ(ValueOf<double>(halves[i]),
              0.5 * static_cast<double>(ValueOf<std::uint64_t>(numbers[i])));
  }
  EXPECT_FALSE(topics.contains("robot/odometer/Control/Passed")) << "nobody asked for it";
}

TEST_F(RecorderTest, RecordsEventsWithTheirValuesAndTheCatalogue) {
  const auto robot = StartProcess("robot");
  StartRecorder({.patterns = {"robot/odometer/Control.Passed"}}, {"robot"});
  ASSERT_TRUE(EventuallyTrue([&] { return recorder_->status().counts.events >= 300; }));
  ASSERT_TRUE(recorder_->Stop());

  const auto reader = Open();
  auto topics = ByTopic(*reader);
  const auto& events = topics["robot/odometer/Control/Passed"];
  ASSERT_GE(events.size(), 300U);
  for (std::size_t i = 1; i < events.size(); ++i) {
    ASSERT_EQ(events[i].sequence, i);
    ASSERT_GT(ValueOf<std::uint64_t>(events[i]), ValueOf<std::uint64_t>(events[i - 1]));
  }
  Catalogue catalogue;
  for (const auto& message : topics[kCatalogueTopic]) {
    const auto change = ValueOf<CatalogueChange>(message);
    if (message.sequence == 0) catalogue = Catalogue::At(change.revision - 1);
    EXPECT_TRUE(catalogue.Apply(change));
  }
  EXPECT_NE(catalogue.FindComponent("robot", "odometer"), nullptr);
  EXPECT_EQ(reader->attachments().at(0).name, kSystemAttachment);
}

/// Can call the command of an odometer.
class Driver final : public Component {
 public:
  explicit Driver(std::string name) : Component(std::move(name)) {
    AddRequiredInterface("Odometer").AddFunction(reverse_, "Reverse");
  }

 private:
  VoidFunction reverse_;
};

/// A change of a system, and whether a catalogue shows it.
struct Change {
  using IsReached = std::function<bool(const Catalogue&)>;

  std::function<bool()> request;
  IsReached is_reached;
};

Change::IsReached OdometerIs(ComponentState state) {
  return [state](const Catalogue& catalogue) {
    const auto* odometer = catalogue.FindComponent("robot", "odometer");
    return odometer != nullptr && odometer->state == state;
  };
}

Change::IsReached DriverIsConnected(bool wanted) {
  return [wanted](const Catalogue& catalogue) {
    return (catalogue.FindConnection({"robot", "driver", "Odometer"}) != nullptr) == wanted;
  };
}

TEST_F(RecorderTest, TheFileSaysWhenAComponentIsSuspendedAndWhenItIsConnected) {
  const auto robot = StartProcess("robot");
  robot->Add<Driver>("driver");
  const std::vector<Change> changes{
      {[&] { return robot->Suspend("odometer").ok(); }, OdometerIs(ComponentState::kSuspended)},
      {[&] { return robot->Start("odometer").ok(); }, OdometerIs(ComponentState::kActive)},
      {[&] {
         return robot->Connect({"driver", "Odometer"}, {"odometer", "Control"}).ok();
       },
       DriverIsConnected(true)},
      {[&] {
         return robot->Disconnect({"driver", "Odometer"}).ok();
       },
       DriverIsConnected(false)}};
  StartRecorder({.patterns = {"robot/**"}}, {"robot"});
  ASSERT_TRUE(EventuallyRows(50));

  std::vector<SteadyTime> before;
  for (const Change& change : changes) {
    before.push_back(SteadyClock().Now());
    ASSERT_TRUE(change.request());
    ASSERT_TRUE(EventuallyTrue([&] { return change.is_reached(client_->catalogue()); }));
  }
  // The recorder hears of a change a little later than the catalogue of its client.
  ASSERT_TRUE(EventuallyRows(recorder_->status().counts.rows + 200));
  ASSERT_TRUE(recorder_->Stop());
  const SteadyTime end = SteadyClock().Now();

  const auto reader = Open();
  auto topics = ByTopic(*reader);
  const auto time_of = [shift = WallMinusSteadyIn(*reader)](const mcap::StoredMessage& message) {
    return SteadyTime(
        std::chrono::nanoseconds(static_cast<std::int64_t>(message.log_time) - shift));
  };
  Catalogue catalogue;
  std::vector<SteadyTime> found;
  for (const auto& message : topics[kCatalogueTopic]) {
    const auto change = ValueOf<CatalogueChange>(message);
    if (message.sequence == 0) catalogue = Catalogue::At(change.revision - 1);
    ASSERT_TRUE(catalogue.Apply(change));
    if (found.size() < changes.size() && changes[found.size()].is_reached(catalogue)) {
      found.push_back(time_of(message));
    }
  }
  ASSERT_EQ(found.size(), changes.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_GE(found[i], before[i]) << i;
    // The client may show a change just before the recorder receives it.
    EXPECT_LE(found[i], i + 2 < before.size() ? before[i + 2] : end) << i;
  }
  EXPECT_TRUE(std::ranges::none_of(topics["robot/odometer/state/Number"],
                                   [&](const mcap::StoredMessage& row) {
                                     return time_of(row) > found[0] && time_of(row) < before[1];
                                   }))
      << "a suspended component writes no rows";
}

TEST_F(RecorderTest, RecordsAProcessThatComesLaterAndOneThatComesBack) {
  auto robot = StartProcess("robot");
  StartRecorder({.patterns = {"**"}}, {"robot"});
  ASSERT_TRUE(EventuallyRows(100));

  robot.reset();
  robot = StartProcess("robot");
  const auto desk = StartProcess("desk");
  const auto channels_of = [&](const std::string& topic) {
    std::size_t count = 0;
    const auto reader = mcap::Reader::Open(file_);
    if (!reader) return count;
    for (const auto& [id, channel] : (*reader)->channels()) count += channel.topic == topic;
    return count;
  };
  ASSERT_TRUE(EventuallyTrue([&] {
    return channels_of("robot/odometer/state/Number") == 2 &&
           channels_of("desk/odometer/state/Number") == 1;
  })) << "a file that is being written can be read";
  ASSERT_TRUE(recorder_->Stop());

  const auto reader = Open();
  std::map<mcap::ChannelId, std::vector<std::uint32_t>> ticks;
  auto messages = reader->Messages({.order = mcap::Query::Order::kFile});
  while (const auto message = messages.Next()) {
    if (reader->FindChannel(message->channel_id)->topic.ends_with("/state/Number")) {
      ticks[message->channel_id].push_back(message->sequence);
    }
  }
  EXPECT_EQ(ticks.size(), 3U);
  for (const auto& [channel, all] : ticks) {
    for (std::size_t i = 1; i < all.size(); ++i) EXPECT_GT(all[i], all[i - 1]);
  }
}

TEST_F(RecorderTest, ALostGcmEndsNoRecording) {
  const auto robot = StartProcess("robot");
  StartRecorder({.patterns = {"robot/**"}}, {"robot"});
  ASSERT_TRUE(EventuallyRows(50));

  gcm_.reset();
  ASSERT_TRUE(EventuallyTrue([&] { return queue_->is_gcm_lost(); }));
  const std::uint64_t before = recorder_->status().counts.rows;
  ASSERT_TRUE(EventuallyRows(before + 300));
  StartGcm(address_);
  ASSERT_TRUE(EventuallyTrue([&] { return !queue_->is_gcm_lost(); }));
  ASSERT_TRUE(recorder_->Stop());

  EXPECT_THAT(recorder_->TakeNotices(), Contains(HasSubstr("the GCM is available again")));
  const auto reader = Open();
  ExpectEachRowOnce(ByTopic(*reader)["robot/odometer/state/Number"]);
}

TEST_F(RecorderTest, ARestartOfTheGcmEndsNoSubscription) {
  const auto robot = StartProcess("robot");
  StartRecorder({.patterns = {"robot/**"}}, {"robot"});
  ASSERT_TRUE(EventuallyTrue([&] { return recorder_->status().counts.events >= 50; }));
  ASSERT_TRUE(EventuallyRows(50));

  gcm_.reset();
  ASSERT_TRUE(EventuallyTrue([&] { return queue_->is_gcm_lost(); }));
  StartGcm(address_);
  ASSERT_TRUE(EventuallyTrue([&] { return !queue_->is_gcm_lost(); }));
  ASSERT_TRUE(EventuallyTrue(
      [&] { return client_->catalogue().FindComponent("robot", "odometer") != nullptr; }));
  const std::uint64_t before = recorder_->status().counts.rows;
  ASSERT_TRUE(EventuallyRows(before + 300));
  ASSERT_TRUE(recorder_->Stop());

  const auto reader = Open();
  auto topics = ByTopic(*reader);
  ExpectEachRowOnce(topics["robot/odometer/state/Number"]);
  const auto& events = topics["robot/odometer/Control/Passed"];
  ASSERT_FALSE(events.empty());
  const std::uint64_t raised =
      ValueOf<std::uint64_t>(events.back()) - ValueOf<std::uint64_t>(events.front()) + 1;
  EXPECT_LE(raised,
            events.size() + recorder_->status().losses.events["robot/odometer/Control.Passed"]);
}

TEST_F(RecorderTest, AProcessThatIsForgottenIsNotRecordedAnyMore) {
  auto robot = StartProcess("robot");
  StartRecorder({.patterns = {"**"}}, {"robot"});
  ASSERT_TRUE(EventuallyTrue([&] { return recorder_->status().tables == 1; }));

  robot.reset();
  ASSERT_TRUE(EventuallyTrue([&] {
    const Catalogue catalogue = client_->catalogue();
    const ProcessEntry* entry = catalogue.FindProcess("robot");
    return entry != nullptr && entry->process.state == ProcessState::kLeft;
  }));
  const auto desk = StartProcess("desk");
  ASSERT_TRUE(EventuallyTrue([&] {
    const Catalogue catalogue = client_->catalogue();
    return catalogue.FindComponent("desk", "odometer") != nullptr &&
           recorder_->status().tables == Select(catalogue, {"**"}).tables.size();
  })) << "the recorder has seen that the process has left";
  const auto done =
      Wait<void>(10s, [&](auto handler) { client_->Forget("robot", std::move(handler)); });
  ASSERT_TRUE(done) << done.error().message;

  EXPECT_TRUE(EventuallyTrue([&] { return recorder_->status().tables == 1; }));
}

TEST_F(RecorderTest, ASlowDiskCostsRowsThatAreCountedAndHoldsUpNobody) {
  FaultyDisk disk;
  const auto robot = StartProcess("robot");
  StartRecorder({.patterns = {"robot/odometer/state"}, .files = On(disk)}, {"robot"}, kFewBytes);
  ASSERT_TRUE(EventuallyRows(100));

  {
    const std::scoped_lock slow(disk.gate);
    ASSERT_TRUE(EventuallyTrue([&] { return LostRowsUpToNow().viewer >= 500; }))
        << "rows arrive while nothing can be written";
  }
  const std::uint64_t before = recorder_->status().counts.rows;
  ASSERT_TRUE(EventuallyRows(before + 200));
  ASSERT_TRUE(recorder_->Stop());

  const auto reader = Open();
  auto topics = ByTopic(*reader);
  ExpectEachRowOnce(topics["robot/odometer/state/Number"]);
  std::uint64_t told = 0;
  for (const auto& message : topics[kLossTopic]) told += ValueOf<Loss>(message).recorder;
  EXPECT_EQ(told, LostRowsUpToNow().viewer);
}

TEST_F(RecorderTest, ASourceThatTheFileCannotHoldIsCountedAsLostAndTheOthersAreRecorded) {
  const auto robot = StartProcess("robot");
  StartRecorder({.patterns = {"robot/odometer/state"}}, {"robot"});
  constexpr std::size_t kColumns = 65'001;
  TableSubscription huge{"robot", "other", "state", {}};
  for (std::size_t i = 0; i < kColumns; ++i) huge.columns.push_back("C" + std::to_string(i));
  const auto sink = queue_->SinkOf(huge);
  sink->OnSubscribed(std::vector<Schema>(kColumns, SchemaOf<std::uint8_t>()));
  const std::byte cell[] = {std::byte{1}};
  for (std::uint64_t i = 0; i < 3; ++i) {
    const std::uint64_t ticks[] = {i};
    const std::int64_t times[] = {SteadyClock().Now().time_since_epoch().count()};
    RowBatch batch;
    batch.count = 1;
    batch.ticks = ticks;
    batch.times = times;
    batch.cell = [&](std::size_t, std::size_t) { return std::span<const std::byte>(cell); };
    sink->OnRows(batch);
  }
  ASSERT_TRUE(EventuallyTrue(
      [&] { return recorder_->status().losses.rows["robot/other/state"].viewer == 3; }));
  const std::uint64_t before = recorder_->status().counts.rows;
  ASSERT_TRUE(EventuallyRows(before + 100));

  const auto notices = recorder_->TakeNotices();
  EXPECT_EQ(
      std::ranges::count_if(
          notices, [](const auto& one) { return one.starts_with("robot/other/state is not"); }),
      1);
  ASSERT_TRUE(recorder_->Stop());
  const auto reader = Open();
  auto topics = ByTopic(*reader);
  ExpectEachRowOnce(topics["robot/odometer/state/Number"]);
  std::uint64_t told = 0;
  for (const auto& message : topics[kLossTopic]) {
    const auto loss = ValueOf<Loss>(message);
    if (loss.path == "robot/other/state") told += loss.recorder;
  }
  EXPECT_EQ(told, 3U);
}

TEST_F(RecorderTest, RowsThatWaitWhenTheDiskFailsAreCountedAsLost) {
  FaultyDisk disk;
  const auto robot = StartProcess("robot");
  StartRecorder({.patterns = {"robot/odometer/state"}, .files = On(disk)}, {"robot"});
  const auto sink =
      queue_->SinkOf(TableSubscription{"robot", "other", "state", std::vector<std::string>{"A"}});
  sink->OnSubscribed({SchemaOf<std::uint8_t>()});
  const std::byte cell[] = {std::byte{1}};
  std::uint64_t sent = 0;
  const auto send = [&](int count) {
    for (int i = 0; i < count; ++i) {
      const std::uint64_t ticks[] = {sent++};
      const std::int64_t times[] = {SteadyClock().Now().time_since_epoch().count()};
      RowBatch batch;
      batch.count = 1;
      batch.ticks = ticks;
      batch.times = times;
      batch.cell = [&](std::size_t, std::size_t) { return std::span<const std::byte>(cell); };
      sink->OnRows(batch);
    }
  };
  send(500);
  ASSERT_TRUE(EventuallyRows(1000));

  {
    const std::scoped_lock change(disk.gate);
    send(5000);
    disk.failure = kDiskFull;
  }
  ASSERT_TRUE(EventuallyTrue([&] { return recorder_->status().failure.has_value(); }));
  send(500);
  ASSERT_FALSE(recorder_->Stop());

  const auto reader = mcap::Reader::Open(file_);
  ASSERT_TRUE(reader) << reader.error().message;
  auto topics = ByTopic(**reader);
  RecorderStatus status = recorder_->status();
  EXPECT_EQ(topics["robot/other/state/A"].size() + status.losses.rows["robot/other/state"].viewer,
            sent);
  EXPECT_EQ(status.counts.rows,
            topics["robot/other/state/A"].size() + topics["robot/odometer/state/Number"].size());
}

/// Records onto a disk that fails.
class FailingDisk : public RecorderTest {
 protected:
  ~FailingDisk() override { recorder_.reset(); }

  /// Records, lets the disk fail, and waits until the recorder has noticed it. Expects that only
  /// the recording ends.
  void RecordUntil(const std::function<void()>& fail) {
    const auto robot = StartProcess("robot");
    StartRecorder({.patterns = {"robot/odometer/state"}, .files = On(disk_)}, {"robot"}, kFewBytes);
    EXPECT_TRUE(EventuallyRows(1000));
    {
      const std::scoped_lock change(disk_.gate);
      fail();
    }
    EXPECT_TRUE(EventuallyTrue([&] { return recorder_->status().failure.has_value(); }));
    const std::uint64_t lost = LostRowsUpToNow().viewer;
    const std::uint64_t cycles = NumberOf(*robot);
    EXPECT_TRUE(EventuallyTrue([&] { return NumberOf(*robot) > cycles + 100; }))
        << "the component goes on";
    EXPECT_TRUE(EventuallyTrue([&] { return LostRowsUpToNow().viewer > lost + 100; }))
        << "the loss is counted";
  }
  std::string ErrorOfStop() {
    const auto stopped = recorder_->Stop();
    EXPECT_FALSE(stopped);
    return stopped ? "" : stopped.error().message;
  }
  /// Expects that the file has all messages that `error` calls safe, and that all other rows count
  /// as lost.
  void ExpectSafe(mcap::Reader& reader, const std::string& error) {
    EXPECT_THAT(error,
                HasSubstr("; " + std::to_string(mcap::ReadAll(reader).size()) + " messages up to"));
    const auto rows = ByTopic(reader)["robot/odometer/state/Number"];
    ExpectEachRowOnce(rows);
    EXPECT_EQ(recorder_->status().counts.rows, rows.size());
  }

  void Break() {
    disk_.failure = "Input/output error";
    disk_.leaves_halves = true;
  }

  FaultyDisk disk_;
};

TEST_F(FailingDisk, AFullOneEndsTheRecordingAlone) {
  RecordUntil([&] { disk_.failure = kDiskFull; });
  const std::string error = ErrorOfStop();

  EXPECT_THAT(error,
              testing::MatchesRegex(
                  "recording stopped: cannot write at [0-9]+ of .*run.mcap: No space left on "
                  "device \\(0 B free\\); [0-9]+ messages up to .* are in the file; the [0-9]+ "
                  "later messages are lost; free space or check the disk, then record into another "
                  "file; the file has no index; to make an index: gcm recover"));
  const auto reader = mcap::Reader::Open(file_);
  ASSERT_TRUE(reader) << reader.error().message;
  ExpectSafe(**reader, error);
}

TEST_F(FailingDisk, ABrokenOneEndsTheRecordingAtTheLastCompleteChunk) {
  RecordUntil([&] { Break(); });
  const std::string error = ErrorOfStop();

  EXPECT_THAT(error, HasSubstr("run.mcap: Input/output error; "));
  EXPECT_THAT(error, HasSubstr("; the file has no index; to make an index: gcm recover"));
  const auto reader = mcap::Reader::Open(file_);
  ASSERT_TRUE(reader) << reader.error().message;
  ExpectSafe(**reader, error);
  EXPECT_THAT(mcap::Sentences(**reader), HasSubstr("the file ends within the record"));
}

TEST_F(FailingDisk, OneThatRecoversGetsACompleteFile) {
  RecordUntil([&] { Break(); });
  {
    const std::scoped_lock change(disk_.gate);
    disk_.failure.clear();
  }
  const std::string error = ErrorOfStop();

  EXPECT_THAT(error, HasSubstr("run.mcap: Input/output error; "));
  EXPECT_THAT(error, Not(HasSubstr("gcm recover")));
  ExpectSafe(*Open(), error);
}

TEST_F(FailingDisk, OneThatCannotSyncEndsTheRecordingWithWhatWasSyncedBefore) {
  RecordUntil([&] { disk_.can_sync = false; });
  const std::string error = ErrorOfStop();

  EXPECT_THAT(error, testing::MatchesRegex(
                         "recording stopped: cannot write .*run.mcap to the disk: Input/output "
                         "error; [0-9]+ messages up to .* are on the disk; the [0-9]+ later "
                         "messages may be lost; .*"));
}

/// The disk keeps only the data that was synced before the power fails.
TEST_F(FailingDisk, APowerCutCostsASecondOfRowsAtMost) {
  const test::StallMeter stalls;
  const auto memory = std::make_shared<test::MemoryDisk>();
  const auto robot = StartProcess("robot");
  StartRecorder({.patterns = {"robot/odometer/state"}, .files = On(disk_, memory)}, {"robot"});
  const auto syncs = [&] {
    const std::scoped_lock lock(disk_.gate);
    return memory->syncs;
  };
  ASSERT_TRUE(EventuallyRows(100));
  ASSERT_TRUE(EventuallyTrue([&, before = syncs()] { return syncs() > before; }));

  const int cuts = test::IsSanitized() ? 3 : 10;
  constexpr std::uint64_t kMaxRows = 800;  // a row is a millisecond
  std::mt19937 random(27);
  std::size_t safe = 0;
  for (int cut = 0; cut < cuts; ++cut) {
    const std::uint64_t rows = recorder_->status().counts.rows + random() % kMaxRows;
    SCOPED_TRACE("cut " + std::to_string(cut) + " of seed 27, after " + std::to_string(rows));
    ASSERT_TRUE(EventuallyRows(rows));
    std::unique_lock lock(disk_.gate);
    const mcap::Buffer left = memory->synced;
    const SteadyTime now = SteadyClock().Now();
    lock.unlock();

    const auto reader = mcap::Open(left);
    const auto numbers = ByTopic(*reader)["robot/odometer/state/Number"];
    ExpectEachRowOnce(numbers);
    EXPECT_GE(numbers.size(), safe);
    safe = numbers.size();
    ASSERT_FALSE(numbers.empty());
    const std::chrono::nanoseconds last(static_cast<std::int64_t>(numbers.back().log_time) -
                                        WallMinusSteadyIn(*reader));
    // A row passes four threads, and a busy machine may delay each of them.
    EXPECT_LE(now.time_since_epoch() - last, 1500ms + 4 * stalls.longest());
    EXPECT_THAT(mcap::Sentences(*reader), HasSubstr("the end of the file is missing"));
    EXPECT_EQ(reader->problems().count(), 1U) << mcap::Sentences(*reader);
  }
  EXPECT_TRUE(EventuallyTrue([&] { return syncs() >= 3; }));
  ASSERT_TRUE(recorder_->Stop());
}

/// A system whose processes do not answer for their types in time.
class SilentSystem final : public RecordedSystem {
 public:
  explicit SilentSystem(GcmClient& client) : system_(client, 10s) {}

  std::uint64_t revision() override { return system_.revision(); }
  [[nodiscard]] Catalogue catalogue() const override {
    ++looks;
    return system_.catalogue();
  }
  TelemetryClient& telemetry() override { return system_.telemetry(); }
  GcmClient::ListenerId Listen(const EventSubscription& events,
                               std::shared_ptr<EventSink> sink) override {
    ++listeners;
    return system_.Listen(events, std::move(sink));
  }
  void StopListening(GcmClient::ListenerId id) override { system_.StopListening(id); }
  void ReadPastEvents(const EventSubscription& events, std::chrono::nanoseconds last,
                      std::shared_ptr<EventSink> sink,
                      std::function<void(const PastEvents&)> done) override {
    system_.ReadPastEvents(events, last, std::move(sink), std::move(done));
  }
  Result<message::ReadLogReply> ReadLog(const std::string& process,
                                        const message::ReadLog& wanted) override {
    return system_.ReadLog(process, wanted);
  }
  Result<message::ProcessHistoryState> GetProcessHistory(const std::string& process) override {
    return system_.GetProcessHistory(process);
  }
  Result<Schema> FindSchema(const std::string& process, Fingerprint /*type*/) override {
    ++questions;
    if (std::this_thread::get_id() == starter) ++questions_of_starter;
    return Error{ErrorCode::kTimeout, process + " did not answer"};
  }
  void Resync() override { system_.Resync(); }
  void WatchLog() override { system_.WatchLog(); }

  const std::thread::id starter = std::this_thread::get_id();
  mutable std::atomic<int> looks = 0;
  std::atomic<int> listeners = 0;
  std::atomic<int> questions = 0;
  std::atomic<int> questions_of_starter = 0;

 private:
  GcmSystem system_;
};

TEST_F(RecorderTest, AProcessThatDoesNotAnswerIsAskedOnceForEachChangeAndNeverByStart) {
  constexpr int kComponents = 8;
  const auto robot = StartProcess("robot");
  for (int i = 1; i < kComponents; ++i) robot->Add<Odometer>("odometer" + std::to_string(i));
  queue_ = std::make_shared<RecordingQueue>();
  client_ = std::make_unique<GcmClient>(
      Node(), GcmClient::Options{.name = "gcm record", .address = address_}, queue_);
  ASSERT_TRUE(client_->WaitUntilWatching());
  ASSERT_TRUE(EventuallyTrue([&] {
    return Select(client_->catalogue(), {"robot/*/Control"}).events.size() == kComponents;
  }));
  const auto system = std::make_shared<SilentSystem>(*client_);

  auto recorder = Recorder::Start(
      system, queue_, {.patterns = {"robot/*/Control.Passed"}, .files = {.file = file_}});
  ASSERT_TRUE(recorder) << recorder.error().message;
  ASSERT_TRUE(EventuallyTrue([&] { return system->listeners.load() >= kComponents; }));
  EXPECT_TRUE((*recorder)->Stop());

  EXPECT_EQ(system->questions_of_starter.load(), 0);
  EXPECT_GE(system->questions.load(), 1);
  EXPECT_LE(system->questions.load(), system->looks.load());
}

TEST_F(RecorderTest, AFileThatExistsIsRefused) {
  folder_.Write("run.mcap", "");
  queue_ = std::make_shared<RecordingQueue>();
  GcmClient client(Node(), {.name = "gcm record", .address = address_}, queue_);
  ASSERT_TRUE(client.WaitUntilWatching());

  const auto recorder =
      Recorder::Start(client, queue_, {.patterns = {"**"}, .files = {.file = file_}});

  ASSERT_FALSE(recorder);
  EXPECT_EQ(recorder.error().code, ErrorCode::kExists);
}

}  // namespace
}  // namespace tendon::recording
