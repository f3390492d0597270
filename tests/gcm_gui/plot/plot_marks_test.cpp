#include <gcm_gui/plot/plot_marks.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/theme/theme.h>
#include <gtest/gtest.h>

#include <QHelpEvent>
#include <QTest>
#include <QToolTip>
#include <cmath>

#include "samples.h"

namespace tendon::gui {
namespace {

/// A plot of 30 s that does not move, with a mark at 10 s.
class PlotMarksTest : public testing::Test {
 protected:
  void SetUp() override {
    ShowView(view_);
    view_.addCurve({"p/a/state.x", "rad"}).append(Rows(0, 30'000));
    view_.refresh();
    view_.setPaused(true);
    view_.marks().set(track_);
    track_.add({.time_ns = 10 * kSecond, .label = "MoveTo", .text = "all of MoveTo"});
    x_ = columnOf(10 * kSecond);
  }

  [[nodiscard]] PlotMarks& marks() { return view_.marks(); }
  [[nodiscard]] int columnOf(std::int64_t time_ns) {
    return static_cast<int>(
        std::round(view_.axes().columnOf(view_.timeWindow().secondsAt(time_ns))));
  }
  /// Returns the colour of the plot where the line of the mark is.
  [[nodiscard]] QColor colorOfMark() {
    const QImage image = Painted(view_);
    const QWidget& canvas = *view_.canvas();
    return image.pixelColor(canvas.geometry().topLeft() + QPoint(x_, canvas.height() - 4));
  }

  MarkTrack track_;
  PlotView view_;
  int x_ = 0;  // the column of the mark
};

TEST_F(PlotMarksTest, HoveringAMarkShowsItsText) {
  EXPECT_EQ(marks().textAt(x_ + 2), "all of MoveTo");
  EXPECT_EQ(marks().textAt(x_ - 40), "");

  const QPoint place(x_ + 2, 20);
  QHelpEvent rest(QEvent::ToolTip, place, view_.canvas()->mapToGlobal(place));
  QCoreApplication::sendEvent(view_.canvas(), &rest);
  EXPECT_EQ(QToolTip::text(), "all of MoveTo");
}

TEST_F(PlotMarksTest, HiddenMarksHaveNoTextAndAreNotDrawn) {
  const QColor color = Theme::instance().color(Token::kWarning);  // of an event
  EXPECT_EQ(colorOfMark(), color);

  marks().setShown(false);
  EXPECT_EQ(marks().textAt(x_ + 2), "");
  EXPECT_NE(colorOfMark(), color);

  marks().setShown(true);
  EXPECT_EQ(marks().textAt(x_ + 2), "all of MoveTo");
  EXPECT_EQ(colorOfMark(), color);
}

TEST_F(PlotMarksTest, OtherMarksReplaceTheFormerOnes) {
  MarkTrack other;
  other.add({.time_ns = 20 * kSecond, .label = "Stop", .text = "all of Stop"});

  marks().set(other);

  EXPECT_EQ(marks().textAt(x_ + 2), "");
  EXPECT_EQ(marks().textAt(columnOf(20 * kSecond) + 2), "all of Stop");
  marks().set(track_);  // `other` ends before the plot
}

TEST_F(PlotMarksTest, ScreenReadersGetTheVisibleMarksWhileTheCanvasHasTheFocus) {
  track_.add({.time_ns = -10 * kSecond, .label = "old", .text = "not in sight"});
  view_.activateWindow();
  view_.canvas()->setFocus();
  ASSERT_TRUE(QTest::qWaitFor([this] { return view_.canvas()->hasFocus(); }, 120'000));

  marks().describe();
  EXPECT_EQ(view_.canvas()->accessibleDescription(), "all of MoveTo");

  view_.canvas()->clearFocus();
  marks().describe();
  EXPECT_EQ(view_.canvas()->accessibleDescription(), "");
}

TEST(PlotMarks, APlotWithoutMarksHasNoText) {
  PlotView view;
  view.marks().setShown(true);

  EXPECT_EQ(view.marks().textAt(10), "");
}

}  // namespace
}  // namespace tendon::gui
