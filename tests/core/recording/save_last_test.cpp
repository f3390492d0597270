#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/gcm/text.h>
#include <tendon/recording/mcap/verify.h>
#include <tendon/recording/save_last.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "recorder_fixture.h"

namespace tendon::recording {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// Has a table of 256 rows, which is written at 1 kHz, and raises an event at 100 Hz.
class FastTask final : public PeriodicTask {
 public:
  explicit FastTask(std::string name) : PeriodicTask(std::move(name), 1ms) {
    state_table().Add(number_, "Number");
    state_table().SetLength(256);
    AddProvidedInterface("Control").AddEvent(passed_, "Passed");
  }
  ~FastTask() override { Join(); }
  void Run() override {
    ++number_;
    if (number_ % 10 == 0) passed_(number_);
  }

 private:
  std::uint64_t number_ = 0;
  WriteEvent<std::uint64_t> passed_;
};

/// Has a table that is written at 5 Hz.
class SlowTask final : public PeriodicTask {
 public:
  explicit SlowTask(std::string name) : PeriodicTask(std::move(name), 200ms) {
    state_table().Add(number_, "Number");
  }
  ~SlowTask() override { Join(); }
  void Run() override { ++number_; }

 private:
  std::uint64_t number_ = 0;
};

/// A process with an odometer, or with a fast and a slow task, and a client for `gcm save-last`.
class SaveLastTest : public RecorderTest {
 protected:
  void StartTasks(HistoryOptions history = {}) {
    robot_ = std::make_unique<Process>(
        "robot", ProcessOptions{.middleware = Node(), .gcm = address_, .history = history});
    robot_->Add<FastTask>("fast");
    robot_->Add<SlowTask>("slow");
    ASSERT_TRUE(robot_->StartAll());
    ASSERT_TRUE(robot_->WaitUntilJoined(60s));
    ConnectTo("slow");
  }
  void StartOdometer() {
    robot_ = StartProcess("robot");
    ASSERT_TRUE(EventuallyTrue([&] { return NumberOf(*robot_) > 300; }));
    ASSERT_TRUE(robot_->Suspend("odometer"));
    ConnectTo("odometer");
  }
  [[nodiscard]] std::uint64_t RowsOf(const std::string& component) const {
    return robot_->Find(component)->tables().front()->next_tick();
  }
  [[nodiscard]] Result<message::ProcessHistoryState> HistoryOfRobot() const {
    return Wait<message::ProcessHistoryState>(
        10s, [&](auto handler) { client_->GetProcessHistory("robot", handler); });
  }
  Result<SaveLastReport> Save(std::chrono::nanoseconds last = 30s) {
    GcmSystem system(*client_, 10s);
    return SaveLast(
        system, queue_,
        {.patterns = {"robot"}, .files = {.file = file_}, .last = last, .timeout = 10s});
  }

  std::unique_ptr<Process> robot_;

