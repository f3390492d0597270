#pragma once

#include <QCoreApplication>
#include <QDir>

namespace tendon::gui {

/// Returns the file in which a test saves the picture `name` for people. The file is in this
/// program's build folder; the folder is created.
inline QString PictureFile(const QString& name) {
  const QDir folder(QCoreApplication::applicationDirPath() + "/../pictures");
  folder.mkpath(".");
  return folder.filePath(name + ".png");
}

}  // namespace tendon::gui
