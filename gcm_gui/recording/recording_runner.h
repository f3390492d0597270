#pragma once

#include <tendon/recording/recorder.h>

#include <QObject>
#include <QString>
#include <QStringList>
#include <chrono>
#include <string>
#include <vector>

namespace tendon::gui {

/// The content of a recording, and the place of its file.
struct RecordingRequest {
  std::vector<std::string> patterns;  ///< the patterns of `gcm record`
  QString folder;                     ///< created if missing
  QString name;  ///< name of the file without suffix; a number is added if the file exists
  /// If above 0, nothing is recorded; the last seconds that the processes have kept are saved.
  std::chrono::seconds past{0};
};

/// The state of a running recording.
struct RecordingProgress {
  recording::RecorderStatus status;
  double seconds = 0.0;  ///< time since its begin; or the time that the saving of the past took
  double rate = 0.0;     ///< growth of the file in the last seconds, in bytes per second
  /// The reasons why a saved history is not complete: one sentence for each process or table.
  QStringList shortfalls{};
};

/// Records the running system, one recording at a time. GUI thread; no function waits.
class RecordingRunner : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// Starts a recording. Then either begun() or refused() is emitted; after begun(), also ended().
  virtual void start(const RecordingRequest& request) = 0;
  /// Ends the recording and completes the file.
  virtual void stop() = 0;

 Q_SIGNALS:
  void begun(const QString& file);
  /// No file was made. `sentence` is the reason; it is empty if stop() was called.
  void refused(const QString& sentence);
  /// Emitted several times a second.
  void progressed(const tendon::gui::RecordingProgress& progress);
  /// A process or the GCM was lost or came back; the recording continues.
  void interrupted(const QString& sentence);
  /// `failure` is empty if the file is complete.
  void ended(const tendon::gui::RecordingProgress& progress, const QString& failure);
};

}  // namespace tendon::gui
