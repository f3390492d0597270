#include <gcm_gui/plot/controls/legend.h>
#include <gcm_gui/plot/controls/rate_badge.h>
#include <gcm_gui/plot/plot_layout.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/theme/theme.h>
#include <gmock/gmock.h>

#include <QApplication>
#include <QDropEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabBar>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>
#include <cmath>

#include "samples.h"

namespace tendon::gui {
namespace {

const QString kAngle = "robot/arm/state.Joints.position[0]";
const QString kForce = "robot/sensor/state.Wrench.force[2]";

/// An angle in the upper plot, and a force with large numbers in the lower plot.
class PlotPages : public testing::Test {
 protected:
  void SetUp() override {
    Theme::instance().choose(Theme::Choice::kDark);
    panel_.resize(830, 420);
    panel_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel_, 120'000));
    panel_.addSignal(kAngle, "rad");
    QTest::mouseClick(panel_.findChild<QToolButton*>("splitPlot"), Qt::LeftButton);
    panel_.addSignal(kForce, "N");
    feed(0, 30'000);
    ASSERT_EQ(panel_.plotCount(), 2);
  }

  void feed(std::uint64_t from, std::uint64_t to) {
    panel_.append(kAngle, Rows(from, to, [](double t) { return std::sin(t); }));
    panel_.append(kForce, Rows(from, to, [](double t) { return -123'456.5 + 1000 * t; }));
  }
  PlotView& above() { return panel_.plot(0); }
  PlotView& below() { return panel_.plot(1); }
  [[nodiscard]] bool areAligned() {
    const auto left = [](PlotView& view) { return view.canvas()->mapToGlobal(QPoint()).x(); };
    return above().isVisible() && below().isVisible() && left(above()) == left(below()) &&
           above().canvas()->width() == below().canvas()->width();
  }
  static QPushButton& Pill(const PlotView& view) { return *view.findChild<QPushButton*>("live"); }
  static void TurnWheel(PlotView& view, QPoint at, Qt::KeyboardModifiers keys = {}) {
    QWheelEvent event(at, view.canvas()->mapToGlobal(at), {}, {0, 120}, Qt::NoButton, keys,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(view.canvas(), &event);
  }
  static void moveTo(QWidget* widget, QPoint at) {
    QMouseEvent event(QEvent::MouseMove, at, widget->mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                      {});
    QApplication::sendEvent(widget, &event);
  }
  static void drop(PlotView& view, const QMimeData& data) {
    QDragEnterEvent enter({50, 50}, Qt::MoveAction, &data, Qt::LeftButton, {});
    QDropEvent drop({50, 50}, Qt::MoveAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&view, &enter);
    QApplication::sendEvent(&view, &drop);
  }
  void refresh() {
    above().refresh();
    below().refresh();
  }

  PlotPanel panel_;
};

TEST_F(PlotPages, CanvasesStayAligned) {
  EXPECT_TRUE(QTest::qWaitFor([this] { return areAligned(); }, 120'000));
  EXPECT_LT(above().mapToGlobal(QPoint()).y(), below().mapToGlobal(QPoint()).y());

  panel_.addSignal("robot/a/state.v", "V");
  panel_.addSignal("robot/a/state.a", "A");
  panel_.addSignal("robot/a/state.t", "°C");

  EXPECT_TRUE(QTest::qWaitFor(
      [this] {
        return areAligned() &&
               above().axes().wantedRoom().right < below().axes().wantedRoom().right;
      },
      120'000));
}

TEST_F(PlotPages, PlotsOfOneColumnHaveDifferentAccessibleNames) {
  QTest::keyClick(below().legendBox().rows().front(), Qt::Key_Delete);
  panel_.addSignal("robot/arm/state.Joints.position[1]", "rad");
  EXPECT_EQ(above().accessibleName(), "Plot Joints");
  EXPECT_EQ(below().accessibleName(), "Plot Joints 2");
  EXPECT_EQ(below().canvas()->accessibleName(), "Plot Joints 2");

  QTest::mouseClick(above().findChild<QToolButton*>("closePlot"), Qt::LeftButton);

  ASSERT_EQ(panel_.plotCount(), 1);
  EXPECT_EQ(panel_.plot(0).accessibleName(), "Plot Joints");
}

TEST_F(PlotPages, AllPlotsShareZoomAndItsHistory) {
  TurnWheel(above(), {300, 40});
  refresh();

  EXPECT_FALSE(below().isLive());
  EXPECT_EQ(below().timeWindow(), above().timeWindow());

  QTest::keyClick(below().canvas(), Qt::Key_Left, Qt::AltModifier);
  EXPECT_TRUE(above().isLive());
  QTest::keyClick(below().canvas(), Qt::Key_Right, Qt::AltModifier);
  EXPECT_FALSE(above().isLive());
}

TEST_F(PlotPages, GoingLiveAffectsAllPlots) {
  TurnWheel(above(), {300, 40});
  refresh();
  EXPECT_TRUE(Pill(above()).isVisible());

  QTest::mouseDClick(below().canvas(), Qt::LeftButton, {}, {100, 30});
  refresh();

  EXPECT_TRUE(above().isLive());
  EXPECT_FALSE(Pill(above()).isVisible());
}

TEST_F(PlotPages, OneButtonMakesAllLiveAgain) {
  TurnWheel(below(), {300, 40});
  TurnWheel(below(), {300, 40}, Qt::ControlModifier);  // zooms the values of the lower plot
  refresh();
  EXPECT_TRUE(Pill(above()).isVisible());
  EXPECT_FALSE(Pill(below()).isVisible());

  QTest::mouseClick(&Pill(above()), Qt::LeftButton);
  refresh();

  EXPECT_TRUE(below().isLive());
  EXPECT_FALSE(Pill(above()).isVisible());
  EXPECT_FALSE(Pill(below()).isVisible()) << "its values follow, too";
  above().gestures().goBack();
  refresh();
  EXPECT_FALSE(below().isLive());
}

TEST_F(PlotPages, AValueZoomIsResetInItsPlotOnly) {
  TurnWheel(below(), {300, 40}, Qt::ControlModifier);
  refresh();

  EXPECT_FALSE(Pill(above()).isVisible());
  EXPECT_TRUE(Pill(below()).isVisible());
  EXPECT_EQ(Pill(below()).text(), "Fit");
}

TEST_F(PlotPages, TheLiveButtonIsOnTheFirstNonEmptyPlot) {
  TurnWheel(below(), {300, 40});
  QTest::keyClick(above().legendBox().rows().front(), Qt::Key_Delete);
  refresh();
  EXPECT_FALSE(Pill(above()).isVisible());
  EXPECT_TRUE(Pill(below()).isVisible());

  panel_.closePlot(above());
  EXPECT_TRUE(Pill(panel_.plot(0)).isVisible());
}

TEST_F(PlotPages, AllPlotsShareCursorsAndTheHoverLine) {
  panel_.setPaused(true);
  refresh();
  above().cursors().place(Cursor::kA, 200);
  EXPECT_EQ(below().cursors().at(200), Cursor::kA);

  QTest::mouseMove(above().canvas(), {300, 30});
  above().setHover(300);
  below().refresh();

  const auto value = below().legendBox().rows().front()->entry().value.toDouble();
  const auto at = below().timeWindow().shownAt(below().invTransform(QwtAxis::XBottom, 300));
  EXPECT_NEAR(value, below().curve(kForce)->numberAt(at).value_or(0).nearest(), 1);
}

TEST_F(PlotPages, AClickChoosesThePlotForNewSignals) {
  QTest::mouseClick(above().canvas(), Qt::LeftButton, {}, {100, 20});
  EXPECT_EQ(panel_.currentIndex(), 0);

  panel_.addSignal("robot/a/state.v", "V");

  EXPECT_NE(above().curve("robot/a/state.v"), nullptr);
  EXPECT_EQ(below().curve("robot/a/state.v"), nullptr);
}

TEST_F(PlotPages, TheCrossClosesOnePlot) {
  QSignalSpy released(&panel_, &PlotPanel::subscriptionReleased);

  QTest::mouseClick(above().findChild<QToolButton*>("closePlot"), Qt::LeftButton);

  ASSERT_EQ(panel_.plotCount(), 1);
  EXPECT_EQ(panel_.paths(), QStringList{kForce});
  ASSERT_EQ(released.count(), 1);
  EXPECT_EQ(released[0][0], kAngle);
  EXPECT_FALSE(panel_.plot(0).findChild<QToolButton*>("closePlot")->isVisible());
  EXPECT_EQ(panel_.findChild<QTabBar*>("plotTabs")->count(), 1);
}

TEST_F(PlotPages, ClosingTheTabClosesAllItsPlots) {
  panel_.addPlot();
  ASSERT_EQ(panel_.plotCount(), 3);

  panel_.closePlot(0);
  panel_.closePlot(0);

  EXPECT_EQ(panel_.plotCount(), 1);
  EXPECT_TRUE(panel_.paths().isEmpty());
}

TEST_F(PlotPages, DraggingALegendRowDoesNotToggleIt) {
  refresh();
  QSignalSpy dragged(&below().legendBox(), &Legend::dragRequested);
  ASSERT_TRUE(below().legendBox().disconnect(&below()));  // a real drag would wait for the user
  dragged.clear();
  LegendRow* row = below().legendBox().rows().front();
  const QPoint from = row->rect().center();

  QTest::mousePress(row, Qt::LeftButton, {}, from);
  moveTo(row, from + QPoint(QApplication::startDragDistance() + 1, 0));
  QTest::mouseRelease(row, Qt::LeftButton, {}, from + QPoint(40, 0));

  ASSERT_EQ(dragged.count(), 1);
  EXPECT_EQ(dragged[0][0], kForce);
  EXPECT_TRUE(below().curve(kForce)->isVisible());
}

TEST_F(PlotPages, DroppingASignalMovesItWithItsSamples) {
  QSignalSpy released(&panel_, &PlotPanel::subscriptionReleased);
  QMimeData data;
  data.setData(kPathMimeType, EncodedPaths({{kForce, "N"}}));
  data.setData(kPlotMimeType, QByteArray::number(qulonglong{below().id()}));

  drop(below(), data);
  EXPECT_NE(below().curve(kForce), nullptr) << "it is there already";
  drop(above(), data);

  ASSERT_NE(above().curve(kForce), nullptr);
  EXPECT_EQ(above().curve(kForce)->samples().endIndex(), 30'000U) << "with what was seen of it";
  EXPECT_EQ(above().curve(kForce)->colorIndex(), 1) << "the first colour is taken here";
  EXPECT_EQ(below().curve(kForce), nullptr);
  EXPECT_EQ(released.count(), 0);
  feed(30'000, 30'100);
  EXPECT_EQ(above().curve(kForce)->samples().endIndex(), 30'100U);
}

TEST_F(PlotPages, ALayoutKeepsStackedPlots) {
  below().setScale(ValueScale::kLogarithmic);
  below().setMotion(TimeWindow::Motion::kSweep);
  panel_.addPlot();
  panel_.addSignal("robot/a/state.v", "V");

  PlotPanel other;
  ASSERT_EQ(ShowLayout(other, LayoutOf(panel_)), std::nullopt);

  EXPECT_EQ(LayoutOf(other), LayoutOf(panel_));
  ASSERT_EQ(other.plotCount(), 3);
  EXPECT_TRUE(other.isBelow(1));
  EXPECT_FALSE(other.isBelow(2));
  EXPECT_EQ(other.findChild<QTabBar*>("plotTabs")->count(), 2);
  EXPECT_EQ(other.plot(0).timeWindow().motion(), TimeWindow::Motion::kSweep);
  EXPECT_EQ(other.plot(0).curves().scale(), ValueScale::kLinear);
  EXPECT_EQ(other.plot(1).curves().scale(), ValueScale::kLogarithmic);
}

TEST_F(PlotPages, RendersStackedPlots) {
  panel_.addSignal("robot/arm/state.Joints.velocity[0]", "rad/s");
  panel_.append("robot/arm/state.Joints.velocity[0]",
                Rows(0, 30'000, [](double t) { return 14 * std::cos(t); }));
  refresh();
  panel_.setPaused(true);
  above().cursors().place(Cursor::kA, 200);
  above().cursors().place(Cursor::kB, 420);
  above().setHover(300);
  ASSERT_TRUE(QTest::qWaitFor([this] { return areAligned(); }, 120'000));
  for (const auto& [choice, name] : {std::pair{Theme::Choice::kDark, "plot_split-dark"},
                                     std::pair{Theme::Choice::kLight, "plot_split-light"}}) {
    Theme::instance().choose(choice);
    refresh();
    const auto* badge = panel_.findChild<RateBadge*>("rateBadge");
    EXPECT_TRUE(QTest::qWaitFor([&] { return badge->text().contains("0 lost"); }, 120'000))
        << badge->text().toStdString();
    KeepPicture(panel_.grab().toImage(), name);
  }
}

}  // namespace
}  // namespace tendon::gui
