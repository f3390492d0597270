#include <gcm_gui/plot/controls/plot_navigator.h>
#include <gcm_gui/plot/plot_view.h>
#include <gmock/gmock.h>
#include <qwt_interval.h>
#include <qwt_scale_map.h>

#include <QApplication>
#include <QPushButton>
#include <QTest>
#include <QWheelEvent>
#include <cmath>

#include "../samples.h"

namespace tendon::gui {
namespace {

using namespace std::chrono_literals;

// A curve of 1 kHz that receives samples during every gesture.
class PlotNavigatorTest : public testing::Test {
 protected:
  void SetUp() override {
    ShowView(view_);
    view_.setWindow(10s);
    curve_ = &view_.addCurve({"p/a/state.x", "rad"});
    stream();
  }

  void stream(std::uint64_t rows = 10'000) {
    curve_->append(Rows(tick_, tick_ + rows, [](double t) { return std::sin(t); }));
    tick_ += rows;
    Painted(view_);
  }

  void turnWheel(QPoint at, QPoint angle, Qt::KeyboardModifiers modifiers = {}) {
    QWheelEvent event(at, view_.canvas()->mapToGlobal(at), {}, angle, Qt::NoButton, modifiers,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(view_.canvas(), &event);
    stream(50);
  }

  void drag(QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mousePress(view_.canvas(), Qt::LeftButton, modifiers, from);
    stream(50);
    moveTo((from + to) / 2, modifiers);
    moveTo(to, modifiers);
    QTest::mouseRelease(view_.canvas(), Qt::LeftButton, modifiers, to);
    stream(50);
  }

  // Sends a move event with a pressed button; QTest::mouseMove() cannot do this.
  void moveTo(QPoint to, Qt::KeyboardModifiers modifiers) {
    QMouseEvent event(QEvent::MouseMove, to, view_.canvas()->mapToGlobal(to), Qt::NoButton,
                      Qt::LeftButton, modifiers);
    QApplication::sendEvent(view_.canvas(), &event);
  }

  [[nodiscard]] double timeSpan() const {
    return view_.timeWindow().to() - view_.timeWindow().from();
  }
  [[nodiscard]] double valueSpan() const { return view_.axisInterval(QwtAxis::YLeft).width(); }
  [[nodiscard]] QPushButton& pill() const { return *view_.findChild<QPushButton*>("live"); }

  PlotView view_;
  Curve* curve_ = nullptr;
  std::uint64_t tick_ = 0;
};

TEST_F(PlotNavigatorTest, TheWheelZoomsInTimeAroundTheMouse) {
  const double under_mouse = view_.invTransform(QwtAxis::XBottom, 300);

  turnWheel({300, 100}, {0, 120});

  EXPECT_NEAR(timeSpan(), 8, 1e-9);
  EXPECT_NEAR(view_.invTransform(QwtAxis::XBottom, 300), under_mouse, 0.03);
  EXPECT_FALSE(view_.isLive());
}

TEST_F(PlotNavigatorTest, AZoomedViewStaysWhileSamplesArrive) {
  turnWheel({300, 100}, {0, 120});
  const std::int64_t from = view_.timeWindow().timeAt(view_.timeWindow().from());

  stream(20'000);

  EXPECT_EQ(view_.timeWindow().timeAt(view_.timeWindow().from()), from);
  EXPECT_EQ(curve_->samples().lost(), 0U);
  EXPECT_EQ(curve_->samples().endIndex(), tick_);
}

TEST_F(PlotNavigatorTest, CtrlWheelZoomsInValuesAndStaysLiveInTime) {
  const double before = valueSpan();

  turnWheel({300, 100}, {0, 120}, Qt::ControlModifier);

  EXPECT_NEAR(valueSpan(), before * 0.8, 1e-9);
  EXPECT_TRUE(view_.isLive());
  EXPECT_TRUE(pill().isVisible()) << "the values no longer follow";
  EXPECT_EQ(pill().text(), "Fit") << "it is live";
}

TEST_F(PlotNavigatorTest, DraggingZoomsToTheRectangle) {
  const double left = view_.invTransform(QwtAxis::XBottom, 100);
  const double right = view_.invTransform(QwtAxis::XBottom, 220);
  const double top = view_.invTransform(QwtAxis::YLeft, 60);

  drag({100, 60}, {220, 160});

  EXPECT_NEAR(view_.timeWindow().from(), left, 0.06);
  EXPECT_NEAR(view_.timeWindow().to(), right, 0.06);
  EXPECT_NEAR(view_.axisInterval(QwtAxis::YLeft).maxValue(), top, 1e-9);
}

TEST_F(PlotNavigatorTest, EscapeCancelsTheRectangle) {
  QTest::mousePress(view_.canvas(), Qt::LeftButton, {}, {100, 60});
  moveTo({220, 160}, {});
  QTest::keyClick(view_.canvas(), Qt::Key_Escape);
  QTest::mouseRelease(view_.canvas(), Qt::LeftButton, {}, {220, 160});

  EXPECT_TRUE(view_.isLive());
}

TEST_F(PlotNavigatorTest, AClickDoesNotZoom) {
  QTest::mouseClick(view_.canvas(), Qt::LeftButton, {}, {100, 60});

  EXPECT_TRUE(view_.isLive());
  EXPECT_NEAR(timeSpan(), 10, 1e-9);
}

TEST_F(PlotNavigatorTest, ShiftDragMovesThePicture) {
  const double under_mouse = view_.invTransform(QwtAxis::XBottom, 100);

  drag({100, 100}, {300, 104}, Qt::ShiftModifier);

  EXPECT_NEAR(view_.invTransform(QwtAxis::XBottom, 300), under_mouse, 0.06);
  EXPECT_TRUE(view_.curves().axes().front().fitted) << "a few pixels up are no wish to move values";
}

TEST_F(PlotNavigatorTest, ShiftDragUpwardsMovesValues) {
  drag({100, 100}, {100, 180}, Qt::ShiftModifier);

  EXPECT_FALSE(view_.curves().axes().front().fitted);
}

TEST_F(PlotNavigatorTest, ADoubleClickGoesLive) {
  drag({100, 60}, {220, 160});
  EXPECT_TRUE(pill().isVisible());

  QTest::mouseDClick(view_.canvas(), Qt::LeftButton, {}, {100, 60});
  stream();

  EXPECT_TRUE(view_.isLive());
  EXPECT_TRUE(view_.curves().axes().front().fitted);
  EXPECT_NEAR(timeSpan(), 10, 1e-9);
  EXPECT_FALSE(pill().isVisible());
}

TEST_F(PlotNavigatorTest, TheLiveButtonGoesLive) {
  turnWheel({300, 100}, {0, 120});

  QTest::mouseClick(&pill(), Qt::LeftButton);

  EXPECT_TRUE(view_.isLive());
}

TEST_F(PlotNavigatorTest, AltLeftGoesBackStepByStep) {
  drag({100, 60}, {220, 160});
  const double first = timeSpan();
  drag({100, 60}, {220, 160});
  EXPECT_LT(timeSpan(), first);

  QTest::keyClick(view_.canvas(), Qt::Key_Left, Qt::AltModifier);
  EXPECT_NEAR(timeSpan(), first, 1e-9);
  QTest::keyClick(view_.canvas(), Qt::Key_Left, Qt::AltModifier);
  stream();

  EXPECT_TRUE(view_.isLive());
}

TEST_F(PlotNavigatorTest, WorksFromTheKeyboard) {
  QTest::keyClick(view_.canvas(), Qt::Key_Plus);
  EXPECT_NEAR(timeSpan(), 8, 1e-9);
  const double from = view_.timeWindow().from();
  QTest::keyClick(view_.canvas(), Qt::Key_Left);
  EXPECT_LT(view_.timeWindow().from(), from);
  QTest::keyClick(view_.canvas(), Qt::Key_End);
  EXPECT_TRUE(view_.isLive());
}

TEST_F(PlotNavigatorTest, AnEmptyPlotHasNothingToZoom) {
  view_.removeCurve("p/a/state.x");
  const QPoint at(300, 100);
  QWheelEvent event(at, view_.canvas()->mapToGlobal(at), {}, {0, 120}, Qt::NoButton, {},
                    Qt::NoScrollPhase, false);

  QApplication::sendEvent(view_.canvas(), &event);
  QTest::mousePress(view_.canvas(), Qt::LeftButton, {}, {100, 60});

  EXPECT_TRUE(view_.isLive());
}

}  // namespace
}  // namespace tendon::gui
