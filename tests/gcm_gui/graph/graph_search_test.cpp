#include <gcm_gui/graph/graph_search.h>
#include <gcm_gui/graph/highlight.h>
#include <gcm_gui/graph/items/component_item.h>
#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "graph/graph_fixture.h"

namespace tendon::gui {
namespace {

class GraphSearchTest : public GraphFixture {
 protected:
  GraphSearchTest() : GraphFixture(LookSystem(0)) {
    Show();
    view_.resize(900, 480);
    view_.show();
    view_.fit();
    QObject::connect(&search_, &GraphSearch::chosen, &view_, &GraphView::goTo);
    search_.open();
  }

  void Type(const char* text) {
    search_.field().clear();
    QTest::keyClicks(&search_.field(), text);
  }
  void Enter(Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(&search_.field(), Qt::Key_Return, modifiers);
  }

  QString CountText() const { return search_.findChild<QLabel*>("graphSearch.count")->text(); }

  GraphSearch search_{view_};
};

TEST_F(GraphSearchTest, MatchesAllWordsInAnyOrder) {
  Type("ARM rob");
  EXPECT_TRUE(search_.found().contains("robot/arm"));
  EXPECT_FALSE(search_.found().contains("desk/view"));

  Type("drives");
  EXPECT_EQ(search_.found(), QStringList{"robot/arm"}) << "by the name of an interface";
  EXPECT_EQ(CountText(), "1 found");

  Type("no such thing");
  EXPECT_TRUE(search_.found().isEmpty());
  EXPECT_EQ(CountText(), "no match");
  EXPECT_TRUE(scene_.highlight().names().empty());
}

TEST_F(GraphSearchTest, HighlightsMatches) {
  Type("desk");

  EXPECT_TRUE(scene_.highlight().names().components.contains("desk/view"));
  EXPECT_FALSE(scene_.highlight().names().components.contains("robot/arm"));

  system_.Component("desk", Task("newcomer", 1, {}));
  Show();
  EXPECT_TRUE(scene_.highlight().names().components.contains("desk/newcomer"));
}

TEST_F(GraphSearchTest, EnterAndShiftEnterStepThroughMatches) {
  Type("desk");
  ASSERT_EQ(search_.found().size(), 3);

  Enter();
  EXPECT_EQ(selection_.current(), search_.found()[0]);
  EXPECT_EQ(CountText(), "1 of 3");
  Enter();
  EXPECT_EQ(selection_.current(), search_.found()[1]);
  Enter(Qt::ShiftModifier);
  Enter(Qt::ShiftModifier);
  EXPECT_EQ(selection_.current(), search_.found()[2]);
  QTest::mouseClick(search_.findChild<QToolButton*>("graphSearch.next"), Qt::LeftButton);
  EXPECT_EQ(selection_.current(), search_.found()[0]);
  EXPECT_TRUE(view_.seen().contains(scene_.component(selection_.current())->sceneRect()));
}

TEST_F(GraphSearchTest, ZoomsInUntilAMatchIsReadable) {
  for (int step = 0; step < 12; ++step) view_.zoomOut();
  const double far_away = view_.transform().m11();

  Type("controller");
  Enter();

  EXPECT_GT(view_.transform().m11(), far_away);
  EXPECT_GE(view_.transform().m11(), 0.5);
  EXPECT_TRUE(view_.seen().contains(scene_.component("robot/controller")->sceneRect()));
}

TEST_F(GraphSearchTest, EscapeClosesItAndRestoresTheFocus) {
  Type("desk");

  QTest::keyClick(&search_.field(), Qt::Key_Escape);

  EXPECT_FALSE(search_.isVisible());
  EXPECT_TRUE(scene_.highlight().names().empty());
  EXPECT_FALSE(search_.leave());
}

}  // namespace
}  // namespace tendon::gui
