#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gmock/gmock.h>

#include <QTest>
#include <algorithm>

#include "live/live_window.h"

namespace tendon::gui {
namespace {

const QString kPosition = "robot/arm/state.Joints.position";

/// Flow (c): plot signals, with mouse and keys, while a real arm moves.
class PlotFlowTest : public LiveWindow {
 protected:
  void SetUp() override {
    StartGcm();
    robot_ = StartLcm("robot", demo);
    ASSERT_NO_FATAL_FAILURE(Open("robot/arm/state.Joints"));
  }

  PlotPanel& plots() { return *window().findChild<PlotPanel*>("plotPanel"); }
  PlotView& plot() { return plots().currentPlot(); }
  [[nodiscard]] bool IsMarked(const QString& text) {
    const auto& all = plots().marks().all();
    return std::any_of(all.begin(), all.end(),
                       [&](const Mark& mark) { return mark.text.contains(text); });
  }

  std::unique_ptr<Program> robot_;
};

TEST_F(PlotFlowTest, ThreeSignalsAreSelectedAndPlottedLiveWithMarksAndCursors) {
  for (int i = 0; i < 3; ++i) {
    Click(QString("%1[%2]").arg(kPosition).arg(i));
    QTest::keyClick(&window(), Qt::Key_P);
  }
  ASSERT_EQ(plots().paths().size(), 3);
  for (const auto& curve : plot().curves().curves()) {
    QTRY_VERIFY_WITH_TIMEOUT(curve->samples().endIndex() > 1000, kLivePatience);
    EXPECT_FALSE(curve->isStale());
  }
  EXPECT_EQ(plot().curves().axes().size(), 1U);  // one unit

  // Someone else steers the system; it is marked all the same.
  ASSERT_EQ(Gcm({"suspend", "robot/arm"}).exit_code, 0);
  QTRY_VERIFY_WITH_TIMEOUT(IsMarked("robot/arm is suspended"), kLivePatience);
  ASSERT_EQ(Gcm({"start", "robot/arm"}).exit_code, 0);
  QTRY_VERIFY_WITH_TIMEOUT(IsMarked("robot/arm is active"), kLivePatience);

  // Zoom and cursors while data streams: only the view pauses.
  QWidget* canvas = plot().canvas();
  canvas->setFocus();
  QTest::keyClick(canvas, Qt::Key_A);
  QTest::keyClick(canvas, Qt::Key_B);
  EXPECT_TRUE(plot().cursors().both());
  const QPoint centre = canvas->rect().center();
  QTest::mousePress(canvas, Qt::LeftButton, {}, centre - QPoint(80, 30));
  QTest::mouseMove(canvas, centre + QPoint(80, 30));
  QTest::mouseRelease(canvas, Qt::LeftButton, {}, centre + QPoint(80, 30));
  EXPECT_FALSE(plot().isLive());
  const std::uint64_t before = plot().curves().curves().front()->samples().endIndex();
  QTRY_VERIFY_WITH_TIMEOUT(plot().curves().curves().front()->samples().endIndex() > before + 100,
                           kLivePatience);
  QTest::mouseDClick(canvas, Qt::LeftButton, {}, centre);
  EXPECT_TRUE(plot().isLive());
  KeepPictures("flow-plot");
}

TEST_F(PlotFlowTest, WhatIsNotThereIsWaitedForAndHealsWithAGap) {
  Click(kPosition + "[0]");
  QTest::keyClick(&window(), Qt::Key_P);
  Curve& curve = *plot().curve(kPosition + "[0]");
  QTRY_VERIFY_WITH_TIMEOUT(curve.samples().endIndex() > 100, kLivePatience);

  robot_.reset();
  QTRY_VERIFY_WITH_TIMEOUT(curve.isStale(), kLivePatience);
  EXPECT_TRUE(IsMarked("robot lost") ||
              QTest::qWaitFor([&] { return IsMarked("robot lost"); }, kLivePatience));
  KeepPictures("flow-plot-lost");
  const std::uint64_t before = curve.samples().endIndex();
  robot_ = StartLcm("robot", demo);
  QTRY_VERIFY_WITH_TIMEOUT(curve.samples().endIndex() > before, kLivePatience);
  EXPECT_FALSE(curve.isStale());
  EXPECT_EQ(curve.samples().gaps().back().cause, Gap::Cause::kRestart);
}

}  // namespace
}  // namespace tendon::gui
