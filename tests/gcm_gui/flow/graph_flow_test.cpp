#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/graph/items/component_item.h>
#include <gcm_gui/graph/items/process_item.h>

#include <csignal>

#include "flow/flow_fixture.h"
#include "support/pictures.h"

namespace tendon::gui {
namespace {

const QString kArmEdge = QStringLiteral("desk/supervisor/Robot");

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
};

TEST_F(GraphFlowTest, AProcessThatStandsStillIsGreyAndComesBackInItsPlace) {
  ASSERT_TRUE(Eventually([&] { return IsWell(); }));
  const QRectF place = scene().component("robot/arm")->sceneRect();

  robot_->Signal(SIGSTOP);
  ASSERT_TRUE(Eventually([&] { return IsGrey("robot/arm"); }));
  EXPECT_FALSE(IsGrey("desk/supervisor"));
  // Pending where the desk has missed it as early as the GCM has.
  EXPECT_TRUE(Look() == EdgeItem::Look::kStale || Look() == EdgeItem::Look::kPending);
  EXPECT_TRUE(scene().processes().at("robot")->title().startsWith("robot · lost"));
  KeepPictures(*window_, "flow-graph-stale");

  robot_->Signal(SIGCONT);
  EXPECT_TRUE(Eventually([&] { return IsWell(); }));
  EXPECT_EQ(scene().component("robot/arm")->sceneRect(), place);
}

TEST_F(GraphFlowTest, WithoutItsGcmAllIsGreyUntilItIsBack) {
  ASSERT_TRUE(Eventually([&] { return IsWell(); }));

  gcm_->Signal(SIGKILL);
  ASSERT_TRUE(Eventually([&] { return IsGrey("robot/arm") && IsGrey("desk/supervisor"); }));
  EXPECT_EQ(Look(), EdgeItem::Look::kStale);

  StartGcm();
  EXPECT_TRUE(Eventually([&] { return IsWell(); }));
}

}  // namespace
}  // namespace tendon::gui
