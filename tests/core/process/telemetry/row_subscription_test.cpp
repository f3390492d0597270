#include <gtest/gtest.h>
#include <tendon/process/telemetry/row_batch.h>
#include <tendon/process/telemetry/row_subscription.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace tendon {
namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

struct RowCounts {
  std::uint64_t received = 0;
  LostRows lost;

  bool operator==(const RowCounts&) const = default;
};

/// Stores the last batch, and counts the rows of all batches.
class Sink final : public RowSink {
 public:
  void OnSubscribed(const std::vector<Schema>& /*columns*/) override {}
  void OnRows(const RowBatch& batch) override {
    last = batch;
    times.assign(batch.times.begin(), batch.times.end());
    counts.received += batch.count;
    counts.lost += batch.lost;
  }
  void OnStale(const Error& /*reason*/) override {}

  RowBatch last;  ///< without its rows
  std::vector<std::int64_t> times;
  RowCounts counts;
};

/// A viewer of a table without columns, and the batches of its process.
class Viewer {
 public:
  explicit Viewer(RowChoice rows = {})
      : subscription(
            {.process = "robot", .component = "arm", .table = "state", .columns = {}, .rows = rows},
            sink) {}

  /// Begins the subscription, or renews it.
  void Stand(std::uint64_t epoch, std::uint64_t first_tick) {
    beginning = *subscription.Begin({.handle = 1, .epoch = epoch, .first_tick = first_tick});
    rows_before = 0;
    next_tick = first_tick;
  }
  /// Does the same for a topic. `rows` is the number of rows that were sent to the topic before the
  /// row `tick`.
  void StandByTopic(std::uint64_t epoch, std::uint64_t tick, std::uint64_t rows) {
    beginning =
        *subscription.Begin({.handle = 1, .epoch = epoch}, RowSubscription::Start::kFirstBatch);
    rows_before = rows;
    next_tick = tick;
  }
  /// Sends the next rows. Rows that are not sent to the viewer are counted like in its process.
  void Send(std::uint64_t rows, SteadyTime first = SteadyTime(1s), nanoseconds period = 1ms) {
    RowBatchWriter writer({});
    for (std::uint64_t row = 0; row < rows; ++row) {
      writer.BeginRow(next_tick + row, (first + row * period).time_since_epoch().count());
    }
    next_tick += rows;
    subscription.Deliver(beginning,
                         writer.Finish({.rows_before = rows_before,
                                        .lost_table = std::exchange(overwritten, 0),
                                        .next_tick = next_tick}),
                         clock);
    rows_before += rows;
  }
  void Refuse(std::uint64_t rows) {
    rows_before += rows;
    next_tick += rows;
  }
  void Overwrite(std::uint64_t rows) {
    overwritten += rows;
    next_tick += rows;
  }

  std::shared_ptr<Sink> sink = std::make_shared<Sink>();
  RowSubscription subscription;
  ClockOffset clock;
  std::uint64_t beginning = 0;
  std::uint64_t rows_before = 0;
  std::uint64_t next_tick = 0;
  std::uint64_t overwritten = 0;
};

TEST(RowSubscription, CountsLossesByTableAndNetwork) {
  Viewer viewer;
  viewer.Stand(1, 100);

  viewer.Send(10);
  viewer.Refuse(3);
  viewer.Overwrite(5);
  viewer.Send(12);

  EXPECT_EQ(viewer.sink->last.lost.table, 5U);
  EXPECT_EQ(viewer.sink->last.lost.network, 3U);
  EXPECT_EQ(viewer.sink->counts, (RowCounts{.received = 22, .lost = {.table = 5, .network = 3}}));
}

TEST(RowSubscription, CountsRowsMissedDuringAReconnect) {
  Viewer viewer;
  viewer.Stand(1, 100);
  viewer.Send(10);

  viewer.Stand(1, 150);
  viewer.Send(5);

  EXPECT_EQ(viewer.sink->last.lost.network, 40U);
  EXPECT_EQ(viewer.sink->last.epoch, 1U);
  viewer.Send(5);
  EXPECT_EQ(viewer.sink->last.lost.network, 0U);
  EXPECT_EQ(viewer.sink->counts, (RowCounts{.received = 20, .lost = {.network = 40}}));
}

TEST(RowSubscription, RestartsWithANewTable) {
  Viewer viewer;
  viewer.Stand(1, 100);
  viewer.Send(10);

  viewer.Stand(2, 150);
  viewer.Send(5);

  EXPECT_EQ(viewer.sink->last.epoch, 2U);
  EXPECT_EQ(viewer.sink->counts, (RowCounts{.received = 15}));
}

TEST(RowSubscription, DoesNotCountSkippedRowsAsLostWithAPeriod) {
  Viewer viewer({.period = 10ms});
  viewer.Stand(1, 100);
  viewer.Send(10);

  viewer.Stand(1, 150);
  viewer.Send(5);

  EXPECT_EQ(viewer.sink->counts, (RowCounts{.received = 15}));
}

TEST(RowSubscription, OfTheNewestRowStartsWithTheCurrentOne) {
  Viewer viewer({.delivery = RowDelivery::kNewest});
  const auto send_the_row_before = [&viewer] {
    viewer.next_tick = 99;
    viewer.Send(1);
  };
  viewer.Stand(1, 100);
  send_the_row_before();
  EXPECT_EQ(viewer.sink->counts, (RowCounts{.received = 1}));

  viewer.Stand(1, 100);
  send_the_row_before();
  EXPECT_EQ(viewer.sink->counts, (RowCounts{.received = 1})) << "it was heard already";

  viewer.Stand(2, 100);
  send_the_row_before();
  EXPECT_EQ(viewer.sink->counts, (RowCounts{.received = 2}));
}

