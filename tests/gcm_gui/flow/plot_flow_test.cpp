#include <gcm_gui/plot/controls/rate_badge.h>
#include <gcm_gui/plot/plot_files.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gtest/gtest.h>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "flow/flow_fixture.h"
#include "support/machine/sanitized.h"
#include "support/machine/stall_meter.h"
#include "support/pictures.h"

namespace tendon::gui {
namespace {

constexpr int kOneCall = 2000;  // ms until the call is repeated
constexpr int kArms = 5;
constexpr int kSignalsOfAnArm = 20;  // 14 of the joints and 6 of the goal
const QString kJoint = QStringLiteral("robot/arm/state.Joints.position[0]");

/// Returns the number of rows to wait for. With TENDON_FULL_FAULTS, these are the rows of 60 s;
/// TENDON_PLOT_SECONDS sets another number of seconds. A sanitizer makes the test about thirty
/// times slower.
std::uint64_t Rows() {
  constexpr std::uint64_t kRate = 1000;  // Hz
  if (const char* seconds = std::getenv("TENDON_PLOT_SECONDS")) return std::stoull(seconds) * kRate;
  if (std::getenv("TENDON_FULL_FAULTS") != nullptr) return 60 * kRate;
  return test::IsSanitized() ? kRate / 5 : 2 * kRate;
}

/// Returns a system file for a process with several arms, each with a table of 1 kHz.
QByteArray SystemOfArms() {
  QJsonArray components;
  for (int i = 0; i < kArms; ++i) {
    components.append(QJsonObject{{"name", QString("arm%1").arg(i)},
                                  {"class", "SimulatedArm"},
                                  {"library", "simulated_arm"}});
  }
  const QJsonObject process{{"name", "load"}, {"components", components}};
  return QJsonDocument(
             QJsonObject{{"version", 1}, {"name", "arms"}, {"processes", QJsonArray{process}}})
      .toJson();
}

/// Returns a layout with a plot for each arm; two of the plots are below another one.
QByteArray LayoutOfArms() {
  QJsonArray plots;
  for (int arm = 0; arm < kArms; ++arm) {
    QJsonArray curves;
    for (int i = 0; i < kSignalsOfAnArm; ++i) {
      const char* column = i < 7 ? "Joints.position" : i < 14 ? "Joints.velocity" : "Goal.position";
      const QString path =
          QString("load/arm%1/state.%2[%3]").arg(arm).arg(column).arg(i < 14 ? i % 7 : i - 14);
      curves.append(QJsonObject{{"path", path}, {"unit", i < 7 || i >= 14 ? "rad" : "rad/s"}});
    }
    plots.append(QJsonObject{{"window", 10}, {"below", arm % 2 == 1}, {"curves", curves}});
  }
  return QJsonDocument(QJsonObject{{"version", 1}, {"plots", plots}}).toJson();
}

class PlotFlow : public FlowFixture {
 protected:
  [[nodiscard]] QString Write(const char* name, const QByteArray& content) const {
    QFile file(QString::fromStdString((home_.path() / name).string()));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly) && file.write(content) == content.size());
    return file.fileName();
  }
  [[nodiscard]] std::vector<const Curve*> Curves() const {
    std::vector<const Curve*> curves;
    for (int i = 0; i < window_->plots().plotCount(); ++i) {
      for (const auto& curve : window_->plots().plot(i).curves().curves()) {
        curves.push_back(curve.get());
      }
    }
    return curves;
  }
  [[nodiscard]] bool IsMarked(const QString& label, const QString& text = {}) const {
    for (const Mark& mark : window_->plots().marks().all()) {
      if (mark.label == label && mark.text.contains(text)) return true;
    }
    return false;
  }
};

// Counts rows, and measures no times: on a slow machine the test takes longer, but every row must
// arrive. Rows may be lost in two cases: the machine stalls for longer than a table keeps its rows,
// or the window is 1.5 s late (as with a sanitizer) and renews its link. Even then every loss must
// be reported.
TEST_F(PlotFlow, AHundredSignalsAtOneKilohertzLoseNoRow) {
  const test::StallMeter stalls;
  const auto may_lose = [&] { return test::IsSanitized() || stalls.has_stood_still(); };
  const QString system = Write("arms.json", SystemOfArms());
  const auto load = StartLcm("load", system.toStdString());
  window_->plots().files().openLayout(Write("arms.plots.json", LayoutOfArms()));
  ASSERT_TRUE(Eventually([this] { return Curves().size() == 100; }));
  const std::vector<const Curve*> curves = Curves();
  const std::uint64_t rows = Rows();

  const auto have_come = [&] {
    return std::all_of(curves.begin(), curves.end(),
                       [&](const Curve* curve) { return curve->samples().endIndex() >= rows; });
  };
  const int timeout = kFlowTimeout + static_cast<int>(rows) * 4;
  ASSERT_TRUE(QTest::qWaitFor(have_come, timeout)) << load->err();

  for (const Curve* curve : curves) {
    const SampleRing& samples = curve->samples();
    EXPECT_EQ(samples.repeated(), 0U) << curve->path().toStdString();
    const std::uint64_t ticks =
        samples.tick(samples.endIndex() - 1) - samples.tick(samples.firstIndex());
    const std::uint64_t missing = ticks - (samples.endIndex() - 1 - samples.firstIndex());
    EXPECT_LE(missing, samples.lost()) << curve->path().toStdString();
    if (may_lose()) continue;
    EXPECT_EQ(samples.lost(), 0U) << curve->path().toStdString() << "; "
                                  << Find<RateBadge>("rateBadge").toolTip().toStdString();
    EXPECT_TRUE(samples.gaps().empty()) << curve->path().toStdString();
  }
  EXPECT_TRUE(Eventually([&] {
    const auto& shown = window_->plots().currentPlot().curves().curves();
    const bool is_whole = std::all_of(
        shown.begin(), shown.end(), [](const auto& curve) { return curve->samples().lost() == 0; });
    const QString badge = Find<RateBadge>("rateBadge").text();
    return badge.contains(" lost") && badge.contains("· 0 lost") == is_whole;
  }));
  KeepPictures(*window_, "flow-hundred-signals");
}

TEST_F(PlotFlow, MarksEventsAndCommandsOfOtherPrograms) {
  window_->plots().addSignal(kJoint, QStringLiteral("rad"));
  window_->plots().setWindow(std::chrono::seconds(10));
  ASSERT_TRUE(Eventually([&] { return !Curves().front()->samples().empty(); }));

  // The first calls may be made before this window has subscribed to the log.
  const auto called = [&] {
    StartGcmVerb({"call", "robot/arm/Control.MoveTo",
                  R"({"position": [0.1, 0, 0, -1.5, 0, 1.5, 0], "duration": 0.05})"})
        ->Wait();
    return QTest::qWaitFor([this] { return IsMarked("MoveTo", " by ") && IsMarked("GoalReached"); },
                           kOneCall);
  };
  EXPECT_TRUE(Eventually(called));
  KeepPictures(*window_, "flow-plot-marks");

  QTest::keyClick(window_->plots().currentPlot().canvas(), Qt::Key_E);
  EXPECT_FALSE(window_->plots().areMarksShown());
}

}  // namespace
}  // namespace tendon::gui
