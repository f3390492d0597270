#pragma once

#include <tendon/interface/interface_description.h>
#include <tendon/task/component_state.h>

#include <QPushButton>
#include <QTimer>
#include <chrono>

namespace tendon::gui {

/// A button that calls a command at a click or, if the call can move something, after it
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
  void releasedEarly();

 protected:
  bool event(QEvent* event) override;

 private:
  void press();
  void release();

  bool careful_ = false;
  bool has_held_ = false;  // it has called since it was pressed
  QTimer hold_;
};

/// True if the user must hold a button or press a key twice to call `command`: it can move
/// something, and its component executes it at once in this state.
[[nodiscard]] inline bool NeedsCare(const MemberDescription& command, ComponentState state) {
  return !command.hazard.empty() && state == ComponentState::kActive;
}

}  // namespace tendon::gui
