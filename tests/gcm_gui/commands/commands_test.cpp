#include <gcm_gui/commands/command_palette.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/catalogue_panel.h>
#include <gcm_gui/views/catalogue_tree.h>
#include <gcm_gui/views/row_view.h>
#include <gcm_gui/window/notice_line.h>
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QApplication>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSet>
#include <QTabBar>
#include <QTest>

#include "window/window_fixture.h"

namespace tendon::gui {
namespace {

class CommandsTest : public WindowFixture {
 protected:
  [[nodiscard]] QMenuBar& bar() const { return *window_.findChild<QMenuBar*>("menus"); }
  [[nodiscard]] CommandPalette& palette() const { return *window_.findChild<CommandPalette*>(); }
  [[nodiscard]] QLineEdit& field() const { return *window_.findChild<QLineEdit*>("palette.field"); }
  [[nodiscard]] QString firstRow() const {
    return window_.findChild<RowView*>("palette.list")->model()->index(0, 0).data().toString();
  }
  void OpenPalette() { QTest::keyClick(&window_, Qt::Key_K, Qt::ControlModifier); }
};

TEST_F(CommandsTest, TheMouseOpensAMenuAndChoosesAnEntry) {
  QAction* plot = bar().actions().at(1);
  QTest::mouseClick(&bar(), Qt::LeftButton, {}, bar().actionGeometry(plot).center());
  ASSERT_EQ(QApplication::activePopupWidget(), plot->menu());

  const auto actions = plot->menu()->actions();
  const auto pause = std::find_if(actions.begin(), actions.end(), [](const QAction* action) {
    return action->objectName() == "Pause view";
  });
  ASSERT_NE(pause, actions.end());
  QTest::mouseClick(plot->menu(), Qt::LeftButton, {},
                    plot->menu()->actionGeometry(*pause).center());

  EXPECT_TRUE(window_.plots().isPaused());
  EXPECT_TRUE((*pause)->isChecked());
  QTest::keyClick(&window_, Qt::Key_Space);
  EXPECT_FALSE(window_.plots().isPaused());
  EXPECT_FALSE((*pause)->isChecked());
}

TEST_F(CommandsTest, ASmallWindowShowsAllMenusAndThePlotName) {
  window_.resize(1024, 700);
  QCoreApplication::processEvents();
  ASSERT_LE(window_.width(), 1024);

  for (QAction* menu : bar().actions()) {
    EXPECT_TRUE(bar().rect().contains(bar().actionGeometry(menu))) << qPrintable(menu->text());
  }
  const auto* tabs = window_.findChild<QTabBar*>("plotTabs");
  EXPECT_GE(tabs->width(), tabs->tabRect(0).width());
}

TEST_F(CommandsTest, ShortcutsAreUnique) {
  QSet<QKeySequence> keys;
  for (const QAction* action : window_.actions()) {
    for (const QKeySequence& key : action->shortcuts()) {
      EXPECT_FALSE(keys.contains(key)) << qPrintable(key.toString());
      keys.insert(key);
    }
  }
  EXPECT_GE(keys.size(), 12);
}

TEST_F(CommandsTest, ThePaletteListsCommandsAndEnterRunsOne) {
  OpenPalette();
  ASSERT_TRUE(palette().isVisible());
  EXPECT_TRUE(field().hasFocus());
  EXPECT_EQ(firstRow(), "Open a system file");

  QTest::keyClicks(&field(), "pause");
  EXPECT_EQ(firstRow(), "Pause view");
  QTest::keyClick(&field(), Qt::Key_Return);

  EXPECT_TRUE(window_.plots().isPaused());
  EXPECT_FALSE(palette().isVisible());
}

TEST_F(CommandsTest, ThePaletteSelectsAnItemByName) {
  OpenPalette();
  QTest::keyClicks(&field(), "getwrench");
  EXPECT_EQ(firstRow(), "robot/controller/Force.GetWrench");

  QTest::keyClick(&field(), Qt::Key_Down);
  QTest::keyClick(&field(), Qt::Key_Return);

  EXPECT_EQ(window_.selection().current(), "robot/force_sensor/Wrench.GetWrench");
  EXPECT_TRUE(
      window_.catalogue().tree().visibleRows().contains("robot/force_sensor/Wrench.GetWrench"));
}

TEST_F(CommandsTest, ThePaletteModelIsConsistent) {
  PaletteModel model(window_.actions(), window_.catalogueModel());
  const QAbstractItemModelTester tester(&model);

  for (const char* words : {"", "pause", "arm", "robot arm", "nothing of the kind", ""}) {
    model.find(QString::fromLatin1(words));
  }

  EXPECT_GE(model.rowCount(), 12);
}

TEST_F(CommandsTest, ThePaletteMatchesOmittedLetters) {
  OpenPalette();
  QTest::keyClicks(&field(), "psvw");
  EXPECT_EQ(firstRow(), "Pause view");

  field().clear();
  QTest::keyClicks(&field(), "frcsnsr");
  EXPECT_EQ(firstRow(), "robot/force_sensor");
}

TEST_F(CommandsTest, ExactMatchesHideFuzzyOnes) {
  PaletteModel model(window_.actions(), window_.catalogueModel());

  model.find(QStringLiteral("arm"));

  ASSERT_GT(model.rowCount(), 0);
  for (int row = 0; row < model.rowCount(); ++row) {
    const QString text = model.index(row, 0).data().toString();
    EXPECT_TRUE(text.contains("arm", Qt::CaseInsensitive)) << text.toStdString();
  }
}

TEST_F(CommandsTest, AnExactNameComesBeforeItsChildren) {
  OpenPalette();
  QTest::keyClicks(&field(), "arm");

  EXPECT_EQ(firstRow(), "robot/arm");
}

TEST_F(CommandsTest, EscapeAndAClickElsewhereCloseThePalette) {
  window_.catalogue().tree().setFocus();
  OpenPalette();
  QTest::keyClicks(&field(), "p");
  QTest::keyClick(&field(), Qt::Key_Escape);
  EXPECT_FALSE(palette().isVisible());
  EXPECT_TRUE(window_.catalogue().tree().hasFocus());
  EXPECT_TRUE(window_.plots().paths().isEmpty()) << "typing is no command";

  QTest::mouseClick(window_.findChild<QPushButton*>("searchOrRun"), Qt::LeftButton);
  EXPECT_TRUE(palette().isVisible());
  QTest::mouseClick(&window_.catalogue().filterField(), Qt::LeftButton);
  window_.catalogue().filterField().setFocus();
  EXPECT_FALSE(palette().isVisible());
}

TEST_F(CommandsTest, SavingAnEmptyPlotGivesANotice) {
  QTest::keyClick(&window_, Qt::Key_E, Qt::ControlModifier);

  EXPECT_TRUE(window_.findChild<NoticeLine*>()->text().startsWith("There is nothing to save"));
}

}  // namespace
}  // namespace tendon::gui
