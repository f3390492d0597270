#pragma once

#include <gcm_gui/activity/activity_model.h>
#include <gcm_gui/recording/recording_runner.h>

#include <QByteArray>
#include <QObject>
#include <QString>
#include <QStringList>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tendon::gui {

/// The content of the next recording.
enum class RecordingScope { kPlotted, kSelected, kEverything };

/// The outcome of the latest recording, or the reason why there is none.
struct RecordingReport {
  enum class Kind {
    kDone,
    kNothingChosen,  ///< there is nothing to record
    kFailed          ///< the recording could not begin, or its file could not be completed
  };
  Kind kind = Kind::kDone;
  QString title;   ///< a few words
  QString detail;  ///< the file, or the reason
  QString file;    ///< empty if there is none
  bool has_losses = false;
};

/// Records the objects that the user has chosen, and lists each recording as an action. Has no
/// widgets. GUI thread.
class RecordingController : public QObject {
  Q_OBJECT

 public:
  enum class State { kIdle, kStarting, kRecording, kStopping };
  /// Functions that return the plotted paths and the selected paths.
  struct Sources {
    std::function<QStringList()> plotted;
    std::function<QStringList()> selected;
  };

  RecordingController(RecordingRunner& runner, ActivityModel& activity, Sources sources,
                      QObject* parent = nullptr);

  [[nodiscard]] RecordingScope scope() const { return scope_; }
  void setScope(RecordingScope scope);
  /// The folder of the files.
  [[nodiscard]] QString folder() const { return folder_; }
  void setFolder(const QString& folder);
  /// The scope and the folder, which are restored at the next start of the window.
  [[nodiscard]] QByteArray choices() const;
  void restoreChoices(const QByteArray& choices);

  [[nodiscard]] State state() const { return state_; }
  // These functions describe the running recording.
  [[nodiscard]] QString subject() const { return subject_; }  ///< "3 plotted signals"
  [[nodiscard]] QStringList patterns() const { return patterns_; }
  [[nodiscard]] QString file() const { return file_; }
  /// The length of the history that is saved; 0 for a recording of what happens now.
  [[nodiscard]] std::chrono::seconds past() const { return past_; }
  [[nodiscard]] const RecordingProgress& progress() const { return progress_; }
  /// Sentences about lost processes and the lost GCM, oldest first.
  [[nodiscard]] QStringList interruptions() const { return interruptions_; }

  [[nodiscard]] const std::optional<RecordingReport>& report() const { return report_; }
  void dismissReport();

 public Q_SLOTS:
  /// Starts a recording, or stops the running one.
  void toggle();
  void start();
  void stop();
  /// Saves the last 30 s of the processes' history, as a recording that ends by itself. Does
  /// nothing while a recording runs.
  void saveLast();

 Q_SIGNALS:
  /// A value that the functions above return has changed.
  void changed();
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  [[nodiscard]] QStringList chosenPatterns() const;
  [[nodiscard]] QString chosenSubject() const;
  [[nodiscard]] Action actionFor(const QString& file) const;
  void begin(std::chrono::seconds past);
  void setReport(RecordingReport report);
  void reportPast();
  void onBegun(const QString& file);
  void onRefused(const QString& sentence);
  void onProgressed(const RecordingProgress& progress);
  void onInterrupted(const QString& sentence);
  void onEnded(const RecordingProgress& progress, const QString& failure);

  RecordingRunner& runner_;
  ActivityModel& activity_;
  const Sources sources_;
  RecordingScope scope_ = RecordingScope::kPlotted;
  QString folder_;
  State state_ = State::kIdle;
  QString subject_;
  QStringList patterns_;
  std::chrono::seconds past_{0};  // 0 for a recording
  QString file_;                  // until begun(), the requested file
  RecordingProgress progress_;
  QStringList interruptions_;
  ActivityModel::Id action_ = 0;
  std::optional<RecordingReport> report_;
};

}  // namespace tendon::gui
