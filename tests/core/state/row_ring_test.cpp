#include <gtest/gtest.h>
#include <tendon/state/row_ring.h>

#include <array>
#include <cstdint>
#include <new>

namespace tendon {
namespace {

using Words = std::array<std::uint64_t, 3>;

void Write(RowRing<>& ring, std::uint64_t value, std::int64_t time) {
  ring.Begin(time);
  const Words words{value, value, value};
  ring.Store(0, words);
  ring.Publish();
}

RowResult Read(const RowRing<>& ring, std::uint64_t tick, Words& words) {
  return ring.Read(tick, [&](const RowRing<>::Word* row) {
    for (std::size_t i = 0; i < words.size(); ++i) words[i] = row[i].load();
  });
}

class RowRingTest : public testing::Test {
 protected:
  RowRingTest() { ring_.Allocate(5, 3); }

  RowRing<> ring_;
  Words words_{};
};

TEST_F(RowRingTest, StartsEmpty) {
  std::uint64_t tick = 0;
  EXPECT_EQ(ring_.next_tick(), 0U);
  EXPECT_EQ(Read(ring_, 0, words_), RowResult::kNotYet);
  EXPECT_EQ(ring_.ReadNewest(tick, [](auto) {}), RowResult::kNotYet);
  EXPECT_EQ(ring_.Find(0, tick), RowResult::kNotYet);
}

TEST_F(RowRingTest, KeepsAtLeastTheRequestedRows) {
  for (std::uint64_t tick = 0; tick < 100; ++tick) {
    Write(ring_, tick, 0);
    for (std::uint64_t back = 0; back < 5 && back <= tick; ++back) {
      ASSERT_EQ(Read(ring_, tick - back, words_), RowResult::kDone);
      ASSERT_EQ(words_[0], tick - back);
    }
  }
}

TEST_F(RowRingTest, TheFirstTickIsNotZeroIfItIsSet) {
  ring_.SetFirstTick(13);
  std::uint64_t tick = 0;
  EXPECT_EQ(ring_.next_tick(), 13U);
  EXPECT_EQ(ring_.ReadNewest(tick, [](auto) {}), RowResult::kNotYet);
  EXPECT_EQ(ring_.Find(0, tick), RowResult::kNotYet);
  EXPECT_EQ(Read(ring_, 13, words_), RowResult::kNotYet);

  Write(ring_, 77, 0);

  EXPECT_EQ(ring_.oldest_tick(), 13U);
  EXPECT_EQ(Read(ring_, 13, words_), RowResult::kDone);
  EXPECT_EQ(words_[0], 77U);
  EXPECT_EQ(Read(ring_, 0, words_), RowResult::kOvertaken) << "its memory was never written";
  EXPECT_EQ(Read(ring_, 12, words_), RowResult::kOvertaken);
}

TEST_F(RowRingTest, TicksThatAreLeftOutAreLostRows) {
  for (std::uint64_t tick = 0; tick < 3; ++tick) Write(ring_, tick, 0);
  ring_.BeginAt(6, 0);
  ring_.Store(0, Words{6, 6, 6});
  ring_.Publish();

  EXPECT_EQ(ring_.next_tick(), 7U);
  for (const std::uint64_t left_out : {3U, 4U, 5U}) {
    EXPECT_EQ(Read(ring_, left_out, words_), RowResult::kOvertaken) << left_out;
  }
  EXPECT_EQ(Read(ring_, 2, words_), RowResult::kDone);
  EXPECT_EQ(words_[0], 2U);
  std::uint64_t tick = 0;
  EXPECT_EQ(ring_.ReadNewest(tick, [](auto) {}), RowResult::kDone);
  EXPECT_EQ(tick, 6U);
}

TEST_F(RowRingTest, DistinguishesFutureFromLostRows) {
  for (std::uint64_t tick = 0; tick < 20; ++tick) Write(ring_, tick, 0);

  EXPECT_EQ(Read(ring_, 20, words_), RowResult::kNotYet);
  EXPECT_EQ(Read(ring_, 0, words_), RowResult::kOvertaken);
  EXPECT_EQ(Read(ring_, ring_.oldest_tick(), words_), RowResult::kDone);
  EXPECT_EQ(words_[2], ring_.oldest_tick());
}

TEST_F(RowRingTest, ReturnsNoRowReplacedDuringTheCopy) {
  Write(ring_, 7, 0);

  const RowResult result = ring_.Read(0, [&](const RowRing<>::Word* row) {
    words_[0] = row[0].load();
    for (std::uint64_t tick = 1; tick <= 8; ++tick) Write(ring_, 7 + tick, 0);
    words_[1] = row[1].load();
  });

  EXPECT_NE(words_[0], words_[1]) << "the test tears no row";
  EXPECT_EQ(result, RowResult::kOvertaken);
}

TEST_F(RowRingTest, ReturnsNoRowThatIsBeingReplaced) {
  for (std::uint64_t tick = 0; tick < 8; ++tick) Write(ring_, tick, 0);
  EXPECT_EQ(Read(ring_, 0, words_), RowResult::kDone);

  ring_.Begin(0);

  EXPECT_EQ(Read(ring_, 0, words_), RowResult::kOvertaken);
  EXPECT_EQ(Read(ring_, 8, words_), RowResult::kNotYet);
}

TEST_F(RowRingTest, RetriesTheNewestRowIfTheWriterOvertakes) {
  Write(ring_, 0, 0);
  int copies = 0;
  std::uint64_t tick = 0;

  const RowResult result = ring_.ReadNewest(tick, [&](const RowRing<>::Word* row) {
    if (copies++ == 0) {
      for (std::uint64_t i = 1; i <= 8; ++i) Write(ring_, i, 0);
    }
    words_[0] = row[0].load();
  });

  EXPECT_EQ(result, RowResult::kDone);
  EXPECT_EQ(copies, 2);
  EXPECT_EQ(tick, 8U);
  EXPECT_EQ(words_[0], 8U);
}

TEST_F(RowRingTest, FindsTheRowAtATime) {
  for (std::uint64_t tick = 0; tick < 4; ++tick) {
    Write(ring_, tick, 100 + 10 * static_cast<std::int64_t>(tick));
  }
  std::uint64_t tick = 99;

  EXPECT_EQ(ring_.Find(99, tick), RowResult::kNotYet);
  EXPECT_EQ(ring_.Find(100, tick), RowResult::kDone);
  EXPECT_EQ(tick, 0U);
  EXPECT_EQ(ring_.Find(119, tick), RowResult::kDone);
  EXPECT_EQ(tick, 1U);
  EXPECT_EQ(ring_.Find(1'000'000, tick), RowResult::kDone);
  EXPECT_EQ(tick, 3U);
}

TEST_F(RowRingTest, ReportsTheRowOfAnOldTimeAsLost) {
  for (std::uint64_t tick = 0; tick < 50; ++tick) {
    Write(ring_, tick, static_cast<std::int64_t>(tick));
  }
  std::uint64_t tick = 99;

  EXPECT_EQ(ring_.Find(3, tick), RowResult::kOvertaken);
  const auto oldest = static_cast<std::int64_t>(ring_.oldest_tick());
  EXPECT_EQ(ring_.Find(oldest, tick), RowResult::kDone);
  EXPECT_EQ(tick, ring_.oldest_tick());
  EXPECT_EQ(ring_.Find(oldest - 1, tick), RowResult::kOvertaken);
}

TEST_F(RowRingTest, AFailedAllocationKeepsTheRing) {
  constexpr std::size_t kTooMany = (std::size_t{1} << 59U) - 1;

  EXPECT_THROW(ring_.Allocate(kTooMany, 8), std::bad_alloc);

  for (std::uint64_t i = 0; i < 20; ++i) Write(ring_, i, 0);
  EXPECT_EQ(Read(ring_, 19, words_), RowResult::kDone);
  EXPECT_EQ(words_, (Words{19, 19, 19}));
  EXPECT_EQ(Read(ring_, 10, words_), RowResult::kOvertaken);
}

TEST(RowRing, ComputesHowManyRowsFitIntoMemory) {
  EXPECT_EQ(RowRing<>::RowsWithin(1024, 6), 127U);
  EXPECT_EQ(RowRing<>::RowsWithin(1024, 7), 63U);
  EXPECT_EQ(RowRing<>::RowsWithin(1, 1000), 1U);
}

}  // namespace
}  // namespace tendon
