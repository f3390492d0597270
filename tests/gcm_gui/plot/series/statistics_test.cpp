#include <gcm_gui/plot/frame_governor.h>
#include <gcm_gui/plot/series/statistics.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../samples.h"

namespace tendon::gui {
namespace {

TEST(Statistics, AreOfTheSamplesOfThatTimeAlone) {
  SampleRing ring;
  ring.append(Rows(0, 100, [](double) { return 1000.0; }));
  ring.append(Rows(100, 104, [](double t) { return std::round(t * 1000) - 100; }));  // 0 1 2 3

  const auto found = StatisticsOf(ring, 100 * kMillisecond, 103 * kMillisecond);

  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->count, 4U);
  EXPECT_EQ(found->lowest, 0);
  EXPECT_EQ(found->highest, 3);
  EXPECT_DOUBLE_EQ(found->mean, 1.5);
  EXPECT_DOUBLE_EQ(found->deviation, std::sqrt(1.25));
  EXPECT_DOUBLE_EQ(found->rms, std::sqrt(3.5));
  EXPECT_DOUBLE_EQ(found->rate, 1000);
}

TEST(Statistics, LeaveOutWhatIsNoNumberAndAreNothingWithoutAny) {
  SampleRing ring;
  ring.append(Rows(0, 1, [](double) { return std::numeric_limits<double>::quiet_NaN(); }));
  EXPECT_FALSE(StatisticsOf(ring, 0, kSecond).has_value());

  ring.append(Rows(1, 2, [](double) { return 7.0; }));
  EXPECT_EQ(StatisticsOf(ring, 0, kSecond)->mean, 7.0);
}

TEST(FrameGovernor, DrawsAt60HzWhileFramesAreCheap) {
  FrameGovernor governor;
  governor.drew(FrameGovernor::Time(3000));

  EXPECT_EQ(governor.interval(), FrameGovernor::kShortest);
}

TEST(FrameGovernor, LeavesHalfOfTheTimeWhenTheyAreDearAndRecovers) {
  FrameGovernor governor;
  governor.drew(FrameGovernor::Time(40'000));
  EXPECT_EQ(governor.interval(), FrameGovernor::Time(80'000));
  governor.drew(FrameGovernor::Time(4'000'000));
  EXPECT_EQ(governor.interval(), FrameGovernor::kLongest);

  for (int frame = 0; frame < 100; ++frame) governor.drew(FrameGovernor::Time(1000));

  EXPECT_EQ(governor.interval(), FrameGovernor::kShortest);
}

}  // namespace
}  // namespace tendon::gui
