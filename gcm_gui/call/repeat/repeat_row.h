#pragma once

#include <gcm_gui/call/repeat/repeater.h>

#include <QTimer>
#include <QWidget>
#include <functional>
#include <string>

class QPushButton;

namespace tendon::gui {

class NumberBox;

/// How often and how many times a command is called, and a button that begins and ends that. Where
/// a call can set something in motion, it goes on only as long as the button is held down.
class RepeatRow : public QWidget {
  Q_OBJECT

 public:
  /// `argument` says what would be said now.
  RepeatRow(CommandCalls& calls, std::function<std::string()> argument, QWidget* parent = nullptr);

  /// Ends what runs. Suggests to call it often enough to renew one that expires after so many
  /// seconds, and else once a second.
  void setCommand(const QString& path, double expires_after = 0);
  void setCareful(bool careful);
  /// False ends what runs.
  void setCallable(bool callable);
  [[nodiscard]] const Repeater& repeater() const { return repeater_; }

 Q_SIGNALS:
  /// "12 calls", and what became of them; `is_bad` when it ended with a refusal.
  void told(const QString& text, bool is_bad);

 protected:
  /// The button is left, by the pointer or the keys.
  bool eventFilter(QObject* watched, QEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void begin();
  void letGo();
  void showButton();
  void checkNumbers();
  [[nodiscard]] QString counts() const;

  Repeater repeater_;
  std::function<std::string()> argument_;
  QString path_;
  bool careful_ = false;
  QTimer hold_;  // until it begins, where that must be held

  bool is_callable_ = true;
  bool is_refused_ = false;  // a number of the row, as it is typed
  NumberBox* rate_;
  NumberBox* times_;
  QPushButton* button_;
};

}  // namespace tendon::gui
