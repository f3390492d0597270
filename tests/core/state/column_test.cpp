#include <core/state/sample.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/allocation_guard.h>
#include <tendon/state/state_table.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace tendon {
namespace {

using namespace std::chrono_literals;
using test::Gear;
using test::Report;
using test::Sample;
using test::TimeOf;
using testing::ElementsAre;

/// A table of few rows with the column "Sample". Its field count is the tick of the row.
class ColumnTest : public testing::Test {
 protected:
  ColumnTest() {
    table_.Add(sample_, "Sample");
    table_.SetLength(7);
  }
  void Advance(std::uint64_t rows) {
    for (std::uint64_t i = 0; i < rows; ++i) {
      sample_.count = static_cast<std::int32_t>(table_.next_tick());
      table_.Advance(TimeOf(table_.next_tick()));
    }
  }
  const Column<Sample>& column() const { return table_.Find(sample_); }

  StateTable table_;
  Sample sample_{.position = {1, 2, 3}, .mode = 4, .count = 0};
  Sample read_{.position = {}, .mode = 0, .count = -1};
};

TEST_F(ColumnTest, HasNoSampleBeforeTheFirstRow) {
  EXPECT_EQ(column().ReadNewest(read_), Status::kNoSample);
  EXPECT_EQ(column().ReadAt(0, read_), RowResult::kNotYet);
  EXPECT_EQ(column().ReadDelayed(0, read_), RowResult::kNotYet);
  EXPECT_EQ(column().ReadAtTime(TimeOf(0), read_), RowResult::kNotYet);
  EXPECT_EQ(read_.count, -1);
}

TEST_F(ColumnTest, ReadsTheNewestRowWithItsTickAndTime) {
  Advance(3);
  RowStamp stamp;

  EXPECT_EQ(column().ReadNewest(read_, stamp), Status::kDone);

  EXPECT_EQ(read_, sample_);
  EXPECT_EQ(stamp, (RowStamp{2, TimeOf(2)}));
}

TEST_F(ColumnTest, IgnoresChangesAfterTheRow) {
  Advance(1);
  sample_.count = 99;
  EXPECT_EQ(column().ReadNewest(read_), Status::kDone);
  EXPECT_EQ(read_.count, 0);
}

TEST_F(ColumnTest, ReadsByTick) {
  Advance(20);
  EXPECT_EQ(column().ReadAt(15, read_), RowResult::kDone);
  EXPECT_EQ(read_.count, 15);
  EXPECT_EQ(column().ReadAt(20, read_), RowResult::kNotYet);
  EXPECT_EQ(column().ReadAt(2, read_), RowResult::kOvertaken);
  EXPECT_EQ(read_.count, 15);
}

/// In cisst, a delayed read does not advance while the writer passes the end of the ring.
TEST_F(ColumnTest, ADelayedReadAdvancesThroughTheWrap) {
  constexpr std::size_t kDelay = 5;
  Advance(kDelay);
  EXPECT_EQ(column().ReadDelayed(kDelay, read_), RowResult::kNotYet);
  for (std::int32_t expected = 0; expected < 100; ++expected) {
    Advance(1);
    ASSERT_EQ(column().ReadDelayed(kDelay, read_), RowResult::kDone);
    ASSERT_EQ(read_.count, expected);
  }
}

TEST_F(ColumnTest, ReportsADelayBeyondTheRing) {
  Advance(100);
  EXPECT_EQ(column().ReadDelayed(50, read_), RowResult::kOvertaken);
}

TEST_F(ColumnTest, ReadsTheValueAtATime) {
  Advance(20);

  EXPECT_EQ(column().ReadAtTime(TimeOf(17), read_), RowResult::kDone);
  EXPECT_EQ(read_.count, 17);
  EXPECT_EQ(column().ReadAtTime(TimeOf(17) - 1ns, read_), RowResult::kDone);
  EXPECT_EQ(read_.count, 16);
  EXPECT_EQ(column().ReadAtTime(TimeOf(1000), read_), RowResult::kDone);
  EXPECT_EQ(read_.count, 19);
  EXPECT_EQ(column().ReadAtTime(TimeOf(3), read_), RowResult::kOvertaken);
}

TEST_F(ColumnTest, ReadsEveryRowSinceATick) {
  std::vector<std::int32_t> counts;
  std::uint64_t lost = 0;
  std::uint64_t tick = 0;
  for (const std::uint64_t rows : {1, 0, 3, 7, 2}) {
    Advance(rows);
    tick = column().ReadSince(tick, read_, lost, [&](const RowStamp& stamp, const Sample& sample) {
      EXPECT_EQ(stamp, (RowStamp{counts.size(), TimeOf(counts.size())}));
      counts.push_back(sample.count);
    });
  }

  EXPECT_EQ(tick, 13U);
  EXPECT_EQ(lost, 0U);
  EXPECT_THAT(counts, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12));
}

TEST_F(ColumnTest, CountsLostRowsSinceATick) {
  Advance(100);
  std::uint64_t lost = 0;
  std::uint64_t visited = 0;

  const auto visit = [&](const RowStamp& stamp, const Sample& sample) {
    EXPECT_EQ(static_cast<std::uint64_t>(sample.count), stamp.tick);
    ++visited;
  };
  EXPECT_EQ(column().ReadSince(10, read_, lost, visit), 100U);

  EXPECT_GE(visited, 7U);
  EXPECT_EQ(lost + visited, 90U);
}

TEST_F(ColumnTest, ReadingSinceAFutureTickReturnsNothing) {
  Advance(5);
  std::uint64_t lost = 0;
  const auto next =
      column().ReadSince(8, read_, lost, [](const auto&, const auto&) { FAIL() << "a row"; });
  EXPECT_EQ(next, 8U);
  EXPECT_EQ(lost, 0U);
}

