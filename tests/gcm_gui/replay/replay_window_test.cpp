#include <gcm_gui/activity/events_page.h>
#include <gcm_gui/graph/graph_scene.h>
#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/plot/series/shown_time.h>
#include <gcm_gui/replay/recording_notes.h>
#include <gcm_gui/replay/recording_opener.h>
#include <gcm_gui/replay/replay_page.h>
#include <gcm_gui/replay/replay_session.h>
#include <gcm_gui/replay/replay_strip.h>
#include <gcm_gui/replay/replay_stripe.h>
#include <gcm_gui/replay/time_slider.h>
#include <gcm_gui/replay/window_replay.h>
#include <gcm_gui/views/catalogue_panel.h>
#include <gcm_gui/views/catalogue_tree.h>
#include <gcm_gui/window/main_window.h>
#include <gcm_gui/window/top_bar.h>
#include <gmock/gmock.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QDropEvent>
#include <QFile>
#include <QFileInfo>
#include <QLineEdit>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QUrl>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "replay/recorded_file.h"
#include "support/pictures.h"

namespace tendon::gui {
namespace {

using testing::HasSubstr;
using State = ReplaySession::State;

constexpr int kReplayTimeout = 120'000;  // ms; bounds a test that fails
constexpr auto kSignal = "robot/arm/state.Joints.position[0]";

/// The real window with a recording of 20 s; see WriteRun().
class ReplayWindow : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(folder_.isValid());
    file_ = QFileInfo(folder_.path()).canonicalFilePath() + QStringLiteral("/run.mcap");
  }
  void TearDown() override {
    window_.reset();
    session_.reset();
  }

  /// Drops files onto this part of the window, as the mouse does.
  static bool Drop(QWidget& part, const QList<QUrl>& files) {
    QMimeData data;
    data.setUrls(files);
    const QPoint middle = part.rect().center();
    QDragEnterEvent enter(middle, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&part, &enter);
    QDropEvent drop(middle, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&part, &drop);
    return enter.isAccepted() && drop.isAccepted();
  }
  /// A program that stands for the one that shows a recording. It writes down its arguments.
  [[nodiscard]] QString Viewer() const {
    QFile program(folder_.filePath("viewer"));
    if (!program.exists() && program.open(QIODevice::WriteOnly)) {
      program.write("#!/bin/sh\nprintf '%s\\n' \"$@\" >>\"$0.arguments\"\n");
      program.setPermissions(QFile::ReadOwner | QFile::ExeOwner);
    }
    return program.fileName();
  }
  /// Returns the arguments of all started viewers, one a line.
  [[nodiscard]] std::string ViewerArguments() const {
    QFile arguments(folder_.filePath("viewer.arguments"));
    return arguments.open(QIODevice::ReadOnly) ? arguments.readAll().toStdString() : "";
  }

