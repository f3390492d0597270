#include <core/state/sample.h>
#include <gtest/gtest.h>
#include <support/allocation_guard.h>
#include <tendon/state/row_copy.h>

#include <string>

namespace tendon {
namespace {

using test::Gear;
using test::Report;
using test::Sample;
using test::TimeOf;

/// A table with three columns. The value of each column is the tick of the row.
class RowCopyTest : public testing::Test {
 protected:
  RowCopyTest() {
    table_.Add(sample_, "Sample");
    table_.Add(report_, "Report", 100);
    table_.Add(number_, "Number");
    table_.SetLength(7);
  }
  void Advance(int rows) {
    for (int i = 0; i < rows; ++i) {
      const std::uint64_t tick = table_.next_tick();
      sample_.count = static_cast<std::int32_t>(tick);
      report_.text = "row " + std::to_string(tick);
      number_ = static_cast<double>(tick);
      table_.Advance(TimeOf(tick));
    }
  }
  void ExpectRow(const RowCopy& row, std::uint64_t tick) const {
    Sample sample;
    Report report;
    double number = -1;
    EXPECT_EQ(row.stamp(), (RowStamp{tick, TimeOf(tick)}));
    EXPECT_EQ(row.Get(table_.Find(sample_), sample), RowResult::kDone);
    EXPECT_EQ(row.Get(table_.Find(report_), report), RowResult::kDone);
    EXPECT_EQ(row.Get(table_.Find(number_), number), RowResult::kDone);
    EXPECT_EQ(sample.count, static_cast<std::int32_t>(tick));
    EXPECT_EQ(report.text, "row " + std::to_string(tick));
    EXPECT_EQ(number, static_cast<double>(tick));
  }

  StateTable table_;
  Sample sample_;
  Report report_;
  double number_ = 0;
};

TEST_F(RowCopyTest, HasNoValuesBeforeTheFirstRow) {
  RowCopy row(table_);
  double number = -1;
  EXPECT_EQ(row.ReadNewest(), Status::kNoSample);
  EXPECT_EQ(row.ReadAt(0), RowResult::kNotYet);
  EXPECT_EQ(row.ReadAtTime(TimeOf(0)), RowResult::kNotYet);
  EXPECT_EQ(row.Get(table_.Find(number_), number), RowResult::kNotYet);
  EXPECT_EQ(number, -1);
}

TEST_F(RowCopyTest, ReturnsAllColumnsOfTheNewestRow) {
  Advance(5);
  RowCopy row(table_);
  ASSERT_EQ(row.ReadNewest(), Status::kDone);
  Advance(20);
  ExpectRow(row, 4);
}

TEST_F(RowCopyTest, ReturnsARowByTickAndByTime) {
  Advance(20);
  RowCopy row(table_);
  ASSERT_EQ(row.ReadAt(15), RowResult::kDone);
  ExpectRow(row, 15);
  ASSERT_EQ(row.ReadAtTime(TimeOf(17) + std::chrono::nanoseconds(1)), RowResult::kDone);
  ExpectRow(row, 17);
}

TEST_F(RowCopyTest, ALostRowHasNoValues) {
  Advance(20);
  RowCopy row(table_);
  ASSERT_EQ(row.ReadNewest(), Status::kDone);
  double number = -1;

  EXPECT_EQ(row.ReadAt(3), RowResult::kOvertaken);
  EXPECT_EQ(row.Get(table_.Find(number_), number), RowResult::kNotYet);
  ASSERT_EQ(row.ReadNewest(), Status::kDone);
  EXPECT_EQ(row.ReadAtTime(TimeOf(3)), RowResult::kOvertaken);
  EXPECT_EQ(row.Get(table_.Find(number_), number), RowResult::kNotYet);
  EXPECT_EQ(number, -1);
}

TEST_F(RowCopyTest, DistinguishesAbsentFromInvalidValues) {
  StateTable table;
  auto gear = static_cast<Gear>(77);
  std::string text(1000, 'x');
  table.Add(gear, "Gear");
  table.Add(text, "Text", 10);
  table.Advance(TimeOf(0));

  RowCopy row(table);
  Gear read = Gear::kLow;
  ASSERT_EQ(row.ReadNewest(), Status::kDone);
  EXPECT_EQ(row.Get(table.Find(gear), read), RowResult::kInvalid);
  EXPECT_EQ(row.Get(table.Find(text), text), RowResult::kAbsent);
}

TEST_F(RowCopyTest, AllocatesNothingOnceMade) {
  Advance(20);
  RowCopy row(table_);
  Sample sample;

  const AllocationGuard guard;
  EXPECT_EQ(row.ReadNewest(), Status::kDone);
  EXPECT_EQ(row.ReadAt(18), RowResult::kDone);
  EXPECT_EQ(row.Get(table_.Find(sample_), sample), RowResult::kDone);
}

}  // namespace
}  // namespace tendon