TEST_F(ColumnTest, ReadsARangeOfRows) {
  Advance(6);
  std::vector<std::int32_t> counts;
  std::uint64_t lost = 0;
  const auto visit = [&](const RowStamp& /*stamp*/, const Sample& sample) {
    counts.push_back(sample.count);
  };

  EXPECT_EQ(column().ReadRange(2, 4, read_, lost, visit), 4U);
  EXPECT_EQ(column().ReadRange(5, 9, read_, lost, visit), 6U) << "those to come are left";
  EXPECT_EQ(column().ReadRange(4, 2, read_, lost, visit), 4U);

  EXPECT_THAT(counts, ElementsAre(2, 3, 5));
  EXPECT_EQ(lost, 0U);
}

TEST_F(ColumnTest, CountsOnlyTheLostRowsOfARange) {
  Advance(100);
  std::uint64_t lost = 0;
  const auto visit = [](const auto&, const auto&) { FAIL() << "a row"; };
  EXPECT_EQ(column().ReadRange(10, 40, read_, lost, visit), 40U);
  EXPECT_EQ(lost, 30U);
}

TEST_F(ColumnTest, ReadsTheRowsOfATimeSpan) {
  Advance(7);
  std::uint64_t first = 0;
  std::uint64_t last = 0;
  ASSERT_EQ(table_.FindRow(TimeOf(3), first), RowResult::kDone);
  ASSERT_EQ(table_.FindRow(TimeOf(5) + 1ns, last), RowResult::kDone);

  std::vector<std::int32_t> counts;
  std::uint64_t lost = 0;
  column().ReadRange(first, last + 1, read_, lost,
                     [&](const auto&, const Sample& sample) { counts.push_back(sample.count); });

  EXPECT_THAT(counts, ElementsAre(3, 4, 5));
}

TEST_F(ColumnTest, ReadingAFixedPayloadAllocatesNothing) {
  Advance(20);
  std::uint64_t lost = 0;
  const auto& samples = column();

  const AllocationGuard guard;
  EXPECT_EQ(samples.ReadNewest(read_), Status::kDone);
  EXPECT_EQ(samples.ReadDelayed(3, read_), RowResult::kDone);
  EXPECT_EQ(samples.ReadAtTime(TimeOf(18), read_), RowResult::kDone);
  samples.ReadSince(0, read_, lost, [](const auto&, const auto&) {});
}

TEST(Column, ReadingADynamicPayloadAllocatesNothingOnceWarm) {
  Report report{.text = std::string(40, 'x'), .values = {1, 2, 3}};
  StateTable table;
  table.Add(report, "Report", 200);
  table.Advance(TimeOf(0));
  Report read;
  EXPECT_EQ(table.Find(report).ReadNewest(read), Status::kDone);
  report = {.text = std::string(30, 'y'), .values = {4}};
  table.Advance(TimeOf(1));

  {
    const AllocationGuard guard;
    EXPECT_EQ(table.Find(report).ReadNewest(read), Status::kDone);
  }

  EXPECT_EQ(read, report);
}

/// An array of plain numbers has the same layout in memory as on the wire, so it is read without an
/// intermediate copy.
TEST(Column, ReadsAnArrayOfPlainNumbers) {
  std::array<double, 9> plain{1, 2, 3, 4, 5, 6, 7, 8, 9};
  StateTable table;
  table.Add(plain, "Plain");
  std::array<double, 9> read{-1};
  EXPECT_EQ(table.Find(plain).ReadNewest(read), Status::kNoSample);
  EXPECT_EQ(read[0], -1);
  table.Advance(TimeOf(0));

  RowStamp stamp;
  EXPECT_EQ(table.Find(plain).ReadNewest(read, stamp), Status::kDone);

  EXPECT_EQ(read, plain);
  EXPECT_EQ(stamp, (RowStamp{0, TimeOf(0)}));
}

TEST(Column, ReportsAnInvalidEnumValue) {
  auto gear = static_cast<Gear>(77);
  StateTable table;
  table.Add(gear, "Gear");
  table.Advance(TimeOf(0));

  Gear read = Gear::kLow;
  EXPECT_EQ(table.Find(gear).ReadNewest(read), Status::kInvalid);
  EXPECT_EQ(table.Find(gear).ReadAt(0, read), RowResult::kInvalid);
}

TEST(Column, HoldsEveryKindOfScalar) {
  bool flag = true;
  std::int8_t small = -3;
  float real = 2.5F;
  Gear gear = Gear::kHigh;
  StateTable table;
  table.Add(flag, "Flag");
  table.Add(small, "Small");
  table.Add(real, "Real");
  table.Add(gear, "Gear");
  table.Advance(TimeOf(0));

  bool read_flag = false;
  std::int8_t read_small = 0;
  float read_real = 0;
  Gear read_gear = Gear::kLow;
  EXPECT_EQ(table.Find(flag).ReadNewest(read_flag), Status::kDone);
  EXPECT_EQ(table.Find(small).ReadNewest(read_small), Status::kDone);
  EXPECT_EQ(table.Find(real).ReadNewest(read_real), Status::kDone);
  EXPECT_EQ(table.Find(gear).ReadNewest(read_gear), Status::kDone);
  EXPECT_TRUE(read_flag);
  EXPECT_EQ(read_small, -3);
  EXPECT_EQ(read_real, 2.5F);
  EXPECT_EQ(read_gear, Gear::kHigh);
}

}  // namespace
}  // namespace tendon
