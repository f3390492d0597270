#include <core/state/sample.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/allocation_guard.h>
#include <support/refusal.h>
#include <tendon/state/state_table.h>

#include <chrono>
#include <string>
#include <vector>

namespace tendon {
namespace {

using namespace std::chrono_literals;
using test::Refusal;
using test::Report;
using test::Sample;
using test::TimeOf;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class StateTableTest : public testing::Test {
 protected:
  void AddBoth() {
    table_.Add(sample_, "Sample");
    table_.Add(number_, "Number");
  }
  void Advance() { table_.Advance(TimeOf(table_.next_tick())); }

  StateTable table_;
  Sample sample_;
  double number_ = 0;
  Report report_;
};

TEST_F(StateTableTest, IsNamedStateByDefault) {
  EXPECT_EQ(table_.name(), "state");
  EXPECT_EQ(StateTable("slow").name(), "slow");
  EXPECT_THAT(Refusal([] { StateTable("not a name"); }), HasSubstr("not a name"));
}

TEST_F(StateTableTest, HasAUniqueEpoch) { EXPECT_NE(table_.epoch(), StateTable().epoch()); }

TEST_F(StateTableTest, DescribesItsColumns) {
  AddBoth();
  table_.Add(report_, "Report", 100);

  const auto columns = table_.columns();
  ASSERT_EQ(columns.size(), 3U);
  EXPECT_EQ(columns[0]->name(), "Sample");
  EXPECT_EQ(columns[0]->fingerprint(), FingerprintOf<Sample>());
  EXPECT_EQ(columns[0]->schema(), SchemaOf<Sample>());
  EXPECT_EQ(columns[0]->layout(), (CellLayout{.offset = 0, .words = 4, .bytes = 32}));
  EXPECT_EQ(columns[1]->layout(), (CellLayout{.offset = 4, .words = 1, .bytes = 8}));
  EXPECT_EQ(columns[2]->layout(),
            (CellLayout{.offset = 5, .words = 14, .bytes = 100, .is_dynamic = true}));
  EXPECT_EQ(table_.row_words(), 19U);
}

TEST_F(StateTableTest, FindsAColumnByVariableAndByName) {
  AddBoth();

  EXPECT_EQ(table_.Find(number_).name(), "Number");
  EXPECT_EQ(table_.Find("Number"), &table_.Find(number_));
  EXPECT_EQ(table_.Find("number"), nullptr);
}

TEST_F(StateTableTest, RefusesAVariableThatIsNotAColumn) {
  AddBoth();
  const double other = 0;
  EXPECT_THAT(Refusal([&] { (void)table_.Find(other); }),
              HasSubstr("is not a column of state table 'state'"));
}

TEST_F(StateTableTest, TheFirstMemberOfAColumnIsNotThatColumn) {
  AddBoth();
  EXPECT_THAT(Refusal([&] { (void)table_.Find(sample_.position); }), HasSubstr("is not a column"));
}

TEST_F(StateTableTest, RefusesADuplicateColumnNameOrVariable) {
  AddBoth();
  const double other = 0;
  EXPECT_THAT(Refusal([&] { table_.Add(other, "Number"); }), HasSubstr("'Number' already"));
  EXPECT_THAT(Refusal([&] { table_.Add(number_, "Other"); }),
              AllOf(HasSubstr("'Other'"), HasSubstr("'Number'")));
  EXPECT_THAT(Refusal([&] { table_.Add(other, "two words"); }), HasSubstr("two words"));
  EXPECT_EQ(table_.columns().size(), 2U);
}

/// In cisst, adding a column to a table in use writes beyond its memory.
TEST_F(StateTableTest, RefusesColumnsOnceItIsPrepared) {
  AddBoth();
  table_.Prepare();

  EXPECT_EQ(
      Refusal([&] { table_.Add(report_, "Report", 100); }),
      "cannot add column 'Report' to state table 'state' (sealed): add it in the constructor");
  Advance();
  EXPECT_THAT(Refusal([&] { table_.Add(report_, "Report", 100); }), HasSubstr("'Report'"));

  EXPECT_EQ(table_.columns().size(), 2U);
  EXPECT_EQ(table_.row_words(), 5U);
}

TEST_F(StateTableTest, MayBeLengthenedUntilRowsAreWritten) {
  constexpr std::size_t kLonger = 2000;
  table_.Add(number_, "Number");
  table_.Prepare();
  table_.SetLength(kLonger);
  for (std::size_t i = 0; i < kLonger; ++i) {
    number_ = static_cast<double>(i);
    Advance();
  }

  double value = -1;
  EXPECT_EQ(table_.Find(number_).ReadAt(0, value), RowResult::kDone);
  EXPECT_EQ(value, 0);
  EXPECT_THAT(Refusal([&] { table_.SetLength(2 * kLonger); }),
              AllOf(HasSubstr("already holds rows"), HasSubstr("before the component starts")));
}

TEST_F(StateTableTest, RefusesALengthOutOfRange) {
  EXPECT_THAT(Refusal([&] { table_.SetLength(0); }), HasSubstr("cannot keep 0 rows"));
  EXPECT_THAT(Refusal([&] { table_.SetLength(~std::size_t{0}); }), HasSubstr("give 1 to 16777216"));
}

TEST_F(StateTableTest, RefusesAColumnThatExceedsTheRowLimit) {
  constexpr std::size_t kMax = StateTable::kMaximumRowBytes;
  EXPECT_THAT(Refusal([&] { table_.Add(report_, "Report", kMax + 1); }),
              AllOf(HasSubstr("'Report'"), HasSubstr("smaller capacity")));
  EXPECT_THAT(Refusal([&] { table_.Add(report_, "Report", ~std::size_t{0}); }),
              HasSubstr("smaller capacity"));
  table_.Add(report_, "Report", kMax);
  EXPECT_THAT(Refusal([&] { table_.Add(number_, "Number"); }), HasSubstr("'Number'"));
  EXPECT_EQ(table_.columns().size(), 1U);
}

TEST_F(StateTableTest, ByDefaultNeedsAtMost16MiB) {
  table_.Add(report_, "Report", 1 << 20);
  for (int i = 0; i < 30; ++i) Advance();
  EXPECT_EQ(table_.oldest_tick(), 30U - 7U);
}

TEST_F(StateTableTest, KeepsTheConfiguredNumberOfRows) {
  AddBoth();
  table_.SetLength(1000);
  for (int i = 0; i < 5000; ++i) {
    number_ = i;
    Advance();
  }

  double value = 0;
  EXPECT_EQ(table_.length(), 1000U);
  EXPECT_EQ(table_.next_tick(), 5000U);
  EXPECT_LE(table_.oldest_tick(), 4000U);
  EXPECT_EQ(table_.Find(number_).ReadAt(table_.oldest_tick(), value), RowResult::kDone);
  EXPECT_EQ(value, static_cast<double>(table_.oldest_tick()));
}

TEST_F(StateTableTest, ByDefaultKeeps256Rows) {
  table_.Add(number_, "Number");
  for (int i = 0; i < 1000; ++i) Advance();
  EXPECT_LE(table_.oldest_tick(), 1000U - 256U);
}

TEST_F(StateTableTest, SuggestsOneSecondOfRowsWithinBounds) {
  table_.Add(number_, "Number");
  EXPECT_EQ(table_.LengthFor(1ms), 1000U);
  EXPECT_EQ(table_.LengthFor(50ms), 256U);
  EXPECT_EQ(table_.LengthFor(0ns), 256U);
  EXPECT_EQ(table_.LengthFor(1ns), (std::size_t{16} << 20) / 64 - 1);

  table_.Add(report_, "Report", 1 << 20);
  EXPECT_EQ(table_.LengthFor(1ms), 7U);
  EXPECT_EQ(StateTable::LengthFor(1ms, (1 << 20) + 16), 7U);
}

TEST_F(StateTableTest, AllColumnsOfARowBelongToOneCycle) {
  AddBoth();
  for (int i = 0; i < 10; ++i) {
    sample_.count = i;
    number_ = i;
    Advance();
  }

  Sample sample;
  double number = 0;
  EXPECT_EQ(table_.Find(sample_).ReadAt(4, sample), RowResult::kDone);
  EXPECT_EQ(table_.Find(number_).ReadAt(4, number), RowResult::kDone);
  EXPECT_EQ(sample.count, 4);
  EXPECT_EQ(number, 4);
}

TEST_F(StateTableTest, CopiesARowThatDecodesCellByCell) {
  AddBoth();
  table_.Add(report_, "Report", 100);
  sample_ = {.position = {1, 2, 3}, .mode = 4, .count = 5};
  number_ = 6;
  report_ = {.text = "seven", .values = {8, 9}};
  Advance();

  std::vector<std::uint64_t> words(table_.row_words());
  std::int64_t time = 0;
  ASSERT_EQ(table_.CopyRow(0, words, time), RowResult::kDone);

  Sample sample;
  double number = 0;
  Report report;
  EXPECT_EQ(SteadyTime(std::chrono::nanoseconds(time)), TimeOf(0));
  EXPECT_EQ(table_.cell(words, 0).size(), 32U);
  EXPECT_TRUE(Decode(table_.cell(words, 0), sample));
  EXPECT_TRUE(Decode(table_.cell(words, 1), number));
  EXPECT_TRUE(Decode(table_.cell(words, 2), report));
  EXPECT_EQ(sample, sample_);
  EXPECT_EQ(number, number_);
  EXPECT_EQ(report, report_);
}

TEST_F(StateTableTest, DistinguishesFutureFromLostRows) {
  table_.Add(number_, "Number");
  table_.SetLength(3);
  std::vector<std::uint64_t> words(table_.row_words());
  std::int64_t time = 0;
  EXPECT_EQ(table_.CopyRow(0, words, time), RowResult::kNotYet);

  for (int i = 0; i < 10; ++i) Advance();

  EXPECT_EQ(table_.CopyRow(0, words, time), RowResult::kOvertaken);
  EXPECT_EQ(table_.CopyRow(9, words, time), RowResult::kDone);
  EXPECT_EQ(table_.CopyRow(10, words, time), RowResult::kNotYet);
}

TEST_F(StateTableTest, CountsItsRowsWithoutColumns) {
  Advance();
  Advance();
  std::int64_t time = 0;
  EXPECT_EQ(table_.CopyRow(1, {}, time), RowResult::kDone);
  EXPECT_EQ(SteadyTime(std::chrono::nanoseconds(time)), TimeOf(1));
}

TEST_F(StateTableTest, AValueOverItsCapacityIsAbsentAndCounted) {
  AddBoth();
  table_.Add(report_, "Report", 64);
  report_.text = std::string(20, 'a');
  Advance();
  number_ = 1;
  report_.text = std::string(1000, 'b');
  Advance();

  Report report{.text = "before", .values = {}};
  double number = 0;
  std::vector<std::uint64_t> words(table_.row_words());
  std::int64_t time = 0;
  EXPECT_EQ(table_.Find(report_).absent(), 1U);
  EXPECT_EQ(table_.Find(report_).ReadNewest(report), Status::kNoSample);
  EXPECT_EQ(table_.Find(report_).ReadAt(1, report), RowResult::kAbsent);
  EXPECT_EQ(report.text, "before");
  EXPECT_EQ(table_.CopyRow(1, words, time), RowResult::kDone);
  EXPECT_THAT(table_.cell(words, 2), IsEmpty());
  EXPECT_EQ(table_.Find(number_).ReadNewest(number), Status::kDone) << "other columns are there";
  EXPECT_EQ(number, 1);
}

TEST_F(StateTableTest, ALaterFittingValueIsPresent) {
  table_.Add(report_, "Report", 64);
  report_.text = std::string(1000, 'b');
  Advance();
  report_.text = "short";
  Advance();

  Report report;
  EXPECT_EQ(table_.Find(report_).ReadNewest(report), Status::kDone);
  EXPECT_EQ(report, report_);
  EXPECT_EQ(table_.Find(report_).absent(), 1U);
}

TEST_F(StateTableTest, AnEncodedColumnHoldsBodiesOfATypeThatIsKnownAtRunTimeOnly) {
  std::vector<std::byte> body;
  table_.AddEncoded(body, SchemaOf<Report>(), "Report", 40);
  table_.SetFirstTick(5);
  const ColumnBase& column = *table_.columns()[0];
  EXPECT_EQ(column.fingerprint(), FingerprintOf<Report>());
  std::vector<std::uint64_t> row(table_.row_words());
  std::int64_t time = 0;
  std::uint64_t tick = 0;
  EXPECT_EQ(table_.CopyNewestRow(tick, row, time), RowResult::kNotYet);

  Encode(report_, body);
  table_.AdvanceTo(5, TimeOf(1));
  ASSERT_EQ(table_.CopyNewestRow(tick, row, time), RowResult::kDone);
  EXPECT_EQ(tick, 5U);
  EXPECT_THAT(table_.cell(row, 0), testing::ElementsAreArray(body));

  body.resize(41);
  table_.AdvanceTo(9, TimeOf(2));
  ASSERT_EQ(table_.CopyNewestRow(tick, row, time), RowResult::kDone);
  EXPECT_EQ(tick, 9U);
  EXPECT_THAT(table_.cell(row, 0), IsEmpty()) << "the value is larger than the capacity";
  EXPECT_EQ(column.absent(), 1U);
  EXPECT_EQ(table_.CopyRow(7, row, time), RowResult::kOvertaken);
  EXPECT_THAT(Refusal([&] { table_.SetFirstTick(0); }), HasSubstr("already holds rows"));
}

TEST_F(StateTableTest, ACycleWritesARowUnlessAdvancedByHand) {
  AddBoth();
  table_.AdvanceAfterCycle(TimeOf(0));
  EXPECT_EQ(table_.next_tick(), 1U);

  table_.AdvanceOnlyByHand();
  table_.AdvanceAfterCycle(TimeOf(1));
  EXPECT_EQ(table_.next_tick(), 1U);
  table_.Advance(TimeOf(2));
  EXPECT_EQ(table_.next_tick(), 2U);
}

TEST_F(StateTableTest, FastCyclesWriteAtMostOneRowPerInterval) {
  AddBoth();
  table_.SetShortestInterval(1ms);
  constexpr int kCycles = 10'000;
  for (int i = 0; i < kCycles; ++i) {
    number_ = i;
    table_.AdvanceAfterCycle(SteadyTime(i * 10us));
  }

  double value = 0;
  EXPECT_EQ(table_.next_tick(), kCycles / 100U);
  EXPECT_EQ(table_.Find(number_).ReadNewest(value), Status::kDone);
  EXPECT_EQ(value, 9900.0);
}

TEST_F(StateTableTest, AdvancingAllocatesNothingOncePrepared) {
  AddBoth();
  table_.Add(report_, "Report", 100);
  report_ = {.text = "a text too long for the string itself", .values = {1, 2}};
  table_.SetLength(4);
  table_.Prepare();

  const AllocationGuard guard;
  for (int i = 0; i < 100; ++i) Advance();
}

}  // namespace
}  // namespace tendon
