#include <gcm_gui/models/text.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <optional>

namespace tendon::gui {
namespace {

TEST(Text, NumbersShowFourDigits) {
  EXPECT_EQ(NumberText(0), "0");
  EXPECT_EQ(NumberText(12), "12");
  EXPECT_EQ(NumberText(0.20134), "0.2013");
  EXPECT_EQ(NumberText(-1.25), "-1.250");
  EXPECT_EQ(NumberText(0.000998), "0.000998");
  EXPECT_EQ(NumberText(123.456), "123.5");
  EXPECT_EQ(NumberText(1.5e-7), "1.5e-07");
  EXPECT_EQ(NumberText(std::numeric_limits<double>::infinity()), "inf");
}

TEST(Text, DurationsUseAFittingUnit) {
  EXPECT_EQ(DurationText(420e-9), "420 ns");
  EXPECT_EQ(DurationText(38e-6), "38.0 µs");
  EXPECT_EQ(DurationText(-347e-6), "-347 µs");
  EXPECT_EQ(DurationText(1e-3), "1.000 ms");
  EXPECT_EQ(DurationText(0.0384), "38.40 ms");
  EXPECT_EQ(DurationText(2.5), "2.50 s");
}

TEST(Text, ADurationNeverRoundsToAThousandOfAUnit) {
  EXPECT_EQ(DurationText(999.6e-9), "1.0 µs");
  EXPECT_EQ(DurationText(999.6e-6), "1.000 ms");
  EXPECT_EQ(DurationText(0.99996), "1.00 s");
}

TEST(Text, RatesComeFromPeriods) {
  EXPECT_EQ(RateOfPeriodText(1e-3), "1 kHz");
  EXPECT_EQ(RateOfPeriodText(0.02), "50 Hz");
  EXPECT_EQ(RateOfPeriodText(0), "");
}

TEST(Text, AgesGrowCoarser) {
  EXPECT_EQ(AgeText(12'400'000'000), "12 s");
  EXPECT_EQ(AgeText(180'000'000'000), "3 min");
  EXPECT_EQ(AgeText(47 * 3'600'000'000'000), "47 h");
  EXPECT_EQ(AgeText(121 * 3'600'000'000'000), "5 d");
  EXPECT_EQ(AgeText(-5), "0 s");
}

TEST(Text, EnumsAndBooleansShowTheirNames) {
  NumericField enumeration;
  enumeration.schema = Schema::Enum("arm.Mode", {{"off", 0}, {"on", 1}});
  NumericField boolean;
  boolean.schema = Schema(Schema::Kind::kBool);

  EXPECT_EQ(QuantityOf(enumeration, NumericValue(std::int32_t{1})).number, "on");
  EXPECT_EQ(QuantityOf(enumeration, NumericValue(std::int32_t{7})).number, "7");
  EXPECT_EQ(QuantityOf(boolean, NumericValue(false)).number, "false");
  EXPECT_EQ(QuantityOf(boolean, std::nullopt).number, "–");
}

TEST(Text, IntegersHaveAllTheirDigits) {
  NumericField counter;
  counter.schema = Schema(Schema::Kind::kUint64);
  counter.unit = "ns";
  const NumericValue last(std::numeric_limits<std::uint64_t>::max());
  const NumericValue odd((std::int64_t{1} << 53) + 1);

  EXPECT_EQ(QuantityOf(counter, last).number, "18446744073709551615");
  EXPECT_EQ(QuantityOf(counter, odd).number, "9007199254740993");
  EXPECT_EQ(WholeText(counter, last), "") << "it is whole already";
}

TEST(Text, ARoundedNumberHasAnExactText) {
  NumericField angle;
  angle.schema = Schema(Schema::Kind::kFloat64);
  angle.unit = "rad";
  NumericField stamp;
  stamp.schema = Schema(Schema::Kind::kFloat64);
  stamp.unit = "s";
  const auto shown = [](const NumericField& field, double value) {
    return QuantityOf(field, NumericValue(value)).number;
  };
  const auto whole = [](const NumericField& field, double value) {
    return WholeText(field, NumericValue(value));
  };

  EXPECT_EQ(shown(angle, 0.1 + 0.2), "0.3000");
  EXPECT_EQ(whole(angle, 0.1 + 0.2), "0.30000000000000004 rad");
  EXPECT_EQ(whole(angle, 12), "") << "it is whole already";
  EXPECT_EQ(shown(stamp, 1764300000.25), "1764300000");
  EXPECT_EQ(whole(stamp, 1764300000.25), "1764300000.25 s");
  EXPECT_EQ(shown(stamp, 1.956e-5), "19.6");
  EXPECT_EQ(whole(stamp, 1.956e-5), "1.956e-05 s");
  EXPECT_EQ(shown(angle, std::numeric_limits<double>::quiet_NaN()), "nan");
}

TEST(Text, FractionsOfASecondUseAFittingUnit) {
  NumericField seconds;
  seconds.unit = "s";
  NumericField angle;
  angle.unit = "rad";
  const auto text = [](const NumericField& field, double value) {
    const auto [number, unit] = QuantityOf(field, NumericValue(value));
    return number + ' ' + unit;
  };

  EXPECT_EQ(text(seconds, 1.956e-5), "19.6 µs");
  EXPECT_EQ(text(seconds, 0.0384), "38.40 ms");
  EXPECT_EQ(text(seconds, 0), "0 s");
  EXPECT_EQ(text(seconds, 12), "12 s");
  EXPECT_EQ(text(angle, 0.0384), "0.0384 rad");
}

}  // namespace
}  // namespace tendon::gui
