#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/property.h>
#include <tendon/base/axis_ticks.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace tendon {
namespace {

using testing::ElementsAre;

constexpr double kMax = std::numeric_limits<double>::max();

template <typename Number>
std::vector<std::string> Labels(const AxisSpan<Number>& span, int most = 5) {
  std::vector<std::string> labels;
  for (const auto& tick : TicksOf(span, most)) labels.push_back(tick.label);
  return labels;
}
std::vector<std::string> FittedLabels(double low, double high, int most = 5) {
  return Labels(FittedSpan(low, high, most), most);
}
template <typename Number>
std::vector<std::string> FittedIntegerLabels(Number low, Number high, int most = 5) {
  return Labels(FittedSpan(low, high, most), most);
}

TEST(AxisTicks, AreRoundWithoutRoundingErrors) {
  EXPECT_THAT(FittedLabels(0.0, 0.5), ElementsAre("0.0", "0.1", "0.2", "0.3", "0.4", "0.5"));
  EXPECT_THAT(FittedLabels(-0.31, 0.29), ElementsAre("-0.4", "-0.2", "0.0", "0.2", "0.4"));
  EXPECT_THAT(FittedLabels(0.0, 40.0), ElementsAre("0", "10", "20", "30", "40"));
}

TEST(AxisTicks, FarFromZeroHaveEnoughDigitsToDiffer) {
  EXPECT_THAT(FittedLabels(9e9, 9e9 + 4),
              ElementsAre("9000000000", "9000000001", "9000000002", "9000000003", "9000000004"));
  EXPECT_THAT(FittedLabels(1.000000000001, 1.000000000003),
              ElementsAre("1.0000000000010", "1.0000000000015", "1.0000000000020",
                          "1.0000000000025", "1.0000000000030"));
}

TEST(AxisTicks, UseExponentsIfShorter) {
  EXPECT_THAT(FittedLabels(0.0, 4e-14 * 1e3), ElementsAre("0", "1e-11", "2e-11", "3e-11", "4e-11"));
  EXPECT_THAT(FittedLabels(0.0, 2e12), ElementsAre("0", "5e+11", "1e+12", "1.5e+12", "2e+12"));
}

TEST(AxisTicks, TreatNoiseAroundZeroAsZero) {
  EXPECT_THAT(FittedLabels(-3e-14, 5e-14), ElementsAre("-1.0", "-0.5", "0.0", "0.5", "1.0"));
  EXPECT_THAT(FittedLabels(0.0, 0.0), ElementsAre("-1.0", "-0.5", "0.0", "0.5", "1.0"));
}

TEST(AxisTicks, SurroundAConstantValue) {
  const double noise = 1e-16;
  EXPECT_EQ(FittedLabels(-0.8, -0.8 + noise), FittedLabels(-0.8, -0.8));
  EXPECT_THAT(FittedLabels(-0.8, -0.8), ElementsAre("-0.90", "-0.85", "-0.80", "-0.75", "-0.70"));
}

TEST(AxisTicks, AreFiniteForTheRangeOfAllDoubles) {
  const AxisSpan<double> span = FittedSpan(-kMax, kMax, 5);

  EXPECT_EQ(span, (AxisSpan<double>{.low = -kMax, .high = kMax}));
  EXPECT_THAT(Labels(span), ElementsAre("-1e+308", "0", "1e+308"));
}

TEST(AxisTicks, ForIntegersAreExactBeyondDoubles) {
  constexpr std::uint64_t kLast = std::numeric_limits<std::uint64_t>::max();
  constexpr std::int64_t kFirst = std::numeric_limits<std::int64_t>::min();
  EXPECT_THAT(FittedIntegerLabels(kLast - 3, kLast),
              ElementsAre("18446744073709551612", "18446744073709551613", "18446744073709551614",
                          "18446744073709551615"));
  EXPECT_THAT(FittedIntegerLabels(kFirst, kFirst + 2),
              ElementsAre("-9223372036854775808", "-9223372036854775807", "-9223372036854775806"));
  EXPECT_THAT(FittedIntegerLabels<std::int64_t>(-7, 12),
              ElementsAre("-10", "-5", "0", "5", "10", "15"));
}

TEST(AxisTicks, ForOneIntegerShowItsNeighbours) {
  EXPECT_THAT(FittedIntegerLabels<std::int64_t>(5, 5), ElementsAre("4", "5", "6"));
  EXPECT_THAT(FittedIntegerLabels<std::uint64_t>(0, 0), ElementsAre("0", "1"));
}

TEST(AxisTicks, ForIntegersAreNeverFractions) {
  EXPECT_THAT(FittedIntegerLabels<std::int64_t>(1, 2, 10), ElementsAre("1", "2"));
}

TEST(AxisPart, IsExactForNeighboursBeyondDoubles) {
  constexpr std::uint64_t kLast = std::numeric_limits<std::uint64_t>::max();
  const AxisSpan<std::uint64_t> span{.low = kLast - 4, .high = kLast};

  EXPECT_EQ(PartOf(span, kLast - 3), 0.25);
  EXPECT_EQ(PartOf(span, std::uint64_t{0}), 0.0);
  EXPECT_EQ(PartOf(AxisSpan<double>{.low = -kMax, .high = kMax}, 0.0), 0.5);
  EXPECT_EQ(PartOf(AxisSpan<double>{.low = 1e15, .high = 1e15 + 8}, 1e15 + 2), 0.25);
}

/// Checks properties that every axis must have.
template <typename Number, typename Read>
void CheckAxis(const AxisSpan<Number>& span, int most, Read read) {
  const auto ticks = TicksOf(span, most);
  RC_ASSERT(!ticks.empty());
  RC_ASSERT(ticks.size() <= 8U * static_cast<std::size_t>(most));
  std::set<std::string> labels;
  double last_part = -1;
  for (const auto& tick : ticks) {
    RC_ASSERT(span.low <= tick.value);
    RC_ASSERT(tick.value <= span.high);
    RC_ASSERT(read(tick.label) == tick.value);
    RC_ASSERT(tick.label != "-0");
    RC_ASSERT(labels.insert(tick.label).second);
    const double part = PartOf(span, tick.value);
    RC_ASSERT(part >= 0 && part <= 1 && part >= last_part);
    last_part = part;
  }
  for (std::size_t i = 1; i < ticks.size(); ++i) RC_ASSERT(ticks[i - 1].value < ticks[i].value);
}

template <typename Number, typename Read>
void CheckAxes(Number one, Number other, int most, Read read) {
  const auto [low, high] = std::minmax(one, other);
  const AxisSpan<Number> wide = WidenedSpan<Number>(low, high);
  const AxisSpan<Number> fitted = FittedSpan<Number>(low, high, most);
  for (const auto& span : {wide, fitted}) {
    RC_ASSERT(span.low < span.high);
    CheckAxis(span, most, read);
  }
  RC_ASSERT(fitted.low <= wide.low && wide.high <= fitted.high);
  if (low < high) CheckAxis(AxisSpan<Number>{.low = low, .high = high}, most, read);
}

double ReadDouble(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

TEST(AxisTicksProperty, HoldForAnyTwoDoubles) {
  test::CheckProperty([] {
    const double one = *test::AnyFinite();
    const double other = *rc::gen::oneOf(test::AnyFinite(), rc::gen::just(one),
                                         rc::gen::map(rc::gen::inRange(-64, 64), [=](int steps) {
                                           // Differs by a few of the smallest steps.
                                           double near = one;
                                           const double towards = std::copysign(
                                               std::numeric_limits<double>::infinity(), steps);
                                           for (int i = 0; i < std::abs(steps); ++i)
                                             near = std::nextafter(near, towards);
                                           return std::isfinite(near) ? near : one;
                                         }));
    CheckAxes(one, other, *rc::gen::inRange(1, 20), &ReadDouble);
  });
}

TEST(AxisTicksProperty, HoldForAnyTwoSignedIntegers) {
  test::CheckProperty([] {
    const auto one = *test::AnyInteger<std::int64_t>();
    const auto other = *test::AnyInteger<std::int64_t>();
    CheckAxes(one, other, *rc::gen::inRange(1, 20),
              [](const std::string& text) { return std::int64_t{std::stoll(text)}; });
  });
}

TEST(AxisTicksProperty, HoldForAnyTwoUnsignedIntegers) {
  test::CheckProperty([] {
    const auto one = *test::AnyInteger<std::uint64_t>();
    const auto other = *test::AnyInteger<std::uint64_t>();
    CheckAxes(one, other, *rc::gen::inRange(1, 20),
              [](const std::string& text) { return std::uint64_t{std::stoull(text)}; });
  });
}

}  // namespace
}  // namespace tendon
