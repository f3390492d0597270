#include <gcm_gui/call/hold_button.h>

#include <QEvent>

namespace tendon::gui {

HoldButton::HoldButton(const QString& text, QWidget* parent) : QPushButton(text, parent) {
  hold_.setSingleShot(true);
  hold_.setInterval(kHold);
  connect(&hold_, &QTimer::timeout, this, [this] {
    has_held_ = true;
    Q_EMIT called();
  });
  connect(this, &QPushButton::clicked, this, [this] {
    if (!careful_ && !has_held_) Q_EMIT called();
  });
  connect(this, &QPushButton::pressed, this, &HoldButton::press);
  connect(this, &QPushButton::released, this, &HoldButton::release);
}

bool HoldButton::event(QEvent* event) {
  const auto type = event->type();
  const bool goes_down = type == QEvent::MouseButtonPress || type == QEvent::MouseButtonDblClick ||
                         type == QEvent::KeyPress;
  if (goes_down) has_held_ = false;
  if (type == QEvent::Hide || type == QEvent::FocusOut) hold_.stop();
  return QPushButton::event(event);
}

/// Also called when the pointer returns to the button while the mouse button is still down.
void HoldButton::press() {
  if (careful_ && !has_held_) hold_.start();
}

void HoldButton::release() {
  if (!hold_.isActive()) return;
  hold_.stop();
  Q_EMIT releasedEarly();
}

}  // namespace tendon::gui
