#include "live/live_window.h"

#include <gcm_gui/session/live_signals.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/catalogue_panel.h>
#include <gcm_gui/views/catalogue_tree.h>
#include <gcm_gui/window/window_parts.h>
#include <tendon/ice/ice_middleware.h>

#include <QDir>
#include <QImage>
#include <QTest>

namespace tendon::gui {

LiveWindow::~LiveWindow() {
  Theme::instance().choose(Theme::Choice::kSystem);
  window_.reset();
  session_.reset();
}

void LiveWindow::Open(const QString& path) {
  // Of one user with the programs, whose cookie lies there.
  const Outcome runtime = RunProgram({"/bin/sh", "-c", "printf %s \"$XDG_RUNTIME_DIR\""});
  qputenv("XDG_RUNTIME_DIR", QByteArray::fromStdString(runtime.out));
  session_ = std::make_unique<Session>(MakeIceMiddleware(Exposure::kLoopbackOnly), address, false);
  window_ = std::make_unique<MainWindow>(WindowParts{session_->store(), session_->link(),
                                                     session_->activity(), *session_,
                                                     session_->liveSignals(), *session_});
  window_->show();
  window_->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get(), kLivePatience));
  ASSERT_TRUE(QTest::qWaitFor([&] { return Knows(path); }, kLivePatience)) << path.toStdString();
}

bool LiveWindow::Knows(const QString& path) const {
  auto& tree = window_->catalogue().tree();
  tree.reveal(ColumnPathOf(path));  // its values come once it is seen
  tree.reveal(path);
  return tree.visibleRows().contains(path);
}

void LiveWindow::Click(const QString& path, Qt::KeyboardModifiers modifiers) {
  ASSERT_TRUE(QTest::qWaitFor([&] { return Knows(path); }, kLivePatience)) << path.toStdString();
  auto& tree = window_->catalogue().tree();
  const QPoint place = tree.visibleRows().value(path).center();
  QTest::mouseClick(tree.viewport(), Qt::LeftButton, modifiers, place);
}

void LiveWindow::KeepPictures(const QString& name) {
  QDir().mkpath(PICTURE_FOLDER);
  for (const bool dark : {true, false}) {
    Theme::instance().choose(dark ? Theme::Choice::kDark : Theme::Choice::kLight);
    QTest::qWait(300);  // for people: the figures of a whole tick
    for (const int scale : {1, 2}) {
      QImage image(window_->size() * scale, QImage::Format_RGB32);
      image.setDevicePixelRatio(scale);
      window_->render(&image);
      const QString file =
          QString("%1/%2-%3-%4x.png").arg(PICTURE_FOLDER, name, dark ? "dark" : "light").arg(scale);
      EXPECT_TRUE(image.save(file));
      EXPECT_EQ(image.pixelColor(image.width() / 2, 3 * scale),
                Theme::instance().color(Token::kPanel));
    }
  }
}

}  // namespace tendon::gui
