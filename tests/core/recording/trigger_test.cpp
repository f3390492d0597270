#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/recording/recorder.h>
#include <tendon/recording/trigger.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "recorder_fixture.h"

namespace tendon::recording {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using testing::HasSubstr;

/// Recordings that begin or end with a condition.
class TriggerTest : public RecorderTest {};

/// More bytes than the catalogue alone has, so that the buffer also holds rows.
constexpr std::size_t kBeyondTheCatalogue = 150'000;

/// The condition, or none if it cannot be read.
std::optional<Condition> When(const std::string& text) {
  auto condition = ParseCondition(text);
  EXPECT_TRUE(condition) << condition.error().message;
  return condition ? std::optional(*condition) : std::nullopt;
}

TEST_F(TriggerTest, RecordsRowsFromBeforeTheCondition) {
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

TEST_F(TriggerTest, TheFileTellsWhatIsMissingBeforeTheCondition) {
  const auto robot = StartProcess("robot");
  StartRecorder({.patterns = {"robot/odometer/state"},
                 .start_when = When("robot/odometer/state.Half < 0"),
                 .before = 1h,
                 .before_bytes = 1},
                {"robot"});
  const auto events = queue_->SinkOf(
      EventSubscription{.provided = {"robot", "odometer", "Control"}, .events = {"Passed"}}, {});
  events->OnEventsLost(0, 7);  // within the hour
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

TEST_F(TriggerTest, BeginsWithTheConditionIfNothingBeforeIsWanted) {
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

TEST_F(TriggerTest, EndsSomeTimeAfterTheConditionToStop) {
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

TEST_F(TriggerTest, LossesBeforeTheBeginAreNeverSubtractedBeforeTheyAreCounted) {
  const auto robot = StartProcess("robot");
  StartRecorder(
      {.patterns = {"robot/odometer/state"}, .start_when = When("robot/odometer/Control.Passed")},
      {"robot"});
  ASSERT_TRUE(EventuallyRows(1));
  const auto sink =
      queue_->SinkOf(TableSubscription{"robot", "other", "state", std::vector<std::string>{"A"}});
  sink->OnSubscribed({SchemaOf<std::uint8_t>()});

  // Rows of a time before the begin, each behind a loss.
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

TEST_F(TriggerTest, AnEventStartsTheRecording) {
  const auto robot = StartProcess("robot");
  StartRecorder(
      {.patterns = {"robot/odometer/state"}, .start_when = When("robot/odometer/Control.Passed")},
      {"robot"});

  ASSERT_TRUE(EventuallyRows(100));

  ASSERT_TRUE(recorder_->Stop());
  const auto reader = Open();
  ExpectEachRowOnce(ByTopic(*reader)["robot/odometer/state/Number"]);
}

TEST_F(TriggerTest, WithoutItsConditionThereIsNoFile) {
  const auto robot = StartProcess("robot");
  StartRecorder({.patterns = {"**"}, .start_when = When("robot/odometer/state.Half < 0")},
                {"robot"});

  EXPECT_TRUE(recorder_->Stop());

  EXPECT_TRUE(recorder_->status().is_waiting);
  EXPECT_FALSE(std::filesystem::exists(file_));
}

TEST_F(TriggerTest, AConditionOnSomethingThatDoesNotExistIsRefused) {
  const auto robot = StartProcess("robot");
  StartRecorder({.patterns = {"**"}}, {"robot"});
  const auto refusal_of = [&](const std::string& text) {
    const auto started = Recorder::Start(
        *client_, queue_,
        {.patterns = {"**"}, .files = {.file = "other.mcap"}, .start_when = When(text)});
    EXPECT_FALSE(started) << text;
    return started ? std::string() : started.error().message;
  };

  EXPECT_THAT(refusal_of("robot/odometre/state.Number > 1"), HasSubstr("odometer"));
  EXPECT_THAT(refusal_of("robot/odometer/state.Numer > 1"), HasSubstr("did you mean 'Number'?"));
  EXPECT_THAT(refusal_of("robot/odometer/Control.Passt"),
              HasSubstr("has no event or command 'Passt'"));
  EXPECT_THAT(refusal_of("robot/odometer/state.Number"), HasSubstr("expected a comparison"));
  EXPECT_THAT(refusal_of("robot/odometer/Control.Passed > 3"), HasSubstr("no state table"));
  EXPECT_THAT(refusal_of("robot/odometer/state.Number > 3 m"), HasSubstr("has no unit"));
}

TEST_F(TriggerTest, IfNoFileCanBeMadeTheRowsBeforeTheConditionAreCountedAsLost) {
  FileOptions full_disk;
  full_disk.create = [](const auto&) -> Result<std::unique_ptr<os::WritableFile>> {
    return Error{ErrorCode::kFailed, "No space left on device"};
  };
  const auto robot = StartProcess("robot");
  StartRecorder({.patterns = {"robot/odometer/state"},
                 .files = full_disk,
                 .start_when = When("robot/odometer/state.Half < 0"),
                 .before = 1h},
                {"robot"});
  ASSERT_TRUE(
      EventuallyTrue([&] { return recorder_->status().before_bytes > kBeyondTheCatalogue; }));
  EXPECT_EQ(LostRowsUpToNow().viewer, 0U);

  Reverse();
  ASSERT_TRUE(EventuallyTrue([&] { return recorder_->status().failure.has_value(); }));
  ASSERT_TRUE(EventuallyTrue([&] { return LostRowsUpToNow().viewer > 100; }));

  const auto stopped = recorder_->Stop();
  ASSERT_FALSE(stopped);
  EXPECT_THAT(stopped.error().message, HasSubstr("No space left on device"));
}

}  // namespace
}  // namespace tendon::recording