  void OpenRun(FileEnd end = FileEnd::kComplete) {
    WriteRun(file_, end);
    Open();
    ASSERT_TRUE(Eventually([this] { return session_->state() == State::kOpen && IsAt(0.0); }));
  }
  void Open() {
    session_ = std::make_unique<ReplaySession>(file_);
    WindowParts parts = PartsOf(*session_);
    parts.kept = folder_.filePath("kept");
    parts.viewer = QStringList{Viewer(), "--theme", "dark"};
    window_ = std::make_unique<MainWindow>(parts);
    window_->show();
    window_->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get(), kReplayTimeout));
  }
  static bool Eventually(const std::function<bool()>& holds) {
    return QTest::qWaitFor(holds, kReplayTimeout);
  }
  [[nodiscard]] double Seconds() const {
    return static_cast<double>(session_->position() - kRunBegin) / kSecond;
  }
  [[nodiscard]] bool IsAt(double seconds) const {
    return !session_->isJumping() && std::abs(Seconds() - seconds) < 1e-6;
  }
  template <typename T>
  T& Find(const char* name) {
    T* found = window_->findChild<T*>(QString::fromLatin1(name));
    if (found == nullptr) throw std::runtime_error(std::string("there is no ") + name);
    return *found;
  }
  void Click(const char* name) { QTest::mouseClick(&Find<QAbstractButton>(name), Qt::LeftButton); }
  void Key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(window_.get(), key, modifiers);
  }
  /// Clicks the slider at this time.
  void GoTo(double seconds) {
    TimeSlider& slider = window_->replay()->strip().slider();
    const auto time = kRunBegin + static_cast<std::int64_t>(seconds * kSecond);
    QTest::mouseClick(&slider, Qt::LeftButton, {},
                      {static_cast<int>(std::lround(slider.xOf(time))), slider.height() / 2});
    // A column of the slider stands for some milliseconds.
    ASSERT_TRUE(Eventually([&] {
      return !session_->isJumping() && std::abs(Seconds() - seconds) < 0.1;
    })) << Seconds();
  }
  void Plot() {
    window_->plots().addSignal(kSignal, "rad");
    ASSERT_TRUE(Eventually([this] { return Samples().endIndex() > 0 && !session_->isJumping(); }));
  }
  [[nodiscard]] const SampleRing& Samples() const {
    return window_->plots().plot(0).curve(kSignal)->samples();
  }
  [[nodiscard]] double NewestValue() const {
    return Samples().empty() ? NAN : Samples().value(Samples().endIndex() - 1);
  }
  [[nodiscard]] ComponentState ArmState() const {
    return session_->store().catalogue().FindComponent("robot", "arm")->state;
  }
  [[nodiscard]] bool IsTeleoperationConnected() const {
    return session_->store().catalogue().FindConnection({"desk", "teleoperation", "Robot"}) !=
           nullptr;
  }
  [[nodiscard]] int Rows(const char* list) {
    return Find<QAbstractItemView>(list).model()->rowCount();
  }

  /// In s since the begin.
  [[nodiscard]] std::vector<double> MarkTimes(Mark::Kind kind) const {
    std::vector<double> times;
    for (const Mark& mark : window_->plots().marks().all()) {
      const std::int64_t since = mark.time_ns - ReplayReader::SampleTime(kRunBegin, kRunBegin);
      if (mark.kind == kind) times.push_back(static_cast<double>(since) / kSecond);
    }
    return times;
  }

  QTemporaryDir folder_;
  QString file_;
  std::unique_ptr<ReplaySession> session_;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(ReplayWindow, ShowsTheSystemAsItWasAndSaysThatItIsARecording) {
  OpenRun();

  EXPECT_EQ(window_->windowTitle(), "REPLAY run.mcap – gcm-gui");
  const ReplayStripe& stripe = *window_->replay()->strip().findChild<ReplayStripe*>();
  EXPECT_TRUE(stripe.isVisible());
  EXPECT_EQ(stripe.width(), window_->width());
  EXPECT_THAT(stripe.text().toStdString(), HasSubstr("REPLAY run.mcap recorded on"));
  EXPECT_TRUE(window_->catalogueModel().indexOf("robot/arm").isValid());
  EXPECT_TRUE(window_->catalogueModel().indexOf("vision/camera").isValid());
  EXPECT_TRUE(Eventually([this] { return window_->graph().isVisible(); }));
  EXPECT_EQ(window_->findChild<QWidget*>("consolePage"), nullptr);
}

TEST_F(ReplayWindow, SpacePlaysAndPauses) {
  OpenRun();
  Plot();

  Key(Qt::Key_Space);
  ASSERT_TRUE(Eventually([this] { return Seconds() > 0.5; }));
  EXPECT_TRUE(session_->clock().isPlaying());
  Key(Qt::Key_Space);
  EXPECT_FALSE(session_->clock().isPlaying());
  ASSERT_TRUE(Eventually([this] { return session_->position() == session_->clock().position(0); }));

  EXPECT_NEAR(NewestValue(), Seconds(), 0.011) << "the row before the moment";
  EXPECT_EQ(Samples().lost(), 0U);
}

TEST_F(ReplayWindow, TheCurveShowsThePastAsSoonAsItIsPlotted) {
  OpenRun();
  GoTo(9.0);

  Plot();

  EXPECT_NEAR(NewestValue(), Seconds(), 0.011);
  EXPECT_NEAR(Samples().value(Samples().firstIndex()), 0.0, 1e-9) << "30 s are in sight";
}

TEST_F(ReplayWindow, GoingBackShowsThePastUpToThatMomentOnly) {
  OpenRun();
  Plot();
  GoTo(15.0);
  ASSERT_NEAR(NewestValue(), Seconds(), 0.011);

  GoTo(4.0);

  EXPECT_NEAR(NewestValue(), Seconds(), 0.011);
  EXPECT_EQ(window_->plots().plot(0).now(), ShownTime());
}

