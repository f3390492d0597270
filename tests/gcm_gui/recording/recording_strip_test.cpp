#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/recording/recording_strip.h>
#include <gcm_gui/recording/window_recording.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/window/notice_line.h>
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QLabel>
#include <QMenu>
#include <QTest>

#include "support/fakes.h"
#include "support/pictures.h"
#include "window/window_fixture.h"

namespace tendon::gui {
namespace {

const QString kRun = QStringLiteral("/data/recordings/2026-11-29_14-05-09.mcap");

/// The window with its record button and its strip. The test acts as the recorder.
class RecordingStripTest : public WindowFixture {
 protected:
  ~RecordingStripTest() override { Theme::instance().choose(Theme::Choice::kSystem); }

  template <typename T = QAbstractButton>
  T& Find(const char* name) {
    return *window_.findChild<T*>(QString::fromLatin1(name));
  }
  QString Text(const char* name) { return Find<QLabel>(name).text(); }
  void Click(const char* name) { QTest::mouseClick(&Find<QWidget>(name), Qt::LeftButton); }
  void PressCtrlR() { QTest::keyClick(&window_, Qt::Key_R, Qt::ControlModifier); }
  RecordingStrip& Strip() { return window_.recording().strip(); }

  void Plot() {
    for (int joint = 0; joint < 3; ++joint) {
      window_.plots().addSignal(QStringLiteral("robot/arm/state.Joints.position[%1]").arg(joint),
                                "rad");
    }
  }
  void Begin() {
    Plot();
    PressCtrlR();
    Q_EMIT recordings_.begun(kRun);
    Q_EMIT recordings_.progressed(progress_);
  }
  static RecordingProgress Usual() {
    RecordingProgress progress;
    progress.status.counts = {.rows = 754012, .events = 3, .log = 17, .bytes = 48'200'000};
    progress.status.disk_free = 40'300'000'000;
    progress.seconds = 754.0;
    progress.rate = 64'000.0;
    return progress;
  }

