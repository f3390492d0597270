#pragma once

#include <QPushButton>
#include <QTimer>
#include <chrono>

namespace tendon::gui {

/// A button that calls a command at a click or, if the call can set something in motion, after it
/// has been held for a while.
class HoldButton : public QPushButton {
  Q_OBJECT

 public:
  static constexpr std::chrono::milliseconds kHold{400};

  explicit HoldButton(const QString& text, QWidget* parent = nullptr);

  void setCareful(bool careful) { careful_ = careful; }
  [[nodiscard]] bool isCareful() const { return careful_; }

 Q_SIGNALS:
  void called();
  /// The user released the button too early.
  void letGoEarly();

 protected:
  bool event(QEvent* event) override;

 private:
  void press();
  void release();

  bool careful_ = false;
  bool has_held_ = false;  // it has called since it was pressed
  QTimer hold_;
};

}  // namespace tendon::gui
