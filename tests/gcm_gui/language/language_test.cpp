#include <gcm_gui/language/language.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/theme/theme.h>
#include <gtest/gtest.h>
#include <tests/support/locales.h>

#include <QAbstractButton>
#include <QLabel>
#include <QRegularExpression>
#include <QTest>
#include <QTranslator>
#include <clocale>

#include "support/picture_file.h"
#include "window/window_fixture.h"

namespace tendon::gui {
namespace {

/// Removes the translations that SetLanguage() has installed.
void SpeakEnglish() {
  for (auto* one : QCoreApplication::instance()->findChildren<QTranslator*>()) delete one;
}

class LanguageTest : public ::testing::Test {
 protected:
  ~LanguageTest() override { SpeakEnglish(); }
};

TEST_F(LanguageTest, FollowsTheDesktop) {
  EXPECT_EQ(Words::tr("Nothing is wrong."), "Nothing is wrong.");
  SetLanguage(QLocale(QStringLiteral("de_DE")));
  EXPECT_EQ(Words::tr("Nothing is wrong."), "Es ist alles in Ordnung.");
  SpeakEnglish();
  SetLanguage(QLocale(QStringLiteral("fr_CA")));
  EXPECT_EQ(Words::tr("Nothing is wrong."), "Tout va bien.");
}

TEST_F(LanguageTest, NumbersAreTheSameInAllLanguages) {
  test::Locales locales;
  ASSERT_TRUE(locales.Use("de_DE")) << "localedef did not make de_DE";
  ASSERT_STREQ(std::localeconv()->decimal_point, ",");
  QLocale::setDefault(QLocale(QStringLiteral("de_DE")));
  ASSERT_EQ(QLocale().toString(1234.5, 'f', 1), "1.234,5");

  SetLanguage(QLocale(QStringLiteral("de_DE")));

  EXPECT_EQ(QLocale().toString(1234.5, 'f', 1), "1234.5");
  EXPECT_STREQ(std::localeconv()->decimal_point, ".");
}

TEST_F(LanguageTest, FallsBackToEnglish) {
  SetLanguage(QLocale(QStringLiteral("ja_JP")));
  EXPECT_EQ(Words::tr("Nothing is wrong."), "Nothing is wrong.");
}

TEST_F(LanguageTest, ListsTheLanguages) { EXPECT_EQ(Languages(), (QStringList{"de", "fr"})); }

/// A base class that sets the locale before the members of the window are created.
struct Speaking {
  explicit Speaking(const char* language) { SetLanguage(QLocale(QString(language))); }
  ~Speaking() { SpeakEnglish(); }
};

class WindowInLanguage : private Speaking, public WindowFixture {
 protected:
  explicit WindowInLanguage(const char* language) : Speaking(language) {}
  ~WindowInLanguage() override { Theme::instance().choose(Theme::Choice::kSystem); }

  /// Returns the widgets whose texts are wider than the available room.
  QStringList cutOff() {
    QStringList found;
    for (auto* button : window_.findChildren<QAbstractButton*>()) {
      const bool has_words = button->text().contains(QRegularExpression("[[:alpha:]]{3}"));
      if (has_words && button->isVisible() && button->width() < button->minimumSizeHint().width())
        found << button->objectName() + ": " + button->text();
    }
    for (auto* label : window_.findChildren<QLabel*>()) {
      if (label->isVisible() && !label->wordWrap() && label->pixmap().isNull() &&
          label->width() < label->minimumSizeHint().width())
        found << label->objectName() + ": " + label->text();
    }
    return found;
  }

  void look(const QString& name) {
    Theme::instance().choose(Theme::Choice::kLight);
    window_.selection().select("robot/arm");
    EXPECT_TRUE(QTest::qWaitFor([this] { return cutOff().isEmpty(); }, kTestTimeout))
        << cutOff().join('\n').toStdString();
    EXPECT_TRUE(window_.grab().save(PictureFile(name)));
  }
};

struct GermanWindow : WindowInLanguage {
  GermanWindow() : WindowInLanguage("de_DE") {}
};
struct FrenchWindow : WindowInLanguage {
  FrenchWindow() : WindowInLanguage("fr_FR") {}
};

TEST_F(GermanWindow, FitsItsTexts) { look("window-german"); }
TEST_F(FrenchWindow, FitsItsTexts) { look("window-french"); }

}  // namespace
}  // namespace tendon::gui
