#pragma once

#include <gcm_gui/session/system_requests.h>

#include <QObject>
#include <QString>
#include <QTimer>
#include <cstdint>
#include <string>

namespace tendon::gui {

/// Calls one command repeatedly, with at most one unanswered call: a call that is due before the
/// last answer is skipped, even after a new start(). Ends after a number of calls, at the first
/// refusal, or on stop(); a call that was sent is not cancelled.
class Repeater : public QObject {
  Q_OBJECT

 public:
  explicit Repeater(CommandCalls& calls, QObject* parent = nullptr);

  /// `rate` in Hz, above 0; `times` 0 means no end. The first call is due at once.
  void start(const QString& path, const std::string& argument, double rate, int times);
  /// Does nothing if it is not running.
  void stop();

  [[nodiscard]] bool isRunning() const { return timer_.isActive(); }
  [[nodiscard]] int called() const { return called_; }
  [[nodiscard]] int leftOut() const { return left_out_; }

 Q_SIGNALS:
  void progressed();
  /// The calls have ended; `refusal` is the reason if a call was refused.
  void stopped(const QString& refusal);

 private:
  void callNext();
  void onAnswer(const Result<std::string>& answer);
  void end(const QString& refusal);

  CommandCalls& calls_;
  QTimer timer_;
  QString path_;
  std::string argument_;
  int times_ = 0;
  int called_ = 0;
  int left_out_ = 0;
  bool under_way_ = false;
  std::uint64_t run_ = 0;  // answers to an earlier run are ignored
};

}  // namespace tendon::gui
