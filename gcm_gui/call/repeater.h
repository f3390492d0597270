#pragma once

#include <gcm_gui/session/system_requests.h>

#include <QObject>
#include <QString>
#include <QTimer>
#include <cstdint>
#include <string>

namespace tendon::gui {

/// Calls one command repeatedly, with at most one unanswered call. If the previous call is still
/// unanswered when the next one is due, the next one is skipped; this holds even across stop() and
/// start(). The calls end after the requested number, at the first refusal, or on stop(). A call
/// that was already sent is not cancelled.
class Repeater : public QObject {
  Q_OBJECT

 public:
  explicit Repeater(CommandCalls& calls, QObject* parent = nullptr);

  /// Starts the calls; the first one is due at once. `rate` is in Hz and above 0; if `times` is 0,
  /// the calls do not end by themselves.
  void start(const QString& path, const std::string& argument, double rate, int times);
  /// Does nothing if no calls are running.
  void stop();

  [[nodiscard]] bool isRunning() const { return timer_.isActive(); }
  [[nodiscard]] int called() const { return called_; }
  [[nodiscard]] int leftOut() const { return left_out_; }

 Q_SIGNALS:
  void progressed();
  /// Emitted when the calls have ended. `refusal` is the reason if a call was refused; otherwise
  /// empty.
  void stopped(const QString& refusal);

 private:
  void callNext();
  void onResult(const Result<std::string>& result);
  void end(const QString& refusal);

  CommandCalls& calls_;
  QTimer timer_;
  QString path_;
  std::string argument_;
  int times_ = 0;
  int called_ = 0;
  int left_out_ = 0;
  bool under_way_ = false;
  std::uint64_t run_ = 0;  // results of an earlier run are ignored
};

}  // namespace tendon::gui
