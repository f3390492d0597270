#include <core/state/sample.h>
#include <gtest/gtest.h>
#include <tendon/state/row_copy.h>
#include <tendon/state/state_table.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace tendon {
namespace {

using test::TimeOf;

/// A value whose elements are all equal, unless it is torn.
using Block = std::array<std::int64_t, 32>;

bool IsWhole(const Block& block) {
  return std::ranges::all_of(block, [&](std::int64_t element) { return element == block[0]; });
}

/// Writes at full speed to a ring that is far too small, until the test ends.
class FastWriter {
 public:
  explicit FastWriter(std::size_t rows) {
    table_.Add(block_, "Block");
    table_.Add(text_, "Text", 64);
    table_.SetLength(rows);
    table_.Prepare();
    writer_ = std::jthread([this](const std::stop_token& stop) {
      for (std::int64_t n = 0; !stop.stop_requested(); ++n) {
        block_.fill(n);
        text_.assign(static_cast<std::size_t>(n % 50), static_cast<char>('a' + n % 26));
        table_.Advance(TimeOf(static_cast<std::uint64_t>(n)));
      }
    });
    while (table_.next_tick() < 1000) std::this_thread::yield();
  }
  const StateTable& table() const { return table_; }
  const Column<Block>& blocks() const { return table_.Find(block_); }
  const Column<std::string>& texts() const { return table_.Find(text_); }

 private:
  StateTable table_;
  Block block_{};
  std::string text_;
  std::jthread writer_;  // the last member, because it must end before the table
};

TEST(StateTableStress, NewestRowsAreNeverTornAndNeverGoBack) {
  const FastWriter writer(3);
  RowStamp before;
  Block block;
  for (int i = 0; i < 20'000; ++i) {
    RowStamp stamp;
    ASSERT_EQ(writer.blocks().ReadNewest(block, stamp), Status::kDone);
    ASSERT_TRUE(IsWhole(block));
    ASSERT_EQ(static_cast<std::uint64_t>(block[0]), stamp.tick);
    ASSERT_EQ(stamp.time, TimeOf(stamp.tick));
    ASSERT_GE(stamp.tick, before.tick);
    before = stamp;
  }
}

TEST(StateTableStress, ReportsOvertakingToTheReader) {
  const FastWriter writer(3);
  Block block{};
  std::uint64_t overtaken = 0;
  std::uint64_t done = 0;
  while (overtaken < 100 || done < 100) {
    const std::uint64_t tick = writer.table().oldest_tick();
    const RowResult result = writer.blocks().ReadAt(tick, block);
    ASSERT_NE(result, RowResult::kNotYet);
    if (result == RowResult::kDone) {
      ASSERT_TRUE(IsWhole(block));
      ASSERT_EQ(static_cast<std::uint64_t>(block[0]), tick);
      ++done;
    } else {
      ++overtaken;
    }
    // Reads alternately the newest row and a row that was overwritten long ago.
    if (writer.blocks().ReadAt(writer.table().next_tick() - 1, block) == RowResult::kDone) ++done;
    if (writer.blocks().ReadAt(tick / 2, block) == RowResult::kOvertaken) ++overtaken;
  }
}

TEST(StateTableStress, TextsOfAnyLengthAreIntact) {
  const FastWriter writer(3);
  std::string text;
  for (int i = 0; i < 20'000; ++i) {
    RowStamp stamp;
    ASSERT_EQ(writer.texts().ReadNewest(text, stamp), Status::kDone);
    ASSERT_EQ(text, std::string(stamp.tick % 50, static_cast<char>('a' + stamp.tick % 26)));
  }
}

TEST(StateTableStress, AllColumnsOfACopiedRowBelongToOneCycle) {
  const FastWriter writer(3);
  RowCopy row(writer.table());
  Block block;
  std::string text;
  for (int i = 0; i < 20'000; ++i) {
    ASSERT_EQ(row.ReadNewest(), Status::kDone);
    const std::uint64_t tick = row.stamp().tick;
    ASSERT_EQ(row.Get(writer.blocks(), block), RowResult::kDone);
    ASSERT_EQ(row.Get(writer.texts(), text), RowResult::kDone);
    ASSERT_EQ(row.stamp().time, TimeOf(tick));
    ASSERT_TRUE(IsWhole(block));
    ASSERT_EQ(static_cast<std::uint64_t>(block[0]), tick);
    ASSERT_EQ(text, std::string(tick % 50, static_cast<char>('a' + tick % 26)));
  }
}

TEST(StateTableStress, EveryRowSinceATickIsEitherReadOrCounted) {
  const FastWriter writer(255);
  const std::uint64_t first = writer.table().next_tick();
  std::uint64_t tick = first;
  std::uint64_t lost = 0;
  std::uint64_t read = 0;
  Block block;
  while (tick < first + 20'000) {
    tick = writer.blocks().ReadSince(tick, block, lost, [&](const RowStamp& stamp, const Block& b) {
      EXPECT_TRUE(IsWhole(b));
      EXPECT_EQ(static_cast<std::uint64_t>(b[0]), stamp.tick);
      ++read;
    });
  }
  EXPECT_EQ(read + lost, tick - first);
  EXPECT_GT(read, 0U);
}

TEST(StateTableStress, ManyReadersDoNotDisturbEachOther) {
  const FastWriter writer(7);
  std::atomic<int> torn = 0;
  {
    std::array<std::jthread, 3> readers;
    for (auto& reader : readers) {
      reader = std::jthread([&] {
        Block block{};
        for (int i = 0; i < 5'000; ++i) {
          if (writer.blocks().ReadNewest(block) != Status::kDone || !IsWhole(block)) ++torn;
        }
      });
    }
  }
  EXPECT_EQ(torn, 0);
}

}  // namespace
}  // namespace tendon
