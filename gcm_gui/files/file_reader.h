#pragma once

#include <gcm_gui/files/background.h>
#include <gcm_gui/session/courier.h>

#include <QByteArray>
#include <QObject>
#include <QString>
#include <functional>
#include <memory>

namespace tendon::gui {

/// Reads files in a thread of its own, one after the other: a slow disk holds up nobody. GUI
/// thread.
class FileReader : public QObject {
  Q_OBJECT

 public:
  /// What is in the file; or, where that cannot be read, nothing and why.
  using Done = std::function<void(const QByteArray& content, const QString& refusal)>;

  explicit FileReader(QObject* parent = nullptr);
  FileReader(const FileReader&) = delete;
  FileReader& operator=(const FileReader&) = delete;
  ~FileReader() override;

  /// `done` is not called once the reader is gone.
  void read(const QString& file, Done done);

 private:
  std::shared_ptr<Courier> courier_;
  Background thread_{QT_TRANSLATE_NOOP("Words", "the reading of a file")};
};

}  // namespace tendon::gui
