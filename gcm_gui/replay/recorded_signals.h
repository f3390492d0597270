#pragma once

#include <gcm_gui/plot/series/time_window.h>
#include <gcm_gui/session/signal_source.h>

#include <QString>
#include <QTimer>
#include <functional>
#include <map>
#include <memory>
#include <optional>

namespace tendon::gui {

/// Signals of recordings beside those of the shown system. Their paths are RecordedPath()s, and the
/// times of their samples those that the plots' clock had when they were recorded: the recorded
/// time minus WallOffset().
///
/// Each file is read in a thread of its own, by its index, and only as far as it is seen, at most
/// an hour: a part before and after it as well, so that a small move shows no hole. It is closed
/// some time after its last signal was released.
class RecordedSignals final : public SignalSource {
  Q_OBJECT

 public:
  /// Returns the part of a recording that plots show, in the time of the samples; nothing if they
  /// show none of it.
  using Seen = std::function<std::optional<TimeSpan>(const QString& recording)>;

  explicit RecordedSignals(Seen seen, QObject* parent = nullptr);
  ~RecordedSignals() override;

  void subscribe(const QString& signal) override;
  void release(const QString& signal) override;
  void watch(const QObject* /*owner*/, const QSet<QString>& /*columns*/) override {}
  [[nodiscard]] RowLosses losses(const QString& /*signal*/) const override { return {}; }
  void retry(const QString& /*column*/) override {}

  /// Reads what is seen now; called by a timer.
  void follow();

 Q_SIGNALS:
  /// The time that the recording covers, in the time of the samples.
  void opened(const QString& recording, const tendon::gui::TimeSpan& time);
  /// All samples of the recording are out of date; those of the seen part follow.
  void readAgain(const QString& recording);
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  class File;

  Seen seen_;
  std::map<QString, std::unique_ptr<File>> files_;  // by path
  QTimer timer_;
};

}  // namespace tendon::gui
