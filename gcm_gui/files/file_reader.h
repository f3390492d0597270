#pragma once

#include <gcm_gui/files/background.h>
#include <gcm_gui/files/gui_poster.h>

#include <QByteArray>
#include <QObject>
#include <QString>
#include <functional>
#include <memory>

namespace tendon::gui {

/// Reads files one after another in its own thread, so that a slow disk does not block the GUI
/// thread. Call it in the GUI thread.
class FileReader : public QObject {
  Q_OBJECT

 public:
  /// Called with the content of the file or, if the file cannot be read, with the reason.
  using Done = std::function<void(const QByteArray& content, const QString& refusal)>;

  explicit FileReader(QObject* parent = nullptr);
  FileReader(const FileReader&) = delete;
  FileReader& operator=(const FileReader&) = delete;
  /// Does not wait for the file that is being read.
  ~FileReader() override;

  /// Reads a file and then calls `done`, unless the reader was destroyed before.
  void read(const QString& file, Done done);

 private:
  std::shared_ptr<GuiPoster> poster_;
  Background thread_{QT_TRANSLATE_NOOP("Words", "the reading of a file")};
};

}  // namespace tendon::gui