 private:
  /// Waits until the catalogue has the component.
  void ConnectTo(const std::string& component) {
    queue_ = std::make_shared<RecordingQueue>();
    client_ = std::make_unique<GcmClient>(
        Node(), GcmClient::Options{.name = "gcm save-last", .address = address_}, queue_);
    ASSERT_TRUE(client_->WaitUntilWatching());
    ASSERT_TRUE(EventuallyTrue(
        [&] { return client_->catalogue().FindComponent("robot", component) != nullptr; }));
  }
};

TEST_F(SaveLastTest, WritesTheRowsThatATableHolds) {
  StartOdometer();
  const std::uint64_t newest = NumberOf(*robot_);

  const auto saved = Save(1h);

  ASSERT_TRUE(saved) << saved.error().message;
  ASSERT_EQ(saved->tables.size(), 1U);
  EXPECT_FALSE(saved->tables[0].past.failure);
  EXPECT_EQ(saved->tables[0].path, "robot/odometer/state");
  EXPECT_GT(saved->tables[0].past.reach, 250ms);
  const auto reader = Open();
  const auto rows = ByTopic(*reader)["robot/odometer/state/Number"];
  EXPECT_EQ(rows.size(), saved->tables[0].past.rows);
  ASSERT_GE(rows.size(), 300U);
  EXPECT_EQ(ValueOf<std::uint64_t>(rows.back()), newest);
  EXPECT_EQ(ValueOf<std::uint64_t>(rows.front()), newest + 1 - rows.size());
}

TEST_F(SaveLastTest, LeavesOutRowsThatAreOlder) {
  StartOdometer();

  const auto saved = Save(1ns);

  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_EQ(saved->tables.at(0).past.rows, 0U);
  EXPECT_EQ(saved->tables.at(0).past.reach, 0ns);
}

TEST_F(SaveLastTest, TheFileHasRowsEventsAndLogThatNoTableHolds) {
  StartTasks();
  Log(LogLevel::kInfo, "fast", "something happens");
  ASSERT_TRUE(EventuallyTrue([&] { return RowsOf("fast") > 1500 && RowsOf("slow") > 4; }));
  ASSERT_TRUE(robot_->SuspendAll());
  const std::uint64_t newest = RowsOf("fast");

  const auto saved = Save();

  ASSERT_TRUE(saved) << saved.error().message;
  std::map<std::string, PastRows> tables;
  for (const auto& [path, past] : saved->tables) tables[path] = past;
  const auto reader = Open();
  auto topics = ByTopic(*reader);
  const auto& fast = topics["robot/fast/state/Number"];
  EXPECT_LE(fast.size() + tables["robot/fast/state"].lost, newest);
  ASSERT_EQ(saved->processes.size(), 1U);
  // On a busy machine, the history misses some rows. They are counted soon.
  EXPECT_TRUE(EventuallyTrue([&] {
    const auto history = HistoryOfRobot();
    return history && fast.size() + history->missed_rows >= newest;
  }));
  for (std::size_t i = 1; i < fast.size(); ++i) ASSERT_GT(fast[i].sequence, fast[i - 1].sequence);
  EXPECT_EQ(topics["robot/slow/state/Number"].size(), RowsOf("slow"));
  ASSERT_EQ(saved->events.size(), 1U);
  EXPECT_FALSE(saved->events[0].past.failure);
  EXPECT_EQ(saved->events[0].past.events + saved->events[0].past.lost, newest / 10);
  EXPECT_EQ(topics["robot/fast/Control/Passed"].size(), saved->events[0].past.events);
  EXPECT_GT(saved->counts.log, 0U);
  std::size_t happened = 0;
  for (const auto& message : topics["rosout"]) {
    const auto record = ValueOf<RosLog>(message);
    if (record.name == "robot/fast" && record.msg == "something happens") ++happened;
  }
  EXPECT_EQ(happened, 1U) << "the GCM has it as well";
  EXPECT_THAT(ReachText(saved->processes[0], 30s), HasSubstr("it has not been running longer"));
}

TEST_F(SaveLastTest, SaysThatTheHistoryIsOff) {
  StartTasks({.memory = 0});
  ASSERT_TRUE(EventuallyTrue([&] { return RowsOf("fast") > 300; }));
  ASSERT_TRUE(robot_->SuspendAll());  // so that no row is overwritten before it is read

  const auto saved = Save();

  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_GT(saved->tables.at(0).past.rows, 200U) << "what the table holds";
  ASSERT_TRUE(saved->events.at(0).past.failure);
  EXPECT_THAT(saved->events.at(0).past.failure->message, HasSubstr("keeps no history"));
  EXPECT_THAT(ReachText(saved->processes.at(0), 30s), HasSubstr("its history is off"));
}

TEST_F(SaveLastTest, SaysThatTheHistoryIsFull) {
  StartTasks({.memory = std::size_t{64} << 10U, .span = 30s});
  ASSERT_TRUE(EventuallyTrue([&] {
    const auto state = HistoryOfRobot();
    return state && state->reach < state->age;
  }));

  const auto saved = Save();

  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_THAT(ReachText(saved->processes.at(0), 30s), HasSubstr("its history is full"));
  EXPECT_LE(saved->processes.at(0).history->memory, std::size_t{64} << 10U);
}

TEST_F(SaveLastTest, NamesAProcessThatHasEndedAndSavesTheOthers) {
  StartTasks();
  ASSERT_TRUE(EventuallyTrue([&] { return RowsOf("fast") > 300; }));
  robot_.reset();

  const auto saved = Save();

  ASSERT_TRUE(saved) << saved.error().message;
  for (const auto& [path, past] : saved->tables) EXPECT_TRUE(past.failure) << path;
  EXPECT_THAT(ReachText(saved->processes.at(0), 30s), HasSubstr("not known"));
}

/// Sends one row of each table, except those of the process "bad", which answers with an error, or
/// not at all.
class PastTelemetry final : public TelemetryClient {
 public:
  Id Subscribe(const TableSubscription& /*table*/, std::shared_ptr<RowSink> /*sink*/) override {
    return 0;
  }
  void Unsubscribe(Id /*id*/) override {}
  void ReadPast(const TableSubscription& table, std::chrono::nanoseconds /*last*/,
                std::shared_ptr<RowSink> sink, std::function<void(const PastRows&)> done) override {
    if (table.process == "bad") {
      ++questions;
      if (is_silent) return;
      return done({.failure = Error{failure, "process 'bad' sent invalid rows of its history"}});
    }
    sink->OnSubscribed({SchemaOf<std::uint64_t>()});
    std::vector<std::byte> cell;
    Encode(std::uint64_t{7}, cell);
    const std::vector<std::uint64_t> ticks = {0};
    const std::vector<std::int64_t> times = {SteadyClock().Now().time_since_epoch().count()};
    RowBatch batch;
    batch.epoch = 1;
    batch.count = 1;
    batch.ticks = ticks;
    batch.times = times;
    batch.cell = [&](std::size_t /*row*/, std::size_t /*column*/) { return std::span(cell); };
    sink->OnRows(batch);
    ++answers;
    if (!is_endless) done({.rows = 1, .reach = 1ms});
  }

