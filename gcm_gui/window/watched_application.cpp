#include <gcm_gui/window/watched_application.h>
#include <tendon/base/os/thread.h>

#include <QEvent>

namespace tendon::gui {

bool WatchedApplication::notify(QObject* receiver, QEvent* event) {
  if (depth_ > 0) return QApplication::notify(receiver, event);
  // Both may be gone afterwards.
  const char* receiver_class = receiver->metaObject()->className();
  const QEvent::Type type = event->type();
  ++depth_;
  const auto before = os::ThreadCpuTime();
  const bool handled = QApplication::notify(receiver, event);
  const auto used = os::ThreadCpuTime() - before;
  --depth_;
  if (used > longest_) {
    longest_ = used;
    longest_name_ = QStringLiteral("%1 %2").arg(QLatin1String(receiver_class)).arg(type);
  }
  return handled;
}

}  // namespace tendon::gui
