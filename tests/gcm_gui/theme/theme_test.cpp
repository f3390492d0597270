#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <gmock/gmock.h>

#include <QApplication>
#include <QLabel>
#include <QSignalSpy>
#include <QStandardItemModel>
#include <QToolTip>
#include <QTreeView>

namespace tendon::gui {
namespace {

class ThemeTest : public testing::Test {
 protected:
  void SetUp() override { theme_.choose(Theme::Choice::kDark); }
  void TearDown() override { theme_.choose(Theme::Choice::kSystem); }

  Theme& theme_ = Theme::instance();
};

TEST_F(ThemeTest, SwitchingTheAppearanceNotifiesOnce) {
  QSignalSpy changed(&theme_, &Theme::changed);

  theme_.choose(Theme::Choice::kLight);

  EXPECT_EQ(changed.count(), 1);
  EXPECT_EQ(theme_.appearance(), Appearance::kLight);
  EXPECT_EQ(QApplication::palette().color(QPalette::Window),
            ColorOf(Token::kPanel, Appearance::kLight));
}

TEST_F(ThemeTest, ChoosingTheSameAppearanceNotifiesNoOne) {
  QSignalSpy changed(&theme_, &Theme::changed);

  theme_.choose(Theme::Choice::kDark);

  EXPECT_EQ(changed.count(), 0);
}

TEST_F(ThemeTest, TheStyleSheetNamesOnlyColoursThatExist) {
  EXPECT_FALSE(qApp->styleSheet().isEmpty());
  EXPECT_FALSE(qApp->styleSheet().contains("${")) << qPrintable(qApp->styleSheet());
}

TEST_F(ThemeTest, ALabelFollowsItsRoleAndTheTheme) {
  QLabel label("text");
  SetRole(label, "mono bad");
  label.ensurePolished();
  EXPECT_EQ(label.palette().color(QPalette::WindowText), theme_.color(Token::kBad));

  theme_.choose(Theme::Choice::kLight);

  EXPECT_EQ(label.palette().color(QPalette::WindowText), ColorOf(Token::kBad, Appearance::kLight));
}

class HostileTextsInTheWindow : public ThemeTest {};

/// A name with markup, as an unknown peer might choose it.
const QString kMarkup = QStringLiteral("<img src=x><b>bold</b> <a href=\"x\">here</a>");

TEST_F(HostileTextsInTheWindow, ALabelShowsMarkupVerbatim) {
  QLabel label(kMarkup);
  QLabel plain;
  plain.setTextFormat(Qt::PlainText);
  plain.setText(kMarkup);

  EXPECT_EQ(label.sizeHint(), plain.sizeHint());

  EXPECT_EQ(label.textFormat(), Qt::PlainText);
  EXPECT_EQ(label.text(), kMarkup);
}

TEST_F(HostileTextsInTheWindow, AToolTipShowsMarkupVerbatim) {
  QToolTip::showText(QPoint(10, 10), kMarkup);

  const QLabel* tip = nullptr;
  for (const QWidget* widget : QApplication::topLevelWidgets()) {
    if (widget->inherits("QTipLabel")) tip = qobject_cast<const QLabel*>(widget);
  }
  ASSERT_NE(tip, nullptr);
  EXPECT_EQ(tip->text(), kMarkup);
  EXPECT_EQ(tip->textFormat(), Qt::PlainText);
  QToolTip::hideText();
}

TEST_F(ThemeTest, TreeRowsHaveTheGridHeight) {
  QStandardItemModel model(1, 1);
  model.setData(model.index(0, 0), "arm");
  QTreeView tree;
  tree.setModel(&model);
  tree.show();

  EXPECT_EQ(tree.visualRect(model.index(0, 0)).height(), kRowHeight);
  EXPECT_EQ(tree.frameWidth(), 0);
}

TEST_F(ThemeTest, DigitsHaveEqualWidth) {
  const QFontMetricsF metrics(theme_.mono());

  for (const char digit : std::string("0123456789-.")) {
    EXPECT_EQ(metrics.horizontalAdvance(QChar(digit)), metrics.horizontalAdvance('0')) << digit;
  }
}

}  // namespace
}  // namespace tendon::gui
