#include <gcm_gui/theme/icon.h>
#include <gcm_gui/theme/theme.h>
#include <gmock/gmock.h>

#include <QDir>
#include <QImage>
#include <QPainter>
#include <algorithm>

namespace tendon::gui {
namespace {

QImage Drawn(const QIcon& icon, int size = 16, QIcon::Mode mode = QIcon::Normal) {
  return icon.pixmap(QSize(size, size), mode).toImage().convertToFormat(QImage::Format_ARGB32);
}

// Returns the colour of the most opaque pixel.
QRgb ColorOf(const QImage& image) {
  QRgb strongest = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (qAlpha(image.pixel(x, y)) > qAlpha(strongest)) strongest = image.pixel(x, y);
    }
  }
  return strongest;
}

TEST(ThemeIcon, DrawsEveryIconInTheGivenColour) {
  Theme::instance().choose(Theme::Choice::kDark);
  const QStringList files = QDir(":/tendon/icons").entryList({"*.svg"});
  ASSERT_GE(files.size(), 10);

  for (const QString& file : files) {
    const QRgb color = ColorOf(Drawn(ThemeIcon(file.chopped(4), Token::kAccent), 64));
    EXPECT_EQ(QColor(color), Theme::instance().color(Token::kAccent)) << qPrintable(file);
  }
}

TEST(ThemeIcon, FollowsTheTheme) {
  Theme::instance().choose(Theme::Choice::kDark);
  const QIcon icon = ThemeIcon("plus", Token::kText);
  const QRgb dark = ColorOf(Drawn(icon, 64));

  Theme::instance().choose(Theme::Choice::kLight);

  EXPECT_NE(ColorOf(Drawn(icon, 64)), dark);
}

TEST(ThemeIcon, DrawsADisabledIconInTheStaleColour) {
  Theme::instance().choose(Theme::Choice::kDark);

  const QRgb color = ColorOf(Drawn(ThemeIcon("plus", Token::kText), 64, QIcon::Disabled));

  EXPECT_EQ(QColor(color), Theme::instance().color(Token::kStale));
}

}  // namespace
}  // namespace tendon::gui
