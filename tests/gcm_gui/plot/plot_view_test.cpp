#include <gcm_gui/plot/canvas/axis_labels.h>
#include <gcm_gui/plot/controls/legend.h>
#include <gcm_gui/plot/controls/plot_overlay.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/theme/theme.h>
#include <gmock/gmock.h>
#include <qwt_interval.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_map.h>
#include <qwt_scale_widget.h>

#include <QDropEvent>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "samples.h"

namespace tendon::gui {
namespace {

using namespace std::chrono_literals;

class PlotViewTest : public testing::Test {
 protected:
  void SetUp() override {
    Theme::instance().choose(Theme::Choice::kDark);
    ShowView(view_);
    view_.setWindow(10s);
  }

  [[nodiscard]] int pixelsOf(const QImage& image, const QColor& color) const {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) count += image.pixelColor(x, y) == color ? 1 : 0;
    }
    return count;
  }

  PlotView view_;
};

TEST_F(PlotViewTest, AnEmptyPlotExplainsHowToAddACurve) {
  EXPECT_THAT(view_.accessibleDescription().toStdString(), testing::HasSubstr("press P"));
  EXPECT_FALSE(view_.isAxisVisible(QwtAxis::YLeft));
}

TEST_F(PlotViewTest, DrawsACurveInItsColour) {
  view_.addCurve({"p/a/state.x", "rad"}).append(Rows(0, 10'000, [](double t) {
    return std::sin(t);
  }));

  const QImage image = Painted(view_);

  EXPECT_GT(pixelsOf(image, Theme::instance().curve(0)), 500);
}

