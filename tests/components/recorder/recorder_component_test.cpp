#include <components/counter/counter.h>
#include <components/recorder/recorder_component.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/folder.h>
#include <support/wait.h>
#include <tendon/interface/function.h>
#include <tendon/manager/local_manager.h>
#include <tendon/middleware/loopback.h>
#include <tendon/payload/codec.h>
#include <tendon/process/process.h>
#include <tendon/recording/mcap/reader.h>
#include <tendon/recording/recording_writer.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace recorder {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// Operates a recorder from the test's thread, and collects its events.
class Operator final : public tendon::Component {
 public:
  explicit Operator(std::string name) : Component(std::move(name)) {
    auto& recorder = AddRequiredInterface("Recorder");
    recorder.AddFunction(start, "Start");
    recorder.AddFunction(stop, "Stop");
    recorder.AddFunction(save_last, "SaveLast");
    recorder.AddEventHandlerWrite(&Operator::OnStarted, this, "Started");
    recorder.AddEventHandlerWrite(&Operator::OnStopped, this, "Stopped");
    recorder.AddEventHandlerWrite(&Operator::OnSaved, this, "Saved");
    recorder.AddEventHandlerWrite(&Operator::OnFailed, this, "Failed");
  }

  /// Returns the texts of all events with this name.
  std::vector<std::string> Texts(const std::string& event) {
    const std::scoped_lock lock(mutex_);
    return texts_[event];
  }
  bool EventuallyHas(const std::string& event, std::size_t count = 1) {
    return EventuallyTrue([&] { return Texts(event).size() >= count; });
  }

  tendon::VoidFunction start;
  tendon::VoidFunction stop;
  tendon::WriteFunction<double> save_last;

 private:
  void OnStarted(const std::string& file) { Keep("Started", file); }
  void OnStopped(const std::string& file) { Keep("Stopped", file); }
  void OnSaved(const std::string& file) { Keep("Saved", file); }
  void OnFailed(const std::string& sentence) { Keep("Failed", sentence); }
  void Keep(const std::string& event, const std::string& text) {
    const std::scoped_lock lock(mutex_);
    texts_[event].push_back(text);
  }

  std::mutex mutex_;
  std::map<std::string, std::vector<std::string>> texts_;
};

class RecorderComponentTest : public testing::Test {
 protected:
  explicit RecorderComponentTest(tendon::HistoryOptions history = {})
      : process_("robot",
                 tendon::ProcessOptions{.middleware = std::make_shared<tendon::LoopbackMiddleware>(
                                            std::make_shared<tendon::LoopbackNetwork>()),
                                        .history = history}) {}

  void Begin(RecorderConfiguration configuration) {
    if (configuration.folder == ".") configuration.folder = folder_.path().string();
    operator_ = &process_.Add<Operator>("operator");  // added first, so that it misses no event
    process_.Add<counter::Counter>("counter");
    recorder_ = &process_.Add<RecorderComponent>("recorder", std::move(configuration));
    const auto connected =
        process_.Connect({"operator", "Recorder"}, {"robot", "recorder", "Control"});
    ASSERT_TRUE(connected) << connected.error().message;
    ASSERT_TRUE(process_.StartAll());
  }
  [[nodiscard]] RecorderState State() const {
    RecorderState state;
    const auto* column = dynamic_cast<const tendon::Column<RecorderState>*>(
        recorder_->tables().front()->Find("State"));
    EXPECT_NE(column, nullptr);
    if (column != nullptr) (void)column->ReadNewest(state);
    return state;
  }
  [[nodiscard]] bool EventuallyRows(std::uint64_t rows) const {
    return EventuallyTrue([&] { return State().rows >= rows; });
  }
  /// Returns the number of messages by topic.
  static std::map<std::string, std::size_t> Read(const std::string& file) {
    std::map<std::string, std::size_t> counts;
    const auto reader = tendon::mcap::Reader::Open(std::filesystem::path(file));
    EXPECT_TRUE(reader) << reader.error().message;
    if (!reader) return counts;
    auto messages = (*reader)->Messages({});
    while (const auto message = messages.Next()) {
      ++counts[(*reader)->FindChannel(message->channel_id)->topic];
    }
    EXPECT_EQ((*reader)->problems().count(), 0U);
    return counts;
  }

