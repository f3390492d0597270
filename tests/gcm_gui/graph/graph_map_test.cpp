#include <gcm_gui/graph/graph_map.h>
#include <gtest/gtest.h>

#include <QTest>
#include <cmath>

#include "graph/graph_fixture.h"
#include "support/large_system.h"

namespace tendon::gui {
namespace {

class GraphMapTest : public GraphFixture {
 protected:
  GraphMapTest() : GraphFixture(LargeSystem(4, 6)) {
    Show();
    view_.resize(900, 600);
    view_.show();
    view_.fit();
  }

  void ZoomIn() {
    for (int step = 0; step < 8; ++step) QTest::keyClick(&view_, Qt::Key_Plus);
  }
  /// Expects that the centre of the frame shows the centre of the view.
  void ExpectTrueFrame() const {
    const QPointF off = map_.fromScene(view_.seen().center()) - map_.frame().center();
    EXPECT_LT(std::hypot(off.x(), off.y()), 1.5);
    EXPECT_LT(map_.frame().width(), map_.width());
  }

  GraphMap map_{view_};
};

TEST_F(GraphMapTest, IsVisibleWhileTheGraphDoesNotFit) {
  EXPECT_FALSE(map_.isVisible());

  ZoomIn();
  EXPECT_TRUE(map_.isVisible());
  ExpectTrueFrame();
  EXPECT_TRUE(view_.rect().contains(map_.geometry()));

  QTest::keyClick(&view_, Qt::Key_0);
  EXPECT_FALSE(map_.isVisible());
}

TEST_F(GraphMapTest, AClickCentresTheView) {
  ZoomIn();
  const QPointF corner = scene_.contents().topLeft() + QPointF(150, 100);

  QTest::mouseClick(&map_, Qt::LeftButton, {}, map_.fromScene(corner).toPoint());

  const double pixel = scene_.contents().width() / map_.width();
  EXPECT_LT(std::abs(view_.seen().center().x() - corner.x()), 2 * pixel);
  EXPECT_LT(std::abs(view_.seen().center().y() - corner.y()), 2 * pixel);
  ExpectTrueFrame();
}

TEST_F(GraphMapTest, DraggingTheFrameMovesTheView) {
  ZoomIn();
  const QPointF before = view_.seen().center();
  const QPoint held = (map_.frame().center() + QPointF(4, 3)).toPoint();

  QTest::mousePress(&map_, Qt::LeftButton, {}, held);
  const double slip =
      std::hypot(view_.seen().center().x() - before.x(), view_.seen().center().y() - before.y());
  QTest::mouseMove(&map_, held + QPoint(20, 0));
  QTest::mouseRelease(&map_, Qt::LeftButton, {}, held + QPoint(20, 0));

  const double pixel = scene_.contents().width() / map_.width();
  EXPECT_LT(slip, 2 * pixel) << "it jumped under the pointer";
  EXPECT_GT(view_.seen().center().x(), before.x() + 10 * pixel);
  EXPECT_LT(std::abs(view_.seen().center().y() - before.y()), 2 * pixel);
}

TEST_F(GraphMapTest, CanBeSwitchedOff) {
  ZoomIn();

  map_.setWanted(false);
  EXPECT_FALSE(map_.isVisible());
  view_.zoomIn();
  EXPECT_FALSE(map_.isVisible());

  map_.setWanted(true);
  EXPECT_TRUE(map_.isVisible());
}

TEST_F(GraphMapTest, FollowsNewComponentsAndTheViewSize) {
  ZoomIn();
  const double scale = map_.fromScene({100, 0}).x() - map_.fromScene({0, 0}).x();
  for (int i = 0; i < 3; ++i) {
    const std::string process = "more_" + std::to_string(i);
    system_.Process(process);
    for (int k = 0; k < 12; ++k) {
      system_.Component(process, Task("task_" + std::to_string(k), 1, {}));
    }
  }
  Show();
  EXPECT_LT(map_.fromScene({100, 0}).x() - map_.fromScene({0, 0}).x(), scale);

  view_.resize(700, 400);
  EXPECT_TRUE(view_.rect().contains(map_.geometry()));
  ExpectTrueFrame();
}

TEST_F(GraphMapTest, ShiftAndArrowKeysMoveTheView) {
  ZoomIn();
  const QPointF before = view_.seen().center();

  QTest::keyClick(&view_, Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_GT(view_.seen().center().x(), before.x());
  EXPECT_EQ(view_.seen().center().y(), before.y());

  QTest::keyClick(&view_, Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_EQ(view_.seen().center(), before);
  EXPECT_TRUE(selection_.current().isEmpty());
}

}  // namespace
}  // namespace tendon::gui
