#include <gcm_gui/models/text.h>
#include <gcm_gui/system/plan_controller.h>
#include <gcm_gui/system/system_files.h>
#include <gcm_gui/views/tab_panel.h>
#include <gcm_gui/window/notice_line.h>
#include <gtest/gtest.h>

#include <QPushButton>
#include <QTabBar>
#include <QTest>

#include "window/window_fixture.h"

namespace tendon::gui {
namespace {

using Kind = PlanStep::Kind;

/// At first, no program runs.
class DemoTest : public WindowFixture {
 protected:
  DemoTest() { store_.replace(Catalogue::At(0)); }

  [[nodiscard]] static QPushButton& TryDemo(const MainWindow& window) {
    return *window.findChild<QPushButton*>("tryDemo");
  }
  [[nodiscard]] static QString Notice(const MainWindow& window) {
    return window.findChild<NoticeLine*>()->text();
  }
  bool Start() {
    QTest::mouseClick(&TryDemo(window_), Qt::LeftButton);
    return QTest::qWaitFor([this] { return plans_.started == 1; }, kTestTimeout);
  }
  [[nodiscard]] QString Page() const {
    return window_.centre().tabs().tabText(window_.centre().current());
  }
};

TEST_F(DemoTest, AClickStartsTheProcessesAndShowsProgress) {
  ASSERT_TRUE(Start());

  const auto& steps = plans_.plan.steps;
  const auto starts = [&](const char* process) {
    return std::any_of(steps.begin(), steps.end(), [&](const PlanStep& step) {
      return step.kind == Kind::kStartProcess && step.process == process;
    });
  };
  EXPECT_TRUE(starts("robot"));
  EXPECT_TRUE(starts("desk"));
  plans_.progress(1, {});
  EXPECT_EQ(Notice(window_), QStringLiteral("Starting the demo: step 2 of %1").arg(steps.size()));
  EXPECT_EQ(Page(), "Graph");

  plans_.done({.done = steps.size()});
  EXPECT_TRUE(Notice(window_).startsWith("The demo runs: ")) << Notice(window_).toStdString();
  EXPECT_EQ(Page(), "Graph");
}

TEST_F(DemoTest, UndoEndsOnlyTheProcessesOfTheDemo) {
  ASSERT_TRUE(Start());
  const std::size_t all = plans_.plan.steps.size();
  SystemBuilder running;
  ComponentDescription arm = Task("arm", 0, {});
  arm.class_name = "SimulatedArm";
  arm.library = "simulated_arm";
  running.Process("robot").Process("desk").Process("other").Component("robot", arm);
  store_.replace(running.catalogue());
  for (std::size_t step = 1; step <= all; ++step) plans_.progress(step, {});
  plans_.done({.done = all});
  PlanController& restore = window_.files().restore();

  restore.undo();

  QStringList texts;
  for (const PlanStep& step : restore.plan().steps) texts << ToQString(ToString(step));
  EXPECT_EQ(texts.size(), 4) << qPrintable(texts.join(", "));
  EXPECT_TRUE(texts.contains("remove robot/arm"));
  EXPECT_EQ(texts.last(2).first().left(12), "end process ");
  EXPECT_TRUE(texts.contains("end process robot"));
  EXPECT_TRUE(texts.contains("end process desk"));

  restore.execute(AfterError::kStop);
  SystemBuilder other;
  other.Process("other");
  store_.replace(other.catalogue());
  for (std::size_t step = 1; step <= 4; ++step) plans_.progress(step, {});
  plans_.done({.done = 4});
  restore.undo();
  ASSERT_FALSE(restore.plan().steps.empty());
  EXPECT_EQ(restore.plan().steps.front().kind, Kind::kStartProcess);
  EXPECT_TRUE(restore.plan().obstacles.empty());
}

TEST_F(DemoTest, AFailedStartShowsTheReasonAndTheSteps) {
  ASSERT_TRUE(Start());

  plans_.progress(1, {StepOutcome::State::kFailed, "there is no lcm beside this program"});
  plans_.done({.failed = 1,
               .left = plans_.plan.steps.size() - 1,
               .error = Error{ErrorCode::kNotFound, "there is no lcm beside this program"}});

  EXPECT_EQ(Notice(window_), "The demo was not started: there is no lcm beside this program");
  EXPECT_EQ(Page(), "Diff");
}

TEST_F(DemoTest, ReportsAMissingDemoFile) {
  WindowParts parts = Parts();
  parts.demo = "/no/such/demo.json";
  MainWindow window(parts);
  window.show();

  QTest::mouseClick(&TryDemo(window), Qt::LeftButton);

  EXPECT_TRUE(
      QTest::qWaitFor([&] { return Notice(window).contains("/no/such/demo.json"); }, kTestTimeout));
  EXPECT_TRUE(Notice(window).startsWith("The system file of the demo cannot be read: "));
  EXPECT_EQ(plans_.started, 0);
}

TEST_F(DemoTest, IsOfferedOnlyForAReachableLocalGcm) {
  EXPECT_TRUE(TryDemo(window_).isVisible());

  link_.setUnreachable("refused");
  EXPECT_FALSE(TryDemo(window_).isVisible());

  link_.setAddress("10.0.0.7:10705", false);
  link_.setConnected();
  EXPECT_FALSE(TryDemo(window_).isVisible());

  link_.setAddress("127.0.0.1:4711", false);
  link_.setConnected();
  EXPECT_TRUE(TryDemo(window_).isVisible());
}

}  // namespace
}  // namespace tendon::gui
