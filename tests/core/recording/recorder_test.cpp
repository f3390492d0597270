#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/folder.h>
#include <support/wait.h>
#include <tendon/gcm/global_manager.h>
#include <tendon/middleware/loopback.h>
#include <tendon/process/process.h>
#include <tendon/recording/mcap_reader.h>
#include <tendon/recording/recorder.h>
#include <tendon/recording/save_last.h>
#include <tendon/task/periodic_task.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "recordings.h"

namespace tendon::recording {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using testing::Contains;
using testing::HasSubstr;

/// Writes the number of its cycle to two columns, and raises it as an event.
class Odometer final : public PeriodicTask {
 public:
  explicit Odometer(std::string name) : PeriodicTask(std::move(name), 1ms) {
    state_table().Add(number_, "Number");
    state_table().Add(half_, "Half");
    state_table().SetLength(kRows);
    auto& control = AddProvidedInterface("Control");
    control.AddEvent(passed_, "Passed");
    control.AddCommandVoid(&Odometer::Reverse, this, "Reverse");
  }
  ~Odometer() override { Join(); }

  static constexpr std::size_t kRows = 8192;  // long enough for a busy machine

  void Run() override {
    ProcessQueuedCommands();
    ++number_;
    half_ = direction_ * 0.5 * static_cast<double>(number_);
    passed_(number_);
  }

 private:
  void Reverse() { direction_ = -1.0; }

  double direction_ = 1.0;
  std::uint64_t number_ = 0;
  double half_ = 0.0;
  WriteEvent<std::uint64_t> passed_;
};

/// A disk that waits while `gate` is locked, and that is full when `is_full` is true.
struct FaultyDisk {
  std::mutex gate;
  bool is_full = false;
};

class FileOnFaultyDisk final : public os::WritableFile {
 public:
  FileOnFaultyDisk(std::unique_ptr<os::WritableFile> file, FaultyDisk& disk)
      : file_(std::move(file)), disk_(disk) {}

  [[nodiscard]] const std::string& name() const noexcept override { return file_->name(); }
  Result<void> WriteAt(std::uint64_t offset,
                       std::span<const std::span<const std::byte>> parts) override {
    const std::scoped_lock wait(disk_.gate);
    if (disk_.is_full) return Error{ErrorCode::kFailed, "No space left on device (0 B free)"};
    return file_->WriteAt(offset, parts);
  }
  Result<void> Reserve(std::uint64_t offset, std::uint64_t length) override {
    return file_->Reserve(offset, length);
  }
  Result<void> Truncate(std::uint64_t size) override { return file_->Truncate(size); }
  Result<void> Sync() override {
    const std::scoped_lock wait(disk_.gate);
    return file_->Sync();
  }

 private:
  const std::unique_ptr<os::WritableFile> file_;
  FaultyDisk& disk_;
};

/// So little memory for waiting entries that losses begin soon.
constexpr std::size_t kFewBytes = 20'000;

FileOptions On(FaultyDisk& disk) {
  FileOptions options;
  options.create =
      [&disk](const std::filesystem::path& path) -> Result<std::unique_ptr<os::WritableFile>> {
    auto file = os::CreateWritableFile(path);
    if (!file) return file.error();
    std::unique_ptr<os::WritableFile> faulty =
        std::make_unique<FileOnFaultyDisk>(*std::move(file), disk);
    return faulty;
  };
  return options;
}

/// A GCM and processes with one odometer each, over loopback.
class RecorderTest : public testing::Test {
 protected:
  RecorderTest() { StartGcm("127.0.0.1:0"); }

