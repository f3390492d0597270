#pragma once

#include <gcm_gui/call/repeater.h>

#include <QTimer>
#include <QWidget>
#include <functional>
#include <string>

class QPushButton;

namespace tendon::gui {

class NumberBox;

/// The rate and number of repeated calls, and a button that starts and stops them. If a call can
/// move something, calls are only made while the button is held down.
class RepeatRow : public QWidget {
  Q_OBJECT

 public:
  /// `argument` returns the present argument.
  RepeatRow(CommandCalls& calls, std::function<std::string()> argument, QWidget* parent = nullptr);

  /// Stops the calls. Suggests a rate that renews a command which expires after `expires_after`
  /// seconds, or else 1 Hz.
  void setCommand(const QString& path, double expires_after = 0);
  void setCareful(bool careful);
  /// False stops the calls.
  void setCallable(bool callable);
  [[nodiscard]] const Repeater& repeater() const { return repeater_; }

 Q_SIGNALS:
  /// "12 calls" and their outcome; `is_bad` is true if a refusal ended them.
  void statusChanged(const QString& text, bool is_bad);

 protected:
  /// Watches for the pointer or the focus leaving the button.
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
  bool is_refused_ = false;  // a typed number is invalid
  NumberBox* rate_;
  NumberBox* times_;
  QPushButton* button_;
};

}  // namespace tendon::gui
