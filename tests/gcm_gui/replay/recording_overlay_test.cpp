#include <gcm_gui/plot/controls/legend.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/plot/series/shown_time.h>
#include <gcm_gui/replay/recorded_signal_dialog.h>
#include <gcm_gui/replay/recording_overlay.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/window/notice_line.h>
#include <gmock/gmock.h>

#include <QAbstractItemView>
#include <QContextMenuEvent>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <vector>

#include "replay/recorded_file.h"
#include "support/pictures.h"
#include "window/window_fixture.h"

namespace tendon::gui {
namespace {

using testing::HasSubstr;

const QString kShownWave = QStringLiteral("robot/arm/state.Joints.position[1]");

/// A live window whose plot shows a signal, and a recording with the same one.
class RecordingOverlayTest : public WindowFixture {
 protected:
  RecordingOverlayTest() {
    file_ = folder_.filePath("run.mcap");
    recorded_ = RecordedPath(file_, kShownWave);
    window_.plots().addSignal(kShownWave, "rad");
    Feed();
  }
  ~RecordingOverlayTest() override { Theme::instance().choose(Theme::Choice::kSystem); }

  /// Sends live rows for the last 30 s.
  void Feed() {
    constexpr int kLiveRows = 3000;
    const std::int64_t now = ShownTime();
    std::vector<Sample> samples;
    for (int i = 0; i < kLiveRows; ++i) {
      const double seconds = i / 100.0;
      samples.push_back({.time_ns = now - (kLiveRows - 1 - i) * (kSecond / 100),
                         .tick = ++tick_,
                         .value = 0.9 * std::sin(seconds - 2) + 0.05 * std::sin(9 * seconds)});
    }
    Q_EMIT source_.samplesArrived(kShownWave, samples);
  }
  [[nodiscard]] PlotView& Plot() const { return window_.plots().currentPlot(); }
  [[nodiscard]] const Curve* Recorded() const { return Plot().curve(recorded_); }
  static bool Eventually(const std::function<bool()>& holds) {
    return QTest::qWaitFor(holds, kTestTimeout);
  }
  [[nodiscard]] RecordedSignalDialog* Dialog() const {
    return window_.findChild<RecordedSignalDialog*>();
  }
  /// Right click, menu, and the name of the file in the dialog.
  void ChooseFile() {
    QContextMenuEvent asked(QContextMenuEvent::Mouse, {60, 60}, Plot().mapToGlobal(QPoint(60, 60)));
    QCoreApplication::sendEvent(Plot().canvas(), &asked);
    auto* menu = window_.findChild<QMenu*>("plotMenu");
    ASSERT_NE(menu, nullptr);
    for (QAction* action : menu->actions()) {
      if (action->text() != QString("Add a curve of a recording…")) continue;
      QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
    }
    auto* files = window_.findChild<QFileDialog*>("addRecording");
    ASSERT_NE(files, nullptr);
    auto* name = files->findChild<QLineEdit*>("fileNameEdit");
    ASSERT_NE(name, nullptr);
    name->setText(file_);
    QTest::keyClick(name, Qt::Key_Return);
    ASSERT_TRUE(Eventually([this] { return Dialog() != nullptr; }));
  }
  void AddTheSameSignal() {
    ChooseFile();
    ASSERT_TRUE(Eventually([this] { return Dialog()->count() > 0; }));
    ASSERT_EQ(Dialog()->selected(), (QList<CurveKey>{{recorded_, "rad"}}));
    QTest::mouseClick(Dialog()->findChild<QPushButton*>("recordedSignals.add"), Qt::LeftButton);
    ASSERT_TRUE(Eventually([this] { return Recorded() && !Recorded()->samples().empty(); }));
  }
  [[nodiscard]] LegendRow* Row() const {
    return Plot().findChild<LegendRow*>("legend:" + recorded_);
  }

