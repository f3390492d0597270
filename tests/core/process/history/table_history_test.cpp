#include <gtest/gtest.h>
#include <support/machine/scarce_memory.h>
#include <tendon/payload/codec.h>
#include <tendon/process/history/kept_rows.h>
#include <tendon/process/history/table_history.h>
#include <tendon/state/state_table.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace tendon {
namespace {

using namespace std::chrono_literals;

/// A table of three columns that the test writes, one row a millisecond, and its history.
class TableHistoryTest : public testing::Test {
 protected:
  explicit TableHistoryTest(std::size_t most = std::size_t{32} << 20U) : memory(most) {
    table.Add(number, "Number");
    table.Add(text, "Text", 64);
    table.Add(joints, "Joints");
    table.SetLength(kLength);
    table.Prepare();
  }

  void Write(std::uint64_t rows) {
    for (std::uint64_t i = 0; i < rows; ++i) {
      number = table.next_tick();
      text.assign(number % 40, 'x');
      joints.fill(0.5 * static_cast<double>(number));
      now += 1ms;
      table.Advance(now);
    }
  }
  void Gather() {
    while (history.Gather(now)) {
    }
  }
  /// The ticks of all rows from `from` on; checks the cells.
  std::vector<std::uint64_t> ReadSince(SteadyTime from) {
    KeptRows rows(table, &history);
    std::vector<std::uint64_t> ticks;
    const std::uint64_t end = table.next_tick();
    std::uint64_t tick = rows.FirstTick(from);
    while ((tick = rows.Read(tick, end)) < end) {
      EXPECT_EQ(DecodeAs<std::uint64_t>(rows.cell(0)), tick);
      EXPECT_EQ(DecodeAs<std::string>(rows.cell(1)).size(), tick % 40);
      EXPECT_EQ((DecodeAs<std::array<double, 3>>(rows.cell(2))[2]),
                0.5 * static_cast<double>(tick));
      EXPECT_EQ(rows.time(), (begin + (tick + 1) * 1ms).time_since_epoch().count());
      ticks.push_back(tick++);
    }
    return ticks;
  }
  template <typename T>
  static T DecodeAs(std::span<const std::byte> cell) {
    T value{};
    EXPECT_TRUE(Decode(cell, value));
    return value;
  }
  static std::vector<std::uint64_t> Sequence(std::uint64_t first, std::uint64_t end) {
    std::vector<std::uint64_t> ticks;
    for (std::uint64_t tick = first; tick < end; ++tick) ticks.push_back(tick);
    return ticks;
  }

  static constexpr std::size_t kLength = 1000;
  const SteadyTime begin{1h};
  SteadyTime now = begin;
  std::uint64_t number = 0;
  std::string text;
  std::array<double, 3> joints{};
  StateTable table;
  HistoryMemory memory;
  TableHistory history{"arm", table, memory, 30s};
};

TEST_F(TableHistoryTest, TenSecondsAtOneKilohertzAreOneGaplessSeries) {
  for (int i = 0; i < 20; ++i) {
    Write(500);
    if (i < 19) Gather();  // the last rows are only in the table
  }

  EXPECT_EQ(ReadSince(now - 10s), Sequence(0, 10'000));
  EXPECT_EQ(ReadSince(now - 5s), Sequence(4'999, 10'000)) << "the first row is 5 s old";
  EXPECT_EQ(history.missed(), 0U);
}

TEST_F(TableHistoryTest, RowsThatAreOnlyInTheTableAreRead) {
  Write(700);

  EXPECT_EQ(ReadSince(begin), Sequence(0, 700));
  EXPECT_EQ(ReadSince(now + 1ms), Sequence(0, 0));
}

TEST_F(TableHistoryTest, RowsThatWereOverwrittenBeforeTheyWereCopiedAreCounted) {
  Write(100);
  Gather();
  Write(5000);
  const std::uint64_t oldest = table.oldest_tick();
  Gather();

  EXPECT_EQ(history.missed(), oldest - 100);
  auto expected = Sequence(0, 100);
  const auto rest = Sequence(oldest, 5100);
  expected.insert(expected.end(), rest.begin(), rest.end());
  EXPECT_EQ(ReadSince(begin), expected);
}

TEST_F(TableHistoryTest, ARowWithoutMemoryIsCounted) {
  Write(1);
  Gather();
  text.assign(50, 'x');  // the copy of this row needs more memory
  now += 1ms;
  table.Advance(now);
  {
    const ScarceMemory scarce(32);
    Gather();
  }
  Write(1);
  Gather();

  EXPECT_EQ(history.missed(), 1U);
  EXPECT_EQ(history.ring().From(1).Next()->number, 2U);
}

TEST_F(TableHistoryTest, ATickThatTheWriterLeavesOutCostsNoOtherRow) {
  Write(100);
  Gather();
  number = 200;  // as in a replay of a recording with losses
  text.assign(number % 40, 'x');
  joints.fill(0.5 * static_cast<double>(number));
  now = begin + 201ms;
  table.AdvanceTo(number, now);
  Write(300);
  Gather();

  auto expected = Sequence(0, 100);
  const auto rest = Sequence(200, 501);
  expected.insert(expected.end(), rest.begin(), rest.end());
  EXPECT_EQ(ReadSince(begin), expected);
  std::vector<std::uint64_t> kept;
  HistoryRing::Cursor cursor = history.ring().From(0);
  while (const auto record = cursor.Next()) kept.push_back(record->number);
  EXPECT_EQ(kept, expected);
}

TEST_F(TableHistoryTest, ATableWithoutRowsHasNothing) {
  Gather();

  EXPECT_EQ(ReadSince(begin), Sequence(0, 0));
  EXPECT_EQ(memory.used(), 0U);
}

TEST_F(TableHistoryTest, WaitsAtMostAQuarterOfTheTimeInWhichTheTableIsOverwritten) {
  Write(2000);
  Gather();
  Write(100);
  Gather();

  EXPECT_GT(history.until_next_read(), 150ms);
  EXPECT_LE(history.until_next_read(), 260ms) << "1000 to 1023 rows, one a millisecond";

  now += 1s;
  Gather();
  EXPECT_EQ(history.until_next_read(), std::chrono::nanoseconds::max()) << "there were no rows";
}

/// Memory for about a second.
class FullTableHistory : public TableHistoryTest {
 protected:
  FullTableHistory() : TableHistoryTest(std::size_t{128} << 10U) {}
};

TEST_F(FullTableHistory, TheTableGoesOnWhereTheHistoryWasCut) {
  for (int i = 0; i < 20; ++i) {
    Write(500);
    Gather();
    ASSERT_LE(memory.used(), memory.limit());
  }

  const auto ticks = ReadSince(begin);

  ASSERT_FALSE(ticks.empty());
  EXPECT_EQ(ticks, Sequence(ticks.front(), 10'000));
  EXPECT_GT(history.ring().dropped(), 0U);
  EXPECT_EQ(history.missed(), 0U) << "these are rows that were copied";
}

}  // namespace
}  // namespace tendon
