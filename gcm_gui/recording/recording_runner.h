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
  std::vector<std::string> patterns;  ///< as for `gcm record`
  QString folder;                     ///< created if missing
  QString name;  ///< of the file, without suffix; gets a number if there is such a file
  /// If above 0, nothing is recorded; the last seconds that the processes have kept are saved.
  std::chrono::seconds past{0};
};

/// The state of a running recording.
struct RecordingProgress {
  recording::RecorderStatus status;
  double seconds = 0.0;  ///< since its begin
  double rate = 0.0;     ///< of the file over the last seconds, bytes per second
  /// The reasons why a saved past is not complete: a sentence for each process or table.
  QStringList shortfalls{};
};

/// Records the running system, one recording at a time. GUI thread; no function waits.
class RecordingRunner : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// Exactly one of begun() and refused() follows, and ended() after begun().
  virtual void start(const RecordingRequest& request) = 0;
  /// Completes the file.
  virtual void stop() = 0;

 Q_SIGNALS:
  void begun(const QString& file);
  /// No file was made. `sentence` is empty if stop() was the reason.
  void refused(const QString& sentence);
  /// Several times a second.
  void progressed(const tendon::gui::RecordingProgress& progress);
  /// A process or the GCM was lost or came back; the recording goes on.
  void interrupted(const QString& sentence);
  /// `failure` is empty if the file is complete.
  void ended(const tendon::gui::RecordingProgress& progress, const QString& failure);
};

}  // namespace tendon::gui
