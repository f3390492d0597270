#include <gcm_gui/plot/canvas/cursor_lines.h>
#include <gcm_gui/plot/plot_view.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QMouseEvent>
#include <QTest>
#include <chrono>

#include "samples.h"

namespace tendon::gui {
namespace {

using namespace std::chrono_literals;

/// Ten seconds of a line that rises by 1 per second.
class PlotCursors : public testing::Test {
 protected:
  void SetUp() override {
    ShowView(view_);
    view_.setWindow(10s);
    view_.addCurve({"p/a/state.x", "rad"}).append(Rows(0, 10'000, [](double t) { return t; }));
    Painted(view_);
    view_.setPaused(true);
    Painted(view_);
  }

  double xOf(double seconds) { return view_.transform(QwtAxis::XBottom, seconds); }
  std::vector<CursorLines::Line> Lines() {
    return CursorLines(view_.curves(), view_.timeWindow(), view_.cursors().times()).lines();
  }

  PlotView view_;
};

TEST_F(PlotCursors, ShowTheirDistanceInTimeAndInEachCurve) {
  view_.cursors().place(Cursor::kA, xOf(-6));
  EXPECT_TRUE(Lines().empty());
  view_.cursors().place(Cursor::kB, xOf(-4));

  EXPECT_NEAR(view_.cursors().times().span(), 2, 0.03);
  ASSERT_EQ(Lines().size(), 2u);
  const QStringList words = Lines()[1].text.split(' ');
  ASSERT_EQ(words.size(), 3);
  EXPECT_NEAR(words[1].toDouble(), 2, 0.03);
  EXPECT_EQ(words[2], "rad");
}

TEST_F(PlotCursors, StayWithTheDataWhenTheWindowMoves) {
  view_.cursors().place(Cursor::kA, xOf(-5));
  const auto time = view_.cursors().times().time(Cursor::kA);

  view_.gestures().panTime(50);
  Painted(view_);

  EXPECT_EQ(view_.cursors().times().time(Cursor::kA), time);
  EXPECT_TRUE(view_.cursors().at(xOf(-5)).has_value());
}

TEST_F(PlotCursors, KeysPlaceAndRemoveThem) {
  QTest::keyClick(view_.canvas(), Qt::Key_A);
  QTest::keyClick(view_.canvas(), Qt::Key_B);
  EXPECT_TRUE(view_.cursors().times().both());

  QTest::keyClick(view_.canvas(), Qt::Key_Delete);
  EXPECT_FALSE(view_.cursors().times().any());
}

TEST_F(PlotCursors, DraggingThemDoesNotZoom) {
  view_.cursors().place(Cursor::kA, xOf(-5));
  const double span = view_.timeWindow().to() - view_.timeWindow().from();
  const QPoint from(static_cast<int>(xOf(-5)), 40);
  const QPoint to = from + QPoint(60, 30);

  QTest::mousePress(view_.canvas(), Qt::LeftButton, {}, from);
  QMouseEvent move(QEvent::MouseMove, to, view_.canvas()->mapToGlobal(to), Qt::NoButton,
                   Qt::LeftButton, {});
  QApplication::sendEvent(view_.canvas(), &move);
  QTest::mouseRelease(view_.canvas(), Qt::LeftButton, {}, to);

  EXPECT_EQ(view_.cursors().at(to.x()), Cursor::kA);
  EXPECT_FALSE(view_.cursors().at(from.x()).has_value());
  EXPECT_EQ(view_.timeWindow().to() - view_.timeWindow().from(), span);
}

TEST_F(PlotCursors, AnEmptyPlotHasNoCursors) {
  view_.removeCurve("p/a/state.x");
  view_.cursors().show(false);

  view_.cursors().show(true);

  EXPECT_FALSE(view_.cursors().times().any());
}

TEST(SpanText, ShortSpansAreInMilliseconds) {
  EXPECT_EQ(SpanText(12.7), "Δt 12.700 s · 0.0787 Hz");
  EXPECT_EQ(SpanText(0.0205), "Δt 20.500 ms · 48.8 Hz");
  EXPECT_EQ(SpanText(0), "Δt 0.000 ms");
}

}  // namespace
}  // namespace tendon::gui
