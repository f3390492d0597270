#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/views/catalogue_panel.h>
#include <gcm_gui/views/catalogue_tree.h>
#include <gcm_gui/views/row_view.h>
#include <gcm_gui/window/notice_line.h>
#include <gtest/gtest.h>

#include <QTabBar>
#include <QTest>

#include "window/window_fixture.h"

namespace tendon::gui {
namespace {

const PortName kNeeds{Side::kRequired, {"desk", "teleoperation", "Robot"}};
const PortName kOffers{Side::kProvided, {"robot", "controller", "Control"}};
const QString kConnect = "connect desk/teleoperation/Robot robot/controller/Control";

void ClickOn(MainWindow& window, const PortName& port) {
  GraphView& graph = window.graph();
  QTest::mouseClick(graph.viewport(), Qt::LeftButton, {}, graph.pointOf(port).value());
}

/// Tests connecting from the table of connections, and in a read-only window.
class ConnectingTest : public WindowFixture {
 protected:
  void ShowTable() {
    auto& tabs = *window_.findChild<QTabBar*>("centre.tabs");
    QTest::mouseClick(&tabs, Qt::LeftButton, {}, tabs.tabRect(1).center());
  }
  [[nodiscard]] RowView& table() const { return *window_.findChild<RowView*>("connections"); }
  void ClickCell(int row, int column) {
    QTest::mouseClick(table().viewport(), Qt::LeftButton, {},
                      table().visualRect(table().model()->index(row, column)).center());
  }
  [[nodiscard]] int RowOf(const QString& required) const {
    for (int row = 0; row < table().model()->rowCount(); ++row) {
      if (table().model()->index(row, 0).data().toString() == required) return row;
    }
    return -1;
  }
};

TEST_F(ConnectingTest, ReplacesAConnectionFromTheTableInOneStep) {
  system_.Connect(kNeeds.name, {"robot", "arm", "Drives"});
  Show();
  ShowTable();
  ClickCell(RowOf("desk/teleoperation/Robot"), 0);
  EXPECT_EQ(window_.selection().current(), "desk/teleoperation/Robot");

  QTest::keyClick(&window_, Qt::Key_C);
  ASSERT_TRUE(window_.connectMode().active());
  QTest::keyClick(window_.focusWidget(), Qt::Key_Return);

  EXPECT_EQ(actions_.asked,
            QStringList{"connect desk/teleoperation/Robot robot/controller/Control"});
}

TEST_F(ConnectingTest, TheOtherEndCanBePickedInTheTable) {
  system_.Connect({"desk", "view", "Other"}, kOffers.name);
  Show();
  ClickOn(window_, kNeeds);
  ASSERT_TRUE(window_.connectMode().active());

  ShowTable();
  ClickCell(RowOf("desk/view/Other"), 1);

  EXPECT_EQ(actions_.asked, QStringList{kConnect});
}

TEST_F(ConnectingTest, ArrowKeysSelectInTheTable) {
  ShowTable();
  ClickCell(0, 0);
  table().setFocus();

  QTest::keyClick(&table(), Qt::Key_Down);

  EXPECT_EQ(window_.selection().current(), table().model()->index(1, 0).data().toString());
}

class ReadOnlyTest : public ConnectingTest {
 protected:
  ReadOnlyTest() {
    only_looks_.show();
    only_looks_.activateWindow();
    (void)QTest::qWaitForWindowActive(&only_looks_, kTestTimeout);
  }
  [[nodiscard]] QString Refused() const { return only_looks_.findChild<NoticeLine*>()->text(); }
  void ExpectRefusal(const char* how) {
    EXPECT_EQ(Refused(), "this window cannot change anything") << how;
    EXPECT_TRUE(actions_.asked.isEmpty()) << how;
    EXPECT_FALSE(only_looks_.connectMode().active()) << how;
    only_looks_.findChild<NoticeLine*>()->showNotice({});
  }

  [[nodiscard]] WindowParts ReadOnlyParts() {
    WindowParts parts = Parts();
    parts.read_only = "this window cannot change anything";
    return parts;
  }

  MainWindow only_looks_{ReadOnlyParts()};
};

TEST_F(ReadOnlyTest, EveryWayToConnectIsRefusedWithAReason) {
  ClickOn(only_looks_, kNeeds);
  ExpectRefusal("a click on a port");

  GraphView& graph = only_looks_.graph();
  const QPoint from = graph.pointOf(kNeeds).value();
  const QPoint to = graph.pointOf(kOffers).value();
  QTest::mousePress(graph.viewport(), Qt::LeftButton, {}, from);
  QTest::mouseMove(graph.viewport(), (from + to) / 2);
  QTest::mouseMove(graph.viewport(), to);
  QTest::mouseRelease(graph.viewport(), Qt::LeftButton, {}, to);
  ExpectRefusal("a drag from port to port");

  only_looks_.selection().select("desk/teleoperation/Robot");
  QTest::keyClick(&only_looks_, Qt::Key_C);
  ExpectRefusal("C");
  only_looks_.selection().select("robot/controller/Arm");
  QTest::keyClick(&only_looks_, Qt::Key_D);
  ExpectRefusal("D");
  QTest::keyClick(&only_looks_, Qt::Key_Z, Qt::ControlModifier);
  ExpectRefusal("Ctrl+Z");

  Q_EMIT only_looks_.catalogue().tree().connectRequested("desk/teleoperation/Robot");
  ExpectRefusal("the tree");
}

}  // namespace
}  // namespace tendon::gui
