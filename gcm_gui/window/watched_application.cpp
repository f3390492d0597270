#include <gcm_gui/window/watched_application.h>

#include <tendon/base/os/thread.h>

#include <QEvent>

namespace tendon::gui {

bool WatchedApplication::notify(QObject* receiver, QEvent* event) {
  if (depth_ > 0) return GuardedApplication::notify(receiver, event);
  // Reads the class names before the event is handled, because the event may destroy both objects.
  const char* receiver_class = receiver->metaObject()->className();
  const QObject* owner = receiver->parent();
  const char* owner_class = owner == nullptr ? "" : owner->metaObject()->className();
  const QEvent::Type type = event->type();
  ++depth_;
  const auto before = os::ThreadCpuTime();
  const bool handled = GuardedApplication::notify(receiver, event);
  const auto used = os::ThreadCpuTime() - before;
  --depth_;
  if (used > longest_) {
    longest_ = used;
    longest_name_ = QStringLiteral("%1/%2 %3")
                        .arg(QLatin1String(owner_class), QLatin1String(receiver_class))
                        .arg(type);
  }
  return handled;
}

}  // namespace tendon::gui
