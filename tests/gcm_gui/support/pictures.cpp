#include <gcm_gui/theme/theme.h>
#include <gtest/gtest.h>
#include <support/picture_file.h>
#include <support/pictures.h>

#include <QImage>
#include <QTest>
#include <QWidget>
#include <utility>

namespace tendon::gui {

void KeepPictures(QWidget& window, const QString& name) {
  for (const auto& [choice, look] :
       {std::pair{Theme::Choice::kDark, "dark"}, std::pair{Theme::Choice::kLight, "light"}}) {
    Theme::instance().choose(choice);
    QTest::qWait(100);  // time for the timers that lay out and draw
    for (const int dots : {1, 2}) {
      QImage image(window.size() * dots, QImage::Format_ARGB32_Premultiplied);
      image.setDevicePixelRatio(dots);
      image.fill(Qt::transparent);
      window.render(&image);
      const QString file = QStringLiteral("%1-%2-%3x").arg(name, QString::fromLatin1(look));
      EXPECT_TRUE(image.save(PictureFile(file.arg(dots))));
    }
  }
}

}  // namespace tendon::gui
