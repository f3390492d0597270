#include <gtest/gtest.h>
#include <tendon/process/history/history_ring.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace tendon {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kMiB = std::size_t{1} << 20U;

/// Adds a record a millisecond after the one before.
bool AddRecord(HistoryRing& ring, std::uint64_t number, std::size_t size) {
  const std::vector<std::byte> body(size, static_cast<std::byte>(number % 251));
  return ring.Append({.number = number,
                      .time = static_cast<std::int64_t>(number) * 1'000'000,
                      .tag = static_cast<std::uint32_t>(number % 3),
                      .body = body});
}

std::vector<std::uint64_t> NumbersFrom(HistoryRing::Cursor cursor) {
  std::vector<std::uint64_t> numbers;
  while (const auto record = cursor.Next()) numbers.push_back(record->number);
  return numbers;
}

TEST(HistoryRing, ReturnsWhatWasAdded) {
  HistoryMemory memory(kMiB);
  HistoryRing ring(memory, 30s);
  for (std::uint64_t i = 0; i < 1000; ++i) ASSERT_TRUE(AddRecord(ring, i, i % 50));

  HistoryRing::Cursor cursor = ring.From(0);

  for (std::uint64_t i = 0; i < 1000; ++i) {
    const auto record = cursor.Next();
    ASSERT_TRUE(record);
    ASSERT_EQ(record->number, i);
    ASSERT_EQ(record->time, static_cast<std::int64_t>(i) * 1'000'000);
    ASSERT_EQ(record->tag, i % 3);
    ASSERT_EQ(record->body.size(), i % 50);
    if (!record->body.empty()) {
      ASSERT_EQ(record->body.back(), static_cast<std::byte>(i % 251));
    }
  }
  EXPECT_FALSE(cursor.Next());
  EXPECT_EQ(ring.dropped(), 0U);
}

TEST(HistoryRing, TakesNoMemoryBeforeTheFirstRecord) {
  HistoryMemory memory(kMiB);
  HistoryRing ring(memory, 30s);

  EXPECT_EQ(memory.used(), 0U);
  EXPECT_TRUE(AddRecord(ring, 0, 8));
  EXPECT_GT(memory.used(), 0U);
  EXPECT_LE(memory.used(), 2 * HistoryRing::kSmallestChunk);
}

TEST(HistoryRing, BeginsAtANumberOrATime) {
  HistoryMemory memory(kMiB);
  HistoryRing ring(memory, 30s);
  for (const std::uint64_t number : {10, 11, 12, 20, 21}) ASSERT_TRUE(AddRecord(ring, number, 8));

  EXPECT_EQ(NumbersFrom(ring.From(0)), (std::vector<std::uint64_t>{10, 11, 12, 20, 21}));
  EXPECT_EQ(NumbersFrom(ring.From(12)), (std::vector<std::uint64_t>{12, 20, 21}));
  EXPECT_EQ(NumbersFrom(ring.From(13)), (std::vector<std::uint64_t>{20, 21}));
  EXPECT_EQ(NumbersFrom(ring.From(22)), (std::vector<std::uint64_t>{}));
  EXPECT_EQ(NumbersFrom(ring.Since(11'000'000)), (std::vector<std::uint64_t>{11, 12, 20, 21}));
  EXPECT_EQ(NumbersFrom(ring.Since(11'000'001)), (std::vector<std::uint64_t>{12, 20, 21}));
  EXPECT_EQ(NumbersFrom(ring.Since(21'000'001)), (std::vector<std::uint64_t>{}));
}

