#pragma once

#include <gcm_gui/guard/guarded_application.h>

#include <chrono>
#include <cstdint>

namespace tendon::gui {

/// Measures the longest processor time of an event handler, and counts how often handlers wait.
/// Three kinds of waiting do not count: for the processor, so that a busy machine is not reported
/// as a slow handler; of the event loop for events; and of Qt while painting, because Qt paints
/// large areas in several threads.
class WatchedApplication : public GuardedApplication {
  Q_OBJECT

 public:
  using GuardedApplication::GuardedApplication;

  bool notify(QObject* receiver, QEvent* event) override;

  [[nodiscard]] std::chrono::nanoseconds longestHandler() const { return longest_; }
  /// The longest handler: classes of the receiver's parent and the receiver, and event type.
  [[nodiscard]] const QString& longestName() const { return longest_name_; }
  /// How often handlers have given up the processor to wait.
  [[nodiscard]] std::int64_t waits() const { return waits_; }
  /// Each handler that has waited, with its count: "GraphView/QTimer 1 · 2 times".
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
  std::int64_t painting_waits_ = 0;  // number of waits for painting in the running handler
  QStringList waiters_;
};

}  // namespace tendon::gui