TEST_F(PlotViewTest, KeepsNowAtTheRightEdge) {
  Curve& curve = view_.addCurve({"p/a/state.x", "rad"});
  curve.append(Rows(0, 10'000));
  view_.refresh();
  const std::int64_t before = view_.timeWindow().origin();

  curve.append(Rows(10'000, 20'000));
  view_.refresh();

  EXPECT_NEAR(static_cast<double>(view_.timeWindow().origin() - before), 10e9, 0.5e9);
}

TEST_F(PlotViewTest, ScrollsByWholeColumns) {
  Curve& curve = view_.addCurve({"p/a/state.x", "rad"});
  curve.append(Rows(0, 10'000));
  Painted(view_);
  Painted(view_);
  const QwtScaleMap map = view_.canvasMap(QwtAxis::XBottom);
  const double column_ns = 10e9 / (map.p2() - map.p1());
  const std::int64_t before = view_.timeWindow().origin();

  curve.append(Rows(10'000, 13'333));
  view_.refresh();

  const double columns = static_cast<double>(view_.timeWindow().origin() - before) / column_ns;
  EXPECT_GT(columns, 100);
  EXPECT_NEAR(columns, std::round(columns), 1e-6);
}

TEST_F(PlotViewTest, ASecondUnitGetsARightAxisInItsCurveColour) {
  view_.addCurve({"p/a/state.x", "rad"}).append(Rows(0, 10'000));
  const auto* right = view_.axisScaleDraw(QwtAxis::YRight);
  EXPECT_FALSE(right->hasComponent(QwtAbstractScaleDraw::Labels));

  view_.addCurve({"p/a/state.v", "rad/s"}).append(Rows(0, 10'000, [](double t) {
    return 1000 * t;
  }));
  view_.refresh();

  EXPECT_TRUE(right->hasComponent(QwtAbstractScaleDraw::Labels));
  EXPECT_GE(view_.axisInterval(QwtAxis::YRight).maxValue(), 9999);
  EXPECT_LT(view_.axisInterval(QwtAxis::YLeft).maxValue(), 20);
  EXPECT_EQ(dynamic_cast<const AxisLabels*>(right)->color(), Theme::instance().curve(1));
}

TEST_F(PlotViewTest, TheCanvasKeepsItsPlaceWithMoreAxesAndDigits) {
  Curve& curve = view_.addCurve({"p/a/state.x", "rad"});
  curve.append(Rows(0, 1000));
  Painted(view_);
  const QRect before = view_.canvas()->geometry();

  view_.addCurve({"p/a/state.v", "rad/s"}).append(Rows(0, 1000));
  curve.append(Rows(1000, 2000, [](double) { return -800.5; }));
  Painted(view_);

  EXPECT_EQ(view_.canvas()->geometry(), before);
}

TEST_F(PlotViewTest, AFifthUnitIsDrawnWithoutItsOwnAxis) {
  for (const char* unit : {"rad", "rad/s", "V", "A"}) {
    view_.addCurve({QString("p/a/state.") + unit, unit}).append(Rows(0, 10'000));
  }
  view_.addCurve({"p/a/state.t", "Nm"}).append(Rows(0, 10'000, [](double t) {
    return 1e5 * std::cos(t);
  }));

  EXPECT_GT(pixelsOf(Painted(view_), Theme::instance().curve(4)), 500);
}

TEST_F(PlotViewTest, PausingStopsTheViewAndLosesNoSample) {
  Curve& curve = view_.addCurve({"p/a/state.x", "rad"});
  curve.append(Rows(0, 10'000));
  view_.refresh();
  view_.setPaused(true);
  const std::int64_t origin = view_.timeWindow().origin();

  curve.append(Rows(10'000, 60'000));
  view_.refresh();
  EXPECT_EQ(view_.timeWindow().origin(), origin);
  EXPECT_EQ(curve.samples().endIndex(), 60'000U);
  EXPECT_EQ(curve.samples().lost(), 0U);

  view_.setPaused(false);
  view_.refresh();
  EXPECT_NEAR(static_cast<double>(view_.timeWindow().origin()), 60e9, 0.5e9);
}

TEST_F(PlotViewTest, TheLegendShowsTheCurrentOrHoveredValue) {
  view_.addCurve({"robot/arm/state.x", "rad"}).append(Rows(0, 10'000));
  view_.refresh();
  ASSERT_EQ(view_.legendBox().rows().size(), 1U);
  const LegendRow& row = *view_.legendBox().rows().front();
  view_.setHover(0);
  view_.setHover({});
  EXPECT_EQ(row.entry().name, "arm.x");
  EXPECT_NEAR(row.entry().value.toDouble(), 9.999, 0.05);

  const double middle = view_.transform(QwtAxis::XBottom, -5);
  view_.setHover(static_cast<int>(middle));

  EXPECT_NEAR(row.entry().value.toDouble(), 5, 0.2);
}

TEST_F(PlotViewTest, ASilentSourceIsGreyInTheLegendUntilItResumes) {
  Curve& curve = view_.addCurve({"robot/arm/state.x", "rad"});
  const LegendRow& row = *view_.legendBox().rows().front();
  EXPECT_TRUE(row.entry().stale);
  EXPECT_EQ(row.entry().name, "arm.x · waiting for robot/arm/state");

  curve.append(Rows(0, 10));
  view_.setHover(0);
  view_.setHover({});

  EXPECT_FALSE(row.entry().stale);
}

TEST_F(PlotViewTest, TheLegendHidesACurve) {
  view_.addCurve({"p/a/state.x", "rad"}).append(Rows(0, 10'000, [](double) { return 1.0; }));
  EXPECT_GT(pixelsOf(Painted(view_), Theme::instance().curve(0)), 500);

  QTest::keyClick(view_.legendBox().rows().front(), Qt::Key_Space);

  EXPECT_LT(pixelsOf(Painted(view_), Theme::instance().curve(0)), 100) << "the swatch is left";
}

TEST_F(PlotViewTest, ForwardsDroppedPaths) {
  QSignalSpy dropped(&view_, &PlotView::curvesDropped);
  QMimeData data;
  data.setData(kPathMimeType, EncodedPaths({{"p/a/state.x", "rad"}, {"p/a/state.y", "rad"}}));
  QDragEnterEvent enter({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, {});
  QDropEvent drop({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, {});

  QApplication::sendEvent(&view_, &enter);
  QApplication::sendEvent(&view_, &drop);

  EXPECT_TRUE(enter.isAccepted());
  ASSERT_EQ(dropped.count(), 1);
  EXPECT_EQ(dropped[0][0].value<QList<CurveKey>>().size(), 2);
}

TEST_F(PlotViewTest, AThemeChangeReachesTheCanvas) {
  view_.addCurve({"p/a/state.x", "rad"}).append(Rows(0, 10'000));
  Painted(view_);

  Theme::instance().choose(Theme::Choice::kLight);
  const QImage image = Painted(view_);

  const QPoint corner = view_.canvas()->geometry().bottomLeft() + QPoint(3, -3);
  EXPECT_EQ(image.pixelColor(corner), ColorOf(Token::kPanel, Appearance::kLight));
}

TEST_F(PlotViewTest, RedrawsItselfWhileVisibleAndLive) {
  view_.addCurve({"p/a/state.x", "rad"}).append(Rows(0, 10'000));
  const std::int64_t before = view_.timeWindow().origin();

  EXPECT_TRUE(QTest::qWaitFor([&] { return view_.timeWindow().origin() > before; }, 120'000));
}

}  // namespace
}  // namespace tendon::gui