  bool is_silent = false;                   // "bad" does not answer
  bool is_endless = false;                  // "good" seems to have more rows, but sends no more
  ErrorCode failure = ErrorCode::kInvalid;  // of "bad"
  int questions = 0;                        // to "bad"
  int answers = 0;                          // of "good"
};

/// The processes "bad" and "good" with a table and an event each. "bad" answers each request with
/// kInvalid, except those that a test allows.
class OneBadProcess final : public RecordedSystem {
 public:
  OneBadProcess() {
    ComponentDescription arm{.name = "arm"};
    arm.tables.push_back({.name = "state", .columns = {{.name = "Number"}}});
    arm.provided.push_back(
        {.name = "Control",
         .events = {
             {.name = "Stopped"},
             {.name = "Moved", .signature = {CommandKind::kWrite, FingerprintOf<double>()}},
             {.name = "Named", .signature = {CommandKind::kWrite, FingerprintOf<std::string>()}}}});
    std::uint64_t revision = 0;
    for (const char* name : {"bad", "good"}) {
      EXPECT_TRUE(catalogue_.Apply({.revision = ++revision,
                                    .kind = CatalogueChange::Kind::kProcess,
                                    .process = name,
                                    .processes = {{.name = name, .instance = revision}}}));
      EXPECT_TRUE(catalogue_.Apply({.revision = ++revision,
                                    .kind = CatalogueChange::Kind::kComponent,
                                    .process = name,
                                    .components = {arm}}));
    }
  }

  std::uint64_t revision() override { return catalogue_.revision(); }
  [[nodiscard]] Catalogue catalogue() const override { return catalogue_; }
  TelemetryClient& telemetry() override { return past_telemetry; }
  GcmClient::ListenerId Listen(const EventSubscription& /*events*/,
                               std::shared_ptr<EventSink> /*sink*/) override {
    return 0;
  }
  void StopListening(GcmClient::ListenerId /*id*/) override {}
  void ReadPastEvents(const EventSubscription& events, std::chrono::nanoseconds /*last*/,
                      std::shared_ptr<EventSink> sink,
                      std::function<void(const PastEvents&)> done) override {
    if (events.provided.process == "bad") {
      ++questions;
      return done({.failure = Invalid()});
    }
    const Schema type = has_unknown_type ? SchemaOf<std::uint64_t>() : Schema();
    sink->OnListening({{.name = "Stopped", .signature = {.in = type.fingerprint()}}});
    sink->OnEvent(0, {}, {.raised = SteadyClock().Now()});
    done({.events = 1});
  }
  Result<message::ReadLogReply> ReadLog(const std::string& process,
                                        const message::ReadLog& wanted) override {
    if (process == "bad") ++questions;
    if (process == "bad" && wanted.first < log_of_bad.size()) return log_of_bad[wanted.first];
    if (process == "bad" && !has_endless_log) return Invalid();
    message::ReadLogReply reply{.next = 1, .end = 1};
    if (process == "bad") reply.end = UINT64_MAX;
    if (process == "bad") reply.next = wanted.first + 1;
    reply.records.push_back({.time = WallTime(), .text = "a record"});
    return reply;
  }
  Result<message::ProcessHistoryState> GetProcessHistory(const std::string& process) override {
    if (process == "bad" && log_of_bad.empty()) return Invalid();
    return message::ProcessHistoryState{.limit = 1, .span = 30s, .age = 30s, .reach = 30s};
  }
  Result<Schema> FindSchema(const std::string& process, Fingerprint /*type*/) override {
    if (process != "bad" || !is_slow_with_types) return Invalid();
    ++questions;
    return Error{ErrorCode::kTimeout, "no reply from bad within 100 ms"};
  }
  void Resync() override {}
  void WatchLog() override {
    if (gcm_log) gcm_log->OnLog({.is_current = true});
  }

