#include <gcm_gui/system/plan_controller.h>
#include <gtest/gtest.h>
#include <tendon/gcm/system/running_system.h>

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "support/fakes.h"
#include "support/sample_system.h"

namespace tendon::gui {
namespace {

/// A running robot, and a system file with one more component in the robot.
class PlanControllerTest : public ::testing::Test {
 protected:
  PlanControllerTest() {
    system_.Process("robot").Component("robot", Task("arm", 0.001, {}));
    store_.apply(system_.TakeChanges());
    wanted_ = SystemOf(store_.catalogue(), "lab").file;
    wanted_.processes[0].components.push_back({.name = "leg", .class_name = "Leg"});
  }

  [[nodiscard]] static message::Classes Knows(const char* class_name) {
    return {.classes = {{.name = class_name, .library = "limbs"}}, .plugins = {"limbs"}};
  }

  SystemBuilder system_;
  CatalogueStore store_;
  ScriptedReports reports_;
  ScriptedPlans runner_;
  SystemFile wanted_;
  SystemDocument document_{store_, reports_};
  PlanController restore_{document_, runner_, reports_};
};

TEST_F(PlanControllerTest, RequestsTheClassesOfAProcessFirst) {
  restore_.preview(wanted_, QStringLiteral("lab.gcm.json"));

  EXPECT_EQ(reports_.asked_for_classes, QStringList{"robot"});
  EXPECT_EQ(restore_.phase(), PlanController::Phase::kAsking);

  reports_.class_handlers[0](Knows("Leg"));
  EXPECT_EQ(restore_.phase(), PlanController::Phase::kPreview);
  EXPECT_TRUE(restore_.plan().obstacles.empty());
  EXPECT_FALSE(restore_.plan().steps.empty());
}

TEST_F(PlanControllerTest, ReportsAnUnknownClassBeforeAnyStep) {
  restore_.preview(wanted_, QStringLiteral("lab.gcm.json"));
  reports_.class_handlers[0](Knows("Lag"));

  ASSERT_EQ(restore_.plan().obstacles.size(), 1U);
  const std::string& obstacle = restore_.plan().obstacles[0];
  EXPECT_TRUE(
      obstacle.starts_with("robot/leg cannot be created as the file says: process 'robot' has "
                           "no class 'Leg' that is loaded"))
      << obstacle;
  EXPECT_TRUE(restore_.plan().steps.empty());
}

TEST_F(PlanControllerTest, ASilentProcessDoesNotBlockThePlan) {
  restore_.preview(wanted_, QStringLiteral("lab.gcm.json"));
  reports_.class_handlers[0](Error{ErrorCode::kTimeout, "no reply"});

  EXPECT_EQ(restore_.phase(), PlanController::Phase::kPreview);
  EXPECT_FALSE(restore_.plan().steps.empty());
}

TEST_F(PlanControllerTest, IgnoresALateAnswer) {
  restore_.preview(wanted_, QStringLiteral("lab.gcm.json"));
  restore_.leave();
  reports_.class_handlers[0](Knows("Leg"));

  EXPECT_EQ(restore_.phase(), PlanController::Phase::kIdle);
}

TEST_F(PlanControllerTest, KeepsThePlanVisibleWhileItIsRefreshed) {
  restore_.preview(wanted_, QStringLiteral("lab.gcm.json"));
  reports_.class_handlers[0](Knows("Leg"));
  restore_.preview(wanted_, QStringLiteral("lab.gcm.json"));

  EXPECT_EQ(restore_.phase(), PlanController::Phase::kPreview);
  EXPECT_FALSE(restore_.plan().steps.empty());
  restore_.execute(AfterError::kStop);
  reports_.class_handlers[1](Knows("Leg"));
  EXPECT_EQ(restore_.phase(), PlanController::Phase::kRunning);
}

TEST_F(PlanControllerTest, DoesNotReuseThePlanOfAnotherSystem) {
  restore_.preview(wanted_, QStringLiteral("lab.gcm.json"));
  reports_.class_handlers[0](Knows("Leg"));
  wanted_.processes[0].components.back().name = "foot";
  restore_.preview(wanted_, QStringLiteral("lab.gcm.json"));

  EXPECT_EQ(restore_.phase(), PlanController::Phase::kAsking);
  EXPECT_TRUE(restore_.plan().steps.empty());
}

/// Saves the running system in a new file.
class SavingTest : public PlanControllerTest {
 protected:
  /// Saves, and returns the notice of the window.
  QString Save() {
    QSignalSpy told(&document_, &SystemDocument::notice);
    document_.save(Path());
    EXPECT_TRUE(QTest::qWaitFor([&] { return told.count() == 1; }, 120'000));
    return told.isEmpty() ? QString() : told[0][0].toString();
  }
  [[nodiscard]] QString Path() const { return folder_.filePath("new.gcm.json"); }

  QTemporaryDir folder_;
};

TEST_F(SavingTest, RecordsProcessesThatTheGcmStarted) {
  reports_.children =
      message::Children{{{.process = "robot", .restart = RestartPolicy::kOnFailure}}};

  EXPECT_EQ(Save(), "Saved to new.gcm.json");

  const auto saved = ReadSystemFile(Path().toStdString());
  ASSERT_TRUE(saved.ok());
  ASSERT_TRUE(saved->FindProcess("robot")->start.has_value());
  EXPECT_EQ(saved->FindProcess("robot")->start->restart, RestartPolicy::kOnFailure);
}

TEST_F(SavingTest, ReportsAGcmTooOldToListItsProcesses) {
  reports_.children = Error{ErrorCode::kDenied, "unknown message"};

  EXPECT_EQ(Save(),
            "Saved to new.gcm.json; this GCM is too old to report which processes it has started");
  EXPECT_TRUE(ReadSystemFile(Path().toStdString()).ok());
}

TEST_F(SavingTest, WithoutAnAnswerNothingIsWritten) {
  reports_.children = Error{ErrorCode::kTimeout, "no reply within 2000 ms"};

  EXPECT_EQ(Save(), "no reply within 2000 ms");
  EXPECT_FALSE(ReadSystemFile(Path().toStdString()).ok());
}

TEST_F(SavingTest, SavesEvenIfTheWindowClosesEarly) {
  reports_.children.reset();
  auto document = std::make_unique<SystemDocument>(store_, reports_);
  document->save(Path());

  document.reset();

  const auto saved = ReadSystemFile(Path().toStdString());
  ASSERT_TRUE(saved.ok());
  EXPECT_NE(saved->FindComponent("robot", "arm"), nullptr);
}

}  // namespace
}  // namespace tendon::gui
