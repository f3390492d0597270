#include <gcm_gui/plot/canvas/value_ticks.h>
#include <gmock/gmock.h>

#include <cmath>
#include <memory>

namespace tendon::gui {
namespace {

std::vector<QString> TextsOf(const AxisRange& range, int most) {
  return TicksOf(range, ValueScale::kLogarithmic, most).texts;
}

std::vector<QString> LinearTexts(const UnitAxis& axis) {
  return TicksOf(axis, ValueScale::kLinear, 7).texts;
}

TEST(ValueTicks, AreMultiplesOfARoundStepOnALinearAxis) {
  const ValueTicks ticks = TicksOf(AxisRange{.low = 0, .high = 10}, ValueScale::kLinear, 7);

  EXPECT_EQ(ticks.step, 2);
  EXPECT_THAT(ticks.places, testing::ElementsAre(0, 2, 4, 6, 8, 10));
}

TEST(ValueTicks, ArePowersOfTenOverManyDecades) {
  EXPECT_THAT(TextsOf({.low = -3, .high = 2}, 7),
              testing::ElementsAre("0.001", "0.01", "0.1", "1", "10", "100"));
  EXPECT_LE(TextsOf({.low = -12, .high = 12}, 7).size(), 7U);
}

TEST(ValueTicks, IncludeTwoAndFiveOverTwoDecades) {
  EXPECT_THAT(TextsOf({.low = 0, .high = 2}, 7),
              testing::ElementsAre("1", "2", "5", "10", "20", "50", "100"));
}

TEST(ValueTicks, AreRoundValuesWithinADecade) {
  EXPECT_THAT(TextsOf({.low = std::log10(2), .high = std::log10(6)}, 7),
              testing::ElementsAre("2", "3", "4", "5", "6"));
}

TEST(ValueTicks, AreDistinctAndFiniteForExtremeDoubles) {
  EXPECT_THAT(TextsOf({.low = 308, .high = 308.25}, 3), testing::ElementsAre("1e+308", "1.5e+308"));
  EXPECT_THAT(TextsOf({.low = -324, .high = 309}, 4),
              testing::ElementsAre("1e-200", "1", "1e+200"));
}

TEST(ValueTicks, UseTheExponentOfTheAxisForHugeValues) {
  EXPECT_THAT(LinearTexts({.frame = {.exponent = 300}, .range = {.low = -2e8, .high = 2e8}}),
              testing::ElementsAre("-2e+308", "-1e+308", "0", "1e+308", "2e+308"));
}

TEST(ValueTicks, AreDistancesFromABaseFarFromZero) {
  const UnitAxis axis{.unit = "ns", .frame = {.base = 1.7e18}, .range = {.low = 0, .high = 10}};

  EXPECT_THAT(LinearTexts(axis), testing::ElementsAre("0", "2", "4", "6", "8", "10"));
  EXPECT_EQ(HeadOf(axis), "+1.7e18 ns");
  EXPECT_EQ(HeadOf({.unit = "", .frame = {.base = -9'000'001'230}}), "-9000001230");
}

TEST(ValueTicks, AreWholeForIntegers) {
  EXPECT_THAT(LinearTexts({.range = {.low = -0.3, .high = 2.2}, .numbers = NumberKind::kWhole}),
              testing::ElementsAre("0", "1", "2"));
}

TEST(ValueTicks, AreNamesForStates) {
  const auto names = std::make_shared<const ValueNames>(
      ValueNames{.type = "arm.Mode", .all = {{0, "off"}, {2, "manual"}, {7, "automatic"}}});
  UnitAxis axis{.range = {.low = -0.3, .high = 7.3}, .names = names, .numbers = NumberKind::kWhole};

  const ValueTicks ticks = TicksOf(axis, ValueScale::kLinear, 7);
  EXPECT_THAT(ticks.places, testing::ElementsAre(0, 2, 7));
  EXPECT_THAT(ticks.texts, testing::ElementsAre("off", "manual", "automatic"));

  axis.range.high = 5;
  EXPECT_THAT(LinearTexts(axis), testing::ElementsAre("off", "manual"));
}

TEST(StepText, HasTheDigitsThatDistinguishNeighbours) {
  EXPECT_EQ(StepText(9'000'000'005, 5), "9000000005");
  EXPECT_EQ(StepText(9'000'000'010, 5), "9000000010");
  EXPECT_EQ(StepText(2'500'000, 500'000), "2.5e+06");
  EXPECT_EQ(StepText(1.5e-13, 5e-14), "1.5e-13");
  EXPECT_EQ(StepText(1e-20, 5e-14), "0") << "what rounding left of 0";
}

TEST(PlaceOf, NonPositiveValuesHaveNoLogarithmicPlace) {
  EXPECT_EQ(PlaceOf(-7, ValueScale::kLinear), -7);
  EXPECT_DOUBLE_EQ(PlaceOf(1000, ValueScale::kLogarithmic), 3);
  EXPECT_TRUE(std::isinf(PlaceOf(0, ValueScale::kLogarithmic)));
  EXPECT_TRUE(std::isinf(PlaceOf(-1, ValueScale::kLogarithmic)));
}

}  // namespace
}  // namespace tendon::gui
