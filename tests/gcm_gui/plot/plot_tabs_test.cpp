#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_tabs.h>
#include <gcm_gui/plot/plot_view.h>
#include <gtest/gtest.h>

#include <QTabBar>
#include <QTest>
#include <QToolButton>

namespace tendon::gui {
namespace {

const QString kPosition = "robot/arm/state.Joints.position[0]";

class PlotTabsTest : public testing::Test {
 protected:
  void SetUp() override {
    panel_.resize(800, 320);
    panel_.show();
  }
  [[nodiscard]] const QTabBar& Bar() const { return *panel_.findChild<QTabBar*>("plotTabs"); }

  PlotPanel panel_;
};

TEST_F(PlotTabsTest, ATabIsNamedByItsFirstColumn) {
  const QTabBar& tabs = Bar();
  EXPECT_EQ(tabs.tabText(0), "Plot 1");

  panel_.addSignal(kPosition, "rad");
  QTest::mouseClick(panel_.findChild<QToolButton*>("newPlot"), Qt::LeftButton);

  EXPECT_EQ(tabs.tabText(0), "Joints");
  EXPECT_EQ(tabs.tabText(1), "Plot 2");
  EXPECT_EQ(panel_.currentIndex(), 1);
  EXPECT_EQ(panel_.plot(0).accessibleName(), "Plot Joints");
}

TEST_F(PlotTabsTest, TabsWithTheSameColumnAreToldApart) {
  const QTabBar& tabs = Bar();
  panel_.addSignal(kPosition, "rad");
  panel_.addPlot();
  panel_.addSignal("robot/old_arm/state.Joints.position[0]", "deg");
  EXPECT_EQ(tabs.tabText(0), "arm.Joints");
  EXPECT_EQ(tabs.tabText(1), "old_arm.Joints");

  panel_.closePlot(0);
  EXPECT_EQ(tabs.tabText(0), "Joints");

  panel_.addPlot();
  panel_.addSignal("robot/old_arm/state.Joints.position[1]", "deg");
  EXPECT_EQ(tabs.tabText(0), "Joints");
  EXPECT_EQ(tabs.tabText(1), "Joints 2");
}

TEST_F(PlotTabsTest, AnEmptyNameGivesTheTabTheTitleOfItsContents) {
  PlotTabs& tabs = panel_.tabs();
  panel_.addSignal(kPosition, "rad");

  tabs.setName(panel_.currentPlot(), " left   arm ");
  EXPECT_EQ(tabs.name(panel_.currentPlot()), "left arm");
  EXPECT_EQ(tabs.title(), "left arm");

  tabs.setName(panel_.currentPlot(), "");
  EXPECT_EQ(tabs.title(), "Joints");
}

}  // namespace
}  // namespace tendon::gui