  std::shared_ptr<RecordingQueue> gcm_log;  // receives the log of the GCM; null: the GCM hangs
  bool has_endless_log = false;
  bool is_slow_with_types = false;                // does not answer requests for types
  bool has_unknown_type = false;                  // that of the event of "good"
  std::vector<message::ReadLogReply> log_of_bad;  // its pages; the page after these is an error
  PastTelemetry past_telemetry;
  int questions = 0;  // about past events, types and the log of "bad"

 private:
  static Error Invalid() { return {ErrorCode::kInvalid, "the answer is invalid"}; }

  Catalogue catalogue_;
};

class SaveLastOfOneBadProcess : public testing::Test {
 protected:
  SaveLastOfOneBadProcess() { system_.gcm_log = queue_; }

  Result<SaveLastReport> Save(os::StopRequest stop = {}) {
    return SaveLast(system_, queue_,
                    {.patterns = {"**"},
                     .files = {.file = file_},
                     .last = 30s,
                     .timeout = 100ms,
                     .stop = std::move(stop)});
  }
  /// Returns true if the row of "good" is in the file.
  [[nodiscard]] bool HasRow() const {
    return system_.past_telemetry.answers > 0 && queue_->waiting_bytes() == 0;
  }

  /// A log record of "bad". Its text is its time in ns since `begin_`.
  [[nodiscard]] message::LogRecord RecordAt(int time) const {
    return {.time = begin_ + time, .process = "bad", .text = std::to_string(time)};
  }
  /// Lets the GCM send the log records of these times.
  void SendLog(const std::vector<int>& times) {
    LogBatch batch{.is_current = true};
    for (const int time : times) batch.records.push_back(RecordAt(time));
    queue_->OnLog(batch);
  }
  /// Returns a page of the log of "bad", which has 5 records.
  [[nodiscard]] message::ReadLogReply Page(std::uint64_t next, int since, int time) const {
    return {.next = next, .end = 5, .since = begin_ + since, .records = {RecordAt(time)}};
  }
  /// Returns the texts of the log of "bad" in the file.
  [[nodiscard]] std::vector<std::string> LogInFile() const {
    std::vector<std::string> texts;
    const auto reader = mcap::Reader::Open(file_);
    EXPECT_TRUE(reader) << reader.error().message;
    if (!reader) return texts;
    for (const auto& message : mcap::ReadAll(**reader, {.order = mcap::Query::Order::kFile})) {
      if (message.topic != "rosout") continue;
      const auto record = ValueOf<RosLog>(message);
      if (record.name == "bad") texts.push_back(record.msg);
    }
    return texts;
  }

