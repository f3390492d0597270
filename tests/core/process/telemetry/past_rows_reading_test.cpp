#include <gtest/gtest.h>
#include <tendon/process/telemetry/past_rows_reading.h>
#include <tendon/process/telemetry/row_batch.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace tendon {
namespace {

using namespace std::chrono_literals;

constexpr std::uint64_t kEpoch = 7;

class TickSink final : public RowSink {
 public:
  void OnSubscribed(const std::vector<Schema>& /*columns*/) override { ++subscribed; }
  void OnRows(const RowBatch& batch) override {
    ticks.insert(ticks.end(), batch.ticks.begin(), batch.ticks.end());
    lost += batch.lost;
  }
  void OnStale(const Error& /*reason*/) override {}

  int subscribed = 0;
  std::vector<std::uint64_t> ticks;
  LostRows lost;
};

/// A reading of a table without columns.
struct Reading {
  std::shared_ptr<TickSink> sink = std::make_shared<TickSink>();
  std::optional<PastRows> outcome;
  PastRowsReading reading{{.process = "robot", .component = "arm", .table = "state"},
                          30s,
                          sink,
                          [this](const PastRows& past) { outcome = past; }};

  /// Returns true if another page must be requested.
  bool Take(const message::ReadRowsReply& page) { return reading.Take(page, ClockOffset()); }
};

/// Returns the rows [first, end) of a process that has written the rows before `written`. The row
/// of tick N was written N ms after the start of the clock. The present time is 1 s.
message::ReadRowsReply Page(std::uint64_t first, std::uint64_t end, std::uint64_t written,
                            std::uint64_t rows_before, std::uint64_t lost = 0) {
  RowBatchWriter writer({});
  for (std::uint64_t tick = first; tick < end; ++tick) {
    writer.BeginRow(tick, static_cast<std::int64_t>(tick) * 1'000'000);
  }
  const auto body =
      writer.Finish({.rows_before = rows_before, .lost_table = lost, .next_tick = end});
  return {.subscribed = {.epoch = kEpoch, .first_tick = first - lost},
          .now = 1'000'000'000,
          .end_tick = written,
          .rows = {body.begin(), body.end()}};
}

TEST(PastRowsReading, AsksForTheAgeFirstAndThenForTheNextPage) {
  Reading one;
  EXPECT_EQ(one.reading.NextRequest().epoch, 0U);
  EXPECT_EQ(one.reading.NextRequest().last, 30s);

  EXPECT_TRUE(one.Take(Page(100, 104, 106, 0)));

  EXPECT_EQ(one.reading.NextRequest().epoch, kEpoch);
  EXPECT_EQ(one.reading.NextRequest().first_tick, 104U);
  EXPECT_EQ(one.reading.NextRequest().rows_before, 4U);
  EXPECT_FALSE(one.outcome);
}

TEST(PastRowsReading, DeliversAllPagesInOrderAndEndsWithTheRowsOfItsBegin) {
  Reading one;

  EXPECT_TRUE(one.Take(Page(100, 104, 106, 0)));
  EXPECT_FALSE(one.Take(Page(104, 107, 109, 4)));

  EXPECT_EQ(one.sink->subscribed, 1);
  EXPECT_EQ(one.sink->ticks, (std::vector<std::uint64_t>{100, 101, 102, 103, 104, 105, 106}));
  ASSERT_TRUE(one.outcome);
  EXPECT_FALSE(one.outcome->failure);
  EXPECT_EQ(one.outcome->rows, 7U);
  EXPECT_EQ(one.outcome->lost, 0U);
  EXPECT_EQ(one.outcome->reach, 900ms);
}

TEST(PastRowsReading, AnEmptyTableReachesNowhere) {
  Reading one;

  EXPECT_FALSE(one.Take(Page(0, 0, 0, 0)));

  ASSERT_TRUE(one.outcome);
  EXPECT_FALSE(one.outcome->failure);
  EXPECT_EQ(one.outcome->rows, 0U);
  EXPECT_EQ(one.outcome->reach, 0ns);
}

TEST(PastRowsReading, CountsRowsThatWereOverwrittenMeanwhile) {
  Reading one;
  EXPECT_TRUE(one.Take(Page(100, 104, 120, 0)));

  EXPECT_FALSE(one.Take(Page(110, 120, 130, 4, 6)));

  ASSERT_TRUE(one.outcome);
  EXPECT_FALSE(one.outcome->failure);
  EXPECT_EQ(one.outcome->lost, 6U);
  EXPECT_EQ(one.sink->lost.table, 6U);
}

TEST(PastRowsReading, APageThatDoesNotGoOnIsRefused) {
  Reading one;
  EXPECT_TRUE(one.Take(Page(100, 104, 120, 0)));

  EXPECT_FALSE(one.Take(Page(104, 104, 120, 4))) << "it would never end";

  ASSERT_TRUE(one.outcome && one.outcome->failure);
  EXPECT_EQ(one.outcome->failure->message, "process 'robot' sent invalid rows of its history");
}

TEST(PastRowsReading, AMalformedPageIsRefused) {
  Reading one;
  message::ReadRowsReply page = Page(100, 104, 120, 0);
  page.rows.resize(page.rows.size() - 1);

  EXPECT_FALSE(one.Take(page));

  ASSERT_TRUE(one.outcome);
  EXPECT_TRUE(one.outcome->failure);
}

TEST(PastRowsReading, AnErrorEndsItAndLeavesWhatWasRead) {
  Reading one;
  EXPECT_TRUE(one.Take(Page(100, 104, 106, 0)));

  one.reading.Fail({ErrorCode::kUnreachable, "the process is gone"});

  ASSERT_TRUE(one.outcome && one.outcome->failure);
  EXPECT_EQ(one.outcome->failure->code, ErrorCode::kUnreachable);
  EXPECT_EQ(one.outcome->rows, 4U);
  EXPECT_EQ(one.outcome->reach, 900ms);
}

TEST(PastRowsReading, AfterItsEndNeitherTheSinkNorDoneIsCalled) {
  Reading one;
  EXPECT_TRUE(one.Take(Page(100, 104, 106, 0)));

  one.reading.End();
  (void)one.Take(Page(104, 106, 106, 4));
  one.reading.Fail({ErrorCode::kUnreachable, "too late"});

  EXPECT_EQ(one.sink->ticks.size(), 4U);
  EXPECT_FALSE(one.outcome);
}

}  // namespace
}  // namespace tendon
