#include <gcm_gui/plot/controls/legend.h>
#include <gcm_gui/plot/controls/rate_badge.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gmock/gmock.h>

#include <QInputDialog>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "samples.h"

namespace tendon::gui {
namespace {

using namespace std::chrono_literals;

const QString kX = "robot/arm/state.Joints.position[0]";
const QString kY = "robot/arm/state.Joints.position[1]";

class PlotPanelTest : public testing::Test {
 protected:
  void SetUp() override {
    panel_.resize(800, 320);
    panel_.show();
  }

  template <typename Widget>
  [[nodiscard]] Widget& child(const QString& name) const {
    return *panel_.findChild<Widget*>(name);
  }
  [[nodiscard]] const SampleRing& samples(const QString& path) const {
    return panel_.currentPlot().curve(path)->samples();
  }

  PlotPanel panel_;
  QSignalSpy wanted_{&panel_, &PlotPanel::subscriptionWanted};
  QSignalSpy released_{&panel_, &PlotPanel::subscriptionReleased};
};

TEST_F(PlotPanelTest, SubscribesToASignalOnce) {
  panel_.addSignal(kX, "rad");
  panel_.addSignal(kX, "rad");

  panel_.append(kX, Rows(0, 100));
  panel_.append("robot/arm/state.other", Rows(0, 100));

  ASSERT_EQ(wanted_.count(), 1);
  EXPECT_EQ(wanted_[0][0], kX);
  EXPECT_EQ(samples(kX).endIndex(), 100U);
}

TEST_F(PlotPanelTest, SharesASubscriptionBetweenTwoPlots) {
  panel_.addSignal(kX, "rad");
  panel_.addPlot();
  panel_.addSignal(kX, "rad");
  panel_.append(kX, Rows(0, 100));
  EXPECT_EQ(wanted_.count(), 1);
  EXPECT_EQ(panel_.plot(0).curve(kX)->samples().endIndex(), 100U);
  EXPECT_EQ(panel_.plot(1).curve(kX)->samples().endIndex(), 100U);

  QTest::keyClick(panel_.currentPlot().legendBox().rows().front(), Qt::Key_Delete);
  EXPECT_EQ(released_.count(), 0);
  QTest::keyClick(panel_.plot(0).legendBox().rows().front(), Qt::Key_Delete);

  ASSERT_EQ(released_.count(), 1);
  EXPECT_EQ(released_[0][0], kX);
}

TEST_F(PlotPanelTest, DroppedPathsAreAddedToTheirPlot) {
  Q_EMIT panel_.currentPlot().curvesDropped({{kX, "rad"}, {kY, "rad"}});

  EXPECT_EQ(panel_.paths(), (QStringList{kX, kY}));
  EXPECT_EQ(wanted_.count(), 2);
}

TEST_F(PlotPanelTest, ClosingAPlotReleasesItsSignals) {
  panel_.addSignal(kX, "rad");
  panel_.addPlot();
  panel_.addSignal(kY, "rad");

  panel_.closePlot(0);

  EXPECT_EQ(panel_.plotCount(), 1);
  ASSERT_EQ(released_.count(), 1);
  EXPECT_EQ(released_[0][0], kX);
  EXPECT_NE(panel_.currentPlot().curve(kY), nullptr);
}

TEST_F(PlotPanelTest, TheLastPlotIsEmptiedInsteadOfClosed) {
  panel_.addSignal(kX, "rad");

  panel_.closePlot(0);

  EXPECT_EQ(panel_.plotCount(), 1);
  EXPECT_TRUE(panel_.currentPlot().curves().empty());
}

TEST_F(PlotPanelTest, PausingKeepsEverySample) {
  QSignalSpy paused(&panel_, &PlotPanel::pausedChanged);
  panel_.addSignal(kX, "rad");
  panel_.append(kX, Rows(0, 100));

  QTest::mouseClick(&child<QToolButton>("pause"), Qt::LeftButton);
  panel_.append(kX, Rows(100, 5000));

  EXPECT_TRUE(panel_.isPaused());
  ASSERT_EQ(paused.count(), 1);
  EXPECT_FALSE(panel_.currentPlot().isLive());
  EXPECT_EQ(samples(kX).endIndex(), 5000U);
  EXPECT_EQ(samples(kX).lost(), 0U);
}

TEST_F(PlotPanelTest, GoingLiveInOnePlotEndsThePause) {
  panel_.addSignal(kX, "rad");
  panel_.setPaused(true);

  panel_.currentPlot().gestures().goLive();

  EXPECT_FALSE(panel_.isPaused());
  EXPECT_FALSE(child<QToolButton>("pause").isChecked());
}

TEST_F(PlotPanelTest, TheBadgeShowsRateAndLoss) {
  panel_.addSignal(kX, "rad");
  panel_.append(kX, Rows(0, 2000));
  panel_.append(kX, Rows(2600, 4000));

  std::uint64_t next = 4000;
  const auto shows_both = [&] {
    // Otherwise the signal becomes silent on a busy machine.
    panel_.append(kX, Rows(next, next + 10));
    next += 10;
    return child<RateBadge>("rateBadge").text() == "1000 Hz · 600 lost";
  };
  EXPECT_TRUE(QTest::qWaitFor(shows_both, 120'000));
}

TEST_F(PlotPanelTest, EarlierLossesDoNotCountForANewCurve) {
  RowLosses losses{.table = 600};
  panel_.setLosses([&](const QString&) { return losses; });
  panel_.addSignal(kX, "rad");
  panel_.append(kX, Rows(0, 100));

  losses.table += 3;
  panel_.append(kX, Rows(103, 200));

  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return child<RateBadge>("rateBadge").toolTip().endsWith("; lost 3 in its process"); },
      120'000));
}

TEST_F(PlotPanelTest, ARenameStartsWithTheGivenName) {
  panel_.addSignal(kX, "rad");
  const auto asked = [&] {
    panel_.askForName();
    auto* dialog = panel_.findChild<QInputDialog*>();
    const QString begins_with = dialog->textValue();
    delete dialog;
    return begins_with;
  };

  EXPECT_EQ(asked(), "") << "its title is not a name";
  panel_.tabs().setName(panel_.currentPlot(), "left arm");
  EXPECT_EQ(asked(), "left arm");
}

TEST_F(PlotPanelTest, ARestartIsAGapNotALoss) {
  panel_.addSignal(kX, "rad");
  panel_.append(kX, Rows(1000, 2000));
  panel_.setStale(kX, "waiting for robot");
  EXPECT_TRUE(panel_.currentPlot().curve(kX)->isStale());

  panel_.beginEpoch(kX);
  std::vector<Sample> rows = Rows(0, 100);
  for (Sample& row : rows) row.time_ns += 5 * kSecond;
  panel_.append(kX, rows);

  EXPECT_FALSE(panel_.currentPlot().curve(kX)->isStale());
  EXPECT_EQ(samples(kX).lost(), 0U);
  EXPECT_EQ(samples(kX).gaps().size(), 1U);
  EXPECT_EQ(samples(kX).endIndex(), 1100U);
}

TEST(PlotPanelMemory, IsSharedAmongTheCurves) {
  PlotPanel panel(nullptr, 2 * 16 * 10'000);  // 8192 samples per curve
  panel.addSignal(kX, "rad");
  panel.addSignal(kY, "rad");

  panel.append(kX, Rows(0, 40'000));

  const SampleRing& samples = panel.currentPlot().curve(kX)->samples();
  EXPECT_EQ(samples.endIndex() - samples.firstIndex(), 8192U);
}

TEST_F(PlotPanelTest, AHundredSignalsInBatchesLoseNothing) {
  QStringList paths;
  for (int i = 0; i < 100; ++i) paths << QString("robot/arm/state.Load[%1]").arg(i);
  for (const QString& path : paths) panel_.addSignal(path, "Nm");

  for (std::uint64_t tick = 0; tick < 5000; tick += 50) {
    const std::vector<Sample> batch = Rows(tick, tick + 50);
    for (const QString& path : paths) panel_.append(path, batch);
  }

  for (const QString& path : paths) {
    EXPECT_EQ(samples(path).endIndex(), 5000U);
    EXPECT_EQ(samples(path).lost() + samples(path).repeated(), 0U);
  }
}

TEST_F(PlotPanelTest, AMenuChoosesTheTimeWindow) {
  auto& button = child<QToolButton>("window");

  QTest::mouseClick(&button, Qt::LeftButton);

  auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
  ASSERT_NE(menu, nullptr);
  const auto actions = menu->actions();
  const auto find = [&](const QString& text) {
    return *std::find_if(actions.begin(), actions.end(),
                         [&](const QAction* action) { return action->text() == text; });
  };
  EXPECT_TRUE(find("30 s")->isChecked());
  QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(find("10 s")).center());
  EXPECT_EQ(button.text(), "Last 10 s");
  EXPECT_TRUE(find("10 s")->isChecked());
  EXPECT_EQ(panel_.currentPlot().timeWindow().length(), std::chrono::seconds(10));
}

TEST_F(PlotPanelTest, DrawsOnlyTheVisiblePlot) {
  panel_.addSignal(kX, "rad");
  PlotView& behind = panel_.currentPlot();
  panel_.addPlot();

  EXPECT_FALSE(behind.isVisible());
  EXPECT_TRUE(panel_.currentPlot().isVisible());
}

TEST_F(PlotPanelTest, EveryControlHasAnAccessibleName) {
  panel_.addSignal(kX, "rad");
  panel_.append(kX, Rows(0, 100));
  for (const QToolButton* button : panel_.findChildren<QToolButton*>()) {
    EXPECT_TRUE(button->isHidden() || !button->accessibleName().isEmpty())
        << qPrintable(button->objectName());
  }
  EXPECT_FALSE(panel_.currentPlot().accessibleName().isEmpty());
  EXPECT_FALSE(panel_.currentPlot().canvas()->accessibleName().isEmpty());
}

}  // namespace
}  // namespace tendon::gui
