#include <gcm_gui/plot/controls/legend.h>
#include <gcm_gui/plot/plot_layout.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gmock/gmock.h>

#include <QInputDialog>
#include <QSignalSpy>
#include <QTest>

#include "samples.h"

namespace tendon::gui {
namespace {

using namespace std::chrono_literals;

const QString kOld = "robot/arm/state.Joints.position[0]";
const QString kNew = "robot/left_arm/state.Joints.position[0]";

class PlotLayoutTest : public testing::Test {
 protected:
  PlotLayoutTest() { panel_.resize(800, 320); }

  PlotPanel panel_;
};

TEST_F(PlotLayoutTest, ALayoutIsTheSameInAnotherPanel) {
  panel_.addSignal(kOld, "rad");
  panel_.addSignal("robot/arm/state.Goal.duration", "s");
  panel_.currentPlot().curve(kOld)->setVisible(false);
  panel_.addPlot();
  panel_.setWindow(5s);
  panel_.addSignal("desk/host_monitor/state.Cpu.load", "");
  panel_.tabs().setName(panel_.currentPlot(), "load of the desk");

  PlotPanel other;
  other.addSignal("gone/with/the.last", "");
  QSignalSpy wanted(&other, &PlotPanel::subscriptionWanted);
  EXPECT_EQ(ShowLayout(other, LayoutOf(panel_)), std::nullopt);

  EXPECT_EQ(LayoutOf(other), LayoutOf(panel_));
  EXPECT_EQ(other.tabs().name(other.plot(1)), "load of the desk");
  EXPECT_EQ(wanted.count(), 3);
  EXPECT_FALSE(other.paths().contains("gone/with/the.last"));
}

TEST_F(PlotLayoutTest, AMissingSignalIsStaleUntilRowsArrive) {
  panel_.addSignal(kOld, "rad");
  const QByteArray layout = LayoutOf(panel_);
  PlotPanel other;
  ASSERT_EQ(ShowLayout(other, layout), std::nullopt);
  const Curve& curve = *other.currentPlot().curve(kOld);
  EXPECT_TRUE(curve.isStale());

  other.append(kOld, Rows(0, 10));

  EXPECT_FALSE(curve.isStale());
}

TEST_F(PlotLayoutTest, RejectsABadLayoutWithAReason) {
  panel_.addSignal(kOld, "rad");
  const QByteArray before = LayoutOf(panel_);

  for (const auto& [layout, reason] :
       {std::pair{"{", "not JSON"}, std::pair{R"({"version": 7, "plots": []})", "version 7"},
        std::pair{R"({"version": 1, "plots": []})", "the file contains no plot"},
        std::pair{R"({"version": 1, "plots": [{"window": -1, "curves": []}]})", "plot 1"},
        std::pair{R"({"version": 1, "plots": [{"window": 1, "curves": [{}]}]})", "plot 1"}}) {
    const auto told = ShowLayout(panel_, layout);
    ASSERT_TRUE(told.has_value()) << layout;
    EXPECT_THAT(told->toStdString(), testing::HasSubstr(reason));
  }

  EXPECT_EQ(LayoutOf(panel_), before);
}

TEST_F(PlotLayoutTest, AStaleSignalCanBeRemappedFromTheLegend) {
  panel_.addSignal(kOld, "rad");
  panel_.setStale(kOld);
  panel_.setCandidates([](const QString&) { return QList<CurveKey>{{kNew, "rad"}}; });
  panel_.show();
  panel_.currentPlot().refresh();

  QTest::keyClick(panel_.currentPlot().legendBox().rows().front(), Qt::Key_R);
  auto* dialog = panel_.findChild<QInputDialog*>();
  ASSERT_NE(dialog, nullptr);
  EXPECT_EQ(dialog->textValue(), kNew);
  QTest::keyClick(dialog, Qt::Key_Return);

  EXPECT_TRUE(QTest::qWaitFor([this] { return panel_.paths() == QStringList{kNew}; }, 120'000));
}

}  // namespace
}  // namespace tendon::gui
