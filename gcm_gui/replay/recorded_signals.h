#pragma once

#include <gcm_gui/plot/series/time_window.h>
#include <gcm_gui/replay/replay_reader.h>
#include <gcm_gui/session/signal_source.h>

#include <QString>
#include <QTimer>
#include <functional>
#include <map>
#include <memory>
#include <optional>

namespace tendon::gui {

/// The signals of recordings that are plotted beside signals of the shown system. Their paths come
/// from RecordedPath(). The times of their samples are on the plots' clock: the recorded time minus
/// WallOffset().
///
/// Each file is read by its index, in its own thread. Only the visible part is read, at most an
/// hour, and some time before and after it, so that a small move shows no gap. The file is closed
/// some time after its last signal was released, even if it is still being read.
class RecordedSignals final : public SignalSource {
  Q_OBJECT

 public:
  /// Returns the part of a recording that is visible in plots, on the clock of the samples; empty
  /// if no part is visible.
  using Seen = std::function<std::optional<TimeSpan>(const QString& recording)>;

  explicit RecordedSignals(Seen seen, ReplayReader::OpenFile open_file = os::OpenRandomAccessFile);
  ~RecordedSignals() override;

  void subscribe(const QString& signal) override;
  void release(const QString& signal) override;
  void watch(const QObject* /*owner*/, const QSet<QString>& /*columns*/) override {}
  [[nodiscard]] RowLosses losses(const QString& /*signal*/) const override { return {}; }
  void retry(const QString& /*column*/) override {}

  /// Reads the parts that are visible now; called by a timer.
  void follow();

 Q_SIGNALS:
  /// Emitted when a recording was opened; `time` is its time span, on the clock of the samples.
  void opened(const QString& recording, const tendon::gui::TimeSpan& time);
  /// Emitted when all samples of the recording are outdated; the samples of the visible part
  /// follow.
  void readAgain(const QString& recording);
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  class File;

  Seen seen_;
  const ReplayReader::OpenFile open_file_;
  std::map<QString, std::unique_ptr<File>> files_;  // by path
  QTimer timer_;
};

}  // namespace tendon::gui
