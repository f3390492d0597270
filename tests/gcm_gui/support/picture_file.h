#pragma once

#include <QCoreApplication>
#include <QDir>

namespace tendon::gui {

/// The file in which a test saves the picture `name` for people, in this program's build folder.
/// Creates the folder.
inline QString PictureFile(const QString& name) {
  const QDir folder(QCoreApplication::applicationDirPath() + "/../pictures");
  folder.mkpath(".");
  return folder.filePath(name + ".png");
}

}  // namespace tendon::gui
