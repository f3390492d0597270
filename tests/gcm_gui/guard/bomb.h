#pragma once

#include <QEvent>
#include <QObject>
#include <QWidget>
#include <functional>

namespace tendon::gui {

/// Throws at every event of one type that a widget receives.
class Bomb : public QObject {
 public:
  Bomb(QWidget& target, QEvent::Type type, std::function<void()> explode)
      : target_(target), type_(type), explode_(std::move(explode)) {
    target.installEventFilter(this);
  }

  [[nodiscard]] int explosions() const { return explosions_; }
  /// Stops throwing; from now on, only counts the events.
  void defuse() { is_live_ = false; }
  [[nodiscard]] int events() const { return events_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched != &target_ || event->type() != type_) return false;
    ++events_;
    if (!is_live_) return false;
    ++explosions_;
    explode_();
    return false;
  }

 private:
  QWidget& target_;
  const QEvent::Type type_;
  const std::function<void()> explode_;
  bool is_live_ = true;
  int explosions_ = 0;
  int events_ = 0;
};

}  // namespace tendon::gui