  QTemporaryDir folder_;
  QString file_;
  QString recorded_;
  std::uint64_t tick_ = 0;
};

TEST_F(RecordingOverlayTest, AUserPutsARecordingBesideALiveCurveAndShiftsIt) {
  WriteRun(file_);
  AddTheSameSignal();

  const std::int64_t begin = Recorded()->samples().time(0);
  const auto left = static_cast<double>(Plot().timeWindow().firstTime());
  EXPECT_NEAR(static_cast<double>(begin), left, 5.0 * kSecond) << "it begins at the left edge";
  EXPECT_EQ(Recorded()->colorIndex(), Plot().curve(kShownWave)->colorIndex());
  EXPECT_EQ(source_.subscribed.keys(), QStringList{kShownWave}) << "the system is not asked for it";

  const std::int64_t shift = Plot().recordedCurves().shift(file_);
  QWidget* canvas = Plot().canvas();
  const QPoint middle = canvas->rect().center();
  QTest::mousePress(canvas, Qt::LeftButton, Qt::ControlModifier, middle);
  QTest::mouseMove(canvas, middle + QPoint(30, 0));
  QTest::mouseMove(canvas, middle + QPoint(60, 0));
  QTest::mouseRelease(canvas, Qt::LeftButton, Qt::ControlModifier, middle + QPoint(60, 0));
  EXPECT_NEAR(static_cast<double>(Plot().recordedCurves().shift(file_) - shift),
              30.0 * kSecond * 60 / canvas->width(), 0.3 * kSecond);

  QTest::keyClick(canvas, Qt::Key_Left, Qt::AltModifier);
  EXPECT_EQ(Plot().recordedCurves().shift(file_), shift);

  QTest::keyClick(canvas, Qt::Key_T);
  auto* field = window_.findChild<QLineEdit*>("curveEditor.shift");
  ASSERT_NE(field, nullptr);
  QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClicks(field, "-7392.5");
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_EQ(Plot().recordedCurves().shift(file_), -73925 * (kSecond / 10));
  EXPECT_TRUE(Eventually([this] {
    Plot().refresh();
    return Row()->entry().name.contains(QString("−2 h 03 min 12.5 s"));
  })) << Row()->entry().name.toStdString();

  QTest::keyClick(Row(), Qt::Key_Delete);
  EXPECT_EQ(Recorded(), nullptr);
  EXPECT_NE(Plot().curve(kShownWave), nullptr);
}

TEST_F(RecordingOverlayTest, AFileThatCannotBeOpenedIsRefusedInTheDialog) {
  QFile file(file_);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("this is a text, not a recording");
  file.close();

  ChooseFile();

  auto* status = Dialog()->findChild<QLabel*>("recordedSignals.status");
  ASSERT_TRUE(Eventually([&] { return status->text().contains("MCAP"); }))
      << status->text().toStdString();
  EXPECT_FALSE(Dialog()->findChild<QPushButton*>("recordedSignals.add")->isEnabled());
}

TEST_F(RecordingOverlayTest, TheFilterFindsASignal) {
  WriteRun(file_);
  ChooseFile();
  ASSERT_TRUE(Eventually([this] { return Dialog()->count() > 0; }));
  EXPECT_EQ(Dialog()->count(), 3);

  QTest::keyClicks(Dialog()->findChild<QLineEdit*>("recordedSignals.filter"), "temperature");

  auto* list = Dialog()->findChild<QAbstractItemView*>("recordedSignals");
  EXPECT_EQ(list->model()->rowCount(), 1);
}

TEST_F(RecordingOverlayTest, LooksAsInThePictures) {
  WriteRun(file_);
  window_.resize(1440, 900);
  AddTheSameSignal();
  Feed();
  Plot().recordedCurves().setShift(file_, Plot().recordedCurves().shift(file_) + 5 * kSecond);
  KeepPictures(window_, "recording-overlay");
  QTest::keyClick(Plot().canvas(), Qt::Key_T);
  auto* editor = window_.findChild<QFrame*>("curveEditor");
  ASSERT_NE(editor, nullptr);
  KeepPictures(*editor, "recording-overlay-shift");
  QTest::keyClick(editor, Qt::Key_Escape);
  ChooseFile();
  ASSERT_TRUE(Eventually([this] { return Dialog()->count() > 0; }));
  KeepPictures(*Dialog(), "recording-overlay-dialog");
}

}  // namespace
}  // namespace tendon::gui
