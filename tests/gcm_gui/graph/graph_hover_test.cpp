#include <gcm_gui/graph/graph_hover.h>
#include <gcm_gui/graph/highlight.h>
#include <gcm_gui/graph/items/card_item.h>
#include <gcm_gui/graph/items/component_item.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <set>

#include "graph/graph_fixture.h"

namespace tendon::gui {
namespace {

constexpr int kHoverTimeout = 120'000;  // ms; bounds a test that fails
const QString kEdge = "robot/controller/Arm";

class GraphHoverTest : public GraphFixture {
 protected:
  GraphHoverTest() : GraphFixture(LookSystem(0)) {
    Show();
    view_.resize(900, 480);
    view_.show();
    view_.fit();
  }

  /// Sends a move event as the window system would. QTest sends no event if the pointer is there
  /// already.
  void MoveTo(const QPointF& scene) {
    const QPoint at = view_.mapFromScene(scene);
    QMouseEvent event(QEvent::MouseMove, at, view_.viewport()->mapToGlobal(at), Qt::NoButton,
                      Qt::NoButton, {});
    QApplication::sendEvent(view_.viewport(), &event);
  }
  [[nodiscard]] QPointF HeadOf(const QString& component) const {
    return scene_.component(component)->sceneRect().topLeft() + QPointF(30, 14);
  }
  [[nodiscard]] QPointF MiddleOfEdge() const {
    return scene_.edge(kEdge)->path().pointAtPercent(0.5);
  }
  [[nodiscard]] bool EventuallyDims(bool dims) const {
    return QTest::qWaitFor([&] { return scene_.highlight().dimming() == (dims ? 1 : 0); },
                           kHoverTimeout);
  }
  [[nodiscard]] bool IsHighlighted(const QString& component) const {
    return scene_.component(component)->zValue() > scene_.component("desk/teleoperation")->zValue();
  }
};

TEST_F(GraphHoverTest, HighlightsAComponentAndItsNeighbours) {
  MoveTo(HeadOf("robot/arm"));

  ASSERT_TRUE(EventuallyDims(true));
  EXPECT_TRUE(IsHighlighted("robot/arm"));
  EXPECT_TRUE(IsHighlighted("robot/controller"));
  EXPECT_FALSE(IsHighlighted("desk/view"));
  EXPECT_GT(scene_.edge(kEdge)->zValue(), scene_.edge("desk/view/Host")->zValue());

  MoveTo(view_.mapToScene(QPoint(2, 2)));

  ASSERT_TRUE(EventuallyDims(false));
  EXPECT_FALSE(IsHighlighted("robot/arm"));
}

TEST_F(GraphHoverTest, HighlightsAPortAndItsConnections) {
  MoveTo(scene_.port({Side::kProvided, {"robot", "arm", "Drives"}})->scenePos());

  ASSERT_TRUE(EventuallyDims(true));
  EXPECT_EQ(scene_.highlight().names().edges, std::set<QString>{kEdge});
  EXPECT_EQ(scene_.highlight().names().components,
            (std::set<QString>{"robot/arm", "robot/controller"}));
}

TEST_F(GraphHoverTest, AnUnconnectedComponentDimsNothing) {
  MoveTo(HeadOf("robot/arm"));
  ASSERT_TRUE(EventuallyDims(true));

  MoveTo(HeadOf("desk/teleoperation"));

  EXPECT_TRUE(EventuallyDims(false));
}

TEST_F(GraphHoverTest, ShowsTheHealthOfAConnection) {
  QSignalSpy pointed(&scene_.hover(), &GraphHover::connectionPointed);
  MoveTo(MiddleOfEdge());
  ASSERT_TRUE(QTest::qWaitFor([&] { return pointed.size() == 1; }, kHoverTimeout));
  EXPECT_EQ(pointed[0][0].toString(), kEdge);
  EXPECT_EQ(scene_.hover().card(), nullptr);

  scene_.hover().showReadout({"desk", "view", "Host"}, {"of another one"});
  EXPECT_EQ(scene_.hover().card(), nullptr);
  scene_.hover().showReadout({"robot", "controller", "Arm"}, {"round trip 38.0 µs"});

  ASSERT_NE(scene_.hover().card(), nullptr);
  EXPECT_EQ(scene_.hover().card()->title(), "robot/controller/Arm → robot/arm/Drives");
  EXPECT_EQ(scene_.hover().card()->lines(), QStringList("round trip 38.0 µs"));

  MoveTo(view_.mapToScene(QPoint(2, 2)));
  EXPECT_EQ(scene_.hover().card(), nullptr);
  EXPECT_EQ(pointed.back()[0].toString(), QString());
}

TEST_F(GraphHoverTest, ARemovedConnectionClosesItsCard) {
  MoveTo(MiddleOfEdge());
  ASSERT_TRUE(EventuallyDims(true));
  scene_.hover().showReadout({"robot", "controller", "Arm"}, {"round trip 38.0 µs"});

  system_.Disconnect({"robot", "controller", "Arm"});
  Show();

  EXPECT_EQ(scene_.hover().card(), nullptr);
  EXPECT_TRUE(EventuallyDims(false));
}

TEST_F(GraphHoverTest, ConnectModeDimsNothing) {
  MoveTo(HeadOf("robot/arm"));
  ASSERT_TRUE(EventuallyDims(true));

  mode_.start({Side::kRequired, {"desk", "teleoperation", "Robot"}});
  MoveTo(HeadOf("robot/controller"));

  EXPECT_TRUE(scene_.highlight().names().empty());
  EXPECT_TRUE(EventuallyDims(false));
}

TEST_F(GraphHoverTest, KeyboardNavigationHighlightsNeighbours) {
  selection_.select("robot/arm");

  QTest::keyClick(&view_, Qt::Key_Right);

  EXPECT_TRUE(scene_.highlight().names().components.contains("robot/arm"));
  EXPECT_TRUE(scene_.highlight().names().components.contains("robot/controller"));
}

}  // namespace
}  // namespace tendon::gui
