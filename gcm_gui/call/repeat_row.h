#pragma once

#include <gcm_gui/call/repeater.h>

#include <QTimer>
#include <QWidget>
#include <functional>
#include <string>

class QPushButton;

namespace tendon::gui {

class NumberBox;

/// Repeats a call: has fields for the rate and the number of calls, and a button that starts and
/// stops them. If a call can move something, calls are made only while the button is held down.
class RepeatRow : public QWidget {
  Q_OBJECT

 public:
  /// `argument` returns the present argument.
  RepeatRow(CommandCalls& calls, std::function<std::string()> argument, QWidget* parent = nullptr);

  /// Stops the calls and suggests a rate: high enough to renew a command that expires after
  /// `expires_after` seconds; 1 Hz if the command does not expire.
  void setCommand(const QString& path, double expires_after = 0);
  void setCareful(bool careful);
  /// Sets whether the command can be called; false stops the calls.
  void setCallable(bool callable);
  [[nodiscard]] const Repeater& repeater() const { return repeater_; }

 Q_SIGNALS:
  /// Reports the number of calls and their outcome, such as "12 calls". `is_bad` is true if a
  /// refusal has ended the calls.
  void statusChanged(const QString& text, bool is_bad);

 protected:
  /// If the button must be held down, stops the calls when it loses the focus or is hidden.
  bool eventFilter(QObject* watched, QEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void begin();
  void stopRepeating();
  void showButton();
  void checkNumbers();
  [[nodiscard]] QString counts() const;

  Repeater repeater_;
  std::function<std::string()> argument_;
  QString path_;
  bool careful_ = false;
  QTimer hold_;  // delay before the calls start, if the button must be held

  bool is_callable_ = true;
  bool is_refused_ = false;  // a number typed by the user is invalid
  NumberBox* rate_;
  NumberBox* times_;
  QPushButton* button_;
};

}  // namespace tendon::gui
