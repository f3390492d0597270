#include <gcm_gui/files/file_writer.h>
#include <gcm_gui/graph/items/component_item.h>
#include <gcm_gui/graph/items/process_item.h>
#include <gcm_gui/graph/layout/node_positions.h>
#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <chrono>
#include <cmath>

#include "graph/graph_fixture.h"

namespace tendon::gui {
namespace {

class NodePositionsTest : public GraphFixture {
 protected:
  NodePositionsTest() : GraphFixture(LookSystem(0)) {
    Show();
    view_.resize(1400, 900);
    view_.show();
    view_.fit();
  }

  [[nodiscard]] QRectF Rect(const QString& component) const {
    return scene_.component(component)->sceneRect();
  }
  [[nodiscard]] QRectF Box(const QString& process) const {
    return scene_.processes().at(process)->sceneBoundingRect();
  }
  /// Drags with the mouse by `way`, in scene units.
  void Drag(const QPointF& from, const QPointF& way) {
    const QPoint start = view_.mapFromScene(from);
    const QPoint end = view_.mapFromScene(from + way);
    QTest::mousePress(view_.viewport(), Qt::LeftButton, {}, start);
    QTest::mouseMove(view_.viewport(), (start + end) / 2);
    QTest::mouseMove(view_.viewport(), end);
    QTest::mouseRelease(view_.viewport(), Qt::LeftButton, {}, end);
  }
  void DragHead(const QString& component, const QPointF& way) {
    Drag(Rect(component).topLeft() + QPointF(30, 14), way);
  }
};

/// Compares two positions; the tolerance covers the grid and a pixel of the view.
void ExpectNear(const QPointF& a, const QPointF& b) {
  EXPECT_LT(std::abs(a.x() - b.x()), 5);
  EXPECT_LT(std::abs(a.y() - b.y()), 5);
}

TEST_F(NodePositionsTest, ADraggedComponentStaysInItsPlace) {
  const QRectF before = Rect("robot/arm");
  const QRectF other = Rect("robot/controller");
  const QPointF way(-60, 280);

  DragHead("robot/arm", way);

  ExpectNear(Rect("robot/arm").topLeft(), before.topLeft() + way);
  EXPECT_EQ(Rect("robot/controller"), other);
  EXPECT_TRUE(Box("robot").contains(Rect("robot/arm")));
  EXPECT_TRUE(selection_.current().isEmpty());
  EXPECT_EQ(scene_.edge("robot/controller/Arm")->path().elementAt(0).x,
            scene_.port({Side::kProvided, {"robot", "arm", "Drives"}})->scenePos().x());

  const QPointF place = Rect("robot/arm").topLeft();
  system_.Component("robot", Task("newcomer", 1, {}));
  Show();
  EXPECT_EQ(Rect("robot/arm").topLeft(), place);
  EXPECT_FALSE(Rect("robot/newcomer").intersects(Rect("robot/arm")));
}

TEST_F(NodePositionsTest, ADraggedComponentPushesOthersAside) {
  DragHead("robot/arm", Rect("robot/controller").topLeft() - Rect("robot/arm").topLeft());

  EXPECT_FALSE(Rect("robot/arm").intersects(Rect("robot/controller")));
  EXPECT_FALSE(Box("robot").intersects(Box("desk")));
}

TEST_F(NodePositionsTest, DraggingAProcessMovesItsComponents) {
  const QPointF arm = Rect("robot/arm").topLeft();
  const QPointF controller = Rect("robot/controller").topLeft();
  const QPointF way(20, 320);

  Drag(Box("robot").topLeft() + QPointF(30, 12), way);

  ExpectNear(Rect("robot/arm").topLeft(), arm + way);
  ExpectNear(Rect("robot/controller").topLeft(), controller + way);
  EXPECT_FALSE(Box("robot").intersects(Box("desk")));
}

TEST_F(NodePositionsTest, UndoRevertsAMoveInOneStep) {
  const QPointF first = Rect("robot/arm").topLeft();
  DragHead("robot/arm", {-40, 200});
  const QPointF second = Rect("robot/arm").topLeft();
  DragHead("robot/arm", {-40, 80});

  scene_.nodePositions().undo();
  EXPECT_EQ(Rect("robot/arm").topLeft(), second);

  scene_.nodePositions().reset();
  EXPECT_EQ(Rect("robot/arm").topLeft(), first);

  scene_.nodePositions().undo();
  EXPECT_EQ(Rect("robot/arm").topLeft(), second);
  scene_.nodePositions().undo();
  EXPECT_EQ(Rect("robot/arm").topLeft(), first);
  EXPECT_FALSE(scene_.nodePositions().canUndo());
}

TEST_F(NodePositionsTest, CancellingADragRestoresThePosition) {
  const QPointF before = Rect("robot/arm").topLeft();
  const QPoint start = view_.mapFromScene(before + QPointF(30, 14));
  QTest::mousePress(view_.viewport(), Qt::LeftButton, {}, start);
  QTest::mouseMove(view_.viewport(), start + QPoint(0, 60));
  QTest::mouseMove(view_.viewport(), start + QPoint(0, 90));
  ASSERT_NE(Rect("robot/arm").topLeft(), before);

  EXPECT_TRUE(view_.cancelDrag());
  QTest::mouseMove(view_.viewport(), start + QPoint(0, 120));
  QTest::mouseRelease(view_.viewport(), Qt::LeftButton, {}, start + QPoint(0, 120));

  EXPECT_EQ(Rect("robot/arm").topLeft(), before);
  EXPECT_FALSE(scene_.nodePositions().canUndo());
  EXPECT_FALSE(view_.cancelDrag());
}

TEST_F(NodePositionsTest, AltAndArrowKeysMoveTheSelectionAsOneStep) {
  selection_.select("robot/arm");
  const QPointF before = Rect("robot/arm").topLeft();

  for (int step = 0; step < 3; ++step) QTest::keyClick(&view_, Qt::Key_Down, Qt::AltModifier);
  EXPECT_GT(Rect("robot/arm").top(), before.y() + 10);
  EXPECT_EQ(Rect("robot/arm").left(), before.x());

  scene_.nodePositions().undo();
  EXPECT_EQ(Rect("robot/arm").topLeft(), before);
}

TEST_F(NodePositionsTest, SavesPositionsAndIgnoresABadFile) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("kept/graph.json");
  {
    NodePositions places;
    places.keepIn(file);
    places.move({{"robot/arm", {12, -40}}, {"gone/long ago", {3, 4}}});
    ASSERT_TRUE(FileWriter::instance().waitForWritten(std::chrono::minutes(2)));
  }
  NodePositions again;
  again.keepIn(file);
  EXPECT_EQ(again.all(), (NodePositions::Map{{"robot/arm", {12, -40}}, {"gone/long ago", {3, 4}}}));
  EXPECT_FALSE(again.canUndo());

  QFile bad(file);
  ASSERT_TRUE(bad.open(QIODevice::WriteOnly));
  bad.write(
      R"({"schema": 1, "places": {"a/b": [1], "c/d": "x", "e/f": [1e30, 0], "g/h": [1, 2]}})");
  bad.close();
  NodePositions survivor;
  survivor.keepIn(file);
  EXPECT_EQ(survivor.all(), (NodePositions::Map{{"g/h", {1, 2}}}));
}

}  // namespace
}  // namespace tendon::gui
