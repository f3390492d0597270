#include <tendon/process/telemetry/table_feed.h>

#include <array>
#include <atomic>
#include <thread>

#include "conformance/resources.h"
#include "core/process/telemetry/recording_handler.h"
#include "support/wait.h"

namespace tendon {
namespace {

using namespace std::chrono_literals;
using Ticks = std::vector<std::uint64_t>;

/// A table of two columns that the test writes, the feed of the table, and a viewer.
class TableFeedTest : public testing::Test {
 protected:
  TableFeedTest() {
    table.Add(position, "Position");
    table.Add(velocity, "Velocity");
    table.SetLength(kLength);
    table.Prepare();
    feed.emplace("arm", table);
  }

  void Watch(std::uint32_t handle, const std::vector<std::size_t>& columns, RowChoice rows = {}) {
    feed->Add(columns, rows, ends.channel, handle, ends.channel->NewLane());
  }
  /// Writes rows with a distance of one millisecond.
  void Write(int rows) {
    for (int row = 0; row < rows; ++row) {
      position = static_cast<double>(table.next_tick());
      velocity = -position;
      now += 1ms;
      table.Advance(now);
    }
  }
  /// Gathers until no row is left to send.
  void Gather() {
    while (feed->Gather()) {
    }
    ASSERT_TRUE(ends.channel->Notify(message::kRowsEnded, ++last_mark_, Bytes()));
    ASSERT_TRUE(
        EventuallyTrue([this] { return ends.viewing->HasHeard(message::kRowsEnded, last_mark_); }));
  }

  /// Fills the link. The viewer's gate must be locked.
  void FillLink() const {
    ASSERT_TRUE(ends.channel->Notify(message::kUnsubscribe, 0, Bytes()));
    ASSERT_TRUE(EventuallyTrue([this] { return ends.viewing->is_at_gate.load(); }));
    for (const std::size_t size : {std::size_t{1} << 13U, std::size_t{1} << 10U, std::size_t{0}}) {
      while (ends.channel->Notify(message::kUnsubscribe, 0, Bytes(size))) {
      }
    }
  }

  [[nodiscard]] std::vector<Bytes> Batches(std::uint32_t handle) const {
    std::vector<Bytes> batches;
    for (const auto& notice : ends.viewing->notices()) {
      if (notice.header.type == message::kRows && notice.header.handle == handle) {
        batches.push_back(notice.body);
      }
    }
    return batches;
  }
  [[nodiscard]] Ticks TicksOf(std::uint32_t handle) const {
    Ticks ticks;
    for (const Bytes& batch : Batches(handle)) {
      const auto reader = RowBatchReader::Open(batch);
      for (std::size_t row = 0; row < reader->header().rows; ++row) {
        ticks.push_back(reader->tick(row));
      }
    }
    return ticks;
  }
  [[nodiscard]] message::RowsHeader LastHeader(std::uint32_t handle) const {
    const auto batches = Batches(handle);
    return batches.empty() ? message::RowsHeader{} : RowBatchReader::Open(batches.back())->header();
  }

  static constexpr std::size_t kLength = 1023;

  double position = 0.0;
  double velocity = 0.0;
  StateTable table;
  SteadyTime now{10s};
  ProcessAndViewer ends;
  std::optional<TableFeed> feed;

