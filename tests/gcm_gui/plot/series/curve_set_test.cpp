#include <gcm_gui/plot/series/curve_set.h>
#include <gmock/gmock.h>

#include <array>

#include "../samples.h"

namespace tendon::gui {
namespace {

constexpr std::array kTenSeconds{
    VisibleSlices{.slices = {.from_ns = 0, .to_ns = 10 * kSecond, .count = 1000}}};

TEST(CurveSet, CurvesOfOneUnitShareAnAxis) {
  CurveSet set;
  set.add({"p/a/state.x", "rad"});
  set.add({"p/a/state.y", "rad/s"});
  set.add({"p/a/state.z", "rad"});

  ASSERT_EQ(set.axes().size(), 2U);
  EXPECT_EQ(set.axes()[0].unit, "rad");
  EXPECT_EQ(set.axes()[0].color_index, -1) << "two curves share it";
  EXPECT_EQ(set.axes()[1].color_index, set.find("p/a/state.y")->colorIndex());
}

TEST(CurveSet, RemovingTheLastCurveRemovesItsAxis) {
  CurveSet set;
  set.add({"p/a/state.x", "rad"});
  set.add({"p/a/state.y", "rad/s"});

  EXPECT_TRUE(set.remove("p/a/state.x"));

  ASSERT_EQ(set.axes().size(), 1U);
  EXPECT_EQ(set.axes()[0].unit, "rad/s");
  EXPECT_FALSE(set.remove("p/a/state.x"));
}

TEST(CurveSet, ReusesAFreeColour) {
  CurveSet set;
  set.add({"x", ""});
  set.add({"y", ""});
  set.remove("x");

  EXPECT_EQ(set.add({"z", ""}).colorIndex(), 0);
  EXPECT_EQ(set.add({"y", ""}).colorIndex(), 1) << "it was there";
}

TEST(CurveSet, FitsEachAxisToItsOwnCurves) {
  CurveSet set;
  set.add({"x", "rad"}).append(Rows(0, 10'000, [](double) { return 1.0; }));
  set.add({"y", "N"}).append(Rows(0, 10'000, [](double t) { return 100 * t; }));

  set.fitAxes(kTenSeconds);

  EXPECT_LT(set.axes()[0].range.high, 2);
  EXPECT_GE(set.axes()[1].range.high, 999);
}

TEST(CurveSet, DoesNotFitAnAxisSetByTheUser) {
  CurveSet set;
  set.add({"x", "rad"}).append(Rows(0, 1000));
  set.axes()[0].range = {.low = 5, .high = 6};
  set.axes()[0].fitted = false;

  set.fitAxes(kTenSeconds);

  EXPECT_EQ(set.axes()[0].range, (AxisRange{.low = 5, .high = 6}));
}

TEST(CurveSet, CountsTheLossesOfASourceOnce) {
  CurveSet set;
  for (const char* path : {"p/a/state.x", "p/a/state.y", "p/b/state.x"}) {
    Curve& curve = set.add({path, ""});
    curve.append(Rows(0, 1000));
    curve.append(Rows(1600, 3000));
  }

  const auto figures = set.figures(3 * kSecond);

  ASSERT_EQ(figures.size(), 2U);
  EXPECT_EQ(figures[0].source, "p/a/state");
  EXPECT_EQ(figures[0].lost, 600U);
  EXPECT_NEAR(figures[0].rate, 1000, 0.5);
}

TEST(CurveSet, ASilentSourceHasNoRate) {
  CurveSet set;
  set.add({"p/a/state.x", ""}).append(Rows(0, 1000));

  EXPECT_GT(set.figures(1 * kSecond).front().rate, 0);
  EXPECT_EQ(set.figures(3 * kSecond).front().rate, 0);
}

TEST(Curve, IsStaleUntilSamplesArriveAndWhenMarked) {
  Curve curve({"robot/arm/state.x", "rad"}, 0);
  EXPECT_TRUE(curve.isStale());
  EXPECT_EQ(curve.staleReason(), "waiting for robot/arm/state");

  curve.append(Rows(0, 1));
  EXPECT_FALSE(curve.isStale());

  curve.setStale("lost 12 s ago");
  EXPECT_TRUE(curve.isStale());
}

TEST(Curve, NumberAtReturnsThePreviousSample) {
  Curve curve({"x", ""}, 0);
  curve.append(std::vector<Sample>{{.time_ns = 10, .tick = 1, .value = 1},
                                   {.time_ns = 20, .tick = 2, .value = 2},
                                   {.time_ns = 50, .tick = 5, .value = 5}});

  EXPECT_EQ(curve.numberAt(9), std::nullopt);
  EXPECT_EQ(curve.numberAt(10), 1.0);
  EXPECT_EQ(curve.numberAt(19), 1.0);
  EXPECT_EQ(curve.numberAt(30), std::nullopt) << "rows are missing here";
  EXPECT_EQ(curve.numberAt(90), 5.0);
}

TEST(Curve, MeasuresASlowRate) {
  Curve curve({"x", ""}, 0);
  curve.append(std::vector<Sample>{{.time_ns = 0, .tick = 1, .value = 1},
                                   {.time_ns = 2 * kSecond, .tick = 2, .value = 2}});

  EXPECT_DOUBLE_EQ(curve.rate(), 0.5);
}

}  // namespace
}  // namespace tendon::gui
