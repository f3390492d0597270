#include <gcm_gui/plot/frame_governor.h>
#include <gcm_gui/plot/series/sample_statistics.h>
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <limits>

#include "../samples.h"

namespace tendon::gui {
namespace {

TEST(SampleStatistics, CoverOnlyTheGivenTime) {
  SampleRing ring;
  ring.append(Rows(0, 100, [](double) { return 1000.0; }));
  // The values are 0 1 2 3.
  ring.append(Rows(100, 104, [](double t) { return std::round(t * 1000) - 100; }));

  const auto found = StatisticsOf(ring, 100 * kMillisecond, 103 * kMillisecond);

  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->count, 4U);
  EXPECT_EQ(found->lowest, 0);
  EXPECT_EQ(found->highest, 3);
  EXPECT_DOUBLE_EQ(found->mean.nearest(), 1.5);
  EXPECT_DOUBLE_EQ(found->deviation, std::sqrt(1.25));
  EXPECT_DOUBLE_EQ(found->rms, std::sqrt(3.5));
  EXPECT_DOUBLE_EQ(found->rate, 1000);
}

TEST(SampleStatistics, IgnoreNanAndAreEmptyWithoutNumbers) {
  SampleRing ring;
  ring.append(Rows(0, 1, [](double) { return std::numeric_limits<double>::quiet_NaN(); }));
  EXPECT_FALSE(StatisticsOf(ring, 0, kSecond).has_value());

  ring.append(Rows(1, 2, [](double) { return 7.0; }));
  EXPECT_EQ(StatisticsOf(ring, 0, kSecond)->mean, 7.0);
}

std::vector<Sample> Integers(std::initializer_list<std::int64_t> values) {
  std::vector<Sample> rows = Rows(0, values.size());
  std::size_t i = 0;
  for (const std::int64_t value : values) rows[i++].value = ExactNumber::Signed(value);
  return rows;
}

TEST(SampleStatistics, AreExactForLargeIntegers) {
  constexpr std::int64_t kStamp = 1'764'300'000'123'456'789;
  SampleRing ring;
  ring.append(Integers({kStamp, kStamp + 1, kStamp + 5}));

  const auto found = StatisticsOf(ring, 0, kSecond);

  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->lowest, ExactNumber::Signed(kStamp));
  EXPECT_EQ(found->highest, ExactNumber::Signed(kStamp + 5));
  EXPECT_EQ(found->mean, ExactNumber::Signed(kStamp + 2));
  EXPECT_EQ(found->span(), ExactNumber::Unsigned(5));
  EXPECT_DOUBLE_EQ(found->deviation, std::sqrt(14.0 / 3));
}

TEST(SampleStatistics, AreFiniteForExtremeDoubles) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  constexpr double kSmallest = std::numeric_limits<double>::denorm_min();
  SampleRing large;
  bool is_high = false;
  large.append(Rows(0, 100, [&](double) {
    is_high = !is_high;
    return is_high ? kLargest : -kLargest;
  }));
  SampleRing small;
  small.append(Rows(0, 10, [&](double) { return kSmallest; }));

  const auto of_large = StatisticsOf(large, 0, kSecond);
  const auto of_small = StatisticsOf(small, 0, kSecond);

  EXPECT_NEAR(of_large->deviation / kLargest, 1, 1e-9);
  EXPECT_NEAR(of_large->rms / kLargest, 1, 1e-9);
  EXPECT_LT(std::abs(of_large->mean.nearest()), 1e-9 * kLargest);
  EXPECT_EQ(of_small->mean, ExactNumber(kSmallest));
  EXPECT_EQ(of_small->deviation, 0);
}

TEST(SampleStatistics, CountHowOftenAStateOccurs) {
  SampleRing ring;
  ring.append(Integers({0, 3, 3, 0, 3}));

  EXPECT_EQ(OccurrencesOf(ring, kMillisecond, kSecond),
            (std::map<std::int64_t, std::uint64_t>{{0, 1}, {3, 3}}));
}

TEST(FrameGovernor, DrawsAt60HzWhileFramesAreCheap) {
  FrameGovernor governor;
  governor.drew(FrameGovernor::Time(3000));

  EXPECT_EQ(governor.interval(), FrameGovernor::kShortest);
}

TEST(FrameGovernor, UsesHalfOfTheTimeForSlowFramesAndRecovers) {
  FrameGovernor governor;
  governor.drew(FrameGovernor::Time(40'000));
  EXPECT_EQ(governor.interval(), FrameGovernor::Time(80'000));
  governor.drew(FrameGovernor::Time(4'000'000));
  EXPECT_EQ(governor.interval(), FrameGovernor::kLongest);

  for (int frame = 0; frame < 100; ++frame) governor.drew(FrameGovernor::Time(1000));

  EXPECT_EQ(governor.interval(), FrameGovernor::kShortest);
}

TEST(SampleStatistics, AreExactAtTheIntegerLimits) {
  constexpr std::uint64_t kLargest = std::numeric_limits<std::uint64_t>::max();
  std::vector<Sample> rows = Rows(0, 2);
  rows[0].value = ExactNumber::Unsigned(kLargest - 1);
  rows[1].value = ExactNumber::Unsigned(kLargest);
  SampleRing ring;
  ring.append(rows);

  const auto found = StatisticsOf(ring, 0, kSecond);

  ASSERT_TRUE(found.has_value());
  EXPECT_DOUBLE_EQ(found->deviation, 0.5);
  EXPECT_FALSE(found->mean.isBelow(found->lowest));
  EXPECT_FALSE(found->highest.isBelow(found->mean));
}

}  // namespace
}  // namespace tendon::gui
