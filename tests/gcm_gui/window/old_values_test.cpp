#include <gcm_gui/inspector/inspector.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/plot/controls/legend.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <QTreeView>
#include <chrono>

#include "support/fakes.h"
#include "window/window_fixture.h"

namespace tendon::gui {
namespace {

constexpr auto kJoints = "robot/arm/state.Joints";
// Low enough that the values are fresh on any machine.
constexpr std::chrono::milliseconds kFresh{-60'000};
constexpr auto kVelocity = "robot/arm/state.Joints.velocity[0]";

/// The arm is suspended during a motion.
class OldValues : public WindowFixture {
 protected:
  OldValues() {
    window_.selection().select("robot/arm");
    window_.plots().addSignal(kVelocity, "rad/s");
  }

  static std::int64_t SteadyNow() {
    return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  /// Sends a row of this age.
  void SendRow(std::chrono::milliseconds age) {
    const std::int64_t time = SteadyNow() - std::chrono::nanoseconds(age).count();
    const auto shape =
        std::make_shared<const std::vector<NumericField>>(NumericFields(test::JointStateSchema(1)));
    Q_EMIT source_.valuesArrived(kJoints, {.fields = shape,
                                           .values = ExactValues({0.5, 0.116}),
                                           .text = {},
                                           .rows = ++rows_,
                                           .time = time});
    const Sample sample{.time_ns = time, .tick = rows_, .value = 0.116};
    Q_EMIT source_.samplesArrived(kVelocity, std::span(&sample, 1));
  }
  void Let(ComponentState state) {
    ComponentDescription arm = *system_.catalogue().FindComponent("robot", "arm");
    arm.state = state;
    system_.Component("robot", arm);
    Show();
  }
  [[nodiscard]] QString DetailOf(const char* path) {
    return window_.catalogueModel().indexOf(path).data(kDetailRole).toString();
  }
  [[nodiscard]] LegendEntry LegendOf(int row) {
    return window_.plots()
        .currentPlot()
        .legendBox()
        .rows()
        .at(static_cast<std::size_t>(row))
        ->entry();
  }

  std::uint64_t rows_ = 0;
};

TEST_F(OldValues, AreMarkedInEveryViewDuringASuspension) {
  using namespace std::chrono_literals;
  SendRow(4000ms);
  Let(ComponentState::kSuspended);

  const QModelIndex in_catalogue = window_.catalogueModel().indexOf(kVelocity);
  EXPECT_TRUE(in_catalogue.data(kStaleRole).toBool());
  EXPECT_TRUE(DetailOf(kJoints).startsWith("suspended · ")) << DetailOf(kJoints).toStdString();
  EXPECT_TRUE(DetailOf(kJoints).endsWith(" s old")) << DetailOf(kJoints).toStdString();
  const auto* values = window_.findChild<QTreeView*>("inspector.values");
  EXPECT_TRUE(values->model()->index(0, 0).data(kStaleRole).toBool());
  EXPECT_TRUE(values->model()->index(0, 0).data(kDetailRole).toString().startsWith("suspended · "));
  ASSERT_TRUE(QTest::qWaitFor([&] { return LegendOf(0).old; }, kTestTimeout));
  EXPECT_TRUE(LegendOf(0).name.contains("suspended · ")) << LegendOf(0).name.toStdString();
  EXPECT_FALSE(LegendOf(0).value.isEmpty()) << "the last value stands, as old";
}

TEST_F(OldValues, AreLiveAgainOnceTheComponentRuns) {
  using namespace std::chrono_literals;
  SendRow(4000ms);
  Let(ComponentState::kSuspended);
  ASSERT_TRUE(QTest::qWaitFor([&] { return LegendOf(0).old; }, kTestTimeout));

  Let(ComponentState::kActive);
  SendRow(0ms);

  EXPECT_FALSE(window_.catalogueModel().indexOf(kVelocity).data(kStaleRole).toBool());
  EXPECT_TRUE(QTest::qWaitFor([&] { return !LegendOf(0).old; }, kTestTimeout));
  const Curve& curve = *window_.plots().currentPlot().curve(kVelocity);
  ASSERT_EQ(curve.samples().gaps().size(), 1u);
  EXPECT_EQ(curve.samples().gaps()[0].cause, Gap::Cause::kStandstill);
}

TEST_F(OldValues, ASuspectProcessHasOldValuesOnlyWithoutNewRows) {
  using namespace std::chrono_literals;
  SendRow(kFresh);
  system_.Process("robot", ProcessState::kSuspect);
  Show();
  SendRow(kFresh);
  EXPECT_FALSE(window_.catalogueModel().indexOf(kVelocity).data(kStaleRole).toBool());

  SendRow(3000ms);

  EXPECT_TRUE(window_.catalogueModel().indexOf(kVelocity).data(kStaleRole).toBool());
  EXPECT_TRUE(DetailOf(kJoints).startsWith("no reply · ")) << DetailOf(kJoints).toStdString();
}

}  // namespace
}  // namespace tendon::gui
