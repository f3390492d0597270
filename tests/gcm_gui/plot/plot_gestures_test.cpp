#include <gcm_gui/plot/plot_gestures.h>
#include <gcm_gui/plot/plot_view.h>
#include <gtest/gtest.h>

#include <QSignalSpy>
#include <cmath>
#include <memory>
#include <vector>

#include "samples.h"

namespace tendon::gui {
namespace {

using namespace std::chrono_literals;

/// Two plots with one time axis of 10 s. Each has two curves with different units.
class PlotGesturesTest : public testing::Test {
 protected:
  void SetUp() override {
    for (PlotView* view : {&view_, &other_}) {
      ShowView(*view);
      view->addCurve({"p/a/state.x", "rad"}).append(Rows(0, 10'000, [](double t) {
        return std::sin(t);
      }));
      view->addCurve({"p/a/state.v", "rad/s"}).append(Rows(0, 10'000));
    }
    view_.setWindow(10s);
    Painted(view_);
    Painted(other_);
  }

  [[nodiscard]] PlotGestures& gestures() { return view_.gestures(); }
  [[nodiscard]] PlotAxes& axes() { return view_.axes(); }
  [[nodiscard]] double timeSpan() const {
    return view_.timeWindow().to() - view_.timeWindow().from();
  }
  [[nodiscard]] const std::vector<UnitAxis>& valueAxes() const { return view_.curves().axes(); }

  std::shared_ptr<SharedTimeAxis> time_axis_ = std::make_shared<SharedTimeAxis>();
  PlotView view_{time_axis_};
  PlotView other_{time_axis_};
};

TEST_F(PlotGesturesTest, ZoomingTimeKeepsTheTimeAtThatColumn) {
  const double at = axes().secondsAt(300);

  gestures().zoomTime(0.5, 300);
  Painted(view_);

  EXPECT_NEAR(timeSpan(), 5, 1e-9);
  EXPECT_NEAR(axes().secondsAt(300), at, 1e-3);
  EXPECT_FALSE(view_.isLive());
}

TEST_F(PlotGesturesTest, ZoomingValuesKeepsTheValuesAtThatRowAndStaysLive) {
  const std::vector<UnitAxis> before = valueAxes();
  ASSERT_EQ(before.size(), 2U);
  const double at = axes().fractionAt(100);

  gestures().zoomValues(0.5, 100);

  for (std::size_t i = 0; i < before.size(); ++i) {
    const AxisRange& was = before[i].range;
    const AxisRange& is = valueAxes()[i].range;
    EXPECT_NEAR(is.span(), was.span() / 2, 1e-9);
    EXPECT_NEAR(is.low + at * is.span(), was.low + at * was.span(), 1e-9);
    EXPECT_FALSE(valueAxes()[i].fitted);
  }
  EXPECT_TRUE(view_.isLive());
}

TEST_F(PlotGesturesTest, PanningMovesByAPartOfTheCanvas) {
  const double from = view_.timeWindow().from();
  const std::vector<UnitAxis> before = valueAxes();

  gestures().panTime(axes().columns() / 4);
  gestures().panValues(axes().rows() / 2.0);

  EXPECT_NEAR(view_.timeWindow().from(), from + 2.5, 1e-9);
  EXPECT_NEAR(timeSpan(), 10, 1e-9);
  EXPECT_FALSE(view_.isLive());
  for (std::size_t i = 0; i < before.size(); ++i) {
    const AxisRange& was = before[i].range;
    EXPECT_NEAR(valueAxes()[i].range.low, was.low + was.span() / 2, 1e-9);
    EXPECT_NEAR(valueAxes()[i].range.span(), was.span(), 1e-9);
  }
}

TEST_F(PlotGesturesTest, ZoomingToARectangleShowsItsTimesAndValues) {
  const double left = axes().secondsAt(100);
  const double right = axes().secondsAt(220);
  const AxisRange before = valueAxes().front().range;
  const double low = before.low + axes().fractionAt(160) * before.span();
  const double high = before.low + axes().fractionAt(60) * before.span();

  gestures().zoomTo(QRect(QPoint(100, 60), QPoint(220, 160)));

  EXPECT_NEAR(view_.timeWindow().from(), left, 1e-9);
  EXPECT_NEAR(view_.timeWindow().to(), right, 1e-9);
  EXPECT_NEAR(valueAxes().front().range.low, low, 1e-9);
  EXPECT_NEAR(valueAxes().front().range.high, high, 1e-9);
}

TEST_F(PlotGesturesTest, GoingLiveFitsOnlyTheAxesOfThisPlot) {
  gestures().zoomTo(QRect(QPoint(100, 60), QPoint(220, 160)));
  other_.gestures().zoomValues(0.5, 100);

  gestures().goLive();

  EXPECT_TRUE(view_.isLive());
  EXPECT_NEAR(timeSpan(), 10, 1e-9);
  EXPECT_TRUE(view_.curves().isFitted());
  EXPECT_FALSE(other_.curves().isFitted());
}

TEST_F(PlotGesturesTest, GoingLiveTogetherFitsTheAxesOfAllPlots) {
  gestures().zoomTime(0.5, 300);
  other_.gestures().zoomValues(0.5, 100);

  gestures().goLiveTogether();

  EXPECT_TRUE(other_.isLive());
  EXPECT_TRUE(view_.curves().isFitted());
  EXPECT_TRUE(other_.curves().isFitted());
}

TEST_F(PlotGesturesTest, ARunOfEqualGesturesIsOneStepOfTheHistory) {
  EXPECT_FALSE(gestures().hasFormerView());
  for (int i = 0; i < 3; ++i) gestures().zoomTime(0.5, 300);

  gestures().goBack();
  EXPECT_TRUE(view_.isLive());
  EXPECT_FALSE(gestures().hasFormerView());
  EXPECT_TRUE(gestures().hasLaterView());

  gestures().goForward();
  EXPECT_NEAR(timeSpan(), 1.25, 1e-9);
  EXPECT_FALSE(gestures().hasLaterView());
}

TEST_F(PlotGesturesTest, TheEndOfARunBeginsANewStepOfTheHistory) {
  gestures().zoomTime(0.5, 300);
  gestures().endRun();
  gestures().zoomTime(0.5, 300);

  gestures().goBack();

  EXPECT_NEAR(timeSpan(), 5, 1e-9);
  EXPECT_TRUE(gestures().hasFormerView());
}

TEST_F(PlotGesturesTest, GoingLiveIsAStepOfTheHistoryOnlyIfItChangesTheView) {
  gestures().goLive();
  EXPECT_FALSE(gestures().hasFormerView());

  gestures().zoomTime(0.5, 300);
  gestures().goLive();
  gestures().goBack();

  EXPECT_NEAR(timeSpan(), 5, 1e-9);
}

TEST_F(PlotGesturesTest, EachChangeOfTheViewIsSignalled) {
  const QSignalSpy changed(&gestures(), &PlotGestures::changed);

  gestures().zoomTime(0.5, 300);
  gestures().zoomValues(0.5, 100);
  gestures().panTime(10);
  gestures().panValues(10);
  gestures().zoomTo(QRect(QPoint(100, 60), QPoint(220, 160)));
  gestures().goLive();
  gestures().goBack();
  gestures().goForward();

  EXPECT_EQ(changed.count(), 8);
}

}  // namespace
}  // namespace tendon::gui
