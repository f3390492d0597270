// Curves are drawn at their values and in their form: also far from 0, and as steps.

#include <gcm_gui/plot/canvas/axis_labels.h>
#include <gcm_gui/plot/canvas/cursor_lines.h>
#include <gcm_gui/plot/canvas/value_ticks.h>
#include <gcm_gui/plot/controls/legend.h>
#include <gcm_gui/plot/controls/plot_overlay.h>
#include <gcm_gui/plot/plot_layout.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/theme/theme.h>
#include <gmock/gmock.h>
#include <qwt_scale_map.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "samples.h"

namespace tendon::gui {
namespace {

using namespace std::chrono_literals;

const QString kSignal = "robot/arm/state.x";

/// Ten seconds of rows in a paused view, so that the pixels do not move.
class PlotValues : public testing::Test {
 protected:
  void SetUp() override {
    Theme::instance().choose(Theme::Choice::kDark);
    ShowView(view_);
    view_.setWindow(10s);
  }

  Curve& show(const std::vector<Sample>& rows, const QString& unit = {}) {
    Curve& curve = view_.addCurve({kSignal, unit});
    curve.append(rows);
    Painted(view_);
    view_.setPaused(true);
    view_.refresh();
    view_.findChild<QWidget*>("live")->hide();  // this button covers the newest samples
    image_ = view_.grab().toImage();
    return curve;
  }

  static std::vector<Sample> Integers(std::uint64_t count,
                                      const std::function<std::int64_t(std::uint64_t)>& value) {
    std::vector<Sample> rows = Rows(0, count);
    for (Sample& row : rows) row.value = ExactNumber::Signed(value(row.tick));
    return rows;
  }

  /// Returns one row each 500 ms, like a mode that is published at 2 Hz.
  static std::vector<Sample> AtTwoHz(const std::vector<std::int64_t>& values) {
    std::vector<Sample> rows = Rows(0, values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      rows[i].time_ns = static_cast<std::int64_t>(i) * kSecond / 2;
      rows[i].value = ExactNumber::Signed(values[i]);
    }
    return rows;
  }

  [[nodiscard]] bool isCurveAt(int x, int y) const {
    const QPoint place = view_.canvas()->mapTo(&view_, QPoint(x, y));
    const QColor here = image_.pixelColor(place);
    const QColor curve = Theme::instance().curve(0);
    return std::abs(here.red() - curve.red()) + std::abs(here.green() - curve.green()) +
               std::abs(here.blue() - curve.blue()) <
           60;
  }

  /// Returns the middle of the drawn pixels in a column of the canvas; no value if there are none.
  [[nodiscard]] std::optional<double> drawnRow(int x) const {
    int first = -1;
    int last = -1;
    for (int y = 0; y < view_.canvas()->height(); ++y) {
      if (!isCurveAt(x, y)) continue;
      if (first < 0) first = y;
      last = y;
    }
    if (first < 0) return std::nullopt;
    return (first + last) / 2.0;
  }

  [[nodiscard]] double rowOfDistance(double distance) const {
    const UnitAxis& axis = view_.curves().axes().front();
    const double part = (distance * axis.frame.factor() - axis.range.low) / axis.range.span();
    return (1 - part) * (view_.canvas()->height() - 1);
  }

  [[nodiscard]] int columnOf(std::int64_t time_ns) const {
    return static_cast<int>(
        std::lround(view_.transform(QwtAxis::XBottom, view_.timeWindow().pointOf(time_ns))));
  }

  [[nodiscard]] const LegendEntry& entry() {
    view_.setHover(0);
    view_.setHover({});
    return view_.legendBox().rows().front()->entry();
  }