  /// The values of the counter in a file, in their order.
  static std::vector<std::int64_t> Values(const std::string& file) {
    std::vector<std::int64_t> values;
    const auto reader = tendon::mcap::Reader::Open(std::filesystem::path(file));
    EXPECT_TRUE(reader) << reader.error().message;
    if (!reader) return values;
    auto messages = (*reader)->Messages({});
    while (const auto message = messages.Next()) {
      if ((*reader)->FindChannel(message->channel_id)->topic != "robot/counter/state/Value")
        continue;
      std::int64_t& value = values.emplace_back();
      EXPECT_TRUE(
          tendon::Decode(message->data.subspan(tendon::recording::kEncapsulationSize), value));
    }
    return values;
  }

  const tendon::test::Folder folder_;
  tendon::Process process_;
  RecorderComponent* recorder_ = nullptr;
  Operator* operator_ = nullptr;
};

TEST_F(RecorderComponentTest, RecordsItsProcessFromStartToStop) {
  Begin({.patterns = {"robot/counter/**"}});
  ASSERT_TRUE(operator_->start());
  ASSERT_TRUE(operator_->EventuallyHas("Started"));
  EXPECT_TRUE(EventuallyTrue([&] { return State().is_recording; }));
  ASSERT_TRUE(EventuallyRows(100));
  EXPECT_GT(State().disk_left, 0U);

  ASSERT_TRUE(operator_->stop());

  ASSERT_TRUE(operator_->EventuallyHas("Stopped"));
  EXPECT_EQ(operator_->Texts("Stopped"), operator_->Texts("Started"));
  const std::string file = operator_->Texts("Stopped").front();
  EXPECT_THAT(file, StartsWith((folder_.path() / "recording-").string()));
  ASSERT_TRUE(EventuallyTrue([&] { return !State().is_recording; }));
  EXPECT_EQ(Read(file)["robot/counter/state/Value"], State().rows);
}

TEST_F(RecorderComponentTest, RecordsFromItsOwnStartOnIfConfigured) {
  Begin({.patterns = {"**"}, .name = "flight", .record_at_start = true});
  ASSERT_TRUE(operator_->EventuallyHas("Started"));
  ASSERT_TRUE(EventuallyRows(50));

  ASSERT_TRUE(process_.Stop("recorder"));

  const std::string file = operator_->Texts("Started").front();
  EXPECT_THAT(file, HasSubstr("flight-"));
  EXPECT_GE(Read(file)["robot/counter/state/Value"], 50U) << "its end completes the file";
}

TEST_F(RecorderComponentTest, ASecondRecordingHasAFileOfItsOwn) {
  Begin({.patterns = {"robot/counter"}});
  for (std::size_t i = 1; i <= 2; ++i) {
    ASSERT_TRUE(operator_->start());
    ASSERT_TRUE(operator_->EventuallyHas("Started", i));
    ASSERT_TRUE(operator_->stop());
    ASSERT_TRUE(operator_->EventuallyHas("Stopped", i));
  }

  const auto files = operator_->Texts("Stopped");
  EXPECT_NE(files[0], files[1]);
  (void)Read(files[0]);
  (void)Read(files[1]);
}

TEST_F(RecorderComponentTest, ASecondRecordingWithASplitHasFilesOfItsOwn) {
  Begin({.patterns = {"robot/counter"}, .split_size = std::uint64_t{1} << 40U});
  for (std::size_t i = 1; i <= 3; ++i) {
    ASSERT_TRUE(operator_->start());
    ASSERT_TRUE(operator_->EventuallyHas("Started", i));
    ASSERT_TRUE(operator_->stop());
    ASSERT_TRUE(operator_->EventuallyHas("Stopped", i));
  }

  EXPECT_TRUE(operator_->Texts("Failed").empty());
  auto files = operator_->Texts("Stopped");
  std::ranges::sort(files);
  EXPECT_EQ(std::ranges::adjacent_find(files), files.end());
}

