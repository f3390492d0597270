#include <gcm_gui/commands/graph_commands.h>
#include <gcm_gui/graph/graph_map.h>
#include <gcm_gui/graph/graph_search.h>
#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/help/tour.h>
#include <gcm_gui/inspector/inspector.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/views/image_view.h>
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QApplication>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollBar>
#include <QTabBar>
#include <QTest>
#include <algorithm>
#include <stdexcept>
#include <string>

#include "window/window_fixture.h"

namespace tendon::gui {
namespace {

const QString kSignal = QStringLiteral("robot/arm/state.Joints.position[0]");

/// Returns true for a widget that Qt creates inside a control with a name.
bool IsInside(const QWidget& widget) {
  const QWidget* above = widget.parentWidget();
  const auto* area = qobject_cast<const QAbstractScrollArea*>(above);
  return (area != nullptr && area->viewport() == &widget) ||
         qobject_cast<const QScrollBar*>(&widget) != nullptr ||
         qobject_cast<const QComboBox*>(above) != nullptr ||
         qobject_cast<const QAbstractSpinBox*>(above) != nullptr ||
         qobject_cast<const QLineEdit*>(above) != nullptr ||
         qobject_cast<const QTabBar*>(above) != nullptr || widget.objectName().startsWith("qt_");
}

/// Returns true if the user can operate the widget, or if it shows information that no text near it
/// contains.
bool NeedsName(const QWidget& widget) {
  const bool is_reached = (widget.focusPolicy() & Qt::TabFocus) != 0;
  const bool is_picture = qobject_cast<const ImageView*>(&widget) != nullptr ||
                          qobject_cast<const GraphMap*>(&widget) != nullptr;
  return widget.isVisible() && !IsInside(widget) &&
         (is_reached || is_picture || qobject_cast<const QAbstractButton*>(&widget) != nullptr);
}

/// Visits everything that is visible in the window; additional parts are opened first.
class AccessibleTest : public WindowFixture {
 protected:
  /// Returns the class and object name of each widget without a name for screen readers.
  [[nodiscard]] QStringList Nameless() const {
    QStringList nameless;
    for (QWidget* widget : window_.findChildren<QWidget*>()) {
      if (!NeedsName(*widget)) continue;
      QAccessibleInterface* told = QAccessible::queryAccessibleInterface(widget);
      const QString name = told == nullptr ? QString() : told->text(QAccessible::Name).trimmed();
      if (!name.isEmpty() && name != widget->objectName()) continue;
      nameless << QStringLiteral("%1 '%2' in '%3'")
                      .arg(widget->metaObject()->className(), widget->objectName(),
                           widget->parentWidget()->objectName());
    }
    return nameless;
  }
  void ExpectNames(const char* where) const {
    EXPECT_EQ(Nameless(), QStringList()) << where << ": " << qPrintable(Nameless().join("; "));
  }
  /// Returns true if repeated Tab reaches the widget before it returns to the start.
  [[nodiscard]] bool IsReached(const QWidget& wanted) const {
    const QWidget* start = window_.focusWidget();
    for (int step = 0; step < 100 && window_.focusWidget() != &wanted; ++step) {
      QTest::keyClick(window_.focusWidget(), Qt::Key_Tab);
      if (window_.focusWidget() == start) break;
    }
    return window_.focusWidget() == &wanted;
  }
  [[nodiscard]] QWidget& Named(const char* name) const {
    for (auto* widget : window_.findChildren<QWidget*>(QString::fromLatin1(name))) {
      if (widget->isVisible()) return *widget;
    }
    throw std::runtime_error(std::string("there is no ") + name);
  }
};

TEST_F(AccessibleTest, TheWindowHasNames) {
  window_.selection().select("robot/arm");

  ExpectNames("window");
}

TEST_F(AccessibleTest, EveryTabPageHasNames) {
  window_.selection().select("robot/arm");
  int pages = 0;
  for (auto* bar : window_.findChildren<QTabBar*>()) {
    const int before = bar->currentIndex();
    for (int tab = 0; tab < bar->count(); ++tab, ++pages) {
      bar->setCurrentIndex(tab);
      QCoreApplication::processEvents();
      ExpectNames(qPrintable(bar->tabText(tab)));
    }
    bar->setCurrentIndex(before);
  }
  EXPECT_GE(pages, 13);
}

TEST_F(AccessibleTest, EveryCardHasNames) {
  const auto expect_names = [this](const char* card, const QString& selected, Qt::Key key) {
    window_.selection().select(selected);
    QTest::keyClick(&window_, key);
    EXPECT_TRUE(Named(card).isVisible());
    ExpectNames(card);
    QTest::keyClick(window_.focusWidget(), Qt::Key_Escape);
  };
  expect_names("lifecycleCard", "robot/arm", Qt::Key_F8);
  expect_names("whyCard", "robot/controller/Arm", Qt::Key_W);
  expect_names("keysCard", "robot/arm", Qt::Key_F1);
  expect_names("candidatePanel", "desk/teleoperation/Robot", Qt::Key_C);
}

TEST_F(AccessibleTest, TheRenameDialogHasNames) {
  QTest::keyClick(&window_, Qt::Key_F2);
  auto* dialog = window_.findChild<QInputDialog*>();
  ASSERT_NE(dialog, nullptr);
  ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->isVisible(); }, kTestTimeout));
  ExpectNames("name");

  dialog->setTextValue("joints");
  QTest::keyClick(dialog, Qt::Key_Return);
  EXPECT_EQ(window_.plots().tabs().name(window_.plots().plot(0)), "joints");
  EXPECT_EQ(window_.findChild<QTabBar*>("plotTabs")->tabText(0), "joints");
}

