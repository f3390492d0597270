#include <gcm_gui/commands/graph_commands.h>
#include <gcm_gui/graph/graph_hover.h>
#include <gcm_gui/graph/graph_search.h>
#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/graph/highlight.h>
#include <gcm_gui/graph/items/component_item.h>
#include <gcm_gui/graph/layout/node_positions.h>
#include <gcm_gui/theme/theme.h>
#include <gtest/gtest.h>

#include <QLineEdit>
#include <QTest>

#include "support/announcing.h"
#include "support/large_system.h"
#include "support/pictures.h"
#include "window/window_fixture.h"

namespace tendon::gui {
namespace {

/// Saves pictures of the graph in each of its states for people.
class GraphPicturesTest : public WindowFixture {
 protected:
  GraphPicturesTest() {
    window_.panels().show(Panels::Perspective::kConnect);
    window_.graph().setFocus();
  }
  ~GraphPicturesTest() override { Theme::instance().choose(Theme::Choice::kSystem); }

  [[nodiscard]] GraphScene& scene() const { return window_.graph().graph(); }
  [[nodiscard]] bool EventuallyDimmed() const {
    return QTest::qWaitFor([&] { return scene().highlight().dimming() == 1; }, kTestTimeout);
  }
};

TEST_F(GraphPicturesTest, RendersTheHoveredConnection) {
  scene().hover().point("robot/controller/Arm");
  ASSERT_TRUE(EventuallyDimmed());
  scene().hover().showReadout({"robot", "controller", "Arm"},
                              {"connected for 3 min", "round trip 38.0 µs", "1204 calls and events",
                               "mailbox: 0 of 64 used", "0 refused, 0 replaced, 0 events lost"});
  KeepPictures(window_, "graph-hover");
}

TEST_F(GraphPicturesTest, RendersASearchMatchWithTheMap) {
  for (int step = 0; step < 5; ++step) window_.graph().zoomIn();
  KeepPictures(window_, "graph-map");

  window_.graphCommands().search().open();
  QTest::keyClicks(&window_.graphCommands().search().field(), "arm");
  ASSERT_TRUE(EventuallyDimmed());
  window_.graph().fit();
  KeepPictures(window_, "graph-search");
}

TEST_F(GraphPicturesTest, RendersMovedNodes) {
  const QPointF arm = scene().component("robot/arm")->sceneRect().topLeft();
  scene().nodePositions().move({{"robot/arm", arm + QPointF(40, 120)}});
  window_.graph().fit();
  KeepPictures(window_, "graph-moved");
}

TEST_F(GraphPicturesTest, RendersALargeGraphZoomedOut) {
  SystemBuilder large = LargeSystem(12, 20);
  store_.replace(large.catalogue());
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return !IsAnnouncing(store_) && !window_.graph().graph().isArranging(); },
      kTestTimeout));
  window_.graph().fit();
  KeepPictures(window_, "graph-far");
}

}  // namespace
}  // namespace tendon::gui
