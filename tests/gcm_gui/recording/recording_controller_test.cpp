#include <gcm_gui/recording/recording_controller.h>
#include <gtest/gtest.h>

#include <QRegularExpression>
#include <QSignalSpy>

#include "support/fakes.h"

namespace tendon::gui {
namespace {

using State = RecordingController::State;
using Patterns = std::vector<std::string>;

class RecordingControllerTest : public ::testing::Test {
 protected:
  [[nodiscard]] static RecordingProgress Progress(std::uint64_t rows) {
    RecordingProgress progress;
    progress.status.counts = {.rows = rows, .bytes = 2'500'000};
    progress.seconds = 12.0;
    return progress;
  }
  void Begin() {
    controller_.start();
    Q_EMIT runner_.begun(QStringLiteral("/data/run.mcap"));
  }

  ScriptedRecordings runner_;
  ActivityModel activity_;
  QStringList plotted_;
  QStringList selected_;
  RecordingController controller_{
      runner_, activity_, {[this] { return plotted_; }, [this] { return selected_; }}};
};

TEST_F(RecordingControllerTest, ThePlottedColumnsAreRecordedByDefault) {
  plotted_ = {"robot/arm/state.Joints.position[0]", "robot/arm/state.Joints.position[2]",
              "desk/view/state-Video.Frame"};

  controller_.toggle();

  ASSERT_EQ(runner_.requests.size(), 1U);
  EXPECT_EQ(runner_.requests[0].patterns,
            (Patterns{"robot/arm/state.Joints", "desk/view/state-Video.Frame"}));
  EXPECT_EQ(controller_.subject(), "3 plotted signals");
  EXPECT_EQ(controller_.state(), State::kStarting);
}

TEST_F(RecordingControllerTest, TheComponentOfEachSelectedThingIsRecorded) {
  selected_ = {"robot/arm/Control.MoveTo", "robot/arm", "desk/view/state.Cycle", "gcm"};
  controller_.setScope(RecordingScope::kSelected);

  controller_.start();

  EXPECT_EQ(runner_.requests.at(0).patterns, (Patterns{"robot/arm", "desk/view", "gcm"}));
  EXPECT_EQ(controller_.subject(), "robot/arm, desk/view, gcm");
}

TEST_F(RecordingControllerTest, EverythingIsRecordedOnRequest) {
  controller_.setScope(RecordingScope::kEverything);

  controller_.start();

  EXPECT_EQ(runner_.requests.at(0).patterns, Patterns{"**"});
}

TEST_F(RecordingControllerTest, TheLastSecondsAreSavedAndReported) {
  controller_.setScope(RecordingScope::kEverything);

  controller_.saveLast();

  ASSERT_EQ(runner_.requests.size(), 1U);
  EXPECT_EQ(runner_.requests[0].patterns, Patterns{"**"});
  EXPECT_EQ(runner_.requests[0].past, std::chrono::seconds(30));
  Q_EMIT runner_.begun(QStringLiteral("/data/last.mcap"));
  EXPECT_EQ(activity_.command(0), "gcm save-last 30s '**' -o '/data/last.mcap'");
  Q_EMIT runner_.ended(Progress(29'980), QString());
  ASSERT_TRUE(controller_.report());
  EXPECT_EQ(controller_.report()->title, "Saved the last 30 s: 29980 rows, 0 events (2.5 MB)");
  EXPECT_EQ(controller_.report()->detail, "/data/last.mcap");
  EXPECT_FALSE(controller_.report()->has_losses);
}

TEST_F(RecordingControllerTest, AReportOfTheLastSecondsSaysWhatIsMissing) {
  controller_.setScope(RecordingScope::kEverything);
  controller_.saveLast();
  Q_EMIT runner_.begun(QStringLiteral("/data/last.mcap"));
  RecordingProgress progress = Progress(100);
  progress.shortfalls = {"robot: 12.0 s: it has not been running longer"};

  Q_EMIT runner_.ended(progress, QString());

  EXPECT_EQ(controller_.report()->detail, "robot: 12.0 s: it has not been running longer");
  EXPECT_TRUE(controller_.report()->has_losses);
  EXPECT_EQ(controller_.report()->file, "/data/last.mcap");
}

TEST_F(RecordingControllerTest, WithoutAnyChoiceNothingStartsAndAReportSaysWhatToDo) {
  controller_.start();

  EXPECT_TRUE(runner_.requests.empty());
  ASSERT_TRUE(controller_.report());
  EXPECT_EQ(controller_.report()->kind, RecordingReport::Kind::kNothingChosen);
  EXPECT_EQ(controller_.report()->title, "Nothing is plotted");
  controller_.setScope(RecordingScope::kSelected);
  controller_.start();
  EXPECT_EQ(controller_.report()->title, "Nothing is selected");
  EXPECT_EQ(activity_.rowCount(), 0);
}

TEST_F(RecordingControllerTest, TheFileIsNamedByDateAndTimeInTheChosenFolder) {
  plotted_ = {"robot/arm/state.Joints"};
  controller_.setFolder(QStringLiteral("/data/runs/"));

  controller_.start();

  EXPECT_EQ(runner_.requests.at(0).folder, "/data/runs");
  const QRegularExpression date("^\\d{4}-\\d\\d-\\d\\d_\\d\\d-\\d\\d-\\d\\d$");
  EXPECT_TRUE(date.match(runner_.requests.at(0).name).hasMatch())
      << runner_.requests.at(0).name.toStdString();
}

TEST_F(RecordingControllerTest, TheChoicesAreRestored) {
  controller_.setFolder(QStringLiteral("/data/runs"));
  controller_.setScope(RecordingScope::kEverything);

  RecordingController next(runner_, activity_, {[] { return QStringList(); }, nullptr});
  EXPECT_TRUE(next.folder().endsWith("/recordings"));
  next.restoreChoices(controller_.choices());

  EXPECT_EQ(next.folder(), "/data/runs");
  EXPECT_EQ(next.scope(), RecordingScope::kEverything);
  next.restoreChoices("no JSON");
  EXPECT_EQ(next.folder(), "/data/runs");
}

TEST_F(RecordingControllerTest, ARecordingIsAnActionWithItsCommand) {
  plotted_ = {"robot/arm/state.Joints.position[0]"};
  Begin();
  ASSERT_EQ(activity_.rowCount(), 1);
  EXPECT_EQ(activity_.action(0).outcome, Action::Outcome::kRunning);
  EXPECT_EQ(activity_.command(0), "gcm record robot/arm/state.Joints -o '/data/run.mcap'");

  controller_.stop();
  EXPECT_EQ(runner_.stopped, 1);
  EXPECT_EQ(controller_.state(), State::kStopping);
  Q_EMIT runner_.ended(Progress(12000), {});

  EXPECT_EQ(controller_.state(), State::kIdle);
  EXPECT_EQ(activity_.action(0).outcome, Action::Outcome::kDone);
  EXPECT_EQ(activity_.action(0).seconds, 12.0);
  ASSERT_TRUE(controller_.report());
  EXPECT_EQ(controller_.report()->title, "Recorded 12000 rows in 0:12 (2.5 MB, 0 lost)");
  EXPECT_EQ(controller_.report()->file, "/data/run.mcap");
}

TEST_F(RecordingControllerTest, TheCommandQuotesAGlob) {
  controller_.setScope(RecordingScope::kEverything);
  Begin();

  EXPECT_EQ(activity_.command(0), "gcm record '**' -o '/data/run.mcap'");
}

TEST_F(RecordingControllerTest, ARefusalIsReportedAndListed) {
  controller_.setScope(RecordingScope::kEverything);
  controller_.start();

  Q_EMIT runner_.refused(QStringLiteral("no GCM at robot1:10705"));

  EXPECT_EQ(controller_.state(), State::kIdle);
  EXPECT_EQ(controller_.report()->kind, RecordingReport::Kind::kFailed);
  EXPECT_EQ(controller_.report()->detail, "no GCM at robot1:10705");
  EXPECT_EQ(activity_.action(0).refusal, "no GCM at robot1:10705");
  EXPECT_TRUE(activity_.command(0).startsWith("gcm record '**' -o "));
}

TEST_F(RecordingControllerTest, AFailureDuringTheRecordingNamesReasonAndFile) {
  controller_.setScope(RecordingScope::kEverything);
  Begin();

  Q_EMIT runner_.ended(Progress(10), QStringLiteral("cannot write: No space left on device"));

  EXPECT_EQ(controller_.report()->kind, RecordingReport::Kind::kFailed);
  EXPECT_EQ(controller_.report()->detail, "cannot write: No space left on device");
  EXPECT_EQ(controller_.report()->file, "/data/run.mcap");
  EXPECT_EQ(activity_.action(0).outcome, Action::Outcome::kRefused);
}

TEST_F(RecordingControllerTest, AStopBeforeTheBeginLeavesNothing) {
  controller_.setScope(RecordingScope::kEverything);
  controller_.toggle();
  controller_.toggle();
  EXPECT_EQ(runner_.stopped, 1);

  Q_EMIT runner_.refused({});

  EXPECT_EQ(controller_.state(), State::kIdle);
  EXPECT_FALSE(controller_.report());
  EXPECT_EQ(activity_.rowCount(), 0);
}

TEST_F(RecordingControllerTest, AnInterruptionIsToldAndTheRecordingGoesOn) {
  QSignalSpy notices(&controller_, &RecordingController::notice);
  controller_.setScope(RecordingScope::kEverything);
  Begin();

  Q_EMIT runner_.interrupted(QStringLiteral("process 'robot' is lost"));

  EXPECT_EQ(controller_.state(), State::kRecording);
  EXPECT_EQ(controller_.interruptions(), QStringList{"process 'robot' is lost"});
  ASSERT_EQ(notices.size(), 1);
  EXPECT_EQ(notices[0][0].toString(), "The recording continues: process 'robot' is lost");
}

}  // namespace
}  // namespace tendon::gui