  RecordingProgress progress_ = Usual();
};

TEST_F(RecordingStripTest, TheButtonStartsAndTheStripShowsAllFigures) {
  Plot();
  EXPECT_FALSE(Strip().isVisible());
  Click("record");
  ASSERT_EQ(recordings_.requests.size(), 1U);
  EXPECT_TRUE(Strip().isVisible());
  EXPECT_TRUE(Strip().text().contains("Starting to record"));

  Q_EMIT recordings_.begun(kRun);
  Q_EMIT recordings_.progressed(progress_);

  EXPECT_TRUE(Strip().text().contains("Recording 3 plotted signals → " + kRun))
      << Strip().text().toStdString();
  EXPECT_EQ(Text("recordingLength"), "12:34");
  EXPECT_EQ(Text("recordingRows"), "754012 rows");
  EXPECT_EQ(Text("recordingRate"), "64.0 kB/s");
  EXPECT_EQ(Text("recordingSize"), "48.2 MB");
  EXPECT_EQ(Text("recordingDiskFree"), "40.3 GB free");
  EXPECT_EQ(Text("recordingLost"), "0 lost");
  EXPECT_EQ(Find("record").accessibleName(), "Stop the recording");
}

TEST_F(RecordingStripTest, StopInTheStripTheButtonAndTheKeyStop) {
  int stopped = 0;
  for (const auto& stop : {std::function<void()>([this] { Click("stopRecording"); }),
                           std::function<void()>([this] { Click("record"); }),
                           std::function<void()>([this] { PressCtrlR(); })}) {
    Begin();
    stop();
    EXPECT_EQ(recordings_.stopped, ++stopped);
    EXPECT_FALSE(Find("stopRecording").isEnabled());
    Q_EMIT recordings_.ended(progress_, {});
    EXPECT_EQ(Find("record").accessibleName(), "Record");
  }
  EXPECT_EQ(recordings_.requests.size(), 3U);
}

TEST_F(RecordingStripTest, LossesHaveTheColourOfAWarningAndSayWhere) {
  Begin();
  const auto role = [this] { return Find<QLabel>("recordingLost").property("role").toString(); };
  EXPECT_FALSE(role().contains("warning"));

  progress_.status.losses.rows["robot/arm/state"] = {.table = 2, .network = 0, .viewer = 5};
  Q_EMIT recordings_.progressed(progress_);

  EXPECT_EQ(Text("recordingLost"), "7 lost");
  EXPECT_TRUE(role().contains("warning"));
  EXPECT_EQ(Find<QLabel>("recordingLost").toolTip(),
            "robot/arm/state: rows lost: 2 in its process, 5 in this window, because the disk was "
            "too slow");
}

TEST_F(RecordingStripTest, ADiskThatIsAlmostFullHasTheColourOfAWarning) {
  progress_.status.disk_free = 100'000'000;
  Begin();

  const auto& free = Find<QLabel>("recordingDiskFree");
  EXPECT_TRUE(free.property("role").toString().contains("warning"));
  EXPECT_EQ(free.toolTip(), "The disk is almost full.");
}

TEST_F(RecordingStripTest, AnInterruptionStaysVisible) {
  Begin();
  EXPECT_FALSE(Find<QWidget>("recordingInterruptions").isVisible());

  Q_EMIT recordings_.interrupted(QStringLiteral("process 'robot' is lost"));

  EXPECT_TRUE(Find<QWidget>("recordingInterruptions").isVisible());
  EXPECT_EQ(Find<QWidget>("recordingInterruptions").toolTip(), "process 'robot' is lost");
  EXPECT_EQ(window_.notice().text(), "The recording continues: process 'robot' is lost");
}

TEST_F(RecordingStripTest, TheOutcomeOffersTheFileUntilItIsClosed) {
  const ScriptedFileManager manager;
  Begin();
  Click("stopRecording");
  Q_EMIT recordings_.ended(progress_, {});
  EXPECT_TRUE(Strip().text().contains("Recorded 754012 rows"));
  EXPECT_TRUE(Strip().text().contains(kRun));

  Click("copyRecordingPath");
  EXPECT_EQ(QApplication::clipboard()->text(), kRun);
  Click("showRecording");
  EXPECT_EQ(manager.shown, QStringList{"/data/recordings"});

  Click("closeRecordingReport");
  EXPECT_FALSE(Strip().isVisible());
}

TEST_F(RecordingStripTest, SaysThatTheLastSecondsAreSavedAndHowFarBackTheyReach) {
  Plot();
  QTest::keyClick(&window_, Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(Strip().text().startsWith("Saving the last 30 s ")) << Strip().text().toStdString();
  Q_EMIT recordings_.begun(kRun);
  EXPECT_TRUE(Strip().text().startsWith("Saving the last 30 s ")) << Strip().text().toStdString();
  KeepPictures(window_, "save-last-running");

  progress_.status.counts = {.rows = 29'980, .events = 3, .bytes = 2'500'000};
  Q_EMIT recordings_.ended(progress_, {});
  EXPECT_TRUE(Strip().text().startsWith("Saved the last 30 s: 29980 rows, 3 events (2.5 MB)"))
      << Strip().text().toStdString();
  KeepPictures(window_, "save-last");

  QTest::keyClick(&window_, Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
  Q_EMIT recordings_.begun(kRun);
  progress_.shortfalls = {"robot reached back 12.0 s: it has not been running longer"};
  Q_EMIT recordings_.ended(progress_, {});
  EXPECT_TRUE(Strip().text().endsWith("it has not been running longer"));
  KeepPictures(window_, "save-last-short");
}

TEST_F(RecordingStripTest, ARefusalIsShownUnderTheButtonWithAWayOut) {
  Plot();
  Click("record");
  Q_EMIT recordings_.refused(QStringLiteral("cannot create /data/a.mcap: Permission denied"));

  EXPECT_TRUE(Strip().text().contains("cannot create /data/a.mcap: Permission denied"));
  EXPECT_FALSE(Find("copyRecordingPath").isVisible()) << "there is no file";
  Click("chooseRecordingFolder");
  auto* dialog = window_.findChild<QFileDialog*>("recordingFolder");
  ASSERT_NE(dialog, nullptr);
  Q_EMIT dialog->fileSelected(QStringLiteral("/other/disk"));
  dialog->close();

  EXPECT_FALSE(Strip().isVisible());
  Click("record");
  EXPECT_EQ(recordings_.requests.back().folder, "/other/disk");
}

TEST_F(RecordingStripTest, TheArrowChoosesWhatToRecord) {
  PressCtrlR();  // nothing is plotted, so nothing can be recorded
  EXPECT_TRUE(Strip().text().contains("Nothing is plotted"));
  Click("recordMenu");
  auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
  ASSERT_NE(menu, nullptr);
  QAction* everything = nullptr;
  for (QAction* action : menu->actions()) {
    if (action->text().contains("everything")) everything = action;
  }
  ASSERT_NE(everything, nullptr);
  QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(everything).center());

  EXPECT_TRUE(everything->isChecked());
  EXPECT_FALSE(Strip().isVisible()) << "the question is answered";
  EXPECT_TRUE(recordings_.requests.empty()) << "a choice starts nothing";
  PressCtrlR();
  EXPECT_EQ(recordings_.requests.at(0).patterns, std::vector<std::string>{"**"});
}

TEST_F(RecordingStripTest, ALongSentenceDoesNotWidenTheWindow) {
  const int before = window_.minimumSizeHint().width();
  Plot();
  PressCtrlR();
  Q_EMIT recordings_.refused(QString(2000, 'x'));

  EXPECT_LE(window_.minimumSizeHint().width(), before);
  EXPECT_LE(Strip().minimumSizeHint().width(), 900);
}

TEST_F(RecordingStripTest, RendersForPeople) {
  Begin();
  KeepPictures(window_, "recording");
  progress_.status.losses.rows["robot/arm/state"] = {.table = 0, .network = 0, .viewer = 1204};
  progress_.status.disk_free = 310'000'000;
  Q_EMIT recordings_.progressed(progress_);
  Q_EMIT recordings_.interrupted(QStringLiteral("process 'desk' is lost"));
  KeepPictures(window_, "recording-losses");
  Q_EMIT recordings_.ended(progress_, {});
  KeepPictures(window_, "recording-done");
  Click("record");
  Q_EMIT recordings_.refused(
      QStringLiteral("cannot create /data/recordings/2026-11-29_14-05-09.mcap: Permission denied"));
  KeepPictures(window_, "recording-refused");
  EXPECT_EQ(Strip().height(), 32);
}

}  // namespace
}  // namespace tendon::gui
