#include <gcm_gui/plot/series/sample_ring.h>
#include <gmock/gmock.h>

#include <bit>
#include <limits>
#include <numeric>

#include "../samples.h"

namespace tendon::gui {
namespace {

std::vector<double> ValuesOf(const SampleRing& ring) {
  std::vector<double> values;
  for (auto i = ring.firstIndex(); i < ring.endIndex(); ++i) values.push_back(ring.value(i));
  return values;
}

Sample Row(std::uint64_t tick, std::int64_t time_ms) {
  return {.time_ns = time_ms * kMillisecond, .tick = tick, .value = static_cast<double>(tick)};
}

TEST(SampleRing, UnbrokenRowsHaveNoGap) {
  SampleRing ring;

  ring.append(Rows(5, 10'005));

  EXPECT_EQ(ring.endIndex() - ring.firstIndex(), 10'000U);
  EXPECT_EQ(ring.lost(), 0U);
  EXPECT_EQ(ring.repeated(), 0U);
  EXPECT_TRUE(ring.gaps().empty());
}

TEST(SampleRing, CountsAndPlacesMissingRows) {
  SampleRing ring;
  ring.append(Rows(0, 100));
  ring.append(Rows(700, 800));

  ASSERT_EQ(ring.gaps().size(), 1U);
  const Gap& gap = ring.gaps().front();
  EXPECT_EQ(gap.cause, Gap::Cause::kLost);
  EXPECT_EQ(gap.lost, 600U);
  EXPECT_EQ(gap.index, 100U);
  EXPECT_EQ(gap.from_ns, 99 * kMillisecond);
  EXPECT_EQ(gap.to_ns, 700 * kMillisecond);
  EXPECT_EQ(ring.lost(), 600U);
}

TEST(SampleRing, DetectsAGapWithinABatch) {
  SampleRing ring;

  ring.append(std::vector{Row(1, 1), Row(2, 2), Row(5, 5), Row(6, 6)});

  EXPECT_EQ(ring.lost(), 2U);
}

TEST(SampleRing, CountsAndDropsRepeatedRows) {
  SampleRing ring;
  ring.append(Rows(0, 10));
  ring.append(Rows(7, 12));

  EXPECT_EQ(ring.repeated(), 3U);
  EXPECT_EQ(ring.lost(), 0U);
  EXPECT_EQ(ring.endIndex(), 12U);
}

TEST(SampleRing, TheSameTickAtALaterTimeIsARepetition) {
  SampleRing ring;

  ring.append(std::vector{Row(1, 1), Row(2, 2), Row(2, 3), Row(3, 4)});

  EXPECT_EQ(ring.repeated(), 1U);
  EXPECT_TRUE(ring.gaps().empty());
}

TEST(SampleRing, AnEpochIsAGapWithoutLostRows) {
  SampleRing ring;
  ring.append(std::vector{Row(500, 500), Row(501, 501)});

  ring.beginEpoch();
  ring.append(std::vector{Row(0, 3000), Row(1, 3001)});

  ASSERT_EQ(ring.gaps().size(), 1U);
  EXPECT_EQ(ring.gaps().front().cause, Gap::Cause::kRestart);
  EXPECT_EQ(ring.lost(), 0U);
  EXPECT_EQ(ring.endIndex(), 4U);
}

TEST(SampleRing, DetectsAnUnannouncedEpochByItsTicks) {
  SampleRing ring;
  ring.append(std::vector{Row(500, 500), Row(501, 501)});

  ring.append(std::vector{Row(0, 3000), Row(1, 3001)});

  ASSERT_EQ(ring.gaps().size(), 1U);
  EXPECT_EQ(ring.gaps().front().cause, Gap::Cause::kRestart);
  EXPECT_EQ(ring.repeated(), 0U);
}

TEST(SampleRing, RestartsWhenTheClockIsSetBack) {
  SampleRing ring;
  ring.append(Rows(100'000, 100'100));

  ring.beginEpoch();
  ring.append(Rows(0, 10));

  EXPECT_EQ(ring.endIndex() - ring.firstIndex(), 10U);
  EXPECT_TRUE(ring.gaps().empty());
  EXPECT_EQ(ring.tick(ring.firstIndex()), 0U);
}

TEST(SampleRing, TimeNeverRunsBackwards) {
  SampleRing ring;

  ring.append(std::vector{Row(1, 10), Row(2, 9), Row(3, 11)});

  EXPECT_EQ(ring.time(1), 10 * kMillisecond);
  EXPECT_EQ(ring.endIndex(), 3U);
}

TEST(SampleRing, DropsTheOldestWhenFull) {
  SampleRing ring(4096);

  ring.append(Rows(0, 10'000));

  EXPECT_EQ(ring.firstIndex(), 10'000U - 4096U);
  std::vector<double> expected(4096);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    expected[i] = static_cast<double>(10'000 - 4096 + i) / 1e3;
  }
  EXPECT_THAT(ValuesOf(ring), testing::Pointwise(testing::DoubleEq(), expected));
}

TEST(SampleRing, TicksAreKnownAfterWrappingPastAGap) {
  SampleRing ring(1024);
  ring.append(Rows(0, 500));
  ring.append(Rows(600, 3000));
  ring.append(Rows(3010, 3020));

  EXPECT_EQ(ring.lost(), 110U);
  EXPECT_EQ(ring.gaps().size(), 1U) << "the older gap has left with its samples";
  for (auto i = ring.firstIndex(); i < ring.endIndex(); ++i) {
    EXPECT_EQ(static_cast<std::int64_t>(ring.tick(i)) * kMillisecond, ring.time(i));
  }
}

TEST(SampleRing, ALowerLimitKeepsTheLatest) {
  SampleRing ring;
  ring.append(Rows(0, 5000));

  ring.setLimit(1500);  // rounded down to 1024
  ring.append(Rows(5000, 5001));

  EXPECT_EQ(ring.endIndex() - ring.firstIndex(), 1024U);
  EXPECT_EQ(ring.tick(ring.endIndex() - 1), 5000U);
}

TEST(SampleRing, LimitsTheNumberOfGaps) {
  SampleRing ring(std::size_t{1} << 20);
  std::vector<Sample> rows;
  for (std::uint64_t i = 0; i < 100'000; ++i)
    rows.push_back(Row(2 * i, static_cast<std::int64_t>(2 * i)));

  ring.append(rows);

  EXPECT_LE(ring.gaps().size(), 16'384U);
  EXPECT_EQ(ring.lost(), 99'999U);
  EXPECT_EQ(ring.tick(ring.endIndex() - 1), 199'998U);
}

Sample Count(std::uint64_t tick, std::int64_t value) {
  Sample sample = Row(tick, static_cast<std::int64_t>(tick));
  sample.value = ExactNumber::Signed(value);
  return sample;
}

TEST(SampleRing, IntegersKeepAllTheirBits) {
  constexpr std::int64_t kLargest = std::numeric_limits<std::int64_t>::max();
  SampleRing ring;
  std::vector<Sample> rows;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    rows.push_back(Count(i, kLargest - static_cast<std::int64_t>(i)));
  }

  ring.append(rows);

  EXPECT_EQ(ring.kind(), ExactNumber::Kind::kSigned);
  for (std::uint64_t i = 0; i < 3000; ++i) {
    ASSERT_EQ(ring.number(i), ExactNumber::Signed(kLargest - static_cast<std::int64_t>(i)));
  }
}

TEST(SampleRing, ARowWithoutTheElementIsAGapNotALoss) {
  Sample nothing = Count(2, 0);
  nothing.value = std::numeric_limits<double>::quiet_NaN();
  SampleRing ring;

  ring.append(std::vector{Count(1, 7), nothing, Count(3, 8)});

  EXPECT_EQ(ring.lost(), 0U);
  ASSERT_EQ(ring.gaps().size(), 1U);
  EXPECT_EQ(ring.gaps().front().cause, Gap::Cause::kNoValue);
  EXPECT_EQ(ring.tick(1), 3U);
  EXPECT_EQ(ring.number(1), ExactNumber::Signed(8));
}

TEST(SampleRing, NumbersOfAnotherKindRestartTheRing) {
  SampleRing ring;
  ring.append(Rows(0, 10));

  ring.append(std::vector{Count(10, 1), Count(11, 2)});

  EXPECT_EQ(ring.endIndex() - ring.firstIndex(), 2U);
  EXPECT_EQ(ring.number(ring.firstIndex()), ExactNumber::Signed(1));
}

TEST(SampleRing, SegmentsCoverTheWrap) {
  SampleRing ring(1024);
  ring.append(Rows(0, 1500));

  double sum = 0;
  std::size_t parts = 0;
  for (auto i = ring.firstIndex(); i < ring.endIndex(); ++parts) {
    const auto segment = ring.segment(i, ring.endIndex());
    for (const std::uint64_t word : segment.words) sum += std::bit_cast<double>(word);
    i += segment.words.size();
  }

  const auto values = ValuesOf(ring);
  EXPECT_DOUBLE_EQ(sum, std::accumulate(values.begin(), values.end(), 0.0));
  EXPECT_EQ(parts, 2U);
}

TEST(SampleRing, LowerBoundFindsTheFirstAtOrAfter) {
  SampleRing ring(1024);
  ring.append(Rows(0, 1500));

  EXPECT_EQ(ring.lowerBound(0), ring.firstIndex());
  EXPECT_EQ(ring.lowerBound(1000 * kMillisecond), 1000U);
  EXPECT_EQ(ring.lowerBound(1000 * kMillisecond + 1), 1001U);
  EXPECT_EQ(ring.lowerBound(9999 * kMillisecond), ring.endIndex());
}

TEST(SampleRing, APausedSourceLeavesAGapWithoutALoss) {
  SampleRing ring;
  ring.append(std::vector{Row(1, 1), Row(2, 2)});
  ring.noteStandstill();
  ring.append(std::vector{Row(3, 3)});  // this row was sent before the standstill
  EXPECT_TRUE(ring.gaps().empty());

  ring.endStandstill();
  ring.append(std::vector{Row(4, 5000), Row(5, 5001)});

  ASSERT_EQ(ring.gaps().size(), 1U);
  EXPECT_EQ(ring.gaps().front().cause, Gap::Cause::kStandstill);
  EXPECT_EQ(ring.gaps().front().from_ns, 3 * kMillisecond);
  EXPECT_EQ(ring.gaps().front().to_ns, 5000 * kMillisecond);
  EXPECT_EQ(ring.lost(), 0U);
  EXPECT_EQ(ring.tick(4), 5U);
}

TEST(SampleRing, AResumedSlowSourceLeavesOneGap) {
  SampleRing ring;
  ring.append(std::vector{Row(1, 1000), Row(2, 2000)});
  ring.noteStandstill();
  // The source runs again, but endStandstill() was not called yet.
  ring.append(std::vector{Row(3, 9000)});
  ring.endStandstill();
  ring.append(std::vector{Row(4, 10000), Row(5, 11000)});

  ASSERT_EQ(ring.gaps().size(), 1U);
  EXPECT_EQ(ring.gaps().front().cause, Gap::Cause::kStandstill);
  EXPECT_EQ(ring.gaps().front().to_ns, 9000 * kMillisecond);
}

TEST(SampleRing, ARestartedSlowSourceLeavesOneGap) {
  SampleRing ring;
  ring.append(std::vector{Row(7, 1000), Row(8, 2000)});
  ring.noteStandstill();
  ring.beginEpoch();
  ring.append(std::vector{Row(1, 9000)});
  ring.endStandstill();
  ring.append(std::vector{Row(2, 10000), Row(3, 11000)});

  ASSERT_EQ(ring.gaps().size(), 1U);
  EXPECT_EQ(ring.gaps().front().cause, Gap::Cause::kRestart);
}

TEST(SampleRing, ARunningSlowSourceHasNoGaps) {
  SampleRing ring;
  ring.append(std::vector{Row(1, 1000)});
  ring.noteStandstill();
  ring.endStandstill();
  ring.append(std::vector{Row(2, 1100), Row(3, 9000)});

  EXPECT_TRUE(ring.gaps().empty());
}

TEST(SampleRing, ASlowSourcePausedBeforeItsFirstRowHasNoGap) {
  SampleRing ring;
  ring.noteStandstill();
  ring.append(std::vector{Row(1, 1000)});
  ring.endStandstill();
  ring.append(std::vector{Row(2, 2000)});

  EXPECT_TRUE(ring.gaps().empty());
}

TEST(SampleRing, CountsOnlyRowsMissingBeforeARowWithoutTheElement) {
  Sample nothing = Count(5, 0);
  nothing.value = std::numeric_limits<double>::quiet_NaN();
  SampleRing ring;

  // The row with tick 5 comes twice.
  ring.append(std::vector{Count(3, 7), nothing, Count(5, 7), Count(6, 8)});

  EXPECT_EQ(ring.lost(), 1U);
  ASSERT_EQ(ring.gaps().size(), 1U);
  EXPECT_EQ(ring.gaps().front().cause, Gap::Cause::kLost);
  EXPECT_EQ(ring.gaps().front().lost, 1U);
  EXPECT_EQ(ring.tick(1), 6U);
}

}  // namespace
}  // namespace tendon::gui
