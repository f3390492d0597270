#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/plot/series/csv_table.h>
#include <gcm_gui/theme/theme.h>
#include <gmock/gmock.h>
#include <qwt_interval.h>

#include <QTest>
#include <QToolButton>
#include <chrono>
#include <cmath>

#include "samples.h"

namespace tendon::gui {
namespace {

using namespace std::chrono_literals;

/// An axis of ten seconds. The value of a sample is the number of the sweep to which it belongs.
class PlotSweep : public testing::Test {
 protected:
  void SetUp() override {
    Theme::instance().choose(Theme::Choice::kDark);
    ShowView(view_);
    view_.setWindow(10s);
    curve_ = &view_.addCurve({"p/a/state.x", "rad"});
    curve_->append(Rows(0, 24'000, [](double t) { return std::floor(t / 10); }));
    QTest::keyClick(view_.canvas(), Qt::Key_S);
    // The head is at the present time, which advances between two lines of this test. So the view
    // is paused.
    Painted(view_);
    view_.setPaused(true);
    Painted(view_);
  }

  [[nodiscard]] double head() const { return view_.timeWindow().head(); }

  PlotView view_;
  Curve* curve_ = nullptr;
};

TEST_F(PlotSweep, TheAxisIsFixedAndTheHeadShowsNow) {
  EXPECT_TRUE(view_.timeWindow().isSweeping());
  EXPECT_EQ(view_.timeWindow().origin() % (10 * kSecond), 0);
  EXPECT_DOUBLE_EQ(view_.axisInterval(QwtAxis::XBottom).minValue(), 0);
  EXPECT_DOUBLE_EQ(view_.axisInterval(QwtAxis::XBottom).maxValue(), 10);
  EXPECT_GE(head(), 0);
  EXPECT_LE(head(), 10);
}

TEST_F(PlotSweep, RightOfTheHeadIsThePreviousSweep) {
  const double right_of_it = (head() + 10) / 2;

  EXPECT_EQ(view_.timeWindow().shownAt(right_of_it),
            view_.timeWindow().timeAt(right_of_it) - 10 * kSecond);
  EXPECT_EQ(view_.timeWindow().lastTime() - view_.timeWindow().firstTime(), 10 * kSecond);
  EXPECT_NEAR(view_.timeWindow().pointOf(view_.timeWindow().shownAt(right_of_it)), right_of_it,
              1e-6);
}

TEST_F(PlotSweep, ZoomingLeavesTheSweepForTheSelectedTime) {
  const int left = static_cast<int>(view_.transform(QwtAxis::XBottom, head() * 0.25));
  const int right = static_cast<int>(view_.transform(QwtAxis::XBottom, head() * 0.75));
  const std::int64_t from = view_.timeWindow().shownAt(view_.invTransform(QwtAxis::XBottom, left));

  view_.gestures().zoomTo(QRect(QPoint(left, 20), QPoint(right, 120)));
  Painted(view_);

  EXPECT_FALSE(view_.timeWindow().isSweeping());
  EXPECT_NEAR(static_cast<double>(view_.timeWindow().firstTime() - from), 0, 1e6);
  EXPECT_LT(view_.timeWindow().lastTime() - view_.timeWindow().firstTime(), 10 * kSecond);

  QTest::keyClick(view_.canvas(), Qt::Key_Left, Qt::AltModifier);
  EXPECT_TRUE(view_.timeWindow().isSweeping());
}

TEST_F(PlotSweep, CsvExportContainsTheVisibleTime) {
  const TimeWindow& window = view_.timeWindow();

  const CsvTable table = CsvTableOf(view_.curves(), window.firstTime(), window.lastTime(), 0);

  ASSERT_EQ(table.curves.size(), 1U);
  ASSERT_FALSE(table.curves[0].times.empty());
  EXPECT_GE(table.curves[0].times.front(), window.lastTime() - 10 * kSecond);
}

TEST_F(PlotSweep, GoingLiveResumesTheSweep) {
  view_.gestures().goLive();
  EXPECT_TRUE(view_.timeWindow().isSweeping());
  const std::int64_t before = view_.timeWindow().lastTime();

  EXPECT_TRUE(QTest::qWaitFor([&] { return view_.timeWindow().lastTime() > before; }, 120'000));

  QTest::keyClick(view_.canvas(), Qt::Key_S);
  EXPECT_FALSE(view_.timeWindow().isSweeping());
  EXPECT_TRUE(view_.isLive());
}

TEST(PlotSweepPanel, TheButtonShowsWhetherSweepIsOn) {
  PlotPanel panel;
  panel.resize(830, 320);
  panel.show();
  auto* button = panel.findChild<QToolButton*>("sweep");

  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_TRUE(button->isChecked());
  EXPECT_EQ(panel.currentPlot().timeWindow().motion(), TimeWindow::Motion::kSweep);

  QTest::keyClick(panel.currentPlot().canvas(), Qt::Key_S);
  EXPECT_FALSE(button->isChecked());
}

// Uses its own clock: with now(), the head would be elsewhere on a slow machine.
TEST(SweepingWindow, DrawsBothSweepsWithABarBetween) {
  Theme::instance().choose(Theme::Choice::kDark);
  PlotView view;
  ShowView(view);
  view.setWindow(10s);
  view.addCurve({"p/a/state.x", "rad"}).append(Rows(0, 24'000, [](double t) {
    return std::sin(t) + std::floor(t / 10);
  }));
  view.setMotion(TimeWindow::Motion::kSweep);
  Painted(view);

  const QImage image = Painted(view);

  const QRect canvas = view.canvas()->geometry();
  const int head =
      canvas.left() + static_cast<int>(view.transform(QwtAxis::XBottom, view.timeWindow().head()));
  const auto has_curve = [&](int from, int to) {
    for (int x = std::max(from, canvas.left()); x < std::min(to, canvas.right()); ++x) {
      for (int y = canvas.top(); y < canvas.bottom(); ++y) {
        if (image.pixelColor(x, y) == Theme::instance().curve(0)) return true;
      }
    }
    return false;
  };
  EXPECT_FALSE(has_curve(head + 3, head + 10)) << "the bar";
  EXPECT_TRUE(has_curve(canvas.left(), head) || head <= canvas.left() + 4);
  EXPECT_TRUE(has_curve(head + 14, canvas.right()) || head + 20 >= canvas.right());
  KeepPicture(image, "plot_sweep");
}

}  // namespace
}  // namespace tendon::gui