  const test::Folder folder_;
  const std::filesystem::path file_ = folder_.path() / "last.mcap";
  const std::shared_ptr<RecordingQueue> queue_ = std::make_shared<RecordingQueue>();
  const std::int64_t begin_ = WallTime();
  OneBadProcess system_;
};

TEST_F(SaveLastOfOneBadProcess, TheOthersAreSavedIfOneAnswersInvalid) {
  const auto saved = Save();

  ASSERT_TRUE(saved) << saved.error().message;
  ASSERT_EQ(saved->tables.size(), 2U);
  EXPECT_EQ(saved->tables[0].path, "bad/arm/state");
  ASSERT_TRUE(saved->tables[0].past.failure);
  EXPECT_EQ(saved->tables[0].past.failure->code, ErrorCode::kInvalid);
  EXPECT_FALSE(saved->tables[1].past.failure);
  ASSERT_EQ(saved->events.size(), 2U);
  EXPECT_TRUE(saved->events[0].past.failure);
  EXPECT_FALSE(saved->events[1].past.failure);
  EXPECT_EQ(saved->counts.rows, 1U);
  EXPECT_EQ(saved->counts.events, 1U);
  EXPECT_EQ(saved->counts.log, 1U);
  EXPECT_THAT(ReachText(saved->processes.at(0), 30s), HasSubstr("the answer is invalid"));
  EXPECT_EQ(ReachText(saved->processes.at(1), 30s), "");
}

TEST_F(SaveLastOfOneBadProcess, AProcessThatDoesNotAnswerIsAskedOnce) {
  system_.past_telemetry.is_silent = true;

  const auto saved = Save();

  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_EQ(system_.past_telemetry.questions, 1);
  EXPECT_EQ(system_.questions, 0);
  ASSERT_TRUE(saved->events.at(0).past.failure);
  EXPECT_EQ(saved->events[0].past.failure->code, ErrorCode::kTimeout);
  EXPECT_EQ(saved->counts.rows, 1U);
  EXPECT_EQ(saved->counts.events, 1U);
}

TEST_F(SaveLastOfOneBadProcess, AProcessThatTimesOutIsNotAskedAgain) {
  system_.past_telemetry.failure = ErrorCode::kTimeout;

  const auto saved = Save();

  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_EQ(system_.past_telemetry.questions, 1);
  EXPECT_EQ(system_.questions, 0) << "each would take as long as the first one";
  EXPECT_EQ(saved->counts.rows, 1U);
  EXPECT_EQ(saved->counts.events, 1U);
}

TEST_F(SaveLastOfOneBadProcess, AProcessThatDoesNotSendATypeInTimeIsNotAskedAgain) {
  system_.is_slow_with_types = true;

  const auto saved = Save();

  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_EQ(system_.questions, 1);
  ASSERT_TRUE(saved->events.at(0).past.failure);
  EXPECT_EQ(saved->events[0].past.failure->message, "no reply from bad within 100 ms");
  EXPECT_EQ(saved->counts.events, 1U);
}

TEST_F(SaveLastOfOneBadProcess, SaysThatTheGcmHasNotSentItsLog) {
  system_.gcm_log = nullptr;

  const auto saved = Save();

  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_EQ(saved->counts.log, 1U) << "the log that the good process has kept";
  EXPECT_THAT(LossesOf(*saved),
              Contains("the log of the GCM could not be read completely: the GCM sent nothing for "
                       "100 ms"));
}

TEST_F(SaveLastOfOneBadProcess, ReadsNothingMoreAfterAStop) {
  const auto saved = Save([this] { return HasRow(); });

  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_TRUE(saved->is_stopped);
  EXPECT_FALSE(saved->tables.at(1).past.failure);
  EXPECT_EQ(saved->counts.rows, 1U);
  EXPECT_EQ(system_.questions, 0) << "about events and the log";
  for (const SavedEvents& events : saved->events) {
    ASSERT_TRUE(events.past.failure) << events.path;
    EXPECT_EQ(events.past.failure->message, "the saving was interrupted");
  }
  EXPECT_EQ(saved->counts.events, 0U);
  EXPECT_THAT(
      LossesOf(*saved),
      ElementsAre("good: its log could not be read completely: the saving was interrupted",
                  "the log of the GCM could not be read completely: the saving was interrupted"));
  const auto reader = mcap::Reader::Open(file_);
  ASSERT_TRUE(reader) << reader.error().message;
  EXPECT_EQ(mcap::Verify(**reader).problems.count(), 0U);
}

TEST_F(SaveLastOfOneBadProcess, AStopDuringAReadingTellsTheRowsThatAreInTheFile) {
  system_.past_telemetry.is_endless = true;

  const auto saved = Save([this] { return HasRow(); });

  ASSERT_TRUE(saved) << saved.error().message;
  const PastRows& past = saved->tables.at(1).past;
  EXPECT_EQ(past.rows, 1U);
  ASSERT_TRUE(past.failure);
  EXPECT_EQ(past.failure->message, "the saving was interrupted");
  EXPECT_EQ(saved->counts.rows, 1U);
}

TEST_F(SaveLastOfOneBadProcess, AStopBeforeAnyDataLeavesNoFile) {
  const auto saved = Save([] { return true; });

  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error().message,
            "the saving was interrupted before anything was read; no file was written");
  EXPECT_FALSE(std::filesystem::exists(file_));
}

TEST_F(SaveLastOfOneBadProcess, ALogWithoutEndIsCut) {
  system_.has_endless_log = true;

  const auto saved = Save();

  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_GT(saved->counts.log, 1U);
  EXPECT_EQ(saved->counts.rows, 1U);
}

