#include <gcm_gui/graph/items/card_item.h>
#include <gcm_gui/graph/items/component_item.h>
#include <gcm_gui/graph/items/port_item.h>
#include <gcm_gui/graph/items/process_item.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QMouseEvent>
#include <QTest>
#include <chrono>
#include <vector>

#include "graph/graph_fixture.h"

namespace tendon::gui {
namespace {

const PortName kRobot{Side::kRequired, {"desk", "teleoperation", "Robot"}};
const PortName kControl{Side::kProvided, {"robot", "controller", "Control"}};
const PortName kDrives{Side::kProvided, {"robot", "arm", "Drives"}};

class GraphViewTest : public GraphFixture {
 protected:
  explicit GraphViewTest(std::chrono::milliseconds pointer_timeout = GraphView::kPointerTimeout)
      : GraphFixture(LookSystem(0), pointer_timeout) {
    Show();
    view_.resize(900, 480);
    view_.show();
    view_.fit();
  }

  /// Sends a move event as the window system would. QTest sends no event if the pointer is there
  /// already.
  void Hover(const PortName& port) {
    const QPoint at = view_.pointOf(port).value();
    QMouseEvent event(QEvent::MouseMove, at, view_.viewport()->mapToGlobal(at), Qt::NoButton,
                      Qt::NoButton, {});
    QApplication::sendEvent(view_.viewport(), &event);
  }

  void Click(const PortName& port) {
    QTest::mouseClick(view_.viewport(), Qt::LeftButton, {}, view_.pointOf(port).value());
  }

