#include <gtest/gtest.h>
#include <tendon/payload/codec.h>
#include <tendon/recording/recording_queue.h>

#include <chrono>
#include <numeric>
#include <variant>
#include <vector>

namespace tendon::recording {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

const TableSubscription kTable{"robot", "arm", "state", {"Count"}};
const std::string kPath = "robot/arm/state";

/// Rows of one column, a number that equals the tick.
struct Batch {
  explicit Batch(std::uint64_t first, std::size_t count) : ticks(count), times(count) {
    std::iota(ticks.begin(), ticks.end(), first);
    for (std::size_t i = 0; i < count; ++i) {
      times[i] = static_cast<std::int64_t>(1000 * ticks[i]);
      Encode(ticks[i], cells.emplace_back());
    }
  }

  void GiveTo(RowSink& sink) {
    RowBatch batch{.epoch = 1, .lost = {.table = lost_table}, .count = ticks.size()};
    batch.ticks = ticks;
    batch.times = times;
    batch.cell = [this](std::size_t row, std::size_t /*column*/) {
      return std::span<const std::byte>(cells[row]);
    };
    sink.OnRows(batch);
  }

  std::vector<std::uint64_t> ticks;
  std::vector<std::int64_t> times;
  std::vector<std::vector<std::byte>> cells;
  std::uint64_t lost_table = 0;
};

std::vector<RowsEntry> TakeRows(RecordingQueue& queue) {
  std::vector<RowsEntry> all;
  for (RecordingEntry& entry : queue.Take(0ns))
    all.push_back(std::get<RowsEntry>(std::move(entry)));
  return all;
}

TEST(RecordingQueueTest, PassesRowsOnWithTheirCells) {
  const auto queue = std::make_shared<RecordingQueue>();
  const auto sink = queue->SinkOf(kTable);
  sink->OnSubscribed({SchemaOf<std::uint64_t>()});

  Batch(7, 2).GiveTo(*sink);

  const auto rows = TakeRows(*queue);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].ticks, (std::vector<std::uint64_t>{7, 8}));
  EXPECT_EQ(rows[0].times, (std::vector<std::int64_t>{7000, 8000}));
  EXPECT_EQ(rows[0].cell_sizes, (std::vector<std::uint32_t>{8, 8}));
  EXPECT_EQ(ToString(rows[0].source->name), kPath);
  std::uint64_t second = 0;
  EXPECT_TRUE(Decode(std::span(rows[0].cells).subspan(8), second));
  EXPECT_EQ(second, 8U);
  EXPECT_EQ(queue->waiting_bytes(), 0U);
}

TEST(RecordingQueueTest, RowsThatDoNotFitAreCountedAndToldByTheNextRowsThatDo) {
  const auto queue = std::make_shared<RecordingQueue>(2000);
  const auto sink = queue->SinkOf(kTable);
  sink->OnSubscribed({SchemaOf<std::uint64_t>()});

  Batch(0, 40).GiveTo(*sink);
  EXPECT_EQ(queue->losses().rows.at(kPath).viewer, 0U);
  Batch late(40, 60);
  late.lost_table = 3;
  late.GiveTo(*sink);
  EXPECT_EQ(queue->losses().rows.at(kPath).viewer, 60U);

  EXPECT_EQ(TakeRows(*queue).size(), 1U);
  Batch(100, 1).GiveTo(*sink);
  const auto rows = TakeRows(*queue);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].lost_before, (LostRows{3, 0, 60}));
  EXPECT_EQ(queue->losses().rows.at(kPath), (LostRows{3, 0, 60}));
  EXPECT_TRUE(queue->TakeTrailingLosses().empty());
}

TEST(RecordingQueueTest, ALossThatNoRowsFollowIsTheRest) {
  const auto queue = std::make_shared<RecordingQueue>(1000);
  const auto sink = queue->SinkOf(kTable);
  sink->OnSubscribed({SchemaOf<std::uint64_t>()});
  Batch(0, 20).GiveTo(*sink);
  Batch(20, 20).GiveTo(*sink);

  EXPECT_EQ(queue->TakeTrailingLosses(), (std::map<std::string, LostRows>{{kPath, {0, 0, 20}}}));
}

