#include <gcm_gui/graph/items/component_item.h>
#include <gcm_gui/graph/items/process_item.h>
#include <gcm_gui/graph/layout/layout_worker.h>
#include <gcm_gui/graph/layout/node_positions.h>
#include <gcm_gui/graph/layout/picture_updater.h>
#include <gcm_gui/graph/layout_animation.h>
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QSignalSpy>
#include <QTest>

#include "graph/graph_fixture.h"
#include "support/large_system.h"

namespace tendon::gui {
namespace {

constexpr int kWorkerTimeout = 120'000;  // ms

GraphPicture LargePicture() { return PictureOf(LargeSystem(4, 50).catalogue()); }

class LayoutInThread : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(Sizes, LayoutInThread, testing::Bool(),
                         [](const auto& instance) { return instance.param ? "Large" : "Small"; });

TEST_P(LayoutInThread, PlacesNodesLikeTheLayout) {
  const GraphPicture picture = GetParam() ? LargePicture() : PictureOf(LookSystem(0).catalogue());
  GraphLayout layout;
  layout.update(picture);
  LayoutWorker worker;
  QSignalSpy arranged(&worker, &LayoutWorker::arranged);

  worker.arrange(picture, {});
  EXPECT_TRUE(worker.isAtWork());
  EXPECT_EQ(arranged.count(), 0);

  ASSERT_TRUE(QTest::qWaitFor([&] { return arranged.count() == 1; }, kWorkerTimeout));
  EXPECT_FALSE(worker.isAtWork());
  EXPECT_EQ(worker.arrangement().nodes, layout.arrangement().nodes);
  EXPECT_EQ(worker.arrangement().boxes, layout.arrangement().boxes);
}

TEST(LayoutWorker, PlacesOnlyTheNewestPendingRequest) {
  const GraphPicture picture = LargePicture();
  const QString path = picture.processes.front().nodes.front().path;
  LayoutWorker worker;
  QSignalSpy arranged(&worker, &LayoutWorker::arranged);

  worker.arrange(picture, {});
  worker.arrange(picture, {{path, {-500, -500}}});
  worker.move(picture, {{path, {-1000, -2000}}});

  ASSERT_TRUE(QTest::qWaitFor([&] { return !worker.isAtWork(); }, kWorkerTimeout));
  EXPECT_EQ(worker.arrangement().nodes.value(path).topLeft(), QPointF(-1000, -2000));
  EXPECT_EQ(arranged.count(), 2);
}

TEST(LayoutWorker, ADestroyedWorkerSignalsNothing) {
  int told = 0;
  const auto count = [&] { ++told; };
  auto worker = std::make_unique<LayoutWorker>();
  QObject::connect(worker.get(), &LayoutWorker::arranged, qApp, count, Qt::DirectConnection);
  worker->arrange(LargePicture(), {});
  ASSERT_TRUE(worker->isAtWork());

  worker.reset();

  LayoutWorker later;  // needs as much time as the first worker
  QSignalSpy arranged(&later, &LayoutWorker::arranged);
  later.arrange(LargePicture(), {});
  ASSERT_TRUE(QTest::qWaitFor([&] { return arranged.count() == 1; }, kWorkerTimeout));
  EXPECT_EQ(told, 0);
}

TEST(GraphScene, HidesComponentsWithoutAPlace) {
  CatalogueStore store;
  Selection selection;
  RecordingActions actions;
  ConnectMode mode{store, actions};
  GraphScene scene(store, selection, mode);

  store.replace(LookSystem(0).catalogue());
  EXPECT_TRUE(scene.isArranging());
  EXPECT_TRUE(scene.components().empty());
  EXPECT_TRUE(scene.processes().empty());

  ASSERT_TRUE(QTest::qWaitFor([&] { return !scene.isArranging() && !IsAnnouncing(store); },
                              kWorkerTimeout));
  ASSERT_EQ(scene.components().size(), 7U);
  for (const auto& [path, component] : scene.components()) {
    const auto* process = scene.processes().at(path.section('/', 0, 0));
    EXPECT_TRUE(process->sceneBoundingRect().contains(component->sceneRect())) << qPrintable(path);
  }
}

/// A graph with animations, which other tests turn off.
class LayoutAnimationTest : public GraphFixture {
 protected:
  LayoutAnimationTest() : GraphFixture(LookSystem(0)) {
    QCoreApplication::instance()->setProperty(LayoutAnimation::kStill, false);
    Show();
  }
  ~LayoutAnimationTest() override {
    QCoreApplication::instance()->setProperty(LayoutAnimation::kStill, true);
  }

  [[nodiscard]] QPointF place() const { return scene_.component("robot/arm")->pos(); }
  bool IsEventuallyAt(const QPointF& point) const {
    return QTest::qWaitFor([&] { return place() == point; }, kWorkerTimeout);
  }
};

TEST_F(LayoutAnimationTest, AnimatesAResetOfTheLayoutAndItsUndo) {
  const QPointF laid_out = place();
  const QPointF by_hand = laid_out + QPointF(600, 400);
  scene_.nodePositions().move({{"robot/arm", by_hand}});
  ASSERT_TRUE(IsEventuallyAt(by_hand));

  scene_.nodePositions().reset();
  EXPECT_EQ(place(), by_hand) << "it begins where it was";
  EXPECT_TRUE(IsEventuallyAt(laid_out));

  scene_.nodePositions().undo();
  EXPECT_TRUE(IsEventuallyAt(by_hand));
}

TEST(LayoutAnimation, ALargeSystemIsNotAnimated) {
  QCoreApplication::instance()->setProperty(LayoutAnimation::kStill, false);
  CatalogueStore store;
  store.replace(LargeSystem(4, 50).catalogue());
  Selection selection;
  RecordingActions actions;
  ConnectMode mode{store, actions};
  GraphScene scene(store, selection, mode);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !scene.isArranging() && !IsAnnouncing(store); },
                              kWorkerTimeout));
  const auto& [path, component] = *scene.components().begin();
  const QPointF there = component->pos() + QPointF(5000, 5000);

  scene.nodePositions().move({{path, there}});

  EXPECT_EQ(component->pos(), there);
  QCoreApplication::instance()->setProperty(LayoutAnimation::kStill, true);
}

TEST_F(LayoutAnimationTest, ADraggedNodeFollowsThePointerAtOnce) {
  const QPointF there = place() + QPointF(100, 300);

  scene_.carry({{"robot/arm", there}});

  EXPECT_EQ(place(), there);
}

}  // namespace
}  // namespace tendon::gui