TEST(RowSubscription, IgnoresBatchesFromBeforeAReconnect) {
  Viewer viewer;
  viewer.Stand(1, 100);
  viewer.Send(10);
  const std::uint64_t before = viewer.beginning;
  viewer.Stand(1, 150);
  const std::uint64_t now = std::exchange(viewer.beginning, before);

  viewer.Send(7);

  EXPECT_EQ(viewer.sink->counts, (RowCounts{.received = 10}));
  viewer.beginning = now;
  viewer.rows_before = 0;
  viewer.next_tick = 150;
  viewer.Send(5);
  EXPECT_EQ(viewer.sink->counts, (RowCounts{.received = 15, .lost = {.network = 40}}));
}

TEST(RowSubscription, ReportsTheOffsetOfTheSourcesClock) {
  Viewer viewer;
  viewer.Stand(1, 0);
  viewer.Send(1, SteadyTime(1h));
  EXPECT_EQ(viewer.sink->last.clock_uncertainty, nanoseconds::max());

  const SteadyTime now = SteadyClock().Now();
  viewer.clock.Add(now - 2ms, now + 1h, now);
  viewer.Send(10, now + 1h);

  EXPECT_EQ(viewer.sink->last.clock_offset, 1h + 1ms);
  EXPECT_GE(viewer.sink->last.clock_uncertainty, 1ms);
  EXPECT_LT(viewer.sink->last.clock_uncertainty, 1min);
}

TEST(RowSubscription, CorrectedTimesNeverGoBack) {
  Viewer viewer;
  viewer.Stand(1, 0);
  viewer.clock.Add(SteadyTime(1s), SteadyTime(1h), SteadyTime(1s));
  SteadyTime row(1h);
  viewer.Send(100'000, row, 10us);
  row += 100'000 * 10us;
  const SteadyTime before = row - 10us - viewer.sink->last.clock_offset;

  // The other clock has gained time. Half a millisecond of this would be corrected at once, but the
  // next row is only 10 us later.
  viewer.clock.Add(SteadyTime(1s), SteadyTime(1h + 10ms), SteadyTime(1s));
  for (const SteadyTime next : {row, row + 10us}) {
    viewer.Send(1, next);
    EXPECT_EQ(next - viewer.sink->last.clock_offset, before);
  }
  viewer.Send(1, row + 2s);
  EXPECT_EQ(viewer.sink->last.clock_offset, 1h - 1s + 1495us);
}

TEST(RowSubscription, ToleratesImpossibleTimes) {
  Viewer viewer;
  viewer.Stand(1, 0);
  viewer.clock.Add(SteadyTime(1s), SteadyTime(1h), SteadyTime(1s));

  for (const SteadyTime time : {SteadyTime::min(), SteadyTime::max(), SteadyTime(1h)}) {
    viewer.Send(1, time);
    viewer.Send(0, time);
  }

  EXPECT_EQ(viewer.sink->counts.received, 3U);
}

TEST(RowSubscription, OfATopicStartsWithTheFirstBatch) {
  Viewer viewer;
  viewer.StandByTopic(1, 500, 321);

  viewer.Send(10);
  viewer.Refuse(4);
  viewer.Send(6);

  EXPECT_EQ(viewer.sink->counts, (RowCounts{.received = 16, .lost = {.network = 4}}));
}

TEST(RowSubscription, OfATopicIgnoresEarlierLosses) {
  Viewer viewer;
  viewer.StandByTopic(1, 500, 321);

  viewer.Overwrite(7);
  viewer.Send(10);
  viewer.Overwrite(5);
  viewer.Send(6);

  EXPECT_EQ(viewer.sink->counts, (RowCounts{.received = 16, .lost = {.table = 5}}));
}

TEST(RowSubscription, OfATopicCountsTableLossesOfALostBatch) {
  Viewer viewer;
  viewer.StandByTopic(1, 100, 0);
  viewer.Send(10);

  viewer.Overwrite(5);
  viewer.Refuse(3);
  viewer.overwritten = 0;  // that batch has reported the loss
  viewer.Send(2);

  EXPECT_EQ(viewer.sink->counts, (RowCounts{.received = 12, .lost = {.table = 5, .network = 3}}));
}

TEST(RowSubscription, SwitchingFromATopicCountsMissedRows) {
  Viewer viewer;
  viewer.StandByTopic(1, 100, 50);
  viewer.Send(10);

  viewer.Stand(1, 130);
  viewer.Send(5);

  EXPECT_EQ(viewer.sink->counts, (RowCounts{.received = 15, .lost = {.network = 20}}));
}

TEST(RowSubscription, SwitchingToATopicDeliversNoRowTwice) {
  Viewer viewer;
  viewer.Stand(1, 100);
  viewer.Send(100);

  viewer.StandByTopic(1, 190, 40);
  viewer.Send(10);  // the viewer already has these rows
  viewer.Send(10);

  EXPECT_EQ(viewer.sink->counts, (RowCounts{.received = 110}));
}

TEST(RowSubscription, LimitsImpossibleTimesOfAPeer) {
  Viewer viewer;
  viewer.Stand(1, 0);

  viewer.Send(1, SteadyTime::min());
  EXPECT_EQ(viewer.sink->times.front(), 0);
  viewer.Send(1, SteadyTime::max());
  EXPECT_EQ(SteadyTime(nanoseconds(viewer.sink->times.front())),
            ClockOffset::Sensible(SteadyTime::max()));
}

}  // namespace
}  // namespace tendon
