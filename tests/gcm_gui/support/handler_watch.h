#pragma once

#include <gcm_gui/window/watched_application.h>
#include <sys/resource.h>
#include <tendon/base/os/thread.h>

#include <QEvent>
#include <QSet>
#include <QString>
#include <algorithm>
#include <chrono>
#include <cstdint>

namespace tendon::gui {

/// Returns how often the calling thread has given up its processor to wait for a lock, a file or a
/// reply. Preemption by another thread and page faults from the disk do not count. The difference
/// of two calls is the number of waits in between.
[[nodiscard]] inline std::int64_t ThreadWaits() noexcept {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  return usage.ru_nvcsw - usage.ru_majflt;
}

/// Measures the event handlers of one phase of a test: which of them took longest, and which of
/// them waited (gave up the processor). Three kinds of waiting do not count: waiting for the
/// processor, because the machine may be busy; waiting of the event loop for events; and waiting of
/// Qt while it paints, because Qt paints large areas in several threads.
class HandlerWatch : public WatchedApplication {
 public:
  using WatchedApplication::WatchedApplication;

  /// Names are as in WatchedApplication::longestName().
  struct Phase {
    std::chrono::nanoseconds longest{0};  ///< processor time
    QString longest_name;
    QSet<QString> waited;
  };

  void beginPhase() { phase_ = {}; }
  [[nodiscard]] const Phase& phase() const { return phase_; }

  bool notify(QObject* receiver, QEvent* event) override {
    if (depth_ > 0 && event->type() == QEvent::Paint) return paint(receiver, event);
    if (depth_ > 0) return WatchedApplication::notify(receiver, event);
    // Made before the event is handled, because the event may destroy both objects.
    const QObject* owner = receiver->parent();
    const QString name =
        QStringLiteral("%1/%2 %3")
            .arg(QLatin1String(owner == nullptr ? "" : owner->metaObject()->className()),
                 QLatin1String(receiver->metaObject()->className()))
            .arg(event->type());
    const bool is_painting = event->type() == QEvent::Paint;
    ++depth_;
    painting_waits_ = 0;
    const auto before = os::ThreadCpuTime();
    const std::int64_t waits_before = ThreadWaits();
    const bool handled = WatchedApplication::notify(receiver, event);
    const std::int64_t waits = ThreadWaits() - waits_before - painting_waits_;
    const auto used = os::ThreadCpuTime() - before;
    --depth_;
    if (used > phase_.longest) {
      phase_.longest = used;
      phase_.longest_name = name;
    }
    if (waits > 0 && !is_painting) phase_.waited.insert(name);
    return handled;
  }

 private:
  bool paint(QObject* receiver, QEvent* event) {
    const std::int64_t before = ThreadWaits();
    const std::int64_t waits_so_far = painting_waits_;
    const bool handled = WatchedApplication::notify(receiver, event);
    // The difference includes the waits of nested paint events.
    painting_waits_ = waits_so_far + ThreadWaits() - before;
    return handled;
  }

  int depth_ = 0;
  std::int64_t painting_waits_ = 0;  // number of waits for painting in the present handler
  Phase phase_;
};

}  // namespace tendon::gui