TEST_F(RecorderComponentTest, AnOrderThatMakesNoSenseIsRefusedWithASentence) {
  Begin({.patterns = {"**"}});
  ASSERT_TRUE(operator_->stop());
  ASSERT_TRUE(operator_->EventuallyHas("Failed"));
  EXPECT_EQ(operator_->Texts("Failed").back(), "there is no recording to stop");

  ASSERT_TRUE(operator_->start());
  ASSERT_TRUE(operator_->EventuallyHas("Started"));
  ASSERT_TRUE(operator_->start());
  ASSERT_TRUE(operator_->EventuallyHas("Failed", 2));
  EXPECT_THAT(operator_->Texts("Failed").back(), HasSubstr("stop that recording first"));
}

TEST_F(RecorderComponentTest, AFolderThatDoesNotExistIsReportedAndFaultsNothing) {
  Begin({.patterns = {"**"}, .folder = "/does/not/exist"});

  ASSERT_TRUE(operator_->start());

  ASSERT_TRUE(operator_->EventuallyHas("Failed"));
  EXPECT_THAT(operator_->Texts("Failed").front(), HasSubstr("/does/not/exist/recording-"));
  EXPECT_EQ(recorder_->state(), tendon::ComponentState::kActive);
  EXPECT_FALSE(State().is_recording);
}

TEST_F(RecorderComponentTest, SavesTheRowsThatTheTablesHoldWithoutARecording) {
  Begin({.patterns = {"robot/counter"}});
  const auto* const table = process_.Find("counter")->tables().front();
  ASSERT_TRUE(EventuallyTrue([&] { return table->next_tick() >= 200; }));

  ASSERT_TRUE(operator_->save_last(3600.0));

  ASSERT_TRUE(operator_->EventuallyHas("Saved"));
  EXPECT_GE(Read(operator_->Texts("Saved").front())["robot/counter/state/Value"], 200U);
  EXPECT_FALSE(State().is_recording);
}

class RecorderWithoutHistoryTest : public RecorderComponentTest {
 protected:
  RecorderWithoutHistoryTest() : RecorderComponentTest({.memory = 0}) {}
};

TEST_F(RecorderWithoutHistoryTest, SavesTheRowsOfTheTablesAndSaysOnceThatTheHistoryIsOff) {
  Begin({.patterns = {"robot/recorder"}});

  ASSERT_TRUE(operator_->save_last(30.0));

  ASSERT_TRUE(operator_->EventuallyHas("Saved"));
  EXPECT_EQ(
      operator_->Texts("Failed"),
      (std::vector<std::string>{
          "robot: only the rows in its state tables: its history is off (--history-memory)"}));
}

TEST_F(RecorderComponentTest, AnImpossibleTimeToSaveIsRefused) {
  Begin({.patterns = {"**"}});

  ASSERT_TRUE(operator_->save_last(-1.0));

  ASSERT_TRUE(operator_->EventuallyHas("Failed"));
  EXPECT_THAT(operator_->Texts("Failed").front(),
              HasSubstr("cannot save the last -1 s: expected more than 0"));
}

/// Chooses the steps of the counter.
class Stepper final : public tendon::Component {
 public:
  explicit Stepper(std::string name) : Component(std::move(name)) {
    AddRequiredInterface("Counter").AddFunction(set_step, "SetStep");
  }

  tendon::WriteFunction<std::int32_t> set_step;
};

