#include <gcm_gui/window/watched_application.h>
#include <tendon/base/os/thread.h>

#include <QEvent>

namespace tendon::gui {

bool WatchedApplication::notify(QObject* receiver, QEvent* event) {
  if (depth_ > 0 && event->type() == QEvent::Paint) return paint(receiver, event);
  if (depth_ > 0) return GuardedApplication::notify(receiver, event);
  // Reads the class names before the event is handled, because the event may destroy both objects.
  const char* receiver_class = receiver->metaObject()->className();
  const QObject* owner = receiver->parent();
  const char* owner_class = owner == nullptr ? "" : owner->metaObject()->className();
  const QEvent::Type type = event->type();
  const auto name = [&] {
    return QStringLiteral("%1/%2 %3")
        .arg(QLatin1String(owner_class), QLatin1String(receiver_class))
        .arg(type);
  };
  ++depth_;
  painting_waits_ = 0;
  const auto before = os::ThreadCpuTime();
  const std::int64_t waits_before = os::ThreadWaits();
  const bool handled = GuardedApplication::notify(receiver, event);
  const std::int64_t waits =
      type == QEvent::Paint ? 0 : os::ThreadWaits() - waits_before - painting_waits_;
  const auto used = os::ThreadCpuTime() - before;
  --depth_;
  if (used > longest_) {
    longest_ = used;
    longest_name_ = name();
  }
  if (waits > 0) {
    waits_ += waits;
    if (waiters_.size() < kMostWaiters) {
      waiters_.append(QStringLiteral("%1 · %2 times").arg(name()).arg(waits));
    }
  }
  return handled;
}

bool WatchedApplication::paint(QObject* receiver, QEvent* event) {
  const std::int64_t before = os::ThreadWaits();
  const std::int64_t waits_so_far = painting_waits_;
  const bool handled = GuardedApplication::notify(receiver, event);
  // The difference includes the waits of nested paint events.
  painting_waits_ = waits_so_far + os::ThreadWaits() - before;
  return handled;
}

void WatchedApplication::forgetHandlers() {
  longest_ = {};
  longest_name_.clear();
  waits_ = 0;
  waiters_.clear();
}

}  // namespace tendon::gui
