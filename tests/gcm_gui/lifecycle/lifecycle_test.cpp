#include <gcm_gui/call/hold_button.h>
#include <gcm_gui/commands/command_palette.h>
#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/graph/items/component_item.h>
#include <gcm_gui/graph/layout/node_metrics.h>
#include <gcm_gui/lifecycle/lifecycle_card.h>
#include <gcm_gui/views/catalogue_panel.h>
#include <gcm_gui/views/catalogue_tree.h>
#include <gcm_gui/window/notice_line.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QContextMenuEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QTest>

#include "support/pictures.h"
#include "window/window_fixture.h"

namespace tendon::gui {
namespace {

class LifecycleTest : public WindowFixture {
 protected:
  [[nodiscard]] LifecycleCard& card() const { return *window_.findChild<LifecycleCard*>(); }
  [[nodiscard]] QString Notice() const { return window_.findChild<NoticeLine*>()->text(); }
  [[nodiscard]] HoldButton& Button(const char* name) const {
    return *window_.findChild<HoldButton*>(name);
  }
  bool IsAsked(const QStringList& orders) {
    return QTest::qWaitFor([&] { return actions_.asked == orders; }, kTestTimeout);
  }
  /// Returns the menu that opens at this position.
  static QMenu* MenuAt(QWidget& viewport, const QPoint& place) {
    QContextMenuEvent event(QContextMenuEvent::Mouse, place, viewport.mapToGlobal(place));
    QApplication::sendEvent(&viewport, &event);
    return qobject_cast<QMenu*>(QApplication::activePopupWidget());
  }
  static void Choose(QMenu& menu, const char* name) {
    for (QAction* action : menu.actions()) {
      if (action->objectName() == QString::fromLatin1(name)) {
        QTest::mouseClick(&menu, Qt::LeftButton, {}, menu.actionGeometry(action).center());
      }
    }
  }
};

TEST_F(LifecycleTest, AKeyOpensTheCardAndEnterConfirms) {
  window_.selection().select("robot/arm/Drives.Stop");
  QTest::keyClick(&window_, Qt::Key_F8);
  ASSERT_TRUE(card().isVisible());
  EXPECT_EQ(window_.findChild<QLabel*>("lifecycle.names")->text(), "robot/arm");
  EXPECT_TRUE(actions_.asked.isEmpty());
  KeepPictures(window_, "lifecycle-card");

  QTest::keyClick(&card(), Qt::Key_Return);

  EXPECT_TRUE(IsAsked({"stop robot/arm"}));
  EXPECT_FALSE(card().isVisible());
}

TEST_F(LifecycleTest, IgnoresKeyRepeat) {
  window_.selection().select("robot/arm");
  QTest::keyClick(&window_, Qt::Key_F8);

  QKeyEvent repeated(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier, {}, true);
  QApplication::sendEvent(&card(), &repeated);

  EXPECT_TRUE(card().isVisible());
  EXPECT_TRUE(actions_.asked.isEmpty());
  QTest::keyClick(&card(), Qt::Key_Escape);
  EXPECT_FALSE(card().isVisible());
  EXPECT_TRUE(actions_.asked.isEmpty());
}

TEST_F(LifecycleTest, ThePaletteSuspendsAllSelectedComponents) {
  window_.selection().setPaths({"robot/arm", "desk/host_monitor", "robot/arm/Drives"});
  QTest::keyClick(&window_, Qt::Key_K, Qt::ControlModifier);
  auto* field = window_.findChild<QLineEdit*>("palette.field");
  QTest::keyClicks(field, "suspend");
  QTest::keyClick(field, Qt::Key_Return);
  ASSERT_TRUE(card().isVisible());

  QTest::keyClick(&card(), Qt::Key_Return);

  EXPECT_TRUE(IsAsked({"suspend robot/arm", "suspend desk/host_monitor"}));
}

TEST_F(LifecycleTest, ReportsAnImpossibleTransitionWithoutAsking) {
  window_.selection().select("robot/arm");
  QTest::keyClick(&window_, Qt::Key_F6);

  EXPECT_FALSE(card().isVisible());
  EXPECT_TRUE(Notice().startsWith("component 'arm' is active")) << Notice().toStdString();
  window_.selection().clear();
  QTest::keyClick(&window_, Qt::Key_F6);
  EXPECT_TRUE(Notice().startsWith("Select a component"));
}

TEST_F(LifecycleTest, AnInspectorButtonMustBeHeld) {
  window_.selection().select("robot/arm");
  EXPECT_FALSE(Button("lifecycle.start").isEnabled());
  EXPECT_TRUE(Button("lifecycle.start").toolTip().contains("is active"));
  HoldButton& stop = Button("lifecycle.stop");

  QTest::mouseClick(&stop, Qt::LeftButton);
  EXPECT_TRUE(actions_.asked.isEmpty());
  EXPECT_TRUE(Notice().startsWith("Nothing was done"));

  QTest::mousePress(&stop, Qt::LeftButton);
  EXPECT_TRUE(IsAsked({"stop robot/arm"}));
  QTest::mouseRelease(&stop, Qt::LeftButton);
  EXPECT_EQ(actions_.asked.size(), 1);
}

TEST_F(LifecycleTest, TheCardButtonMustBeHeld) {
  window_.selection().select("robot/arm");
  QTest::keyClick(&window_, Qt::Key_F9);
  QTest::mousePress(&Button("lifecycle.confirm"), Qt::LeftButton);

  EXPECT_TRUE(IsAsked({"restart robot/arm"}));
}

TEST_F(LifecycleTest, TheCatalogueMenuOpensOnlyOnARowOrByKey) {
  CatalogueTree& tree = window_.catalogue().tree();
  window_.selection().select("robot/arm");
  window_.catalogue().filterField().setText("robot/arm type:component");
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        return !tree.indexAt(tree.viewport()->rect().bottomLeft() + QPoint(20, -4)).isValid();
      },
      kTestTimeout));

  EXPECT_EQ(MenuAt(*tree.viewport(), tree.viewport()->rect().bottomLeft() + QPoint(20, -4)),
            nullptr);
  QContextMenuEvent key(QContextMenuEvent::Keyboard, {}, {});
  QApplication::sendEvent(&tree, &key);
  auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
  ASSERT_NE(menu, nullptr);
  menu->close();
}