 private:
  std::uint32_t last_mark_ = 1000;
};

TEST_F(TableFeedTest, SendsEveryRowOfTheRequestedColumns) {
  Write(5);
  feed.emplace("arm", table);
  Watch(1, {0, 1});
  Watch(2, {1});
  Write(3);

  Gather();

  EXPECT_EQ(TicksOf(1), (Ticks{5, 6, 7}));
  EXPECT_EQ(TicksOf(2), (Ticks{5, 6, 7}));
  const Bytes both = Batches(1).at(0);
  const Bytes one = Batches(2).at(0);
  double value = 0.0;
  ASSERT_TRUE(Decode(RowBatchReader::Open(both)->cell(2, 0), value));
  EXPECT_EQ(value, 7.0);
  ASSERT_TRUE(Decode(RowBatchReader::Open(one)->cell(2, 0), value));
  EXPECT_EQ(value, -7.0);
}

TEST_F(TableFeedTest, AllViewersOfATableShareItsLossCount) {
  Watch(1, {0});
  Write(static_cast<int>(kLength) + 100);  // a hundred rows are overwritten
  Watch(2, {1});
  Watch(3, {0, 1}, {.period = 10ms});

  Gather();

  EXPECT_EQ(feed->next_tick(), table.next_tick());
  for (const std::uint32_t handle : {1U, 2U, 3U}) {
    EXPECT_GE(LastHeader(handle).lost_table, 100U);
    EXPECT_EQ(LastHeader(handle).lost_table, LastHeader(1).lost_table);
    EXPECT_EQ(LastHeader(handle).next_tick, table.next_tick());
  }
}

TEST_F(TableFeedTest, GathersOneBatchAtATime) {
  StateTable wide;
  const std::array<double, 4096> image{};  // four rows of this size fill a batch
  wide.Add(image, "Image");
  wide.SetLength(kLength);
  wide.Prepare();
  feed.emplace("camera", wide);
  Watch(1, {0});
  for (int row = 0; row < 12; ++row) wide.Advance(now += 1ms);

  EXPECT_TRUE(feed->Gather());
  EXPECT_EQ(feed->next_tick(), 4U);
  EXPECT_TRUE(feed->Gather());
  EXPECT_FALSE(feed->Gather());
  EXPECT_EQ(feed->next_tick(), 12U);
  EXPECT_FALSE(feed->has_more());
}

TEST_F(TableFeedTest, AFasterWriterStillYieldsRowsAndLossCounts) {
  StateTable wide;
  const std::array<double, 256> image{};
  wide.Add(image, "Image");
  wide.SetLength(63);
  wide.Prepare();
  feed.emplace("camera", wide);
  Watch(1, {0});
  std::atomic<bool> stops{false};
  std::thread writer([&] {
    while (!stops) wide.Advance(now += 1us);
  });
  const auto brought = [&] {
    feed->Gather();
    return TicksOf(1).size() > 200;
  };

  EXPECT_TRUE(EventuallyTrue(brought));
  stops = true;
  writer.join();
  Gather();

  std::uint64_t lost = 0;
  for (const Bytes& batch : Batches(1)) lost += RowBatchReader::Open(batch)->header().lost_table;
  EXPECT_EQ(LastHeader(1).rows_before + LastHeader(1).rows + lost, wide.next_tick());
}

TEST_F(TableFeedTest, WithAPeriodSendsTheFirstRowOfEach) {
  Watch(1, {0}, {.period = 10ms});
  Write(35);  // from 10.001 s on

  Gather();
  Write(10);
  Gather();

  EXPECT_EQ(TicksOf(1), (Ticks{0, 9, 19, 29, 39}));
  EXPECT_EQ(LastHeader(1).rows_before, 4U);
  EXPECT_EQ(LastHeader(1).lost_table, 0U);
}

TEST_F(TableFeedTest, WithAPeriodDoesNotDriftWhenRowsAreLate) {
  Watch(1, {0}, {.period = 10ms});
  for (int row = 0; row < 1000; ++row) {
    table.Advance(now + row * 1ms + (row % 7) * 100us);
  }

  Gather();

  EXPECT_EQ(TicksOf(1).size(), 100U);
}

TEST_F(TableFeedTest, WithAShorterPeriodThanTheTableSendsEveryRow) {
  Watch(1, {0}, {.period = 10us});
  Write(20);

  Gather();

  EXPECT_EQ(TicksOf(1).size(), 20U);
}

TEST_F(TableFeedTest, SendsTheNewestRowAfterAnAcknowledgement) {
  Watch(1, {0}, {.delivery = RowDelivery::kNewest});
  Watch(2, {0});
  Write(10);
  Gather();
  Write(10);
  Gather();
  EXPECT_EQ(TicksOf(1), (Ticks{9}));

  feed->OnRowsTaken({{ends.channel, {1}}});
  Gather();
  EXPECT_EQ(TicksOf(1), (Ticks{9, 19}));
  EXPECT_EQ(LastHeader(1).rows_before, 1U);
  EXPECT_EQ(LastHeader(1).lost_table, 0U);
  EXPECT_EQ(TicksOf(2).size(), 20U);

  feed->OnRowsTaken({{ends.channel, {1}}});
  Gather();
  EXPECT_EQ(TicksOf(1).size(), 2U);  // the viewer knows every row
}

TEST_F(TableFeedTest, AFullLinkLearnsOfLossesWithoutFurtherRows) {
  Watch(1, {0});
  {
    const std::scoped_lock held(ends.viewing->gate);
    FillLink();
    Write(7);
    EXPECT_FALSE(feed->Gather());
  }
  ASSERT_TRUE(EventuallyTrue(
      [&] { return bool(ends.channel->Notify(message::kUnsubscribe, 0, Bytes())); }));

  Gather();
  Gather();

  ASSERT_EQ(Batches(1).size(), 1U);
  EXPECT_EQ(LastHeader(1).rows, 0U);
  EXPECT_EQ(LastHeader(1).rows_before, 7U);
  EXPECT_EQ(LastHeader(1).next_tick, 7U);
}

TEST_F(TableFeedTest, AStoppedViewerMakesTheSenderRefuseAndNotGrow) {
  Watch(1, {0, 1});
  const std::scoped_lock held(ends.viewing->gate);
  FillLink();
  Write(200);
  feed->Gather();
  const std::size_t memory = conformance::MemoryInUse();

  for (int gathering = 0; gathering < 1000; ++gathering) {
    Write(200);
    feed->Gather();
  }

  EXPECT_LT(conformance::MemoryInUse(), memory + (std::size_t{4} << 20U));
}

TEST_F(TableFeedTest, NotifiesAViewerWithAFullLinkOfItsEnd) {
  Watch(3, {});
  {
    const std::scoped_lock held(ends.viewing->gate);
    FillLink();

    feed->End({ErrorCode::kNotFound, "the camera was removed"});
  }

  EXPECT_TRUE(EventuallyTrue(
      [&] { return ends.viewing->HasHeard(message::kRowsEnded, 3) || ends.viewing->is_closed(); }));
}

TEST_F(TableFeedTest, HasNoViewersAfterTheLastLeaves) {
  Watch(1, {0});
  Watch(2, {0});
  feed->Remove(*ends.channel, 1);
  EXPECT_TRUE(feed->has_viewers());

  ends.channel->Close();
  EXPECT_TRUE(EventuallyTrue([&] { return !ends.channel->is_open(); }));
  feed->Gather();

  EXPECT_FALSE(feed->has_viewers());
}

}  // namespace
}  // namespace tendon