TEST_F(RecorderComponentTest, BeginsAndEndsWithConditions) {
  auto& stepper = process_.Add<Stepper>("stepper");
  Begin({.patterns = {"robot/counter/**"},
         .start_when = "robot/counter/state.Value < 0",
         .stop_when = "robot/counter/state.Value > 1000000000",
         .before = 0.2});
  ASSERT_TRUE(process_.Connect({"stepper", "Counter"}, {"robot", "counter", "Control"}));
  ASSERT_TRUE(operator_->start());
  ASSERT_TRUE(EventuallyTrue([&] { return State().is_waiting; }));
  EXPECT_FALSE(State().is_recording);
  EXPECT_TRUE(operator_->Texts("Started").empty());

  ASSERT_TRUE(stepper.set_step(-1'000'000));
  ASSERT_TRUE(operator_->EventuallyHas("Started"));
  ASSERT_TRUE(EventuallyRows(50));
  EXPECT_FALSE(State().is_waiting);
  ASSERT_TRUE(stepper.set_step(2'000'000'000));

  ASSERT_TRUE(operator_->EventuallyHas("Stopped"));
  EXPECT_EQ(operator_->Texts("Stopped"), operator_->Texts("Started"));
  EXPECT_TRUE(operator_->Texts("Failed").empty());
  const auto values = Values(operator_->Texts("Stopped").front());
  const auto negative = std::ranges::find_if(values, [](std::int64_t value) { return value < 0; });
  EXPECT_GT(negative - values.begin(), 0) << "what came before it is in the file";
  EXPECT_LE(negative - values.begin(), 300) << "of 200 ms only";
  EXPECT_NE(negative, values.end());
}

TEST_F(RecorderComponentTest, AConditionThatIsNeverTrueLeavesNoFile) {
  Begin({.patterns = {"**"}, .start_when = "robot/counter/state.Value < 0"});
  ASSERT_TRUE(operator_->start());
  ASSERT_TRUE(EventuallyTrue([&] { return State().is_waiting; }));

  ASSERT_TRUE(operator_->stop());

  ASSERT_TRUE(operator_->EventuallyHas("Stopped"));
  EXPECT_EQ(operator_->Texts("Stopped").front(), "");
  EXPECT_TRUE(operator_->Texts("Started").empty());
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

TEST_F(RecorderComponentTest, AConditionOnWhatDoesNotExistIsReported) {
  Begin({.patterns = {"**"}, .start_when = "robot/counter/state.Valu < 0"});

  ASSERT_TRUE(operator_->start());

  ASSERT_TRUE(operator_->EventuallyHas("Failed"));
  EXPECT_THAT(operator_->Texts("Failed").front(), HasSubstr("Valu"));
  EXPECT_FALSE(State().is_waiting);
}

TEST(RecorderConfigurationTest, AnInvalidConfigurationIsRefused) {
  EXPECT_THROW(RecorderComponent("one", {.before = 2.0}), tendon::ConfigurationError);
  EXPECT_THROW(RecorderComponent("one", {.after = 2.0}), tendon::ConfigurationError);
  EXPECT_THROW(RecorderComponent("one", {.start_when = "robot/arm/state.Joints >"}),
               tendon::ConfigurationError);
  EXPECT_THROW(RecorderComponent("one", {.patterns = {}}), tendon::ConfigurationError);
  EXPECT_THROW(RecorderComponent("one", {.keep = 2}), tendon::ConfigurationError);
  EXPECT_THROW(RecorderComponent("one", {.name = "../run"}), tendon::ConfigurationError);
  EXPECT_THROW(RecorderComponent("one", {.name = "runs/run"}), tendon::ConfigurationError);
  EXPECT_NO_THROW(RecorderComponent("one", {.name = "run.2"}));
}

TEST(RecorderConfigurationTest, AManagerThatIsNoProcessDoesNotGetIt) {
  tendon::LocalManager manager;

  EXPECT_THROW(manager.Add<RecorderComponent>("recorder"), tendon::ConfigurationError);

  EXPECT_EQ(manager.Find("recorder"), nullptr);
}

}  // namespace
}  // namespace recorder
