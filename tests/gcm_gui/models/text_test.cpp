#include <gcm_gui/models/text.h>
#include <gtest/gtest.h>

#include <limits>

namespace tendon::gui {
namespace {

TEST(Text, NumbersAreShortAndShowFourDigits) {
  EXPECT_EQ(NumberText(0), "0");
  EXPECT_EQ(NumberText(12), "12");
  EXPECT_EQ(NumberText(0.20134), "0.2013");
  EXPECT_EQ(NumberText(-1.25), "-1.250");
  EXPECT_EQ(NumberText(0.000998), "0.000998");
  EXPECT_EQ(NumberText(123.456), "123.5");
  EXPECT_EQ(NumberText(1.5e-7), "1.5e-07");
  EXPECT_EQ(NumberText(std::numeric_limits<double>::infinity()), "inf");
}

TEST(Text, DurationsTakeTheUnitThatFits) {
  EXPECT_EQ(DurationText(38e-6), "38 µs");
  EXPECT_EQ(DurationText(1e-3), "1.000 ms");
  EXPECT_EQ(DurationText(0.0384), "38.40 ms");
  EXPECT_EQ(DurationText(2.5), "2.50 s");
}

TEST(Text, RatesComeFromPeriods) {
  EXPECT_EQ(RateOfPeriodText(1e-3), "1 kHz");
  EXPECT_EQ(RateOfPeriodText(0.02), "50 Hz");
  EXPECT_EQ(RateOfPeriodText(0), "");
}

TEST(Text, AgesGrowCoarser) {
  EXPECT_EQ(AgeText(12'400'000'000), "12 s");
  EXPECT_EQ(AgeText(180'000'000'000), "3 min");
  EXPECT_EQ(AgeText(-5), "0 s");
}

TEST(Text, AChannelIsShownAsItIsMeant) {
  PlotChannel enumeration;
  enumeration.schema = Schema::Enum("arm.Mode", {{"off", 0}, {"on", 1}});
  PlotChannel boolean;
  boolean.schema = Schema(Schema::Kind::kBool);

  EXPECT_EQ(ChannelText(enumeration, 1), "on");
  EXPECT_EQ(ChannelText(enumeration, 7), "7");
  EXPECT_EQ(ChannelText(boolean, 0), "false");
  EXPECT_EQ(ChannelText(boolean, std::numeric_limits<double>::quiet_NaN()), "–");
}

}  // namespace
}  // namespace tendon::gui