TEST_F(AccessibleTest, TheCallFormHasNames) {
  window_.selection().select("robot/controller/Control.MoveTo");
  window_.callSelection();

  ExpectNames("call");
}

TEST_F(AccessibleTest, TheTourHasNames) {
  window_.tour().start();
  ExpectNames("tour");

  EXPECT_TRUE(IsReached(Named("tour.skip")));
}

TEST_F(AccessibleTest, TheGraphMapAndSearchHaveNames) {
  window_.graph().setFocus();
  for (int step = 0; step < 6; ++step) QTest::keyClick(&window_.graph(), Qt::Key_Plus);
  QTest::keyClick(&window_, Qt::Key_Slash);
  GraphSearch& search = window_.graphCommands().search();
  QTest::keyClicks(&search.field(), "arm");
  ASSERT_TRUE(window_.graphCommands().map().isVisible());
  ExpectNames("graph");

  EXPECT_EQ(search.field().accessibleDescription(),
            search.findChild<QLabel*>("graphSearch.count")->text());
  EXPECT_FALSE(search.field().accessibleDescription().isEmpty());
  for (const char* button : {"graphSearch.previous", "graphSearch.next", "graphSearch.close"}) {
    EXPECT_TRUE(IsReached(Named(button))) << button;
  }
  QTest::keyClick(window_.focusWidget(), Qt::Key_Space);
  EXPECT_FALSE(search.isVisible());
  EXPECT_TRUE(window_.graph().hasFocus());

  const QRectF before = window_.graph().seen();
  QTest::keyClick(&window_.graph(), Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_NE(window_.graph().seen(), before) << "the frame of the map moves by keys";
}

TEST_F(AccessibleTest, SpacePressesAFocusedButtonOrPauses) {
  window_.plots().currentPlot().canvas()->setFocus();
  ASSERT_TRUE(IsReached(Named("newPlot")));
  QTest::keyClick(window_.focusWidget(), Qt::Key_Space);
  EXPECT_EQ(window_.plots().plotCount(), 2);
  EXPECT_FALSE(window_.plots().isPaused());

  window_.plots().currentPlot().canvas()->setFocus();
  QTest::keyClick(window_.focusWidget(), Qt::Key_Space);
  EXPECT_TRUE(window_.plots().isPaused());
}

TEST_F(AccessibleTest, StackedPlotsHaveNames) {
  window_.plots().addSignal(kSignal, "rad");
  window_.plots().currentPlot().canvas()->setFocus();
  ASSERT_TRUE(IsReached(Named("splitPlot")));
  QTest::keyClick(window_.focusWidget(), Qt::Key_Space);
  ASSERT_EQ(window_.plots().plotCount(), 2);
  window_.plots().addSignal("robot/force_sensor/state.Wrench.force[2]", "N");
  ExpectNames("plots");

  PlotView& above = window_.plots().plot(0);
  PlotView& below = window_.plots().plot(1);
  EXPECT_NE(above.canvas()->accessibleName(), below.canvas()->accessibleName());
  above.canvas()->setFocus();
  EXPECT_EQ(window_.plots().currentIndex(), 0);
  ASSERT_TRUE(IsReached(*below.canvas()));
  EXPECT_EQ(window_.plots().currentIndex(), 1);
  ASSERT_TRUE(IsReached(*below.findChild<QWidget*>("closePlot")));
  QTest::keyClick(window_.focusWidget(), Qt::Key_Space);
  EXPECT_EQ(window_.plots().plotCount(), 1);
}

TEST_F(AccessibleTest, KeysReadAndHideMarks) {
  PlotView& plot = window_.plots().currentPlot();
  window_.plots().addSignal(kSignal, "rad");
  window_.plots().addMark({.time_ns = plot.now(), .label = "Moved", .text = "call robot/arm.Move"});
  plot.canvas()->setFocus();
  const auto told = [&] { return plot.canvas()->accessibleDescription(); };
  EXPECT_TRUE(QTest::qWaitFor([&] { return told() == "call robot/arm.Move"; }, kTestTimeout))
      << told().toStdString();

  QTest::keyClick(plot.canvas(), Qt::Key_E);
  EXPECT_FALSE(window_.plots().areMarksShown());
  EXPECT_TRUE(QTest::qWaitFor([&] { return told().isEmpty(); }, kTestTimeout));

  const QPoint middle = plot.canvas()->rect().center();
  QContextMenuEvent wanted(QContextMenuEvent::Keyboard, middle, plot.canvas()->mapToGlobal(middle));
  QApplication::sendEvent(plot.canvas(), &wanted);
  auto* menu = window_.findChild<QMenu*>("plotMenu");
  ASSERT_NE(menu, nullptr);
  menu->close();
}

TEST_F(AccessibleTest, APictureInTheInspectorHasNames) {
  window_.selection().select("robot/arm");
  auto& tabs = *window_.inspector().findChild<QTabBar*>("inspectorTabs.tabs");
  tabs.setFocus();
  QTest::keyClick(&tabs, Qt::Key_Right);
  source_.sendPicture("robot/arm/state.Joints",
                      {.width = 8, .height = 8, .encoding = "mono8", .data = QByteArray(64, 'x')});
  const auto is_shown = [&] {
    const auto views = window_.inspector().findChildren<ImageView*>();
    return std::any_of(views.begin(), views.end(),
                       [](const ImageView* view) { return view->isVisible(); });
  };
  ASSERT_TRUE(QTest::qWaitFor(is_shown, kTestTimeout));

  ExpectNames("values");
}

TEST_F(AccessibleTest, TheKeyCardAndThePaletteHaveNames) {
  QTest::keyClick(&window_, Qt::Key_F1);
  ExpectNames("keys");
  QTest::keyClick(window_.focusWidget(), Qt::Key_Escape);
  QTest::keyClick(&window_, Qt::Key_K, Qt::ControlModifier);
  ExpectNames("palette");
}

}  // namespace
}  // namespace tendon::gui