  /// The cards that are shown.
  [[nodiscard]] std::vector<const CardItem*> Cards() const {
    std::vector<const CardItem*> cards;
    for (const QGraphicsItem* item : scene_.items()) {
      const auto* card = dynamic_cast<const CardItem*>(item);
      if (card != nullptr && card->isVisible()) cards.push_back(card);
    }
    return cards;
  }
};

/// The pointer counts as moving during the whole test.
class MovingPointerTest : public GraphViewTest {
 protected:
  MovingPointerTest() : GraphViewTest(std::chrono::hours(1)) {}
};

TEST_F(GraphViewTest, TwoClicksConnect) {
  Click(kRobot);
  ASSERT_TRUE(mode_.active());
  EXPECT_EQ(scene_.port(kRobot)->role(), PortItem::Role::kChosen);
  EXPECT_EQ(scene_.port(kControl)->role(), PortItem::Role::kCandidate);
  EXPECT_EQ(scene_.port(kControl)->number(), 1);
  EXPECT_EQ(scene_.port(kDrives)->role(), PortItem::Role::kUnfit);

  Click(kControl);

  EXPECT_EQ(actions_.asked,
            QStringList{"connect desk/teleoperation/Robot robot/controller/Control"});
  EXPECT_EQ(scene_.port(kControl)->role(), PortItem::Role::kPlain);
}

TEST_F(GraphViewTest, DraggingFromPortToPortConnects) {
  const QPoint from = view_.pointOf(kRobot).value();
  const QPoint to = view_.pointOf(kControl).value();

  QTest::mousePress(view_.viewport(), Qt::LeftButton, {}, from);
  QTest::mouseMove(view_.viewport(), (from + to) / 2);
  EXPECT_TRUE(mode_.active());
  QTest::mouseMove(view_.viewport(), to);
  QTest::mouseRelease(view_.viewport(), Qt::LeftButton, {}, to);

  EXPECT_EQ(actions_.asked,
            QStringList{"connect desk/teleoperation/Robot robot/controller/Control"});
}

TEST_F(GraphViewTest, CardsHideNoComponent) {
  view_.resize(1800, 700);
  Click(kRobot);

  for (const CardItem* card : Cards()) {
    const QRectF rect(card->pos(), card->size());
    for (const auto& [path, item] : scene_.components()) {
      EXPECT_FALSE(rect.intersects(item->sceneRect())) << path.toStdString();
    }
    for (const auto& [name, item] : scene_.processes()) {
      EXPECT_FALSE(rect.intersects(item->sceneBoundingRect())) << name.toStdString();
    }
  }
}

TEST_F(GraphViewTest, HoverReportsARefusalIfNoCardFits) {
  scene_.setVisible({0, 0, 60, 40});  // as if only this part were visible
  QString title;
  QStringList reasons;
  QObject::connect(&scene_, &GraphScene::refusalPointed, &scene_,
                   [&](const auto& t, const auto& r) {
                     title = t;
                     reasons = r;
                   });
  Click(kRobot);
  EXPECT_TRUE(Cards().empty());
  EXPECT_TRUE(title.isEmpty());

  Hover(kDrives);

  EXPECT_TRUE(Cards().empty());
  EXPECT_EQ(title, "arm / Drives does not fit");
  EXPECT_FALSE(reasons.isEmpty());

  Hover(kControl);

  EXPECT_TRUE(title.isEmpty());
}

TEST_F(GraphViewTest, KeysPickACandidateAndLeaveConnectMode) {
  Click(kRobot);
  QTest::keyClick(&view_, Qt::Key_Escape);
  EXPECT_FALSE(mode_.active());

  Click(kRobot);
  QTest::keyClick(&view_, Qt::Key_1);
  EXPECT_EQ(actions_.asked.size(), 1);

  Click(kControl);
  QTest::keyClick(&view_, Qt::Key_Return);
  EXPECT_EQ(actions_.asked.size(), 2);
}

TEST_F(GraphViewTest, AClickOnTheBackgroundLeavesConnectMode) {
  Click(kRobot);

  QTest::mouseClick(view_.viewport(), Qt::LeftButton, {}, QPoint(3, 3));

  EXPECT_FALSE(mode_.active());
  EXPECT_TRUE(selection_.paths().isEmpty());
}

TEST_F(GraphViewTest, AClickSelectsComponentsProcessesAndConnections) {
  const auto click = [&](const QPointF& scene) {
    QTest::mouseClick(view_.viewport(), Qt::LeftButton, {}, view_.mapFromScene(scene));
  };
  const QRectF arm = scene_.component("robot/arm")->sceneRect();
  click(arm.topLeft() + QPointF(30, 14));
  EXPECT_EQ(selection_.current(), "robot/arm");

  click(scene_.processes().at("desk")->scenePos() + QPointF(20, 12));
  EXPECT_EQ(selection_.current(), "desk");

  const QPointF from = scene_.port(kDrives)->scenePos();
  const QPointF to = scene_.port({Side::kRequired, {"robot", "controller", "Arm"}})->scenePos();
  click((from + to) / 2);
  EXPECT_EQ(selection_.current(), "robot/controller/Arm");
}

TEST_F(GraphViewTest, AnEdgeShowsTheStateOfItsConnection) {
  const QString host = "desk/view/Host";
  EXPECT_EQ(scene_.edge(host)->look(), EdgeItem::Look::kActive);

  system_.Connect({"desk", "view", "Host"}, {"desk", "host_monitor", "state"},
                  ConnectionState::kFailed, "no reply");
  Show();
  EXPECT_EQ(scene_.edge(host)->look(), EdgeItem::Look::kFailed);

  system_.Connect({"desk", "view", "Host"}, {"desk", "host_monitor", "state"},
                  ConnectionState::kPending);
  Show();
  EXPECT_EQ(scene_.edge(host)->look(), EdgeItem::Look::kPending);
}

TEST_F(GraphViewTest, ARequestIsDashedUntilItsAnswer) {
  const QString robot = "desk/teleoperation/Robot";
  ASSERT_EQ(scene_.edge(robot), nullptr);

  scene_.showRequested(kRobot.name, kControl.name);
  ASSERT_NE(scene_.edge(robot), nullptr);
  EXPECT_EQ(scene_.edge(robot)->look(), EdgeItem::Look::kPending);

  scene_.forgetRequested(kRobot.name);
  EXPECT_EQ(scene_.edge(robot), nullptr);
}

TEST_F(GraphViewTest, ALostProcessFadesAndShowsForHowLong) {
  system_.Process("robot", ProcessState::kLost, 0);
  Show();
  scene_.setNow(12'000'000'000);

  EXPECT_EQ(scene_.processes().at("robot")->title(), "robot · lost 12 s");
  EXPECT_TRUE(scene_.component("robot/arm")->isStale());
  EXPECT_EQ(scene_.edge("robot/controller/Arm")->look(), EdgeItem::Look::kStale);
}

TEST_F(GraphViewTest, DraggingMovesTheViewAndSelectsNothing) {
  const QPoint before = view_.pointOf(kRobot).value();

  QTest::mousePress(view_.viewport(), Qt::LeftButton, {}, QPoint(5, 5));
  QTest::mouseMove(view_.viewport(), QPoint(25, 25));
  QTest::mouseMove(view_.viewport(), QPoint(45, 35));
  QTest::mouseRelease(view_.viewport(), Qt::LeftButton, {}, QPoint(45, 35));

  EXPECT_EQ(view_.pointOf(kRobot).value() - before, QPoint(40, 30));
  EXPECT_FALSE(mode_.active());
}

TEST_F(GraphViewTest, FitsTheViewUntilTheUserZooms) {
  system_.Process("extra")
      .Component("extra", Task("a", 1, {}))
      .Component("extra", Task("b", 1, {}));
  Show();
  EXPECT_TRUE(
      view_.mapToScene(view_.viewport()->rect()).boundingRect().contains(scene_.contents()));

  view_.zoomIn();
  const QTransform zoomed = view_.transform();
  system_.Component("extra", Task("c", 1, {}));
  Show();
  EXPECT_EQ(view_.transform(), zoomed);

  view_.fit();
  EXPECT_TRUE(
      view_.mapToScene(view_.viewport()->rect()).boundingRect().contains(scene_.contents()));
}

TEST_F(GraphViewTest, StaysCentredWhenTheViewIsResized) {
  const auto middle = [&] {
    return view_.mapFromScene(scene_.contents().center()) - view_.viewport()->rect().center();
  };
  EXPECT_LE(middle().manhattanLength(), 3);

  view_.resize(1600, 900);
  EXPECT_LE(middle().manhattanLength(), 3);

  view_.resize(500, 300);
  EXPECT_LE(middle().manhattanLength(), 3);
  EXPECT_TRUE(
      view_.mapToScene(view_.viewport()->rect()).boundingRect().contains(scene_.contents()));
}

TEST_F(GraphViewTest, NewProcessesDoNotMoveTheViewInConnectMode) {
  view_.resize(1600, 900);
  Click(kRobot);
  const QPoint before = view_.pointOf(kControl).value();

  system_.Process("extra").Component("extra", Task("a", 1, {}));
  Show();

  EXPECT_EQ(view_.pointOf(kControl).value(), before);
}

TEST_F(MovingPointerTest, NewProcessesDoNotMoveTheView) {
  view_.resize(1600, 900);
  Hover(kControl);
  Hover(kDrives);
  const QPoint before = view_.pointOf(kControl).value();

  system_.Process("extra").Component("extra", Task("a", 1, {}));
  Show();

  EXPECT_EQ(view_.pointOf(kControl).value(), before);
}

TEST_F(GraphViewTest, StaysCentredUnderAPointerAtRest) {
  view_.resize(1600, 900);
  Hover(kControl);
  Hover(kControl);

  system_.Process("extra").Component("extra", Task("a", 1, {}));
  Show();

  EXPECT_LE((view_.mapFromScene(scene_.contents().center()) - view_.viewport()->rect().center())
                .manhattanLength(),
            3);
}

TEST_F(GraphViewTest, AnOutdatedGraphIsGreyAndStaysInPlace) {
  const QPoint before = view_.pointOf(kControl).value();

  scene_.setOutdated(true);
  EXPECT_TRUE(scene_.component("robot/arm")->isStale());
  EXPECT_EQ(scene_.edge("robot/controller/Arm")->look(), EdgeItem::Look::kStale);
  EXPECT_EQ(view_.pointOf(kControl).value(), before);

  scene_.setOutdated(false);
  EXPECT_FALSE(scene_.component("robot/arm")->isStale());
  EXPECT_EQ(scene_.edge("robot/controller/Arm")->look(), EdgeItem::Look::kActive);
}

TEST_F(GraphViewTest, ArrowKeysNavigateTheGraph) {
  selection_.select("robot/arm");

  QTest::keyClick(&view_, Qt::Key_Right);

  EXPECT_EQ(selection_.current(), "robot/controller");
}

}  // namespace
}  // namespace tendon::gui
