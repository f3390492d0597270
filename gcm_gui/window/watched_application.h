#pragma once

#include <gcm_gui/guard/guarded_application.h>

#include <chrono>
#include <cstdint>

namespace tendon::gui {

/// Measures the longest processor time of an event handler, and counts how often handlers wait
/// (give up the processor). Three kinds of waiting do not count: waiting for the processor, so that
/// a handler is not reported as slow because the machine is busy; waiting of the event loop for
/// events; and waiting of Qt while it paints, because Qt paints large areas in several threads.
class WatchedApplication : public GuardedApplication {
  Q_OBJECT

 public:
  using GuardedApplication::GuardedApplication;

  bool notify(QObject* receiver, QEvent* event) override;

  [[nodiscard]] std::chrono::nanoseconds longestHandler() const { return longest_; }
  /// The name of the handler that took longest: the classes of the receiver's parent and of the
  /// receiver, and the type of the event.
  [[nodiscard]] const QString& longestName() const { return longest_name_; }
  /// The number of times that a handler has given up the processor to wait.
  [[nodiscard]] std::int64_t waits() const { return waits_; }
  /// The handlers that have waited, each with its number of waits: "GraphView/QTimer 1 · 2 times".
  [[nodiscard]] const QStringList& waiters() const { return waiters_; }
  /// Starts the measurement again.
  void forgetHandlers();

 private:
  static constexpr qsizetype kMostWaiters = 20;

  bool paint(QObject* receiver, QEvent* event);

  int depth_ = 0;
  std::chrono::nanoseconds longest_{0};
  QString longest_name_;
  std::int64_t waits_ = 0;
  std::int64_t painting_waits_ = 0;  // number of waits for painting in the present handler
  QStringList waiters_;
};

}  // namespace tendon::gui