TEST_F(SaveLastOfOneBadProcess, TheLogThatTheProcessDoesNotSendComesFromTheGcm) {
  system_.log_of_bad = {Page(1, 10, 20)};
  SendLog({5, 20, 30, 40});

  const auto saved = Save();

  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_EQ(LogInFile(), (std::vector<std::string>{"5", "20", "30", "40"}));
  EXPECT_THAT(ShortfallsOf(*saved, 30s),
              Contains("bad: its log could not be read completely: the answer is invalid"));
}

TEST_F(SaveLastOfOneBadProcess, TheLogThatTheProcessDropsBetweenTwoPagesComesFromTheGcm) {
  system_.log_of_bad = {Page(1, 10, 20), Page(5, 30, 40)};
  SendLog({15, 20, 30, 40});

  const auto saved = Save();

  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_EQ(LogInFile(), (std::vector<std::string>{"20", "30", "40"})) << "it has kept none at 15";
  EXPECT_THAT(ShortfallsOf(*saved, 30s), Not(Contains(StartsWith("bad: its log"))));
}

TEST_F(SaveLastOfOneBadProcess, SaysThatEventsOfAnUnknownTypeAreNotInTheFile) {
  system_.has_unknown_type = true;

  const auto saved = Save();

  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_EQ(saved->counts.events, 0U);
  EXPECT_EQ(LossesOf(*saved),
            (std::vector<std::string>{
                "good/arm/Control.Stopped: 1 event sent, but not written into the file"}));
}

TEST(LossesOf, NamesEachLossThatNoTableAndNoInterfaceCounts) {
  SaveLastReport report;
  report.processes.push_back({.process = "off",
                              .history = message::ProcessHistoryState{},
                              .log_failure = Error{ErrorCode::kFailed, "it keeps no history"}});
  report.processes.push_back({.process = "robot",
                              .history = message::ProcessHistoryState{.limit = 1},
                              .log_failure = Error{ErrorCode::kFailed, "it has ended"}});
  report.losses.rows["robot/arm/state"] = {.table = 2, .network = 0, .viewer = 1};
  report.losses.rows["robot/leg/state"] = {.table = 2, .network = 0, .viewer = 0};
  report.losses.events["robot/arm/Control.Stopped"] = 3;
  report.losses.log = 4;

  EXPECT_EQ(LossesOf(report),
            (std::vector<std::string>{
                "robot: its log could not be read completely: it has ended",
                "robot/arm/state: 1 row sent, but not written into the file",
                "robot/arm/Control.Stopped: 3 events sent, but not written into the file",
                "4 log records sent, but not written into the file"}));
}

TEST(ShortfallsOf, NamesWhatIsMissing) {
  const message::ProcessHistoryState off{};
  SaveLastReport report;
  report.processes.push_back({.process = "robot", .history = off});
  report.tables.push_back({"robot/arm/state", {.rows = 10, .lost = 2}});
  report.events.push_back(
      {"robot/arm/Control", {.failure = Error{ErrorCode::kFailed, "it keeps no history"}}});
  report.events.push_back(
      {"desk/pad/Control", {.failure = Error{ErrorCode::kTimeout, "it sent nothing"}}});
  report.losses.log = 2;

  EXPECT_EQ(ShortfallsOf(report, 30s),
            (std::vector<std::string>{
                "robot: only the rows in its state tables: its history is off (--history-memory)",
                "robot/arm/state: 2 rows lost", "desk/pad/Control: it sent nothing",
                "2 log records sent, but not written into the file"}));
}

TEST(ReachText, NamesTheReason) {
  const auto text = [](message::ProcessHistoryState state) {
    state.limit = std::size_t{32} << 20U;
    state.memory = std::size_t{16} << 20U;
    state.span = 30s;
    return ReachText({.process = "robot", .history = state}, 30s);
  };
  EXPECT_EQ(text({.age = 1h, .reach = 30s}), "");
  EXPECT_EQ(text({.age = 12s, .reach = 12s}), "12.0 s: it has not been running longer");
  EXPECT_EQ(text({.age = 1h, .reach = 10s}),
            "10.0 s: its history is full (last 10.0 s, 16.0 of 32.0 MiB; see "
            "--history-memory)");
  EXPECT_EQ(ReachText({.process = "robot",
                       .history =
                           message::ProcessHistoryState{
                               .limit = 1, .span = 30s, .age = 1h, .reach = 30s}},
                      60s),
            "30.0 s: it is set to keep no more");
}

}  // namespace
}  // namespace tendon::recording
