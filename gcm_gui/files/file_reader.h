#pragma once

#include <gcm_gui/files/background.h>
#include <gcm_gui/files/gui_poster.h>

#include <QByteArray>
#include <QObject>
#include <QString>
#include <functional>
#include <memory>

namespace tendon::gui {

/// Reads files one after another in its own thread, so a slow disk blocks nobody. GUI thread.
class FileReader : public QObject {
  Q_OBJECT

 public:
  /// Receives the content of the file or, if it cannot be read, the reason.
  using Done = std::function<void(const QByteArray& content, const QString& refusal)>;

  explicit FileReader(QObject* parent = nullptr);
  FileReader(const FileReader&) = delete;
  FileReader& operator=(const FileReader&) = delete;
  ~FileReader() override;

  /// `done` is not called after the reader is destroyed.
  void read(const QString& file, Done done);

 private:
  std::shared_ptr<GuiPoster> poster_;
  Background thread_{QT_TRANSLATE_NOOP("Words", "the reading of a file")};
};

}  // namespace tendon::gui