TEST(HistoryRing, DropsTheOldestWhenTheMemoryIsUsedUpAndSaysSo) {
  HistoryMemory memory(kMiB);
  HistoryRing ring(memory, 1h);
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    ASSERT_TRUE(AddRecord(ring, i, 800));
    ASSERT_LE(memory.used(), kMiB);
  }

  const auto numbers = NumbersFrom(ring.From(0));

  ASSERT_FALSE(numbers.empty());
  EXPECT_EQ(numbers.back(), 19'999U);
  EXPECT_EQ(numbers.front(), ring.dropped());
  EXPECT_EQ(numbers.size() + ring.dropped(), 20'000U);
  EXPECT_GT(numbers.size() * 816, kMiB * 3 / 4) << "most of the memory is used";
  ASSERT_TRUE(ring.last_dropped());
  EXPECT_EQ(*ring.last_dropped(), static_cast<std::int64_t>(ring.dropped() - 1) * 1'000'000);
}

TEST(HistoryRing, ManyFastSeriesKeepTheirNewestRecordsInLittleMemory) {
  HistoryMemory memory(std::size_t{64} << 10U);
  std::vector<std::unique_ptr<HistoryRing>> rings;
  for (int i = 0; i < 20; ++i) rings.push_back(std::make_unique<HistoryRing>(memory, 30s));
  for (std::uint64_t i = 0; i < 2000; ++i) {
    for (const auto& ring : rings) ASSERT_TRUE(AddRecord(*ring, i, 40));
    ASSERT_LE(memory.used(), memory.limit());
  }

  for (const auto& ring : rings) {
    const auto numbers = NumbersFrom(ring->From(0));
    ASSERT_FALSE(numbers.empty());
    EXPECT_EQ(numbers.back(), 1999U);
    EXPECT_GE(numbers.size(), 10U);
  }
}

TEST(HistoryRing, AFastSeriesDoesNotPushOutASlowOne) {
  HistoryMemory memory(kMiB);
  HistoryRing fast(memory, 1h);
  HistoryRing slow(memory, 1h);
  for (std::uint64_t i = 0; i < 50'000; ++i) {
    ASSERT_TRUE(AddRecord(fast, i, 400));
    if (i % 1000 == 0) {
      ASSERT_TRUE(AddRecord(slow, i / 1000, 40));
    }
  }

  EXPECT_EQ(slow.dropped(), 0U);
  EXPECT_EQ(NumbersFrom(slow.From(0)).size(), 50U);
  EXPECT_GT(fast.dropped(), 0U);
}

TEST(HistoryRing, EquallyFastSeriesHaveEqualShares) {
  HistoryMemory memory(kMiB);
  HistoryRing first(memory, 1h);
  for (std::uint64_t i = 0; i < 10'000; ++i) ASSERT_TRUE(AddRecord(first, i, 400));
  EXPECT_GT(first.bytes(), kMiB * 3 / 4);

  HistoryRing second(memory, 1h);
  for (std::uint64_t i = 10'000; i < 20'000; ++i) {
    ASSERT_TRUE(AddRecord(first, i, 400));
    ASSERT_TRUE(AddRecord(second, i, 400));
  }

  EXPECT_LE(memory.used(), kMiB);
  EXPECT_NEAR(static_cast<double>(first.bytes()), static_cast<double>(second.bytes()),
              2.0 * HistoryRing::kLargestChunk);
}

TEST(HistoryRing, ARecordThatIsLargerThanTheMemoryIsCounted) {
  HistoryMemory memory(kMiB);
  HistoryRing ring(memory, 30s);
  ASSERT_TRUE(AddRecord(ring, 0, 8));

  EXPECT_FALSE(AddRecord(ring, 1, 2 * kMiB));
  EXPECT_TRUE(AddRecord(ring, 2, 8));

  EXPECT_EQ(ring.dropped(), 1U);
  EXPECT_EQ(NumbersFrom(ring.From(0)), (std::vector<std::uint64_t>{0, 2}));
}

TEST(HistoryRing, DropsWhatIsTooOldWithoutCountingIt) {
  HistoryMemory memory(kMiB);
  HistoryRing ring(memory, 1s);
  for (std::uint64_t i = 0; i < 10'000; ++i) {
    ASSERT_TRUE(AddRecord(ring, i, 8));
    ring.DropBefore(static_cast<std::int64_t>(i) * 1'000'000 - 1'000'000'000);
  }

  const auto numbers = NumbersFrom(ring.From(0));

  EXPECT_GE(numbers.size(), 1000U);
  EXPECT_LE(numbers.size(), 1400U) << "chunks are freed as a whole";
  EXPECT_EQ(ring.dropped(), 0U);
  EXPECT_FALSE(ring.last_dropped());
}

TEST(HistoryRing, GivesItsMemoryBack) {
  HistoryMemory memory(kMiB);
  {
    HistoryRing ring(memory, 30s);
    for (std::uint64_t i = 0; i < 1000; ++i) ASSERT_TRUE(AddRecord(ring, i, 100));
  }

  EXPECT_EQ(memory.used(), 0U);
}

TEST(HistoryRing, ASeriesWithMissingNumbersUsesTheMemoryAsWell) {
  HistoryMemory memory(kMiB);
  HistoryRing ring(memory, 1h);
  std::uint64_t number = 0;
  for (; number < 5'000; ++number) ASSERT_TRUE(AddRecord(ring, number, 800));
  for (; number < 200'000; ++number) {
    if (number % 11 != 0) {
      ASSERT_TRUE(AddRecord(ring, number, 40));
    }
  }

  EXPECT_GT(NumbersFrom(ring.From(0)).size(), 5'000U);
  EXPECT_LE(memory.used(), kMiB);
}

TEST(HistoryMemory, RingsLoseTheirOldestRecordsForReservedMemory) {
  HistoryMemory memory(kMiB);
  HistoryRing ring(memory, 1h);
  for (std::uint64_t i = 0; i < 2'000; ++i) ASSERT_TRUE(AddRecord(ring, i, 800));

  EXPECT_TRUE(memory.Reserve(kMiB / 8));

  EXPECT_LE(memory.used(), kMiB);
  const auto numbers = NumbersFrom(ring.From(0));
  ASSERT_FALSE(numbers.empty());
  EXPECT_EQ(numbers.back(), 1'999U);
}

TEST(HistoryMemory, AtMostAQuarterIsReserved) {
  HistoryMemory memory(kMiB);

  EXPECT_TRUE(memory.Reserve(kMiB / 8));
  EXPECT_TRUE(memory.Reserve(kMiB / 8));
  EXPECT_FALSE(memory.Reserve(1));
  EXPECT_EQ(memory.used(), kMiB / 4);

  memory.Release(kMiB / 4);
  EXPECT_EQ(memory.used(), 0U);
}

}  // namespace
}  // namespace tendon
