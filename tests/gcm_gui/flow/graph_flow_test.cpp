#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/graph/items/component_item.h>
#include <gcm_gui/graph/items/process_item.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>

#include <QSet>
#include <QTimer>
#include <chrono>
#include <csignal>
#include <iostream>
#include <map>
#include <memory>
#include <string>

#include "flow/flow_fixture.h"
#include "support/handler_watch.h"
#include "support/pictures.h"

namespace tendon::gui {
namespace {

const QString kArmEdge = QStringLiteral("desk/supervisor/Robot");
constexpr int kRounds = 3;

class GraphFlowTest : public FlowFixture {
 protected:
  [[nodiscard]] GraphScene& scene() const { return window_->graph().graph(); }
  [[nodiscard]] bool IsGrey(const QString& component) const {
    const ComponentItem* item = scene().component(component);
    return item != nullptr && item->isStale();
  }
  [[nodiscard]] EdgeItem::Look Look() const {
    const EdgeItem* edge = scene().edge(kArmEdge);
    return edge == nullptr ? EdgeItem::Look::kPreview : edge->look();
  }
  [[nodiscard]] bool IsWell() const {
    return scene().component("robot/arm") != nullptr && !IsGrey("robot/arm") &&
           scene().component("desk/supervisor") != nullptr && !IsGrey("desk/supervisor") &&
           Look() == EdgeItem::Look::kActive;
  }

  /// Starts to measure the handlers.
  void WatchHandlers() {
    handlers_.beginPhase();
    since_ = std::chrono::steady_clock::now();
  }
  /// After the last round, expects that no handler waited in this phase in all rounds. A wait in
  /// only some rounds is allowed: another thread may have held a lock by chance. Prints the longest
  /// processor time of a handler since WatchHandlers().
  void ExpectNoHandlerStalled(int round, const std::string& phase) {
    const auto milliseconds = [](auto duration) {
      return std::chrono::duration<double, std::milli>(duration).count();
    };
    const auto until = std::chrono::steady_clock::now() - since_;
    const HandlerWatch::Phase handlers = handlers_.phase();
    std::cout << "  " << phase << " after " << milliseconds(until)
              << " ms; the longest handler took " << milliseconds(handlers.longest) << " ms ("
              << handlers.longest_name.toStdString() << ")\n";
    QSet<QString>& waits_each_time =
        waits_each_time_.try_emplace(phase, handlers.waited).first->second;
    waits_each_time.intersect(handlers.waited);
    if (round + 1 < kRounds) return;
    EXPECT_TRUE(waits_each_time.isEmpty())
        << phase << ": " << waits_each_time.values().join('\n').toStdString();
  }

 private:
  HandlerWatch& handlers_ = *static_cast<HandlerWatch*>(qApp);
  std::chrono::steady_clock::time_point since_;
  std::map<std::string, QSet<QString>> waits_each_time_;  // by phase
};

TEST_F(GraphFlowTest, AStoppedProcessIsGreyUntilItResumes) {
  ASSERT_TRUE(Eventually([&] { return IsWell(); }));
  const QRectF place = scene().component("robot/arm")->sceneRect();

  for (int round = 0; round < kRounds; ++round) {
    WatchHandlers();
    robot_->Signal(SIGSTOP);
    ASSERT_TRUE(Eventually([&] { return IsGrey("robot/arm"); }));
    ExpectNoHandlerStalled(round, "grey");
    EXPECT_FALSE(IsGrey("desk/supervisor"));
    // The connection is pending if the desk has noticed the loss as early as the GCM.
    EXPECT_TRUE(Look() == EdgeItem::Look::kStale || Look() == EdgeItem::Look::kPending);
    EXPECT_TRUE(scene().processes().at("robot")->title().startsWith("robot · lost"));
    KeepPictures(*window_, "flow-graph-stale");

    WatchHandlers();
    robot_->Signal(SIGCONT);
    ASSERT_TRUE(Eventually([&] { return IsWell(); }));
    ExpectNoHandlerStalled(round, "healed");
    EXPECT_EQ(scene().component("robot/arm")->sceneRect(), place);
  }
}

TEST_F(GraphFlowTest, RequestsToAStoppedProcessDoNotBlock) {
  ASSERT_TRUE(Eventually([&] { return IsWell(); }));
  session_->reports().listen(window_.get(), {"robot/**"});
  window_->selection().select(QStringLiteral("robot/arm"));
  const QString position = QStringLiteral("robot/arm/state.Joints.position[0]");
  window_->plots().addSignal(position, QStringLiteral("rad"));
  ASSERT_TRUE(Eventually([&] {
    const Curve* curve = window_->plots().currentPlot().curve(position);
    return curve != nullptr && curve->samples().endIndex() > 0;
  }));

  for (int round = 0; round < kRounds; ++round) {
    robot_->Signal(SIGSTOP);
    WatchHandlers();

    const auto result = std::make_shared<std::string>();
    QTimer::singleShot(0, window_.get(), [this, result] {
      session_->callCommand("robot/arm/Control.Stop", {}, [result](const auto& came, double) {
        *result = came ? "done" : came.error().message;
      });
      session_->reports().listen(window_.get(), {});
      session_->reports().listen(window_.get(), {"robot/arm/**"});
      window_->selection().select(QStringLiteral("robot/host_monitor"));
      window_->selection().select(QStringLiteral("robot/arm"));
    });
    ASSERT_TRUE(Eventually([&] { return !result->empty() && IsGrey("robot/arm"); }));
    EXPECT_TRUE(result->starts_with("process 'robot' is lost")) << *result;
    ExpectNoHandlerStalled(round, "answered and grey");

    WatchHandlers();
    robot_->Signal(SIGCONT);
    ASSERT_TRUE(Eventually([&] { return IsWell(); }));
    ExpectNoHandlerStalled(round, "healed");
  }
}

TEST_F(GraphFlowTest, AllIsGreyWithoutTheGcm) {
  ASSERT_TRUE(Eventually([&] { return IsWell(); }));

  for (int round = 0; round < kRounds; ++round) {
    WatchHandlers();
    gcm_->Signal(SIGKILL);
    ASSERT_TRUE(Eventually([&] { return IsGrey("robot/arm") && IsGrey("desk/supervisor"); }));
    ExpectNoHandlerStalled(round, "all grey");
    EXPECT_EQ(Look(), EdgeItem::Look::kStale);

    StartGcm();
    WatchHandlers();
    ASSERT_TRUE(Eventually([&] { return IsWell(); }));
    ExpectNoHandlerStalled(round, "healed since the GCM is back");
  }
}

}  // namespace
}  // namespace tendon::gui