TEST_F(LifecycleTest, EnterOnTheCardButtonConfirms) {
  window_.selection().select("robot/arm");
  QTest::keyClick(&window_, Qt::Key_F8);
  Button("lifecycle.confirm").setFocus();
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return Button("lifecycle.confirm").hasFocus(); }, kTestTimeout));

  QTest::keyClick(&Button("lifecycle.confirm"), Qt::Key_Return);

  EXPECT_TRUE(IsAsked({"stop robot/arm"}));
  EXPECT_FALSE(Notice().startsWith("Nothing was done")) << Notice().toStdString();
}

TEST_F(LifecycleTest, CatalogueRowsAndGraphNodesHaveAMenu) {
  CatalogueTree& tree = window_.catalogue().tree();
  tree.reveal("robot/arm");
  QTest::mouseClick(tree.viewport(), Qt::LeftButton, {},
                    tree.visibleRows().value("robot/arm").center());
  QMenu* menu = MenuAt(*tree.viewport(), tree.visibleRows().value("robot/arm").center());
  ASSERT_NE(menu, nullptr);
  EXPECT_FALSE(window_.findChild<QAction*>("Start")->isEnabled()) << "it is active";
  EXPECT_FALSE(window_.findChild<QAction*>("Start")->toolTip().isEmpty());
  Choose(*menu, "Stop");
  EXPECT_TRUE(card().isVisible());
  EXPECT_TRUE(window_.findChild<QAction*>("Start")->isEnabled()) << "its key says why";
  card().close();

  GraphView& graph = window_.graph();
  const QRectF place = graph.graph().component("desk/host_monitor")->sceneRect();
  const QPointF title = place.topLeft() + QPointF(kNodeHead, kNodeHead / 2);
  menu = MenuAt(*graph.viewport(), graph.mapFromScene(title));
  ASSERT_NE(menu, nullptr);
  EXPECT_EQ(window_.selection().current(), "desk/host_monitor");
  Choose(*menu, "Stop");
  QTest::keyClick(&card(), Qt::Key_Return);
  EXPECT_TRUE(IsAsked({"stop desk/host_monitor"}));
}

TEST_F(LifecycleTest, AReadOnlyWindowExplainsItself) {
  WindowParts parts = Parts();
  parts.read_only = "this window cannot change anything";
  MainWindow window(parts);
  window.show();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window, kTestTimeout));
  window.selection().select("robot/arm");

  QTest::keyClick(&window, Qt::Key_F8);

  EXPECT_FALSE(window.findChild<LifecycleCard*>()->isVisible());
  EXPECT_EQ(window.findChild<NoticeLine*>()->text(), parts.read_only);
  EXPECT_FALSE(window.findChild<HoldButton*>("lifecycle.stop")->isEnabled());
  EXPECT_EQ(window.findChild<HoldButton*>("lifecycle.stop")->toolTip(), parts.read_only);
  EXPECT_FALSE(window.findChild<QAction*>("Stop")->isEnabled());
}

TEST_F(LifecycleTest, TheCardExplainsAResumeAndItsSuspension) {
  ComponentDescription arm = *system_.catalogue().FindComponent("robot", "arm");
  arm.state = ComponentState::kSuspended;
  system_.Component("robot", arm);
  Show();
  window_.selection().select("robot/arm");

  QTest::keyClick(&window_, Qt::Key_F6);

  ASSERT_TRUE(card().isVisible());
  EXPECT_EQ(window_.findChild<QLabel*>("lifecycle.names")->text(), "robot/arm · suspended for 0 s");
  const QString advice = window_.findChild<QLabel*>("lifecycle.advice")->text();
  EXPECT_TRUE(advice.startsWith(
      "The component is notified that it was suspended. If its author has written "
      "code for this case, the component starts from the current situation;"))
      << advice.toStdString();
  EXPECT_TRUE(advice.contains("This order can move something")) << advice.toStdString();
  EXPECT_TRUE(Button("lifecycle.start")
                  .toolTip()
                  .startsWith("The component is notified that it was suspended"));
  KeepPictures(window_, "resume-card");
}

TEST_F(LifecycleTest, TheCardExplainsARestart) {
  window_.selection().select("robot/arm");

  QTest::keyClick(&window_, Qt::Key_F9);

  EXPECT_EQ(window_.findChild<QLabel*>("lifecycle.names")->text(), "robot/arm");
  EXPECT_TRUE(window_.findChild<QLabel*>("lifecycle.advice")
                  ->text()
                  .startsWith("The component starts from the beginning"));
}

}  // namespace
}  // namespace tendon::gui