TEST_F(ReplayWindow, LostRowsAreAGapInTheCurve) {
  OpenRun();
  Plot();

  GoTo(14.0);

  ASSERT_EQ(Samples().gaps().size(), 1U);
  EXPECT_EQ(Samples().gaps().front().lost, 50U);
}

TEST_F(ReplayWindow, StatesAndConnectionsAreThoseOfTheMoment) {
  OpenRun();
  EXPECT_EQ(ArmState(), ComponentState::kActive);
  EXPECT_FALSE(IsTeleoperationConnected());

  GoTo(13.0);
  EXPECT_EQ(ArmState(), ComponentState::kSuspended);
  EXPECT_TRUE(IsTeleoperationConnected());
  GoTo(18.0);
  EXPECT_EQ(ArmState(), ComponentState::kActive);
  GoTo(2.0);
  EXPECT_FALSE(IsTeleoperationConnected());
}

// A small step forward is played, without the clock.
TEST_F(ReplayWindow, StatesChangeWhileItPlays) {
  OpenRun();
  GoTo(11.8);
  ASSERT_EQ(ArmState(), ComponentState::kActive);

  Click("replayNextMark");
  ASSERT_TRUE(Eventually([this] { return IsAt(15.0); })) << "the event; at " << Seconds();
  EXPECT_FALSE(session_->isSought());
  EXPECT_EQ(ArmState(), ComponentState::kSuspended);
  session_->setMarks({kRunBegin + 17 * kSecond});
  Click("replayNextMark");
  ASSERT_TRUE(Eventually([this] { return IsAt(17.0); })) << Seconds();
  EXPECT_FALSE(session_->isSought());
  EXPECT_EQ(ArmState(), ComponentState::kActive);
}

TEST_F(ReplayWindow, EventsAndLogAreThoseUpToTheMoment) {
  OpenRun();
  GoTo(10.0);
  EXPECT_EQ(Rows("events"), 2);
  EXPECT_EQ(Rows("log"), 2);

  GoTo(16.0);
  EXPECT_EQ(Rows("events"), 3);
  EXPECT_EQ(Rows("log"), 3);
  GoTo(6.0);
  EXPECT_EQ(Rows("events"), 1);
  const QAbstractItemModel& events = *Find<QAbstractItemView>("events").model();
  EXPECT_EQ(events.index(0, 0).data(kDetailRole).toString(), "5");
}

TEST_F(ReplayWindow, TheFirstVisibleRecordOfTheLogIsWhole) {
  OpenRun();
  GoTo(16.0);
  const auto& log = Find<QTreeView>("log");
  const QScrollBar& bar = *log.verticalScrollBar();

  ASSERT_TRUE(Eventually([&] { return bar.maximum() > 0 && bar.value() == bar.maximum(); }))
      << "the list is lower than its three records";

  EXPECT_EQ(log.visualRect(log.indexAt({1, 1})).top(), 0);
}

TEST_F(ReplayWindow, EventsOfPlottedComponentsAreMarkedOnThePlotAtTheirTimes) {
  OpenRun();
  Plot();

  GoTo(10.0);

  EXPECT_THAT(MarkTimes(Mark::Kind::kEvent), testing::ElementsAre(5.0, 9.0));
}

TEST_F(ReplayWindow, CallsAreMarkedAtTheirTimesAfterEachJump) {
  OpenRun();
  Plot();

  GoTo(6.0);
  GoTo(7.0);

  EXPECT_THAT(MarkTimes(Mark::Kind::kCommand), testing::ElementsAre(3.0));
}

