#include <gcm_gui/plot/series/time_shift.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

namespace tendon::gui {
namespace {

constexpr std::int64_t kOneSecond = 1'000'000'000;
constexpr std::int64_t kOneHour = 3600 * kOneSecond;
using Limits = std::numeric_limits<std::int64_t>;

TEST(TimeShift, IsWrittenWithItsSignAndItsUnits) {
  EXPECT_EQ(ShiftText(-(2 * kOneHour + 3 * 60 * kOneSecond + kOneSecond * 25 / 2)),
            QString("−2 h 03 min 12.5 s"));
  EXPECT_EQ(ShiftText(26 * kOneHour), "+1 d 2 h 00 min");
  EXPECT_EQ(ShiftText(1), "+0.000000001 s");
  EXPECT_EQ(ShiftText(-kOneSecond), QString("−1 s"));
  EXPECT_EQ(ShiftText(0), "0 s");
}

TEST(TimeShift, IsRoundedToMillisecondsForTheLegend) {
  EXPECT_EQ(RoundedShiftText(kOneSecond + 499'999), "+1 s");
  EXPECT_EQ(RoundedShiftText(-(kOneSecond + 1'600'000)), QString("−1.002 s"));
  EXPECT_EQ(RoundedShiftText(-1), "0 s");
}

TEST(TimeShift, IsReadAsSecondsOrWithUnits) {
  EXPECT_EQ(ShiftIn("-12.5"), -kOneSecond * 25 / 2);
  EXPECT_EQ(ShiftIn(" 7 "), 7 * kOneSecond);
  EXPECT_EQ(ShiftIn("0.000000001 s"), 1);
  EXPECT_EQ(ShiftIn("+2h 3min"), 2 * kOneHour + 180 * kOneSecond);
  EXPECT_EQ(ShiftIn("−1 d 0.25 s"), -(24 * kOneHour + kOneSecond / 4));
  EXPECT_EQ(ShiftIn("0"), 0);
}

TEST(TimeShift, IsRefusedIfItIsNoTimeOrTooLong) {
  for (const char* text : {"", "-", "nan", "NaN", "inf", "1,5", "s", "1e9", "1 s 2 min", "--1",
                           "1.2.3", ".5", "0.0000000001", "99999999999999999999", "40000 d"}) {
    EXPECT_FALSE(ShiftIn(QString::fromLatin1(text))) << text;
  }
  EXPECT_EQ(ShiftIn("36525 d"), kLongestShift);
  EXPECT_FALSE(ShiftIn("36525 d 0.000000001 s"));
  EXPECT_FALSE(ShiftIn("3155760001"));
}

RC_GTEST_PROP(TimeShift, ItsTextIsReadAsTheSameShift, ()) {
  const auto part = *rc::gen::inRange<std::int64_t>(-1'000'000, 1'000'001);
  const auto rest = *rc::gen::inRange<std::int64_t>(0, 3'155'760'000'000);
  const std::int64_t shift = part * 3'155'760'000'000 + (part < 0 ? rest : -rest);
  RC_ASSERT(ShiftIn(ShiftText(shift)) == std::optional(shift));
}

TEST(TimeShift, ATimeStaysAtTheEndsOfTime) {
  EXPECT_EQ(MovedTime(Limits::max() - 1, 2), Limits::max());
  EXPECT_EQ(MovedTime(Limits::min() + 1, -2), Limits::min());
  EXPECT_EQ(MovedTime(-5, 2), -3);
  EXPECT_EQ(MovedTime(Limits::max(), -kLongestShift), Limits::max() - kLongestShift);
}

}  // namespace
}  // namespace tendon::gui