  std::shared_ptr<Middleware> Node() { return std::make_shared<LoopbackMiddleware>(network_); }
  void StartGcm(const std::string& address) {
    auto gcm = GlobalManager::Start(Node(), {.address = address, .state_folder = folder_.path()});
    ASSERT_TRUE(gcm) << gcm.error().message;
    gcm_ = *std::move(gcm);
    address_ = gcm_->address();
  }
  std::unique_ptr<Process> StartProcess(const std::string& name) {
    auto process =
        std::make_unique<Process>(name, ProcessOptions{.middleware = Node(), .gcm = address_});
    process->Add<Odometer>("odometer");
    EXPECT_TRUE(process->StartAll());
    return process;
  }
  /// Starts a recorder when the catalogue has the running components of these processes.
  void StartRecorder(RecorderOptions options, const std::vector<std::string>& processes,
                     std::size_t most_waiting = Inbox::kMostBytes) {
    inbox_ = std::make_shared<Inbox>(most_waiting);
    client_ = std::make_unique<GcmClient>(
        Node(), GcmClient::Options{.name = "gcm record", .address = address_}, inbox_);
    ASSERT_TRUE(client_->WaitUntilWatching());
    ASSERT_TRUE(EventuallyTrue([&] {
      const Catalogue catalogue = client_->catalogue();
      return std::ranges::all_of(processes, [&](const std::string& process) {
        return catalogue.FindComponent(process, "odometer") != nullptr;
      });
    }));
    options.files.file = file_;
    auto recorder = Recorder::Start(*client_, inbox_, std::move(options));
    ASSERT_TRUE(recorder) << recorder.error().message;
    recorder_ = *std::move(recorder);
  }
  [[nodiscard]] bool EventuallyRows(std::uint64_t rows) const {
    return EventuallyTrue([&] { return recorder_->status().counts.rows >= rows; });
  }
  /// From now on, the column `Half` of `robot` has negative values.
  void Reverse() {
    const auto done = Wait<std::string>(
        10s, [&](auto handler) { client_->Call("robot/odometer/Control.Reverse", "", handler); });
    EXPECT_TRUE(done) << done.error().message;
  }
  std::unique_ptr<mcap::Reader> Open() {
    auto reader = mcap::Reader::Open(file_);
    EXPECT_TRUE(reader) << reader.error().message;
    if (!reader) return nullptr;
    EXPECT_TRUE((*reader)->Verify()) << mcap::Sentences(**reader);
    return *std::move(reader);
  }
  static std::map<std::string, std::vector<mcap::StoredMessage>> ByTopic(mcap::Reader& reader) {
    std::map<std::string, std::vector<mcap::StoredMessage>> all;
    for (auto& message : mcap::ReadAll(reader, {.order = mcap::Query::Order::kFile})) {
      all[message.topic].push_back(std::move(message));
    }
    return all;
  }
  [[nodiscard]] LostRows LostRowsUpToNow() const { return recorder_->status().losses.all_rows(); }
  /// Expects that each row occurs once, with its own value, and that all missing rows were counted.
  void ExpectEachRowOnce(const std::vector<mcap::StoredMessage>& messages) const {
    ASSERT_FALSE(messages.empty());
    const auto row_of = [](const auto& message) { return ValueOf<std::uint64_t>(message); };
    std::uint64_t missing = 0;
    for (std::size_t i = 1; i < messages.size(); ++i) {
      const std::uint32_t step = messages[i].sequence - messages[i - 1].sequence;
      ASSERT_GE(step, 1U) << "message " << i;
      ASSERT_GT(messages[i].log_time, messages[i - 1].log_time);
      ASSERT_EQ(row_of(messages[i]) - row_of(messages[i - 1]), step);
      missing += step - 1;
    }
    EXPECT_LE(missing, LostRowsUpToNow().all());
  }

