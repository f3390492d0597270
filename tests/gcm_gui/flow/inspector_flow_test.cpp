#include <gcm_gui/inspector/inspector.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/models/sparkline.h>
#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>
#include <QTreeView>
#include <algorithm>
#include <string>

#include "flow/flow_fixture.h"
#include "support/pictures.h"

namespace tendon::gui {
namespace {

class InspectorFlow : public FlowFixture {
 protected:
  void Select(const QString& path) { window_->selection().select(path); }
  const Action& LastAction() { return session_->activity().action(0); }
  /// Waits until the call was executed `times` times; the next call may be running.
  bool Called(int times) {
    return Eventually([&] {
      if (session_->activity().rowCount() == 0) return false;
      const Action& last = LastAction();
      return last.times > times || (last.times == times && last.outcome == Action::Outcome::kDone);
    });
  }
};

TEST_F(InspectorFlow, ShowsValueTrendsAndTabsForEventsAndParameters) {
  Select("robot/arm");
  ClickTab("inspectorTabs.tabs", "Values");
  auto& values = Find<QTreeView>("inspector.values");
  EXPECT_TRUE(Eventually([&] {
    return values.model()->rowCount() > 0 &&
           values.model()->index(0, 0).data(kSparklineRole).value<Sparkline>().parts.size() > 20;
  }));
  EXPECT_TRUE(Eventually(
      [&] { return values.model()->index(0, 0).data(kDetailRole).toString().endsWith("Hz"); }));
  KeepPictures(*window_, "flow-values");

  ClickTab("inspectorTabs.tabs", "Thread");
  EXPECT_TRUE(Find<QWidget>("inspector.thread").isVisible());
  KeepPictures(*window_, "flow-thread");

  ClickTab("inspectorTabs.tabs", "Events");
  auto& events = Find<QTreeView>("inspector.events");
  EXPECT_TRUE(Eventually([&] {
    MoveArm();
    return events.model()->rowCount() > 0;
  }));
  EXPECT_EQ(events.model()->index(0, 0).data(kTrailRole).toString(), "Control");
  KeepPictures(*window_, "flow-inspector-events");

  ClickTab("inspectorTabs.tabs", "Config");
  auto& parameters = Find<QTreeView>("inspector.configuration");
  EXPECT_EQ(parameters.model()->index(0, 0).data(kTrailRole).toString(), "SimulatedArm");
}

TEST_F(InspectorFlow, TheHealthOfProcessesAndConnectionsIsShown) {
  Select("desk/supervisor");
  auto& interfaces = Find<QTreeView>("inspector.interfaces");
  EXPECT_TRUE(Eventually([&] {
    return interfaces.model()
        ->index(0, 0)
        .data(Qt::ToolTipRole)
        .toString()
        .contains("connected for");
  }));
  KeepPictures(*window_, "flow-health");

  Select("robot");
  EXPECT_TRUE(Eventually([&] {
    const auto labels = window_->inspector().findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
      return label->isVisible() && label->text().contains("MiB");
    });
  }));
  KeepPictures(*window_, "flow-process");
}

TEST_F(InspectorFlow, ACommandIsRepeatedUntilItIsStopped) {
  Select("robot/arm/Control.GetJoints");
  Click(Find<QToolButton>("call.showRepeat"));
  auto& rate = Find<QDoubleSpinBox>("call.rate");
  rate.setFocus();
  rate.selectAll();
  QTest::keyClicks(&rate, "20");
  auto& button = Find<QPushButton>("call.repeat");
  Click(button);
  ASSERT_TRUE(Called(5));
  EXPECT_EQ(button.text(), "Stop");
  KeepPictures(*window_, "flow-repeat");

  Click(button);
  EXPECT_EQ(button.text(), "Repeat");
  EXPECT_TRUE(Eventually([&] { return LastAction().outcome == Action::Outcome::kDone; }));
  EXPECT_EQ(session_->activity().rowCount(), 1);
}

TEST_F(InspectorFlow, MotionCommandsRepeatOnlyWhileTheButtonIsHeld) {
  Select("robot/arm/Control.MoveTo");
  auto& button = Find<QPushButton>("call.repeat");
  ASSERT_TRUE(Eventually([&] { return button.isEnabled(); }));
  Click(Find<QToolButton>("call.showRepeat"));
  EXPECT_EQ(button.text(), "Hold to repeat");
  auto& rate = Find<QDoubleSpinBox>("call.rate");
  rate.setFocus();
  rate.selectAll();
  QTest::keyClicks(&rate, "10");

  QTest::mousePress(&button, Qt::LeftButton);
  ASSERT_TRUE(Called(3));
  QTest::mouseRelease(&button, Qt::LeftButton);
  ASSERT_TRUE(Eventually([&] { return LastAction().outcome == Action::Outcome::kDone; }));
  const int called = LastAction().times;

  QTest::qWait(400);  // time for four further calls
  EXPECT_EQ(LastAction().times, called);
}

TEST_F(InspectorFlow, TheFormStartsWithThePositionOfTheArm) {
  MoveArm();
  Select("robot/arm/Control.MoveTo");
  auto& status = Find<QLabel>("call.status");
  ASSERT_TRUE(Eventually([&] {
    return status.text() == "position: current values from GetJoints";
  })) << qPrintable(status.text());

  Click(Find<QToolButton>("call.asJson"));
  const auto said =
      QJsonDocument::fromJson(Find<QPlainTextEdit>("call.json").toPlainText().toUtf8());

  ASSERT_EQ(said["position"].toArray().size(), 7);
  EXPECT_LT(said["position"][3].toDouble(), -0.1) << "its elbow is bent";
}

TEST_F(InspectorFlow, AFavouriteIsDisabledUntilItsComponentReturns) {
  Select("robot/arm/Control.GetJoints");
  Click(Find<QToolButton>("call.favourite"));
  auto& favourite = Find<QPushButton>("favourite.robot/arm/Control.GetJoints");
  ASSERT_TRUE(favourite.isVisible());
  Click(favourite);
  ASSERT_TRUE(Called(1));
  KeepPictures(*window_, "flow-favourites");

  robot_.reset();  // kills the process
  EXPECT_TRUE(Eventually([&] { return !favourite.isEnabled(); }));
  robot_ = StartLcm("robot");
  EXPECT_TRUE(Eventually([&] { return favourite.isEnabled() && IsDemoRunning(); }));
  Click(favourite);
  EXPECT_TRUE(Called(2));
}

}  // namespace
}  // namespace tendon::gui