TEST(RecordingQueueTest, RowsLargerThanTheBoundAreTakenIfNothingWaits) {
  const auto queue = std::make_shared<RecordingQueue>(10);
  const auto sink = queue->SinkOf(kTable);
  sink->OnSubscribed({SchemaOf<std::uint64_t>()});

  Batch(0, 50).GiveTo(*sink);

  EXPECT_EQ(queue->losses().rows.at(kPath).viewer, 0U);
  EXPECT_EQ(TakeRows(*queue).size(), 1U);
}

TEST(RecordingQueueTest, RowsAfterTheEndAreNoLossAndTakeNoMemory) {
  const auto queue = std::make_shared<RecordingQueue>();
  const auto sink = queue->SinkOf(kTable);
  sink->OnSubscribed({SchemaOf<std::uint64_t>()});
  Batch(0, 2).GiveTo(*sink);

  queue->Close();
  Batch(2, 2).GiveTo(*sink);

  EXPECT_EQ(queue->waiting_bytes(), 0U);
  EXPECT_TRUE(queue->Take(0ns).empty());
  EXPECT_EQ(queue->losses().rows.at(kPath), LostRows());
}

TEST(RecordingQueueTest, ASentenceThatManyTablesSayIsSaidOnce) {
  const auto queue = std::make_shared<RecordingQueue>();
  for (int i = 0; i < 3; ++i) {
    queue->SinkOf(kTable)->OnStale({ErrorCode::kFailed, "process 'robot' was lost"});
  }

  EXPECT_EQ(queue->TakeNotices(), std::vector<std::string>{"process 'robot' was lost"});
}

TEST(RecordingQueueTest, AnEventOfAnUnknownTypeIsCountedAsLost) {
  const auto queue = std::make_shared<RecordingQueue>();
  const EventSubscription events{.provided = {"robot", "arm", "Control"},
                                 .events = {"Moved", "Stopped"}};
  const auto sink = queue->SinkOf(events, {});
  sink->OnListening(
      {{.name = "Moved", .signature = SignatureOf<double, None>(CommandKind::kWrite)},
       {.name = "Stopped", .signature = SignatureOf<None, None>(CommandKind::kVoid)}});
  std::vector<std::byte> value;
  Encode(1.5, value);

  sink->OnEvent(0, value, {});
  sink->OnEvent(1, {}, {});
  sink->OnEventsLost(1, 4);

  EXPECT_EQ(queue->Take(0ns).size(), 1U) << "the event without a value needs no type";
  EXPECT_EQ(queue->losses().events.at("robot/arm/Control.Moved"), 1U);
  EXPECT_EQ(queue->losses().events.at("robot/arm/Control.Stopped"), 4U);
}

TEST(RecordingQueueTest, RecordsThatTheGcmHadLostBeforeDoNotCount) {
  RecordingQueue queue;

  queue.OnLog({.records = {{}}, .lost = 9, .is_current = true});
  EXPECT_EQ(queue.losses().log, 0U);
  queue.OnLog({.records = {}, .lost = 2, .is_current = true});

  EXPECT_EQ(queue.losses().log, 2U);
}

TEST(RecordingQueueTest, ChangesOfTheCatalogueThatDoNotFitNeedASnapshot) {
  RecordingQueue queue(5000);
  queue.OnChanges({{.revision = 1, .process = "robot"}});
  EXPECT_FALSE(queue.needs_snapshot());
  queue.OnChanges({{.revision = 2, .process = "robot"}});
  EXPECT_TRUE(queue.needs_snapshot());

  EXPECT_EQ(queue.Take(0ns).size(), 1U);
  queue.OnChanges({{.revision = 3, .process = "robot"}});
  EXPECT_EQ(queue.Take(0ns).size(), 0U) << "changes without those before them have no meaning";
  queue.OnSnapshot(Catalogue::At(3));

  EXPECT_FALSE(queue.needs_snapshot());
  const auto entries = queue.Take(0ns);
  ASSERT_EQ(entries.size(), 1U);
  EXPECT_TRUE(std::get<CatalogueEntry>(entries[0]).is_snapshot);
}

}  // namespace
}  // namespace tendon::recording
