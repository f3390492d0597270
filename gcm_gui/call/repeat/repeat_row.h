#pragma once

#include <gcm_gui/call/repeat/repeater.h>

#include <QTimer>
#include <QWidget>
#include <functional>
#include <string>

class QDoubleSpinBox;
class QPushButton;
class QSpinBox;

namespace tendon::gui {

/// How often and how many times a command is called, and a button that begins and ends that. Where
/// a call can set something in motion, it goes on only as long as the button is held down.
class RepeatRow : public QWidget {
  Q_OBJECT

 public:
  /// `argument` says what would be said now.
  RepeatRow(CommandCalls& calls, std::function<std::string()> argument, QWidget* parent = nullptr);

  /// Ends what runs.
  void setCommand(const QString& path);
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
  [[nodiscard]] QString counts() const;

  Repeater repeater_;
  std::function<std::string()> argument_;
  QString path_;
  bool careful_ = false;
  QTimer hold_;  // until it begins, where that must be held

  QDoubleSpinBox* rate_;
  QSpinBox* times_;
  QPushButton* button_;
};

}  // namespace tendon::gui
