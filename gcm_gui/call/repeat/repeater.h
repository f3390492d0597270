#pragma once

#include <gcm_gui/session/command_calls.h>

#include <QObject>
#include <QString>
#include <QTimer>
#include <cstdint>
#include <string>

namespace tendon::gui {

/// Calls one command again and again. No more than one call is under way: what is due before the
/// last one is answered is left out, also where that is of an earlier start(). Ends after so many,
/// at the first refusal, or when it is told to; what is under way then is not taken back.
class Repeater : public QObject {
  Q_OBJECT

 public:
  explicit Repeater(CommandCalls& calls, QObject* parent = nullptr);

  /// `rate` in Hz, above 0; `times` 0 for no end. The first call is due at once.
  void start(const QString& path, const std::string& argument, double rate, int times);
  /// Nothing where it does not run.
  void stop();

  [[nodiscard]] bool isRunning() const { return timer_.isActive(); }
  [[nodiscard]] int called() const { return called_; }
  [[nodiscard]] int leftOut() const { return left_out_; }

 Q_SIGNALS:
  void progressed();
  /// With why, where a call was refused.
  void stopped(const QString& refusal);

 private:
  void callNext();
  void hear(const Result<std::string>& answer);
  void end(const QString& refusal);

  CommandCalls& calls_;
  QTimer timer_;
  QString path_;
  std::string argument_;
  int times_ = 0;
  int called_ = 0;
  int left_out_ = 0;
  bool under_way_ = false;
  std::uint64_t run_ = 0;  // answers of an earlier one tell nothing
};

}  // namespace tendon::gui
