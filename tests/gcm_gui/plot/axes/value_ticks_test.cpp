#include <gcm_gui/plot/axes/value_ticks.h>
#include <gmock/gmock.h>

#include <cmath>

namespace tendon::gui {
namespace {

std::vector<QString> TextsOf(const AxisRange& range, int most) {
  std::vector<QString> texts;
  for (const double place : TicksOf(range, ValueScale::kLogarithmic, most).places) {
    texts.push_back(LogarithmicText(place));
  }
  return texts;
}

TEST(ValueTicks, OfALinearAxisAreMultiplesOfARoundStep) {
  const ValueTicks ticks = TicksOf({.low = 0, .high = 10}, ValueScale::kLinear, 7);

  EXPECT_EQ(ticks.step, 2);
  EXPECT_THAT(ticks.places, testing::ElementsAre(0, 2, 4, 6, 8, 10));
}

TEST(ValueTicks, OfManyDecadesArePowersOfTen) {
  EXPECT_THAT(TextsOf({.low = -3, .high = 2}, 7),
              testing::ElementsAre("0.001", "0.01", "0.1", "1", "10", "100"));
  EXPECT_LE(TextsOf({.low = -12, .high = 12}, 7).size(), 7U);
}

TEST(ValueTicks, OfTwoDecadesHaveTwoAndFiveToo) {
  EXPECT_THAT(TextsOf({.low = 0, .high = 2}, 7),
              testing::ElementsAre("1", "2", "5", "10", "20", "50", "100"));
}

TEST(ValueTicks, WithinADecadeAreRoundValues) {
  EXPECT_THAT(TextsOf({.low = std::log10(2), .high = std::log10(6)}, 7),
              testing::ElementsAre("2", "3", "4", "5", "6"));
}

TEST(PlaceOf, ZeroAndLessHaveNoneOnALogarithmicAxis) {
  EXPECT_EQ(PlaceOf(-7, ValueScale::kLinear), -7);
  EXPECT_DOUBLE_EQ(PlaceOf(1000, ValueScale::kLogarithmic), 3);
  EXPECT_TRUE(std::isinf(PlaceOf(0, ValueScale::kLogarithmic)));
  EXPECT_TRUE(std::isinf(PlaceOf(-1, ValueScale::kLogarithmic)));
}

}  // namespace
}  // namespace tendon::gui
