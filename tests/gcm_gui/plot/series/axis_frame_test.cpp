#include <gcm_gui/plot/series/axis_frame.h>
#include <gtest/gtest.h>

#include <limits>

namespace tendon::gui {
namespace {

constexpr double kMaxReal = std::numeric_limits<double>::max();

AxisFrame FrameOf(double low, double high, NumberKind numbers = NumberKind::kReal) {
  return FrameFor({}, {.low = low, .high = high}, numbers);
}

TEST(AxisFrame, OrdinaryValuesNeedNoFrame) {
  EXPECT_EQ(FrameOf(-1, 1), AxisFrame{});
  EXPECT_EQ(FrameOf(20'000, 20'010), AxisFrame{}) << "labels of five digits need no base";
  EXPECT_EQ(FrameOf(0, 0), AxisFrame{});
}

TEST(AxisFrame, CloseValuesFarFromZeroGetARoundBase) {
  EXPECT_EQ(FrameOf(9e9, 9e9 + 1000, NumberKind::kWhole).base, 9'000'000'000);
  EXPECT_DOUBLE_EQ(FrameOf(0.5, 0.5 + 3e-8).base, 0.5);
  EXPECT_EQ(FrameOf(1.7e18, 1.7e18 + 1e10, NumberKind::kWhole).baseText(), "+1.7e18");
}

TEST(AxisFrame, KeepsItsBaseWhileTheLabelsStayShort) {
  const AxisFrame frame = FrameOf(9e9, 9e9 + 1000, NumberKind::kWhole);

  EXPECT_EQ(FrameFor(frame, {.low = 50'000, .high = 51'000}, NumberKind::kWhole), frame);
  EXPECT_EQ(FrameFor(frame, {.low = 5e7, .high = 5e7 + 1000}, NumberKind::kWhole).base,
            9'050'000'000);
}

TEST(AxisFrame, ChoosesARounderBaseForAWiderRange) {
  const AxisFrame first = FrameOf(9'000'001'052, 9'000'001'053, NumberKind::kWhole);
  ASSERT_EQ(first.base, 9'000'001'050);

  const AxisFrame later = FrameFor(first, {.low = 2, .high = 800}, NumberKind::kWhole);

  EXPECT_EQ(later.base, 9'000'000'000);
}

TEST(AxisFrame, DropsItsBaseForSpreadValues) {
  const AxisFrame frame = FrameOf(9e9, 9e9 + 1000, NumberKind::kWhole);

  EXPECT_EQ(FrameFor(frame, {.low = -9e9, .high = 0}, NumberKind::kWhole), AxisFrame{});
}

TEST(AxisFrame, HugeValuesGetAPowerOfTen) {
  const AxisFrame frame = FrameOf(-kMaxReal, kMaxReal);

  EXPECT_NEAR(frame.placeOf(kMaxReal, ValueScale::kLinear), 1.797e8, 1e5);
  EXPECT_EQ(frame.base, 0);
}

TEST(AxisFrame, MovesARangeToTheSameValues) {
  const AxisFrame near{.base = 9'000'000'000};

  EXPECT_EQ(Moved({.low = 1, .high = 2}, near, {.base = 8'999'999'990}),
            (AxisRange{.low = 11, .high = 12}));
  EXPECT_EQ(Moved({.low = 1, .high = 2}, {}, {}), (AxisRange{.low = 1, .high = 2}));
}

TEST(AxisFrame, TheBaseOfIntegersIsWithinTheirLimits) {
  constexpr double kMiddle = 9.22336e18;  // the nearest round number is above 2^63

  const AxisFrame frame = FrameOf(kMiddle - 5e12, kMiddle + 5e12, NumberKind::kWhole);

  EXPECT_EQ(frame.base, 9.2233e18);
}

}  // namespace
}  // namespace tendon::gui
