#include <gcm_gui/plot/controls/legend.h>
#include <gcm_gui/plot/plot_layout.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/plot/series/csv_table.h>
#include <gcm_gui/plot/series/shown_time.h>
#include <gcm_gui/plot/series/time_shift.h>
#include <gmock/gmock.h>

#include <QApplication>
#include <QBuffer>
#include <QDropEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "samples.h"

namespace tendon::gui {
namespace {

const QString kLiveX = "robot/arm/state.Joints.position[0]";
const QString kLiveY = "robot/arm/state.Joints.position[1]";
const QString kRunFile = "/runs/run.mcap";
const QString kRecordedX = RecordedPath(kRunFile, kLiveX);
const QString kRecordedY = RecordedPath(kRunFile, kLiveY);

/// A plot with 30 s of a live signal, and 10 s of the same one from a recording, 5 s later.
class RecordedCurvesTest : public testing::Test {
 protected:
  void SetUp() override {
    panel_.resize(800, 320);
    panel_.show();
    panel_.addSignal(kLiveX, "rad");
    panel_.append(kLiveX, Rows(0, 30'000));
    view().recordedCurves().setShift(kRunFile, 5 * kSecond);
    panel_.addSignal(kRecordedX, "rad");
    panel_.append(kRecordedX, Rows(0, 10'000, [](double) { return 4.0; }));
    view().refresh();
  }
  void TearDown() override { ShowPresent(); }

  [[nodiscard]] PlotView& view() const { return panel_.currentPlot(); }
  [[nodiscard]] Curve& curve(const QString& path) const { return *view().curve(path); }
  [[nodiscard]] static std::int64_t First(const Curve& curve) {
    return curve.samples().time(curve.samples().firstIndex());
  }
  [[nodiscard]] LegendRow& row(const QString& path) const {
    return *view().findChild<LegendRow*>("legend:" + path);
  }
  [[nodiscard]] int middle() const { return view().canvas()->width() / 2; }
  void drag(int from, int to, Qt::KeyboardModifiers modifiers) const {
    QWidget* canvas = view().canvas();
    const int y = canvas->height() / 2;
    QTest::mousePress(canvas, Qt::LeftButton, modifiers, {from, y});
    QTest::mouseMove(canvas, {(from + to) / 2, y});
    QTest::mouseMove(canvas, {to, y});
    QTest::mouseRelease(canvas, Qt::LeftButton, modifiers, {to, y});
  }
  void dropOnPlot(const QMimeData& data) const {
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QDropEvent drop({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&view(), &enter);
    QApplication::sendEvent(&view(), &drop);
  }

  PlotPanel panel_;
};

TEST_F(RecordedCurvesTest, TheShiftMovesOnlyTheRecordedCurve) {
  EXPECT_EQ(First(curve(kLiveX)), 0);
  EXPECT_EQ(First(curve(kRecordedX)), 5 * kSecond);

  view().recordedCurves().setShift(kRunFile, -2 * kSecond);

  EXPECT_EQ(First(curve(kLiveX)), 0);
  EXPECT_EQ(First(curve(kRecordedX)), -2 * kSecond);
}

TEST_F(RecordedCurvesTest, SamplesThatComeLaterAreShifted) {
  view().recordedCurves().setShift(kRunFile, 7 * kSecond);
  panel_.append(kRecordedX, Rows(10'000, 10'001));

  const SampleRing& samples = curve(kRecordedX).samples();
  EXPECT_EQ(samples.time(samples.endIndex() - 1), 17 * kSecond);
}

TEST_F(RecordedCurvesTest, APausedPlotDrawsRecordedSamplesWhenTheyCome) {
  panel_.setPaused(true);
  const QImage before = Painted(view());

  panel_.append(kRecordedX, Rows(10'000, 12'000, [](double) { return 25.0; }));

  EXPECT_NE(Painted(view()), before);
}

TEST_F(RecordedCurvesTest, APlotWithoutLiveCurvesGoesOnWithItsTime) {
  Q_EMIT view().curveRemovalRequested(kLiveX);
  const std::int64_t before = view().now();
  Painted(view());

  EXPECT_GE(view().now(), before);
  EXPECT_LT(view().now(), before + 60 * kSecond);
}

TEST_F(RecordedCurvesTest, AHugeShiftStaysWithinItsLimitAndCanBeTakenBack) {
  view().recordedCurves().setShift(kRunFile, std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(view().recordedCurves().shift(kRunFile), kLongestShift);
  Painted(view());
  view().recordedCurves().setShift(kRunFile, std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(view().recordedCurves().shift(kRunFile), -kLongestShift);
  Painted(view());

  view().recordedCurves().setShift(kRunFile, 0);

  EXPECT_EQ(First(curve(kRecordedX)), 0);
}

TEST_F(RecordedCurvesTest, AShiftIsAStepOfTheHistory) {
  view().recordedCurves().setShift(kRunFile, 9 * kSecond);

  view().gestures().goBack();
  EXPECT_EQ(First(curve(kRecordedX)), 5 * kSecond);
  EXPECT_FALSE(view().gestures().hasFormerView());

  view().gestures().goForward();
  EXPECT_EQ(First(curve(kRecordedX)), 9 * kSecond);
}

TEST_F(RecordedCurvesTest, TheArrowsWithCtrlShiftInOneStep) {
  const TimeWindow before = view().timeWindow();
  for (int i = 0; i < 5; ++i) {
    QTest::keyClick(view().canvas(), Qt::Key_Right, Qt::ControlModifier);
  }

  EXPECT_GT(view().recordedCurves().shift(kRunFile), 5 * kSecond);
  EXPECT_TRUE(view().isLive());
  EXPECT_EQ(view().timeWindow().length(), before.length());

  QTest::keyClick(view().canvas(), Qt::Key_Left, Qt::AltModifier);
  EXPECT_EQ(view().recordedCurves().shift(kRunFile), 5 * kSecond);
}

TEST_F(RecordedCurvesTest, ADragWithCtrlShiftsTheRecordingByTheTimeUnderTheMouse) {
  const double width = view().canvas()->width();
  drag(middle(), middle() + 100, Qt::ControlModifier);

  const double moved =
      static_cast<double>(view().recordedCurves().shift(kRunFile) - 5 * kSecond) / kSecond;
  EXPECT_NEAR(moved, 30 * 100 / width, 0.2);
  EXPECT_EQ(First(curve(kLiveX)), 0);
  EXPECT_TRUE(view().isLive());
  view().gestures().goBack();
  EXPECT_EQ(view().recordedCurves().shift(kRunFile), 5 * kSecond);
}

TEST_F(RecordedCurvesTest, ADragWithCtrlZoomsIfThereIsNoRecording) {
  Q_EMIT view().curveRemovalRequested(kRecordedX);
  QWidget* canvas = view().canvas();
  QTest::mousePress(canvas, Qt::LeftButton, Qt::ControlModifier, {100, 40});
  QTest::mouseMove(canvas, {200, 120});
  QTest::mouseRelease(canvas, Qt::LeftButton, Qt::ControlModifier, {200, 120});

  EXPECT_FALSE(view().isLive());
}

TEST_F(RecordedCurvesTest, AllCurvesOfARecordingMoveTogether) {
  const QString other = RecordedPath("/runs/other.mcap", kLiveX);
  panel_.addSignal(kRecordedY, "rad");
  panel_.append(kRecordedY, Rows(0, 10));
  panel_.addSignal(other, "rad");
  panel_.append(other, Rows(0, 10));
  EXPECT_EQ(First(curve(kRecordedY)), 5 * kSecond);

  view().recordedCurves().setShift(kRunFile, kSecond);

  EXPECT_EQ(First(curve(kRecordedX)), kSecond);
  EXPECT_EQ(First(curve(kRecordedY)), kSecond);
  EXPECT_EQ(First(curve(other)), 0);
}

TEST_F(RecordedCurvesTest, APlotBelowHasTheSameShiftAndAnotherPageItsOwn) {
  PlotView& below = panel_.splitPlot();
  panel_.addSignal(kRecordedY, "rad");
  panel_.append(kRecordedY, Rows(0, 10));
  PlotView& page = panel_.addPlot();
  panel_.addSignal(kRecordedY, "rad");
  panel_.append(kRecordedY, Rows(0, 10));

  below.recordedCurves().setShift(kRunFile, kSecond);
  panel_.plot(0).refresh();

  EXPECT_EQ(First(*panel_.plot(0).curve(kRecordedX)), kSecond);
  EXPECT_EQ(First(*below.curve(kRecordedY)), kSecond);
  EXPECT_EQ(First(*page.curve(kRecordedY)), 0);
}

TEST_F(RecordedCurvesTest, ARemovedCurveIsReleasedAndTheOthersStay) {
  QSignalSpy released(&panel_, &PlotPanel::subscriptionReleased);

  QTest::keyClick(&row(kRecordedX), Qt::Key_Delete);

  ASSERT_EQ(released.count(), 1);
  EXPECT_EQ(released[0][0], kRecordedX);
  EXPECT_FALSE(view().recordedCurves().isOnPage(kRunFile));
  EXPECT_NE(view().curve(kLiveX), nullptr);
}

TEST_F(RecordedCurvesTest, OnlySignalsOfTheSystemCountAsPlotted) {
  EXPECT_EQ(panel_.paths(), QStringList{kLiveX});
  EXPECT_EQ(view().curves().newestTime(), 29'999 * kMillisecond);
  ASSERT_EQ(view().curves().figures(view().now()).size(), 1U);
  EXPECT_EQ(view().curves().figures(view().now()).front().source, "robot/arm/state");
}

TEST_F(RecordedCurvesTest, AJumpInTheRecordingKeepsTheLiveSamples) {
  panel_.removeSamples(kRunFile);

  EXPECT_TRUE(curve(kRecordedX).samples().empty());
  EXPECT_FALSE(curve(kLiveX).samples().empty());
  EXPECT_EQ(curve(kRecordedX).staleReason(), "nothing recorded at this time");
}

TEST_F(RecordedCurvesTest, AJumpOfTheShownSystemKeepsTheRecordedSamples) {
  panel_.removeSamples();

  EXPECT_TRUE(curve(kLiveX).samples().empty());
  EXPECT_FALSE(curve(kRecordedX).samples().empty());
}

TEST_F(RecordedCurvesTest, CursorsReadTheShiftedValue) {
  panel_.append(kRecordedX, Rows(10'000, 11'000, [](double t) { return t; }));

  EXPECT_EQ(curve(kRecordedX).numberAt(15'500 * kMillisecond)->nearest(), 10.5);
  EXPECT_EQ(curve(kRecordedX).numberAt(4 * kSecond), std::nullopt);
}

TEST_F(RecordedCurvesTest, ThereIsNoValueAfterTheEndOfTheRecording) {
  panel_.setRecordedTime(kRunFile, {.from_ns = 0, .to_ns = 10 * kSecond});

  EXPECT_TRUE(curve(kRecordedX).numberAt(15 * kSecond));
  EXPECT_FALSE(curve(kRecordedX).numberAt(15 * kSecond + 1));
  EXPECT_TRUE(QTest::qWaitFor([this] { return row(kRecordedX).entry().value.isEmpty(); }, 120'000));
  EXPECT_NE(row(kLiveX).entry().value, "");
}

TEST_F(RecordedCurvesTest, TheOldestPartIsShiftedAlthoughItsSamplesAreGone) {
  Curve thinned({kRecordedX, "rad"}, 0);
  thinned.setBudget(8 * 1024 * SampleRing::kBytesPerSample);
  thinned.append(Rows(0, 20'000, [](double t) { return t < 1 ? 7.0 : 0.0; }));
  ASSERT_TRUE(thinned.isThinned());

  thinned.setShift(100 * kSecond + 1);

  const TimeSlices there{.from_ns = 100 * kSecond, .to_ns = 101 * kSecond, .count = 10};
  EXPECT_EQ(thinned.envelope(there).highest(), 7);
  const TimeSlices before{.from_ns = 0, .to_ns = kSecond, .count = 10};
  EXPECT_GT(thinned.envelope(before).lowest(), thinned.envelope(before).highest());
}

TEST_F(RecordedCurvesTest, HasTheColourOfItsLiveCurveUnlessAnotherRecordingHasIt) {
  const QString other = RecordedPath("/runs/other.mcap", kLiveX);
  panel_.addSignal(other, "rad");

  EXPECT_EQ(curve(kRecordedX).colorIndex(), curve(kLiveX).colorIndex());
  EXPECT_NE(curve(other).colorIndex(), curve(kLiveX).colorIndex());
}

TEST_F(RecordedCurvesTest, AnotherUnitHasAnAxisOfItsOwn) {
  panel_.addSignal(kRecordedY, "deg");

  EXPECT_EQ(curve(kRecordedX).axis(), curve(kLiveX).axis());
  EXPECT_EQ(view().curves().axisOf(curve(kRecordedY)).unit, "deg");
  EXPECT_EQ(view().curves().axes().size(), 2U);
}

TEST_F(RecordedCurvesTest, TheLegendNamesTheFileAndTheShift) {
  const LegendEntry& entry = row(kRecordedX).entry();

  EXPECT_EQ(entry.recording, "run.mcap");
  EXPECT_EQ(entry.name, QString("arm.Joints.position[0] · +5 s"));
  EXPECT_EQ(row(kRecordedX).toolTip(), QString("run.mcap · ") + kLiveX);
  EXPECT_EQ(row(kLiveX).entry().recording, "");
}

TEST_F(RecordedCurvesTest, ARecordedCurveIsNotMappedToAnotherSignal) {
  QSignalSpy remap(&view(), &PlotView::remapRequested);

  QTest::keyClick(&row(kRecordedX), Qt::Key_R);

  EXPECT_EQ(remap.count(), 0);
}

TEST_F(RecordedCurvesTest, TheEditorSetsAnExactShiftAndRefusesWhatIsNone) {
  QTest::keyClick(view().canvas(), Qt::Key_T);
  auto* field = panel_.findChild<QLineEdit*>("curveEditor.shift");
  ASSERT_NE(field, nullptr);
  EXPECT_EQ(field->text(), "+5 s");
  auto* accept = panel_.findChild<QPushButton*>("curveEditor.accept");
  field->setText("NaN");
  EXPECT_FALSE(accept->isEnabled());
  field->setText("-0.250000001");
  ASSERT_TRUE(accept->isEnabled());

  QTest::keyClick(field, Qt::Key_Return);

  EXPECT_EQ(view().recordedCurves().shift(kRunFile), -250'000'001);
}

TEST_F(RecordedCurvesTest, TheEditorOfALiveCurveHasNoShift) {
  QTest::keyClick(&row(kLiveX), Qt::Key_Return);

  EXPECT_NE(panel_.findChild<QLineEdit*>("curveEditor.factor"), nullptr);
  EXPECT_EQ(panel_.findChild<QLineEdit*>("curveEditor.shift"), nullptr);
}

TEST_F(RecordedCurvesTest, CsvHasTheTimeOfThePlotAndNamesTheShift) {
  view().recordedCurves().setShift(kRunFile, -2 * kSecond - kSecond / 2);
  QBuffer buffer;
  ASSERT_TRUE(buffer.open(QIODevice::WriteOnly));

  ASSERT_TRUE(WriteCsv(CsvTableOf(view().curves(), -2 * kSecond, -2 * kSecond, 0), buffer));

  const QList<QByteArray> lines = buffer.data().split('\n');
  EXPECT_EQ(QString::fromUtf8(lines[0]),
            QString("time_s,utc_estimated,robot/arm/state.Joints.position[0] [rad],"
                    "run.mcap · robot/arm/state.Joints.position[0] [rad] (recorded; utc_estimated "
                    "= recorded utc -2.500000000 s),robot/arm/state rows lost before,"
                    "run.mcap · robot/arm/state rows lost before"));
  EXPECT_EQ(QString(lines[1]), "-2.000000000,1969-12-31T23:59:58.000000Z,,4,,");
}

TEST_F(RecordedCurvesTest, ALayoutKeepsTheRecordingAndItsShift) {
  view().recordedCurves().setShift(kRunFile, -kLongestShift + 1);
  const QByteArray layout = LayoutOf(panel_);

  PlotPanel other;
  ASSERT_EQ(ShowLayout(other, layout), std::nullopt);

  const Curve* shown = other.currentPlot().curve(kRecordedX);
  ASSERT_NE(shown, nullptr);
  EXPECT_EQ(shown->shift(), -kLongestShift + 1);
  EXPECT_EQ(shown->unit(), "rad");
  EXPECT_EQ(other.paths(), QStringList{kLiveX});
  EXPECT_FALSE(other.currentPlot().gestures().hasFormerView());
}

TEST_F(RecordedCurvesTest, ALayoutWithoutAWholeShiftIsRefused) {
  for (const char* shift : {"\"2 h\"", "1.5", "1e300", "3155760000000000001"}) {
    const QByteArray layout = QByteArray(R"({"version": 1, "plots": [{"window": 30, "curves": [
        {"path": "a/b/state.C", "recording": "/runs/run.mcap", "shift_ns": )") +
                              shift + "}]}]}";
    const auto refusal = ShowLayout(panel_, layout);
    ASSERT_TRUE(refusal) << shift;
    EXPECT_THAT(refusal->toStdString(), testing::HasSubstr("a/b/state.C"));
  }
  EXPECT_NE(view().curve(kLiveX), nullptr);
}

TEST_F(RecordedCurvesTest, ADragFromTheWindowOfARecordingPutsItsMomentAtTheRightEdge) {
  const std::int64_t moment = 1'700'000'000 * kSecond;
  QMimeData data;
  ShowMoment({.steady_ns = 1000 * kSecond, .wall_ns = moment, .recording = "/runs/third.mcap"});
  SetPaths(data, {{kLiveX, "rad"}});
  ShowPresent();

  dropOnPlot(data);

  const QString recorded = RecordedPath("/runs/third.mcap", kLiveX);
  ASSERT_NE(view().curve(recorded), nullptr);
  const std::int64_t there =
      MovedTime(moment - WallOffset(), view().recordedCurves().shift("/runs/third.mcap"));
  EXPECT_NEAR(static_cast<double>(there), static_cast<double>(view().timeWindow().lastTime()),
              2 * kSecond);
}

TEST_F(RecordedCurvesTest, ADragWithinTheWindowOfARecordingIsOneOfItsOwnSignals) {
  QMimeData data;
  ShowMoment({.steady_ns = kSecond, .wall_ns = kSecond, .recording = kRunFile});
  SetPaths(data, {{kLiveY, "rad"}});

  dropOnPlot(data);

  EXPECT_NE(view().curve(kLiveY), nullptr);
  EXPECT_EQ(view().curve(kRecordedY), nullptr);
}

TEST_F(RecordedCurvesTest, TheMenuOffersAnotherCurveAndTheShiftOfEachRecording) {
  QSignalSpy wanted(&panel_, &PlotPanel::recordingRequested);
  panel_.setRecordedTime(kRunFile, {.from_ns = 0, .to_ns = 10 * kSecond});
  Q_EMIT view().menuRequested({10, 10});
  auto* menu = panel_.findChild<QMenu*>("plotMenu");
  ASSERT_NE(menu, nullptr);
  const auto trigger = [](const QMenu& in, const QString& text) {
    for (QAction* action : in.actions()) {
      if (action->text() == text) action->trigger();
    }
  };

  trigger(*menu, QString("Add a curve of a recording…"));
  EXPECT_EQ(wanted.count(), 1);

  for (QAction* action : menu->actions()) {
    if (action->text() == "run.mcap") trigger(*action->menu(), "Begin at the left edge");
  }
  EXPECT_NEAR(static_cast<double>(First(curve(kRecordedX))),
              static_cast<double>(view().timeWindow().firstTime()), 2 * kSecond);
}

}  // namespace
}  // namespace tendon::gui
