#pragma once

#include <QCoreApplication>
#include <QDir>

namespace tendon::gui {

/// Where a test leaves the picture `name` for people, in the build this program lies in; the folder
/// is made.
inline QString PictureFile(const QString& name) {
  const QDir folder(QCoreApplication::applicationDirPath() + "/../pictures");
  folder.mkpath(".");
  return folder.filePath(name + ".png");
}

}  // namespace tendon::gui
