#include <gcm_gui/plot/canvas/plot_axes.h>
#include <gcm_gui/plot/controls/legend.h>
#include <gcm_gui/plot/controls/plot_overlay.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/theme/theme.h>
#include <gmock/gmock.h>
#include <qwt_interval.h>
#include <qwt_scale_widget.h>

#include <QTest>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "../samples.h"

namespace tendon::gui {
namespace {

using namespace std::chrono_literals;

class PlotAxesTest : public testing::Test {
 protected:
  void SetUp() override {
    Theme::instance().choose(Theme::Choice::kDark);
    ShowView(view_);
    view_.setWindow(10s);
  }

  Curve& add(const char* path, const char* unit, double size) {
    Curve& curve = view_.addCurve({path, unit});
    curve.append(Rows(0, 10'000, [size](double t) { return size * (2 + std::sin(t)); }));
    return curve;
  }
  /// Returns true if a pixel to the right of the canvas has nearly this colour.
  static bool HasColor(const QImage& image, const QRect& part, const QColor& color) {
    for (int y = part.top(); y <= part.bottom(); ++y) {
      for (int x = part.left(); x <= part.right(); ++x) {
        const QColor here = image.pixelColor(x, y);
        const int apart = std::abs(here.red() - color.red()) +
                          std::abs(here.green() - color.green()) +
                          std::abs(here.blue() - color.blue());
        if (apart < 90) return true;
      }
    }
    return false;
  }
  [[nodiscard]] QRect rightOf(int columns) const {
    const int axis = view_.axisWidget(QwtAxis::YRight)->geometry().right() + 1;
    return {axis + columns * PlotAxes::kSide, view_.canvas()->y(), PlotAxes::kSide - 8,
            view_.canvas()->height()};
  }

  PlotView view_;
};

TEST_F(PlotAxesTest, ThirdAndFourthUnitsHaveColouredAxes) {
  add("p/a/state.x", "rad", 1);
  add("p/a/state.v", "rad/s", 10);
  add("p/a/state.t", "Nm", 1e4);
  add("p/a/state.u", "V", 24);
  Painted(view_);

  const QImage image = Painted(view_);

  ASSERT_LE(rightOf(1).right(), view_.width());
  EXPECT_TRUE(HasColor(image, rightOf(0), Theme::instance().curve(2)));
  EXPECT_TRUE(HasColor(image, rightOf(1), Theme::instance().curve(3)));
  EXPECT_FALSE(HasColor(image, rightOf(0), Theme::instance().curve(3)));
  KeepPicture(image, "plot_four_units");
}

TEST_F(PlotAxesTest, OuterAxesAreStableAndLeaveWithTheirCurve) {
  add("p/a/state.x", "rad", 1);
  add("p/a/state.v", "rad/s", 1);
  Painted(view_);
  const int alone = view_.canvas()->width();
  Curve& third = add("p/a/state.t", "Nm", 1);
  Painted(view_);
  const QRect canvas = view_.canvas()->geometry();
  EXPECT_LT(canvas.width(), alone);

  third.append(Rows(10'000, 20'000, [](double) { return 777; }));
  Painted(view_);
  EXPECT_EQ(view_.canvas()->geometry(), canvas);

  view_.removeCurve("p/a/state.t");
  Painted(view_);
  EXPECT_EQ(view_.canvas()->width(), alone);
}

TEST_F(PlotAxesTest, KeepsTheRequestedSideRoomFree) {
  add("p/a/state.x", "rad", 1);
  Painted(view_);
  const QRect before = view_.canvas()->geometry();

  view_.axes().setRoom({.left = 80, .right = 150});
  Painted(view_);

  EXPECT_EQ(view_.canvas()->x(), before.x() + 80 - PlotAxes::kSide);
  EXPECT_EQ(view_.canvas()->geometry().right(), before.right() - 150 + PlotAxes::kSide);
}

TEST_F(PlotAxesTest, ALogarithmicAxisSpreadsDecadesEvenly) {
  view_.addCurve({"p/a/state.x", "A"}).append(Rows(0, 10'000, [](double t) {
    return std::pow(10, t / 2 - 2);  // from 0.01 to 1000
  }));

  QTest::keyClick(view_.canvas(), Qt::Key_L);
  Painted(view_);

  const QwtInterval shown = view_.axisInterval(QwtAxis::YLeft);
  EXPECT_NEAR(shown.minValue(), -2, 1);
  EXPECT_NEAR(shown.maxValue(), 3, 1);
  EXPECT_EQ(view_.axisScaleDraw(QwtAxis::YLeft)->label(-1).text(), "0.1");
  EXPECT_TRUE(view_.overlay().note().isEmpty());
  const double low = view_.transform(QwtAxis::YLeft, 0);
  view_.setHover(static_cast<int>(view_.transform(QwtAxis::XBottom, -6)));
  EXPECT_NEAR(view_.legendBox().rows().front()->entry().value.toDouble(), 1, 0.3);
  EXPECT_GT(low, view_.transform(QwtAxis::YLeft, 1));
  KeepPicture(Painted(view_), "plot_logarithmic");

  QTest::keyClick(view_.canvas(), Qt::Key_L);
  Painted(view_);
  EXPECT_GT(view_.axisInterval(QwtAxis::YLeft).maxValue(), 900);
}

TEST_F(PlotAxesTest, NonPositiveValuesAreNotedAndDrawnAtTheBottom) {
  view_.addCurve({"robot/arm/state.x", "A"}).append(Rows(0, 10'000, [](double t) {
    return t < 5 ? 100.0 : -3.0;
  }));
  view_.setScale(ValueScale::kLogarithmic);
  Painted(view_);

  const QImage image = Painted(view_);

  EXPECT_THAT(view_.overlay().note().toStdString(), testing::HasSubstr("arm.x"));
  const QRect canvas = view_.canvas()->geometry();
  const QRect foot(canvas.center().x() + 40, canvas.bottom() - 3, 60, 4);
  EXPECT_TRUE(HasColor(image, foot, Theme::instance().curve(0)));
  KeepPicture(image, "plot_logarithmic_without_place");

  view_.setScale(ValueScale::kLinear);
  Painted(view_);
  EXPECT_TRUE(view_.overlay().note().isEmpty());
}

}  // namespace
}  // namespace tendon::gui