  PlotView view_;
  QImage image_;
};

class PlotValuesFarFrom0 : public PlotValues, public testing::WithParamInterface<double> {};

TEST_P(PlotValuesFarFrom0, AConstantIsDrawnAtItsValue) {
  show(Rows(0, 10'000, [](double) { return GetParam(); }));

  const double base = view_.curves().axes().front().frame.base;
  const auto row = drawnRow(columnOf(5 * kSecond));
  ASSERT_TRUE(row.has_value());
  EXPECT_NEAR(*row, rowOfDistance(GetParam() - base), 1);
}

TEST_P(PlotValuesFarFrom0, ACounterIsDrawnAtItsValues) {
  const auto first = static_cast<std::int64_t>(GetParam());
  show(Integers(10'000, [&](std::uint64_t i) { return first + static_cast<std::int64_t>(i); }));

  const UnitAxis& axis = view_.curves().axes().front();
  EXPECT_LT(axis.range.span(), 20'000) << "of a counter that goes on by 10,000";
  const DistanceFrom distance(ExactNumber::Kind::kSigned, axis.frame.base);
  for (const std::int64_t at_ms : {2000, 5000, 8000}) {
    const auto row = drawnRow(columnOf(at_ms * kMillisecond));
    ASSERT_TRUE(row.has_value());
    const double there = distance(static_cast<std::uint64_t>(first + at_ms));
    EXPECT_NEAR(*row, rowOfDistance(there), 1.5) << at_ms;
  }
}

TEST_P(PlotValuesFarFrom0, LabelsDifferAndAddUp) {
  const auto first = static_cast<std::int64_t>(GetParam());
  show(Integers(10'000, [&](std::uint64_t i) { return first + static_cast<std::int64_t>(i); }));

  const UnitAxis& axis = view_.curves().axes().front();
  const ValueTicks ticks = TicksOf(axis, ValueScale::kLinear, PlotAxes::kValueSteps);

  ASSERT_GE(ticks.places.size(), 3U);
  for (std::size_t i = 0; i < ticks.places.size(); ++i) {
    EXPECT_EQ(ticks.texts[i].toDouble(), ticks.places[i]);
    EXPECT_LT(ticks.texts[i].size(), 8);
  }
  EXPECT_EQ(HeadOf(axis).toDouble(), axis.frame.base);
  EXPECT_EQ(entry().value, QString::number(first + 9999)) << "with all its digits";
}

INSTANTIATE_TEST_SUITE_P(Counters, PlotValuesFarFrom0,
                         testing::Values(9e9, -9e9, 1e15, 4e15, 1.7e18));

TEST_F(PlotValues, UnixSecondsAreDrawnAtTheirValue) {
  show(Rows(0, 10'000, [](double t) { return 1'764'300'000 + t; }), "s");

  const double base = view_.curves().axes().front().frame.base;
  EXPECT_GT(base, 1e9);
  for (const int second : {2, 5, 8}) {
    const auto row = drawnRow(columnOf(second * kSecond));
    ASSERT_TRUE(row.has_value());
    EXPECT_NEAR(*row, rowOfDistance(1'764'300'000 + second - base), 1.5);
  }
  EXPECT_NEAR(entry().value.toDouble(), 1'764'300'009.999, 0.02);
}

TEST_F(PlotValues, TheLargestDoublesAreDrawnAtBothEnds) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  show(Rows(0, 10'000, [](double t) { return t < 5 ? kLargest : -kLargest; }));

  const auto before = drawnRow(columnOf(2 * kSecond));
  const auto after = drawnRow(columnOf(8 * kSecond));
  ASSERT_TRUE(before && after);
  EXPECT_NEAR(*before, rowOfDistance(kLargest), 1);
  EXPECT_NEAR(*after, rowOfDistance(-kLargest), 1);
}

TEST_F(PlotValues, ATinyConstantIsALineAtZero) {
  show(Rows(0, 10'000, [](double) { return std::numeric_limits<double>::denorm_min(); }));

  const auto row = drawnRow(columnOf(5 * kSecond));
  ASSERT_TRUE(row.has_value());
  EXPECT_NEAR(*row, rowOfDistance(0), 1);
}

TEST_F(PlotValues, AnExtremeCurveIsNamedAndLeavesOthersReadable) {
  view_.addCurve({kSignal, "rad"}).append(Rows(0, 10'000, [](double t) { return std::sin(t); }));
  view_.addCurve({"robot/arm/state.broken", "rad"}).append(Rows(0, 10'000, [](double) {
    return std::numeric_limits<double>::max();
  }));
  Painted(view_);
  Painted(view_);

  EXPECT_LT(view_.curves().axes().front().range.span(), 4);
  EXPECT_THAT(view_.overlay().note().toStdString(), testing::HasSubstr("arm.broken"));

  view_.removeCurve("robot/arm/state.broken");
  Painted(view_);
  EXPECT_TRUE(view_.overlay().note().isEmpty());
}

TEST_F(PlotValues, StatesAreDrawnAsSteps) {
  show(AtTwoHz({0, 7, 7, 0, 7, 0, 0, 7, 7, 7, 0, 0, 7, 0, 7, 0, 7, 0, 7, 0}));

  // Each value is visible for half a second. The step itself is one or two columns wide.
  for (int i = 2; i < 18; ++i) {
    const int from = columnOf(i * kSecond / 2) + 5;
    const int to = columnOf((i + 1) * kSecond / 2) - 5;
    const auto level = drawnRow(from);
    ASSERT_TRUE(level.has_value()) << i;
    const bool is_low = std::abs(*level - rowOfDistance(0)) <= 1;
    const bool is_high = std::abs(*level - rowOfDistance(7)) <= 1;
    EXPECT_TRUE(is_low || is_high) << "a state that never was, at " << i << ": row " << *level;
    for (int x = from; x <= to; ++x) EXPECT_EQ(drawnRow(x), level) << i << ", column " << x;
  }
  KeepPicture(image_, "plot_steps");
}

ValueNamesPointer Modes() {
  return std::make_shared<const ValueNames>(
      ValueNames{.type = "arm.Mode", .all = {{0, "off"}, {2, "manual"}, {7, "automatic"}}});
}

TEST_F(PlotValues, StatesShowTheirNameOnAxisLegendAndCursors) {
  view_.addCurve({kSignal, ""});
  view_.setNames(kSignal, Modes());
  view_.setStatistics(true);
  show(AtTwoHz({0, 0, 0, 0, 0, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7}));

  const auto label = [&](double place) {
    return view_.axisScaleDraw(QwtAxis::YLeft)->label(place).text();
  };
  EXPECT_EQ(label(0), "off");
  EXPECT_EQ(label(2), "manual");
  EXPECT_EQ(label(7), "automatic");
  EXPECT_EQ(view_.curves().axes().front().unit, "arm.Mode");
  EXPECT_EQ(entry().value, "automatic");
  EXPECT_EQ(entry().unit, "");
  EXPECT_THAT(entry().figures.toStdString(), testing::HasSubstr("off 2"));
  EXPECT_THAT(entry().figures.toStdString(), testing::HasSubstr("automatic 7"));

  view_.cursors().place(Cursor::kA, columnOf(kSecond));
  view_.cursors().place(Cursor::kB, columnOf(8 * kSecond));
  const auto lines =
      CursorLines(view_.curves(), view_.timeWindow(), view_.cursors().times()).lines();
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[1].text, "off → automatic");
  KeepPicture(Painted(view_), "plot_states");
}

TEST_F(PlotValues, AScaledStateIsShownAsANumber) {
  view_.addCurve({kSignal, ""});
  view_.setNames(kSignal, Modes());
  show(AtTwoHz({0, 7, 7, 7}));

  view_.setLook(kSignal, {.scaling = {.factor = 10}, .axis = {}});
  Painted(view_);

  EXPECT_EQ(entry().value.toDouble(), 70);
  EXPECT_EQ(view_.curves().axes().front().unit, "×10");
}

TEST_F(PlotValues, ASecondPlotOfASignalHasItsStateNames) {
  PlotPanel panel;
  panel.addSignal(kSignal, "");
  panel.setNames(kSignal, Modes());

  panel.addPlot();
  panel.addSignal(kSignal, "");

  ASSERT_NE(panel.currentPlot().curve(kSignal)->names(), nullptr);
  EXPECT_EQ(panel.currentPlot().curve(kSignal)->names()->type, "arm.Mode");
}

TEST_F(PlotValues, AMovedAxisBaseKeepsTheZoom) {
  show(Integers(10'000,
                [](std::uint64_t i) { return 9'000'000'000 + static_cast<std::int64_t>(i); }));
  view_.gestures().zoomValues(0.5, 100);
  const UnitAxis before = view_.curves().axes().front();
  view_.gestures().goLive();
  view_.curve(kSignal)->append(Integers(20'000, [](std::uint64_t i) {
    return i < 10'000 ? 0 : 90'000'000'000 + static_cast<std::int64_t>(i);
  }));
  Painted(view_);
  ASSERT_NE(view_.curves().axes().front().frame, before.frame);

  view_.gestures().goBack();

  const UnitAxis& after = view_.curves().axes().front();
  EXPECT_NEAR(after.frame.base + after.range.low, before.frame.base + before.range.low, 1e-3);
  EXPECT_NEAR(after.range.span(), before.range.span(), 1e-3);
}

TEST(PlotValuesOfALayout, OpensWithTheLargestDoubles) {
  PlotPanel saved;
  saved.addSignal(kSignal, "rad");
  const QByteArray layout = LayoutOf(saved);

  PlotPanel panel;
  panel.resize(800, 320);
  panel.show();
  ASSERT_EQ(ShowLayout(panel, layout), std::nullopt);
  panel.append(kSignal, Rows(0, 10'000, [](double t) {
                 constexpr double kLargest = std::numeric_limits<double>::max();
                 return std::fmod(t, 2) < 1 ? kLargest : -kLargest;
               }));
  const QImage image = Painted(panel.currentPlot());

  EXPECT_FALSE(image.isNull());
  EXPECT_TRUE(IsShowable(panel.currentPlot().curves().axes().front().range));
}

TEST_F(PlotValues, AnIntegerAxisIsNotZoomedBelowOneStep) {
  show(Integers(10'000, [](std::uint64_t i) { return static_cast<std::int64_t>(i % 7); }));

  for (int i = 0; i < 50; ++i) view_.gestures().zoomValues(0.8, 100);

  const UnitAxis& axis = view_.curves().axes().front();
  EXPECT_LT(axis.range.span(), 2);
  EXPECT_FALSE(TicksOf(axis, ValueScale::kLinear, 7).places.empty());
}

}  // namespace
}  // namespace tendon::gui
