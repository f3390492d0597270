#include <gcm_gui/models/sparkline.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/plot/series/axis_range.h>
#include <gtest/gtest.h>
#include <tendon/base/axis_ticks.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "support/property.h"

namespace tendon::gui {
namespace {

template <typename T>
Sparkline SparklineOf(Schema::Kind kind, const std::vector<T>& values) {
  QList<std::optional<NumericValue>> all;
  for (const T& value : values) all.append(NumericValue(value));
  return gui::SparklineOf(Schema(kind), all);
}

TEST(Sparkline, FillsTheHeight) {
  const Sparkline trend = SparklineOf<double>(Schema::Kind::kFloat64, {1, 3, 2});

  EXPECT_EQ(trend.parts, (QList<double>{0, 1, 0.5}));
  EXPECT_FALSE(trend.is_stepped);
}

TEST(Sparkline, DrawsStatesAsSteps) {
  const Sparkline trend = SparklineOf<bool>(Schema::Kind::kBool, {true, true});

  EXPECT_EQ(trend.parts, (QList<double>{1, 1})) << "true is above, also where nothing is false";
  EXPECT_TRUE(trend.is_stepped);
}

TEST(Sparkline, KeepsTheDifferencesOfHugeCounters) {
  constexpr std::uint64_t kLast = std::numeric_limits<std::uint64_t>::max();

  EXPECT_EQ(SparklineOf<std::uint64_t>(Schema::Kind::kUint64, {kLast - 4, kLast - 3, kLast}).parts,
            (QList<double>{0, 0.25, 1}));
}

TEST(Sparkline, DrawsNoiseAtRestFlat) {
  const Sparkline trend = SparklineOf<double>(Schema::Kind::kFloat64, {5e-14, -5e-14, 3e-14});

  EXPECT_EQ(trend.parts.size(), 3);
  for (const double part : trend.parts) EXPECT_NEAR(part, 0.5, 1e-9);
}

TEST(Sparkline, DrawsMissingAndNonFiniteValuesAsGaps) {
  const QList<std::optional<NumericValue>> values{
      NumericValue(0.0), std::nullopt, NumericValue(std::numeric_limits<double>::infinity()),
      NumericValue(1.0)};
  const Sparkline trend = gui::SparklineOf(Schema(Schema::Kind::kFloat64), values);

  ASSERT_EQ(trend.parts.size(), 4);
  EXPECT_EQ(trend.parts[0], 0);
  EXPECT_TRUE(std::isnan(trend.parts[1]));
  EXPECT_TRUE(std::isnan(trend.parts[2]));
  EXPECT_EQ(trend.parts[3], 1);
}

template <typename T>
void CheckTrends(Schema::Kind kind, const rc::Gen<T>& any) {
  test::CheckProperty([&] {
    const auto values = *rc::gen::container<std::vector<T>>(any);
    const Sparkline trend = SparklineOf<T>(kind, values);
    RC_ASSERT(trend.parts.size() == static_cast<qsizetype>(values.size()));
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double part = trend.parts[static_cast<qsizetype>(i)];
      const bool is_there = std::isfinite(NumericValue(values[i]).real());
      RC_ASSERT(std::isnan(part) != is_there);
      if (is_there) RC_ASSERT(part >= 0 && part <= 1);
    }
  });
}

TEST(TrendProperty, PlacesEveryNumber) {
  CheckTrends<double>(Schema::Kind::kFloat64, test::AnyDouble());
  CheckTrends<std::int64_t>(Schema::Kind::kInt64, test::AnyInteger<std::int64_t>());
  CheckTrends<std::uint64_t>(Schema::Kind::kUint64, test::AnyInteger<std::uint64_t>());
}

/// The text in a cell is the rounded number; the text in its tool tip is exactly the number.
TEST(ValueTextProperty, ReadsBackAsTheSameNumber) {
  test::CheckProperty([] {
    const double value = *test::AnyFinite();
    NumericField field;
    field.schema = Schema(Schema::Kind::kFloat64);
    const std::string shown = QuantityOf(field, NumericValue(value)).number.toStdString();
    const std::string whole = WholeText(field, NumericValue(value)).toStdString();
    // The largest double, when rounded, exceeds the range of doubles.
    const long double near = std::strtold(shown.c_str(), nullptr);
    RC_ASSERT(std::abs(near - value) <= std::abs(value) * 6e-3L);
    RC_ASSERT(std::strtod((whole.empty() ? shown : whole).c_str(), nullptr) == value);
  });
}

TEST(Sparkline, AgreesWithPlotsAndTheConsoleOnNoiseAtRest) {
  int resting = 0;
  int moving = 0;
  for (const double size : {1e-13, 9e-13, 2e-12, 1.0, 1e9, 1e200}) {
    for (int step = 0; step < 40; ++step) {
      const double high = size * (1 + step * 1e-14);
      const AxisSpan<double> span = WidenedSpan(size, high);
      const bool is_at_rest = span.low != size || span.high != high;
      EXPECT_EQ(IsFlat({.low = size, .high = high}, 0, NumberKind::kReal), is_at_rest)
          << size << " " << step;
      ++(is_at_rest ? resting : moving);
    }
  }
  EXPECT_GT(resting, 0);
  EXPECT_GT(moving, 0);
}

}  // namespace
}  // namespace tendon::gui
