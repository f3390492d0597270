#pragma once

#include <tendon/interface/interface_description.h>
#include <tendon/task/component_state.h>

#include <QPushButton>
#include <QTimer>
#include <chrono>

namespace tendon::gui {

/// A button that calls a command. The user clicks the button or, if the call can move something,
/// holds the button down for a while.
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
  bool has_held_ = false;  // the command was called since the button was pressed
  QTimer hold_;
};

/// Returns true if the user must hold a button or press a key twice to call `command`, because the
/// command can move something and its component executes it at once in this state.
[[nodiscard]] inline bool NeedsCare(const MemberDescription& command, ComponentState state) {
  return !command.hazard.empty() && state == ComponentState::kActive;
}

}  // namespace tendon::gui
