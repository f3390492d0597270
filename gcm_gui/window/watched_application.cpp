#include <gcm_gui/window/watched_application.h>
#include <tendon/base/os/accounting/thread_waits.h>
#include <tendon/base/os/thread.h>

#include <QEvent>

namespace tendon::gui {

bool WatchedApplication::notify(QObject* receiver, QEvent* event) {
  if (depth_ > 0) return QApplication::notify(receiver, event);
  // Both may be gone afterwards.
  const char* receiver_class = receiver->metaObject()->className();
  const QEvent::Type type = event->type();
  const auto name = [&] {
    return QStringLiteral("%1 %2").arg(QLatin1String(receiver_class)).arg(type);
  };
  ++depth_;
  const auto before = os::ThreadCpuTime();
  const std::int64_t waits_before = os::ThreadWaits();
  const bool handled = QApplication::notify(receiver, event);
  const std::int64_t waits = os::ThreadWaits() - waits_before;
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

void WatchedApplication::forgetHandlers() {
  longest_ = {};
  longest_name_.clear();
  waits_ = 0;
  waiters_.clear();
}

}  // namespace tendon::gui
