#include <gcm_gui/activity/activity_model.h>
#include <gcm_gui/connect/candidate_panel.h>
#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/views/catalogue_panel.h>
#include <gcm_gui/views/catalogue_tree.h>
#include <gtest/gtest.h>

#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <algorithm>

#include "flow/flow_fixture.h"
#include "support/pictures.h"

namespace tendon::gui {
namespace {

const PortName kHandNeeds{Side::kRequired, {"desk", "teleoperation", "Robot"}};
const PortName kHandOffers{Side::kProvided, {"robot", "arm", "Control"}};
const PortName kSpareOffers{Side::kProvided, {"spare", "arm", "Control"}};

QStringList Sorted(QStringList paths) {
  paths.sort();
  return paths;
}

/// The actions of a user with mouse and keys, with real processes.
class InteractionFlowTest : public FlowFixture {
 protected:
  [[nodiscard]] CatalogueTree& tree() const { return window_->catalogue().tree(); }
  bool Reveals(const QString& path) {
    return Eventually([&] {
      tree().reveal(path);
      return tree().visibleRows().contains(path);
    });
  }
  [[nodiscard]] bool IsConnectedTo(const PortName& provided) const {
    const auto* connection = session_->store().catalogue().FindConnection(kHandNeeds.name);
    return connection != nullptr && connection->provided == provided.name &&
           connection->state == ConnectionState::kActive;
  }
  [[nodiscard]] bool IsFree() const {
    return session_->store().catalogue().FindConnection(kHandNeeds.name) == nullptr;
  }
  void Drag(const PortName& from, const PortName& to) {
    const GraphView& graph = window_->graph();
    const QPoint begin = graph.pointOf(from).value();
    const QPoint end = graph.pointOf(to).value();
    QTest::mousePress(graph.viewport(), Qt::LeftButton, {}, begin);
    QTest::mouseMove(graph.viewport(), (begin + end) / 2);
    QTest::mouseMove(graph.viewport(), end);
    QTest::mouseRelease(graph.viewport(), Qt::LeftButton, {}, end);
  }
  /// Starts a second arm that is compatible.
  std::unique_ptr<Program> StartSpare() {
    const QString name = QString::fromStdString((home_.path() / "spare.json").string());
    QFile file(name);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(R"({"version": 1, "name": "spare", "processes": [{"name": "spare", "components": [
        {"name": "arm", "class": "SimulatedArm", "library": "simulated_arm"}]}]})");
    file.close();
    return StartLcm("spare", name.toStdString());
  }
  [[nodiscard]] QString Status() { return Find<QLabel>("call.status").text(); }
};

TEST_F(InteractionFlowTest, ThreeSelectedRowsArePlottedByOneKey) {
  const QStringList paths{"robot/arm/state.Joints.position[0]",
                          "robot/arm/state.Joints.position[1]",
                          "robot/arm/state.Joints.position[2]"};
  ASSERT_TRUE(Reveals("robot/arm/state.Joints"));
  for (const QString& path : paths) ASSERT_TRUE(Reveals(path)) << path.toStdString();

  Qt::KeyboardModifiers modifiers;
  for (const QString& path : paths) {
    ASSERT_TRUE(tree().visibleRows().contains(path));
    QTest::mouseClick(tree().viewport(), Qt::LeftButton, modifiers,
                      tree().visibleRows().value(path).center());
    modifiers = Qt::ControlModifier;
  }
  EXPECT_EQ(Sorted(window_->selection().paths()), paths);
  QTest::keyClick(window_->focusWidget(), Qt::Key_P);

  EXPECT_EQ(Sorted(window_->plots().paths()), paths);
  ASSERT_TRUE(Eventually([&] {
    const auto& curves = window_->plots().currentPlot().curves().curves();
    return curves.size() == 3 && std::all_of(curves.begin(), curves.end(), [](const auto& curve) {
             return curve->samples().endIndex() > 1000;
           });
  }));
  KeepPictures(*window_, "flow-plot-three");
}

TEST_F(InteractionFlowTest, ConnectsByDigitReplacesByDragAndUndoesBoth) {
  const auto spare = StartSpare();
  ASSERT_TRUE(Eventually([&] { return window_->graph().pointOf(kSpareOffers).has_value(); }))
      << spare->err();
  window_->selection().select(QStringLiteral("desk/teleoperation/Robot"));
  QTest::keyClick(window_.get(), Qt::Key_C);
  ASSERT_TRUE(window_->connectMode().active());
  const PortCandidate* arm = window_->connectMode().find(kHandOffers);
  ASSERT_TRUE(arm != nullptr && arm->fits());
  KeepPictures(*window_, "flow-connect-mode");
  const auto digit = static_cast<Qt::Key>(Qt::Key_0 + arm->number);
  QTest::keyClick(&window_->candidates().filterField(), digit);
  ASSERT_TRUE(Eventually([&] { return IsConnectedTo(kHandOffers); }));

  Drag(kHandNeeds, kSpareOffers);
  ASSERT_TRUE(Eventually([&] { return IsConnectedTo(kSpareOffers); }));
  EXPECT_EQ(session_->activity().action(0).verb, Action::Verb::kReplace);
  ASSERT_TRUE(
      Eventually([&] { return session_->activity().action(0).outcome == Action::Outcome::kDone; }));

  QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(Eventually([&] { return IsConnectedTo(kHandOffers); }));
  QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(Eventually([&] { return IsFree(); }));
}

TEST_F(InteractionFlowTest, CallsFromAFormAndShowsARefusal) {
  window_->selection().select(QStringLiteral("robot/arm/Control.MoveTo"));
  auto& button = Find<QPushButton>("call.call");
  ASSERT_TRUE(Eventually([&] { return button.isEnabled(); }));
  auto& duration = Find<QLineEdit>("form.duration");
  duration.setFocus();
  duration.selectAll();
  QTest::keyClicks(&duration, "0.25");

  QTest::mousePress(&button, Qt::LeftButton);
  ASSERT_TRUE(Eventually([&] { return Status().startsWith("Done in"); })) << Status().toStdString();
  QTest::mouseRelease(&button, Qt::LeftButton);
  EXPECT_TRUE(session_->activity().command(0).contains("\"duration\":0.25"));
  KeepPictures(*window_, "flow-call-done");

  session_->executeLifecycleOrder(LifecycleVerb::kStop, "robot", "arm");
  ASSERT_TRUE(Eventually([&] {
    const auto* arm = session_->store().catalogue().FindComponent("robot", "arm");
    return arm->state == ComponentState::kFinished;
  }));
  Click(button);
  EXPECT_TRUE(Eventually([&] {
    const Action& last = session_->activity().action(0);
    return last.verb == Action::Verb::kCall && last.outcome == Action::Outcome::kRefused;
  }));
  EXPECT_EQ(Status(), session_->activity().action(0).refusal);
  KeepPictures(*window_, "flow-call-refused");
}

}  // namespace
}  // namespace tendon::gui