TEST_F(ReplayWindow, StepsRowByRowAndFromMarkToMark) {
  OpenRun();
  Plot();

  Key(Qt::Key_Period);
  EXPECT_TRUE(Eventually([this] { return IsAt(0.01); })) << Seconds();
  Key(Qt::Key_Period);
  EXPECT_TRUE(Eventually([this] { return IsAt(0.02); })) << Seconds();
  Key(Qt::Key_Comma);
  EXPECT_TRUE(Eventually([this] { return IsAt(0.01); })) << Seconds();
  Click("replayNextMark");
  EXPECT_TRUE(Eventually([this] { return IsAt(5.0); })) << Seconds();
  Key(Qt::Key_Right, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(Eventually([this] { return IsAt(9.0); })) << Seconds();
  Click("replayNextMark");
  EXPECT_TRUE(Eventually([this] { return IsAt(10.5); })) << "the loss; at " << Seconds();
  Click("replayFormerMark");
  EXPECT_TRUE(Eventually([this] { return IsAt(9.0); })) << Seconds();
}

TEST_F(ReplayWindow, AMomentThatIsChosenDuringASearchIsNotReplacedByItsResult) {
  OpenRun();

  session_->goToMark(1);
  session_->seek(kRunBegin + 2 * kSecond);

  EXPECT_TRUE(Eventually([this] { return IsAt(2.0); })) << Seconds();
}

TEST_F(ReplayWindow, AMarkOfTheUserIsKeptForTheNextTime) {
  OpenRun();
  GoTo(7.0);
  const std::int64_t moment = session_->position();

  Key(Qt::Key_M);
  EXPECT_THAT(session_->marks(), testing::ElementsAre(moment));
  GoTo(1.0);
  Click("replayNextMark");
  EXPECT_TRUE(Eventually([this] { return IsAt(5.0); }));
  Click("replayNextMark");
  EXPECT_TRUE(Eventually([&] { return session_->position() == moment; })) << Seconds();

  ASSERT_TRUE(Eventually(
      [this] { return RecordingNotes(folder_.filePath("kept")).marks(file_).size() == 1; }));
  TearDown();
  Open();
  EXPECT_TRUE(Eventually([this] { return session_->marks().size() == 1; }));
  EXPECT_EQ(window_->opener().notes().recent(), QStringList{file_});
}

TEST_F(ReplayWindow, AMarkBelongsToTheFileUnderEachOfItsNames) {
  OpenRun();
  Key(Qt::Key_M);
  ASSERT_TRUE(Eventually(
      [this] { return RecordingNotes(folder_.filePath("kept")).marks(file_).size() == 1; }));
  TearDown();
  const QString link = folder_.filePath("link.mcap");
  ASSERT_TRUE(QFile::link(file_, link));

  file_ = link;
  Open();

  EXPECT_TRUE(Eventually([this] { return session_->marks().size() == 1; }));
}

TEST_F(ReplayWindow, TheChosenSpeedAndTheLoopAreThoseOfTheClock) {
  OpenRun();

  auto& speed = Find<QComboBox>("replaySpeed");
  speed.setFocus();
  QTest::keyClick(&speed, Qt::Key_Down);
  EXPECT_EQ(session_->clock().speed(), 2.0);
  Key(Qt::Key_BracketRight);
  EXPECT_EQ(session_->clock().speed(), 4.0);
  EXPECT_EQ(speed.currentText(), QStringLiteral("4×"));
  Click("replayLoop");
  GoTo(19.5);
  Click("replayPlay");
  EXPECT_TRUE(Eventually([this] { return Seconds() < 10.0; })) << "it began again";
  EXPECT_TRUE(session_->clock().isPlaying());
}

TEST_F(ReplayWindow, PlayingEndsAtTheEnd) {
  OpenRun();
  GoTo(19.0);
  session_->setSpeed(8.0);

  Click("replayPlay");

  EXPECT_TRUE(Eventually([this] { return !session_->clock().isPlaying(); }));
  EXPECT_TRUE(Eventually([this] { return session_->position() == session_->facts().last; }));
}

TEST_F(ReplayWindow, ActionsThatChangeASystemAreDisabledWithTheReason) {
  OpenRun();

  auto* connect = window_->findChild<QAction*>("Connect");
  ASSERT_NE(connect, nullptr);
  EXPECT_FALSE(connect->isEnabled());
  EXPECT_THAT(connect->toolTip().toStdString(), HasSubstr("shows the recording run.mcap"));
  EXPECT_FALSE(Find<QWidget>("record").isVisible());
  EXPECT_EQ(window_->findChild<QAction*>("Console"), nullptr);
}

TEST_F(ReplayWindow, AFileThatIsStillWrittenIsShownAsFarAsItGoes) {
  const std::shared_ptr<void> writer = BeginRun(file_);

  Open();
  ASSERT_TRUE(Eventually([this] { return session_->state() == State::kOpen && IsAt(0.0); }));

  EXPECT_TRUE(Find<QWidget>("replayWarning").isVisible());
  EXPECT_TRUE(session_->facts().is_growing);
  EXPECT_THAT(window_->replay()->strip().warning().toStdString(), HasSubstr("still being written"));
}

TEST_F(ReplayWindow, ADamagedFileThatNobodyWritesNamesTheCommandThatRepairsIt) {
  OpenRun(FileEnd::kMissing);

  EXPECT_TRUE(Find<QWidget>("replayWarning").isVisible());
  EXPECT_FALSE(session_->facts().is_growing);
  EXPECT_LT(session_->facts().last, kRunBegin + 20 * kSecond);
  EXPECT_THAT(window_->replay()->strip().warning().toStdString(), HasSubstr("gcm recover"));
  KeepPictures(*window_, "replay-damaged");
}

TEST_F(ReplayWindow, AMissingFileIsNamed) {
  Open();

  ASSERT_TRUE(Eventually([this] { return session_->state() == State::kRefused; }));
  auto& page = Find<ReplayPage>("replayPage");
  EXPECT_TRUE(page.isVisible());
  EXPECT_THAT(page.text().toStdString(), HasSubstr("run.mcap cannot be shown"));
  EXPECT_THAT(page.text().toStdString(), HasSubstr("No such file"));
  EXPECT_EQ(window_->topBar().linkText(), "Recorded system cannot be shown");
  KeepPictures(*window_, "replay-missing");
}

TEST_F(ReplayWindow, AFileThatIsNoRecordingIsRefused) {
  QFile file(file_);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("this is a text, not a recording");
  file.close();

  Open();

  ASSERT_TRUE(Eventually([this] { return session_->state() == State::kRefused; }));
  EXPECT_THAT(session_->refusal().toStdString(), HasSubstr("MCAP"));
}

TEST_F(ReplayWindow, ADroppedRecordingOpensAnotherWindow) {
  OpenRun();
  QSignalSpy notices(&window_->opener(), &RecordingOpener::notice);

  EXPECT_TRUE(Drop(*window_, {QUrl::fromLocalFile(file_), QUrl::fromLocalFile("/etc/hostname")}));

  ASSERT_EQ(notices.count(), 1);
  EXPECT_THAT(notices.front().front().toString().toStdString(), HasSubstr("separate window"));
  const std::string arguments = "--theme\ndark\n" + file_.toStdString() + "\n";
  EXPECT_TRUE(Eventually([&] { return ViewerArguments() == arguments; })) << ViewerArguments();
}

TEST_F(ReplayWindow, ARecordingCanBeDroppedOnEachPartOfTheWindow) {
  OpenRun();
  Plot();
  QSignalSpy notices(&window_->opener(), &RecordingOpener::notice);
  int dropped = 0;

  // Other parts pass the drop on to the part around them. A text field takes the path.
  const auto is_text_field = [](const QWidget* part) {
    const auto* text = qobject_cast<const QPlainTextEdit*>(part->parentWidget());
    return qobject_cast<const QLineEdit*>(part) != nullptr ||
           (text != nullptr && part == text->viewport() && !text->isReadOnly());
  };
  for (QWidget* part : window_->findChildren<QWidget*>()) {
    if (!part->acceptDrops() || is_text_field(part)) continue;
    Drop(*part, {QUrl::fromLocalFile(file_)});
    EXPECT_EQ(notices.count(), ++dropped)
        << part->metaObject()->className() << " " << part->objectName().toStdString();
  }
  Drop(*window_->graph().viewport(), {QUrl::fromLocalFile(file_)});
  EXPECT_EQ(notices.count(), ++dropped) << "the graph";

  EXPECT_GE(dropped, 2) << "also a plot takes drops";
}

TEST_F(ReplayWindow, LooksAsInThePictures) {
  OpenRun();
  window_->resize(1440, 900);
  window_->plots().addSignal("robot/arm/state.Joints.position[1]", "rad");
  GoTo(7.0);
  Key(Qt::Key_M);
  GoTo(15.5);
  ASSERT_TRUE(Eventually([this] { return !window_->graph().graph().isArranging(); }));

  KeepPictures(*window_, "replay");
  window_->resize(900, 600);
  KeepPictures(*window_, "replay-narrow");
}

}  // namespace
}  // namespace tendon::gui