  const std::shared_ptr<LoopbackNetwork> network_ = std::make_shared<LoopbackNetwork>();
  const test::Folder folder_;
  const std::filesystem::path file_ = folder_.path() / "run.mcap";
  std::unique_ptr<GlobalManager> gcm_;
  std::string address_;
  std::shared_ptr<Inbox> inbox_;
  std::unique_ptr<GcmClient> client_;
  std::unique_ptr<Recorder> recorder_;
};

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
  ASSERT_TRUE(EventuallyTrue([&] { return inbox_->is_gcm_lost(); }));
  const std::uint64_t before = recorder_->status().counts.rows;
  ASSERT_TRUE(EventuallyRows(before + 300));
  StartGcm(address_);
  ASSERT_TRUE(EventuallyTrue([&] { return !inbox_->is_gcm_lost(); }));
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
  ASSERT_TRUE(EventuallyTrue([&] { return inbox_->is_gcm_lost(); }));
  StartGcm(address_);
  ASSERT_TRUE(EventuallyTrue([&] { return !inbox_->is_gcm_lost(); }));
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
           recorder_->status().tables == Choose(catalogue, {"**"}).tables.size();
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
  const auto sink = inbox_->SinkOf(huge);
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

TEST_F(RecorderTest, AFullDiskEndsTheRecordingAlone) {
  FaultyDisk disk;
  const auto robot = StartProcess("robot");
  StartRecorder({.patterns = {"robot/odometer/state"}, .files = On(disk)}, {"robot"}, kFewBytes);
  ASSERT_TRUE(EventuallyRows(1000));

  {
    const std::scoped_lock change(disk.gate);
    disk.is_full = true;
  }
  ASSERT_TRUE(EventuallyTrue([&] { return recorder_->status().failure.has_value(); }));
  const std::uint64_t lost = LostRowsUpToNow().viewer;
  EXPECT_TRUE(EventuallyTrue([&] { return LostRowsUpToNow().viewer > lost + 100; }))
      << "the component goes on";
  const auto stopped = recorder_->Stop();

  ASSERT_FALSE(stopped);
  EXPECT_THAT(stopped.error().message,
              testing::MatchesRegex(
                  "recording stopped: cannot write at [0-9]+ of .*run.mcap: No space left on "
                  "device \\(0 B free\\); [0-9]+ messages up to .* are in the file; the [0-9]+ "
                  "later messages are lost; free space or check the disk, then record into another "
                  "file; the file has no index; to make an index: gcm recover"));
  const auto reader = mcap::Reader::Open(file_);
  ASSERT_TRUE(reader) << reader.error().message;
  const std::size_t safe = mcap::ReadAll(**reader).size();
  EXPECT_THAT(stopped.error().message, HasSubstr("; " + std::to_string(safe) + " messages up to"));
}

/// More bytes than the catalogue needs, so that there is room for rows before the start.
constexpr std::size_t kBeyondTheCatalogue = 150'000;

/// Returns the condition; empty if it cannot be parsed.
std::optional<Condition> When(const std::string& text) {
  auto condition = ParseCondition(text);
  EXPECT_TRUE(condition) << condition.error().message;
  return condition ? std::optional(*condition) : std::nullopt;
}

/// Returns the value in the newest row of an odometer.
std::uint64_t NumberOf(const Process& process) {
  std::uint64_t number = 0;
  const auto* const table = process.Find("odometer")->tables().front();
  const auto* const column = dynamic_cast<const Column<std::uint64_t>*>(table->Find("Number"));
  EXPECT_NE(column, nullptr);
  if (column != nullptr) (void)column->ReadNewest(number);
  return number;
}

TEST_F(RecorderTest, BeginsWithWhatCameBeforeTheCondition) {
  const auto robot = StartProcess("robot");
  StartRecorder({.patterns = {"robot/odometer"},
                 .start_when = When("robot/odometer/state.Half < 0"),
                 .before = 1h},
                {"robot"});
  ASSERT_TRUE(
      EventuallyTrue([&] { return recorder_->status().before_bytes > kBeyondTheCatalogue; }));
  EXPECT_TRUE(recorder_->status().is_waiting);
  EXPECT_FALSE(std::filesystem::exists(file_));

  Reverse();
  ASSERT_TRUE(EventuallyRows(200));
  ASSERT_TRUE(recorder_->Stop());

  EXPECT_FALSE(recorder_->status().is_waiting);
  const auto reader = Open();
  auto topics = ByTopic(*reader);
  ExpectEachRowOnce(topics["robot/odometer/state/Number"]);
  const auto& rows = topics["robot/odometer/state/Half"];
  ASSERT_FALSE(rows.empty());
  EXPECT_GT(ValueOf<double>(rows.front()), 0.0);
  EXPECT_LT(ValueOf<double>(rows.back()), 0.0);
  EXPECT_TRUE(topics.contains(kCatalogueTopic));
}

TEST_F(RecorderTest, TheFileTellsWhatIsMissingBeforeTheCondition) {
  const auto robot = StartProcess("robot");
  StartRecorder({.patterns = {"robot/odometer/state"},
                 .start_when = When("robot/odometer/state.Half < 0"),
                 .before = 1h,
                 .before_bytes = 1},
                {"robot"});
  const auto events = inbox_->SinkOf(
      EventSubscription{.provided = {"robot", "odometer", "Control"}, .events = {"Passed"}}, {});
  events->OnEventsLost(0, 7);  // within an hour of the previous report
  ASSERT_TRUE(EventuallyTrue([&] { return NumberOf(*robot) > 300; }));

  Reverse();
  ASSERT_TRUE(EventuallyRows(50));
  ASSERT_TRUE(recorder_->Stop());

  RecorderStatus status = recorder_->status();
  EXPECT_GT(status.before_rows_missing, 0U);
  EXPECT_GE(status.losses.rows["robot/odometer/state"].viewer, status.before_rows_missing);
  EXPECT_EQ(status.losses.events["robot/odometer/Control.Passed"], 7U);
  const auto reader = Open();
  auto topics = ByTopic(*reader);
  std::uint64_t told = 0;
  for (const auto& message : topics[kLossTopic]) {
    told += ValueOf<Loss>(message).recorder;
  }
  EXPECT_EQ(told, status.losses.rows["robot/odometer/state"].viewer);
}

TEST_F(RecorderTest, BeginsWithTheConditionIfNothingBeforeIsWanted) {
  const auto robot = StartProcess("robot");
  StartRecorder(
      {.patterns = {"robot/odometer/state"}, .start_when = When("robot/odometer/state.Half < 0")},
      {"robot"});
  ASSERT_TRUE(
      EventuallyTrue([&] { return recorder_->status().before_bytes > kBeyondTheCatalogue; }));

  Reverse();
  ASSERT_TRUE(EventuallyRows(50));
  ASSERT_TRUE(recorder_->Stop());

  const auto reader = Open();
  const auto rows = ByTopic(*reader)["robot/odometer/state/Half"];
  ASSERT_FALSE(rows.empty());
  for (const auto& row : rows) ASSERT_LT(ValueOf<double>(row), 0.0);
}

TEST_F(RecorderTest, EndsSomeTimeAfterTheConditionToStop) {
  const auto robot = StartProcess("robot");
  StartRecorder({.patterns = {"robot/odometer/state"},
                 .stop_when = When("robot/odometer/state.Half < 0"),
                 .after = 30ms},
                {"robot"});
  ASSERT_TRUE(EventuallyRows(50));

  Reverse();
  ASSERT_TRUE(EventuallyTrue([&] { return recorder_->status().is_finished; }));
  ASSERT_TRUE(recorder_->Stop());

  const auto reader = Open();
  const auto rows = ByTopic(*reader)["robot/odometer/state/Half"];
  const auto stop =
      std::ranges::find_if(rows, [](const auto& row) { return ValueOf<double>(row) < 0.0; });
  ASSERT_NE(stop, rows.end());
  constexpr std::uint64_t kAfter = 30'000'000;  // ns
  EXPECT_LE(rows.back().log_time - stop->log_time, kAfter);
}

TEST_F(RecorderTest, LossesBeforeTheBeginAreNeverSubtractedBeforeTheyAreCounted) {
  const auto robot = StartProcess("robot");
  StartRecorder(
      {.patterns = {"robot/odometer/state"}, .start_when = When("robot/odometer/Control.Passed")},
      {"robot"});
  ASSERT_TRUE(EventuallyRows(1));
  const auto sink =
      inbox_->SinkOf(TableSubscription{"robot", "other", "state", std::vector<std::string>{"A"}});
  sink->OnSubscribed({SchemaOf<std::uint8_t>()});

  // Rows from before the start; each batch follows a loss.
  constexpr std::uint64_t kBatches = 20'000;
  const std::byte cell[] = {std::byte{1}};
  const std::int64_t times[] = {0};
  std::uint64_t most = 0;
  for (std::uint64_t i = 1; i <= kBatches; ++i) {
    const std::uint64_t ticks[] = {2 * i};
    RowBatch batch;
    batch.lost.network = 1;
    batch.count = 1;
    batch.ticks = ticks;
    batch.times = times;
    batch.cell = [&](std::size_t, std::size_t) { return std::span<const std::byte>(cell); };
    sink->OnRows(batch);
    if (i % 10 == 0) {
      most = std::max(most, recorder_->status().losses.rows["robot/other/state"].network);
    }
  }

  EXPECT_LE(most, kBatches);
  EXPECT_TRUE(EventuallyTrue(
      [&] { return recorder_->status().losses.rows["robot/other/state"].network == 0; }));
}

/// A system whose processes do not answer requests for their types in time.
class SilentAccess final : public SystemAccess {
 public:
  explicit SilentAccess(GcmClient& client) : system_(client, 10s) {}

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
  GcmAccess system_;
};

TEST_F(RecorderTest, AProcessThatDoesNotAnswerIsAskedOnceForEachChangeAndNeverByStart) {
  constexpr int kComponents = 8;
  const auto robot = StartProcess("robot");
  for (int i = 1; i < kComponents; ++i) robot->Add<Odometer>("odometer" + std::to_string(i));
  inbox_ = std::make_shared<Inbox>();
  client_ = std::make_unique<GcmClient>(
      Node(), GcmClient::Options{.name = "gcm record", .address = address_}, inbox_);
  ASSERT_TRUE(client_->WaitUntilWatching());
  ASSERT_TRUE(EventuallyTrue([&] {
    return Choose(client_->catalogue(), {"robot/*/Control"}).events.size() == kComponents;
  }));
  const auto system = std::make_shared<SilentAccess>(*client_);

  auto recorder = Recorder::Start(
      system, inbox_, {.patterns = {"robot/*/Control.Passed"}, .files = {.file = file_}});
  ASSERT_TRUE(recorder) << recorder.error().message;
  ASSERT_TRUE(EventuallyTrue([&] { return system->listeners.load() >= kComponents; }));
  EXPECT_TRUE((*recorder)->Stop());

  EXPECT_EQ(system->questions_of_starter.load(), 0);
  EXPECT_GE(system->questions.load(), 1);
  EXPECT_LE(system->questions.load(), system->looks.load());
}

TEST_F(RecorderTest, AnEventStartsTheRecording) {
  const auto robot = StartProcess("robot");
  StartRecorder(
      {.patterns = {"robot/odometer/state"}, .start_when = When("robot/odometer/Control.Passed")},
      {"robot"});

  ASSERT_TRUE(EventuallyRows(100));

  ASSERT_TRUE(recorder_->Stop());
  const auto reader = Open();
  ExpectEachRowOnce(ByTopic(*reader)["robot/odometer/state/Number"]);
}

TEST_F(RecorderTest, WithoutItsConditionThereIsNoFile) {
  const auto robot = StartProcess("robot");
  StartRecorder({.patterns = {"**"}, .start_when = When("robot/odometer/state.Half < 0")},
                {"robot"});

  EXPECT_TRUE(recorder_->Stop());

  EXPECT_TRUE(recorder_->status().is_waiting);
  EXPECT_FALSE(std::filesystem::exists(file_));
}

TEST_F(RecorderTest, AConditionOnSomethingThatDoesNotExistIsRefused) {
  const auto robot = StartProcess("robot");
  StartRecorder({.patterns = {"**"}}, {"robot"});
  const auto refusal_of = [&](const std::string& text) {
    const auto started = Recorder::Start(
        *client_, inbox_,
        {.patterns = {"**"}, .files = {.file = "other.mcap"}, .start_when = When(text)});
    EXPECT_FALSE(started) << text;
    return started ? std::string() : started.error().message;
  };

  EXPECT_THAT(refusal_of("robot/odometre/state.Number > 1"), HasSubstr("odometer"));
  EXPECT_THAT(refusal_of("robot/odometer/state.Numer > 1"), HasSubstr("did you mean 'Number'?"));
  EXPECT_THAT(refusal_of("robot/odometer/Control.Passt"), HasSubstr("has no event 'Passt'"));
  EXPECT_THAT(refusal_of("robot/odometer/state.Number"), HasSubstr("expected a comparison"));
  EXPECT_THAT(refusal_of("robot/odometer/Control.Passed > 3"), HasSubstr("no state table"));
  EXPECT_THAT(refusal_of("robot/odometer/state.Number > 3 m"), HasSubstr("has no unit"));
}

TEST_F(RecorderTest, SaveLastWritesTheRowsThatATableHolds) {
  const auto robot = StartProcess("robot");
  ASSERT_TRUE(EventuallyTrue([&] { return NumberOf(*robot) > 300; }));
  ASSERT_TRUE(robot->Suspend("odometer"));
  const std::uint64_t newest = NumberOf(*robot);
  inbox_ = std::make_shared<Inbox>();
  client_ = std::make_unique<GcmClient>(
      Node(), GcmClient::Options{.name = "gcm save-last", .address = address_}, inbox_);
  ASSERT_TRUE(client_->WaitUntilWatching());
  ASSERT_TRUE(EventuallyTrue(
      [&] { return client_->catalogue().FindComponent("robot", "odometer") != nullptr; }));
  GcmAccess system(*client_, 10s);

  const auto saved =
      SaveLast(system, inbox_,
               {.patterns = {"robot"}, .files = {.file = file_}, .last = 1h, .timeout = 10s});

  ASSERT_TRUE(saved) << saved.error().message;
  ASSERT_EQ(saved->tables.size(), 1U);
  EXPECT_FALSE(saved->tables[0].failure);
  EXPECT_EQ(saved->tables[0].path, "robot/odometer/state");
  EXPECT_GT(saved->tables[0].past.reach, 250ms);
  const auto reader = Open();
  const auto rows = ByTopic(*reader)["robot/odometer/state/Number"];
  EXPECT_EQ(rows.size(), saved->tables[0].past.rows);
  ASSERT_GE(rows.size(), 300U);
  EXPECT_EQ(ValueOf<std::uint64_t>(rows.back()), newest);
  EXPECT_EQ(ValueOf<std::uint64_t>(rows.front()), newest + 1 - rows.size());
}

TEST_F(RecorderTest, SaveLastLeavesOutRowsThatAreOlder) {
  const auto robot = StartProcess("robot");
  ASSERT_TRUE(EventuallyTrue([&] { return NumberOf(*robot) > 300; }));
  ASSERT_TRUE(robot->Suspend("odometer"));
  inbox_ = std::make_shared<Inbox>();
  client_ = std::make_unique<GcmClient>(
      Node(), GcmClient::Options{.name = "gcm save-last", .address = address_}, inbox_);
  ASSERT_TRUE(client_->WaitUntilWatching());
  ASSERT_TRUE(EventuallyTrue(
      [&] { return client_->catalogue().FindComponent("robot", "odometer") != nullptr; }));
  GcmAccess system(*client_, 10s);

  const auto saved =
      SaveLast(system, inbox_,
               {.patterns = {"robot"}, .files = {.file = file_}, .last = 1ns, .timeout = 10s});

  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_EQ(saved->tables.at(0).past.rows, 0U);
  EXPECT_EQ(saved->tables.at(0).past.reach, 0ns);
}

TEST_F(RecorderTest, AFileThatExistsIsRefused) {
  folder_.Write("run.mcap", "");
  inbox_ = std::make_shared<Inbox>();
  GcmClient client(Node(), {.name = "gcm record", .address = address_}, inbox_);
  ASSERT_TRUE(client.WaitUntilWatching());

  const auto recorder =
      Recorder::Start(client, inbox_, {.patterns = {"**"}, .files = {.file = file_}});

  ASSERT_FALSE(recorder);
  EXPECT_EQ(recorder.error().code, ErrorCode::kExists);
}

TEST(RecorderChoice, APatternNamesAThingAndAllThatIsInIt) {
  ComponentDescription arm{.name = "arm"};
  arm.tables.push_back({.name = "state", .columns = {{.name = "Joints"}, {.name = "Load"}}});
  arm.provided.push_back({.name = "Control", .events = {{.name = "Stopped"}, {.name = "Moved"}}});
  Catalogue catalogue;
  ASSERT_TRUE(catalogue.Apply({.revision = 1,
                               .kind = CatalogueChange::Kind::kProcess,
                               .process = "robot",
                               .processes = {{.name = "robot", .instance = 1}}}));
  ASSERT_TRUE(catalogue.Apply({.revision = 2,
                               .kind = CatalogueChange::Kind::kComponent,
                               .process = "robot",
                               .components = {arm}}));
  const auto choice_of = [&](const std::string& pattern) {
    const Choice choice = Choose(catalogue, {pattern});
    std::set<std::string> all;
    for (const auto& table : choice.tables) all.insert(table.columns.begin(), table.columns.end());
    for (const auto& one : choice.events) all.insert(one.events.begin(), one.events.end());
    return all;
  };
  using Names = std::set<std::string>;

  for (const char* const all : {"robot", "robot/arm", "**", "*/arm", "robot/*/*"}) {
    EXPECT_EQ(choice_of(all), (Names{"Joints", "Load", "Moved", "Stopped"})) << all;
  }
  EXPECT_EQ(choice_of("robot/arm/state"), (Names{"Joints", "Load"}));
  EXPECT_EQ(choice_of("robot/arm/state.J*"), Names{"Joints"});
  EXPECT_EQ(choice_of("**.Moved"), Names{"Moved"});
  EXPECT_EQ(choice_of("desk"), Names{});
}

}  // namespace
}  // namespace tendon::recording
