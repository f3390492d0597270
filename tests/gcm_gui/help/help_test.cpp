#include <gcm_gui/commands/commands.h>
#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/help/libraries.h>
#include <gcm_gui/help/shortcuts_card.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/catalogue_panel.h>
#include <gcm_gui/views/catalogue_tree.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QDialog>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTest>

#include "support/picture_file.h"
#include "window/window_fixture.h"

namespace tendon::gui {
namespace {

class HelpTest : public WindowFixture {
 protected:
  ~HelpTest() override { Theme::instance().choose(Theme::Choice::kSystem); }

  [[nodiscard]] ShortcutsCard& keys() const { return *window_.findChild<ShortcutsCard*>(); }
  [[nodiscard]] QStringList words() const {
    QStringList words;
    for (const auto* label : keys().findChildren<QLabel*>()) words.append(label->text());
    return words;
  }
  QDialog* OpenAbout() {
    auto* help = window_.findChild<QMenuBar*>("menus")->actions().back()->menu();
    help->findChild<QAction*>("About gcm-gui")->trigger();
    return window_.findChild<QDialog*>("about");
  }
  static void Keep(QWidget& widget, const QString& name) {
    EXPECT_TRUE(widget.grab().save(PictureFile(name)));
  }
};

TEST_F(HelpTest, F1TogglesAllKeys) {
  window_.catalogue().tree().setFocus();
  QTest::keyClick(&window_, Qt::Key_F1);
  ASSERT_TRUE(keys().isVisible());

  const QStringList shown = words();
  for (const QAction* action : window_.actions()) {
    if (action->objectName().isEmpty() || action->shortcut().isEmpty()) continue;
    EXPECT_TRUE(shown.contains(PlainText(*action))) << qPrintable(action->text());
  }
  EXPECT_TRUE(shown.contains("In a plot"));

  QTest::keyClick(window_.focusWidget(), Qt::Key_F1);
  EXPECT_FALSE(keys().isVisible());
  QTest::keyClick(&window_, Qt::Key_Question);
  EXPECT_TRUE(keys().isVisible());
  QTest::keyClick(window_.focusWidget(), Qt::Key_Escape);
  EXPECT_FALSE(keys().isVisible());
  EXPECT_TRUE(window_.catalogue().tree().hasFocus());
}

TEST_F(HelpTest, AQuestionMarkShowsTheKeysOfTheFocusedPart) {
  const auto titles = [this] {
    QStringList found;
    for (const auto* label : keys().findChildren<QLabel*>()) found.append(label->text());
    return found;
  };
  window_.graph().setFocus();
  QTest::keyClick(&window_.graph(), Qt::Key_Question);

  EXPECT_TRUE(keys().isVisible());
  EXPECT_TRUE(titles().contains("In the graph"));
  EXPECT_TRUE(titles().contains("Everywhere"));
  EXPECT_FALSE(titles().contains("In a plot"));
  QTest::keyClick(window_.focusWidget(), Qt::Key_Question);
  EXPECT_FALSE(keys().isVisible());

  QTest::keyClick(window_.focusWidget(), Qt::Key_F1);
  EXPECT_TRUE(titles().contains("In a plot"));
}

TEST_F(HelpTest, AQuestionMarkCanBeTypedInATextField) {
  QTest::keyClick(&window_, Qt::Key_F, Qt::ControlModifier);

  QTest::keyClicks(&window_.catalogue().filterField(), "a?");

  EXPECT_EQ(window_.catalogue().filterField().text(), "a?");
  EXPECT_FALSE(keys().isVisible());
}

TEST_F(HelpTest, RendersTheKeys) {
  window_.resize(1280, 900);
  for (const auto& [choice, name] : {std::pair{Theme::Choice::kDark, "keys-dark"},
                                     std::pair{Theme::Choice::kLight, "keys-light"}}) {
    Theme::instance().choose(choice);
    QTest::keyClick(&window_, Qt::Key_F1);
    QCoreApplication::processEvents();
    Keep(window_, name);
    keys().close();
  }
}

TEST_F(HelpTest, AboutShowsAndCopiesTheVersions) {
  QDialog* about = OpenAbout();
  ASSERT_NE(about, nullptr);
  const QString versions = about->findChild<QLabel*>("about.versions")->text();
  EXPECT_TRUE(versions.contains(QString("Qt ") + qVersion())) << qPrintable(versions);
  for (const char* name : {"Tendon ", "Qwt 6.", "Protocol "}) {
    EXPECT_TRUE(versions.contains(name)) << name << " in " << qPrintable(versions);
  }

  QTest::mouseClick(about->findChild<QPushButton*>("about.copy"), Qt::LeftButton);
  EXPECT_EQ(QGuiApplication::clipboard()->text(), versions);

  QTest::mouseClick(about->findChild<QPushButton*>("about.close"), Qt::LeftButton);
  EXPECT_FALSE(about->isVisible());
}

TEST_F(HelpTest, AboutShowsTheLicenceOfEachLibrary) {
  QDialog* about = OpenAbout();
  auto* choice = about->findChild<QComboBox*>("about.library");
  const auto* terms = about->findChild<QPlainTextEdit*>("about.terms");
  EXPECT_TRUE(terms->toPlainText().startsWith("BSD 3-Clause License"));
  Theme::instance().choose(Theme::Choice::kLight);
  Keep(*about, "about-light");
  Theme::instance().choose(Theme::Choice::kDark);
  Keep(*about, "about-dark");

  QString before = terms->toPlainText();
  for (int row = 1; row < choice->count(); ++row) {
    QTest::keyClick(choice, Qt::Key_Down);
    EXPECT_NE(terms->toPlainText(), before) << qPrintable(choice->currentText());
    before = terms->toPlainText();
    EXPECT_GT(before.size(), 500) << qPrintable(choice->currentText());
  }
}

TEST(LibrariesInUse, NamesEveryLicenceText) {
  QSet<QString> used;
  for (const Library& library : LibrariesInUse()) {
    EXPECT_FALSE(library.licence.isEmpty());
    EXPECT_FALSE(library.terms().isEmpty()) << qPrintable(library.name);
    for (const QString& text : library.texts) used.insert(text + ".txt");
  }
  EXPECT_TRUE(used.contains("tendon.txt"));
}

}  // namespace
}  // namespace tendon::gui
