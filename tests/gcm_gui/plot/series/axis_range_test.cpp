#include <gcm_gui/plot/series/axis_range.h>
#include <gmock/gmock.h>

#include <cmath>

namespace tendon::gui {
namespace {

TEST(NiceStep, IsOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(NiceStep(3.2, 7), 0.5);
  EXPECT_DOUBLE_EQ(NiceStep(10, 10), 1);
  EXPECT_DOUBLE_EQ(NiceStep(1100, 6), 200);
  EXPECT_DOUBLE_EQ(NiceStep(0.009, 6), 0.002);
}

TEST(NiceStep, TimeStepsUseMinutesAndHours) {
  EXPECT_DOUBLE_EQ(NiceTimeStep(30, 6), 5);
  EXPECT_DOUBLE_EQ(NiceTimeStep(60, 6), 10);
  EXPECT_DOUBLE_EQ(NiceTimeStep(300, 6), 60);
  EXPECT_DOUBLE_EQ(NiceTimeStep(600, 6), 120);
  EXPECT_DOUBLE_EQ(NiceTimeStep(3600, 6), 600);
  EXPECT_DOUBLE_EQ(NiceTimeStep(0.012, 6), 0.002);
}

TEST(FittedRange, ContainsTheDataWithRoundLimits) {
  const AxisRange range = FittedRange({.low = 0, .high = 0}, {.low = -1.1, .high = 1.1});

  EXPECT_DOUBLE_EQ(range.low, -1.25);
  EXPECT_DOUBLE_EQ(range.high, 1.25);
}

TEST(FittedRange, IsUnchangedWhileTheDataFits) {
  const AxisRange current{.low = -1.25, .high = 1.25};

  EXPECT_EQ(FittedRange(current, {.low = -0.9, .high = 1.1}), current);
}

TEST(FittedRange, GrowsAtOnceAndShrinksWhenHalfOfItIsUnused) {
  const AxisRange current{.low = -1.25, .high = 1.25};

  EXPECT_GT(FittedRange(current, {.low = -1.1, .high = 1.3}).high, 1.3);
  EXPECT_LT(FittedRange(current, {.low = -0.1, .high = 0.1}).high, 0.3);
}

TEST(FittedRange, ASingleValueGetsAMargin) {
  EXPECT_TRUE(FittedRange({}, {.low = 0, .high = 0}).contains({.low = -0.5, .high = 0.5}));
  const AxisRange range = FittedRange({}, {.low = 5e6, .high = 5e6});
  EXPECT_LT(range.low, 5e6);
  EXPECT_GT(range.high, 5e6);
}

TEST(FittedRange, DoesNotMagnifyNoiseAtRest) {
  const AxisRange around_zero = FittedRange({}, {.low = -5e-14, .high = 5e-14});
  EXPECT_LE(around_zero.low, -1);
  EXPECT_GE(around_zero.high, 1);

  EXPECT_GT(FittedRange({}, {.low = 0.5, .high = 0.5 + 1e-15}).span(), 0.05);
}

TEST(FittedRange, ShowsADifferenceInTheThirteenthDigit) {
  const AxisRange range = FittedRange({}, {.low = 0, .high = 2e-12}, NumberKind::kReal, 1);

  EXPECT_LT(range.span(), 1e-11);
}

TEST(FittedRange, SeparatesIntegersThatDifferByOne) {
  const AxisRange range = FittedRange({}, {.low = 0, .high = 1}, NumberKind::kWhole, 9e9);

  EXPECT_LT(range.span(), 3);
}

TEST(FittedRange, DecadesStayWithinTheLimitsOfDoubles) {
  const AxisRange range = FittedDecades({}, {.low = -323.3, .high = 308.3});

  EXPECT_GE(range.low, -324);
  EXPECT_LE(range.high, 309);
  EXPECT_GT(FittedDecades({}, {.low = 3, .high = 3}).span(), 0.9);
}

TEST(IsShowable, RejectsRangesThatDoublesCannotResolve) {
  EXPECT_TRUE(IsShowable({.low = 1, .high = 1 + 1e-11}));
  EXPECT_FALSE(IsShowable({.low = 1, .high = 1 + 1e-15}));
  EXPECT_FALSE(IsShowable({.low = 0, .high = 1e300}));
  EXPECT_FALSE(IsShowable({.low = 0, .high = 0}));
  EXPECT_FALSE(IsShowable({.low = 0, .high = std::nan("")}));
}

TEST(Ticks, AreTheMultiplesWithinTheRange) {
  EXPECT_THAT(TicksOf({.low = -1.6, .high = 1.6}, 0.5),
              testing::ElementsAre(-1.5, -1.0, -0.5, 0, 0.5, 1.0, 1.5));
  EXPECT_THAT(TicksOf({.low = 0, .high = 0.3}, 0.1), testing::SizeIs(4));
}

TEST(Decimals, DistinguishTheTicks) {
  EXPECT_EQ(DecimalsOf(0.5), 1);
  EXPECT_EQ(DecimalsOf(0.1), 1);
  EXPECT_EQ(DecimalsOf(0.002), 3);
  EXPECT_EQ(DecimalsOf(20), 0);
}

}  // namespace
}  // namespace tendon::gui
