#pragma once

#include <gcm_gui/guard/guarded_application.h>

#include <chrono>

namespace tendon::gui {

/// Measures the longest processor time of an event handler. The time in which a handler waits does
/// not count, so that a handler is not reported as slow because the machine is busy.
class WatchedApplication : public GuardedApplication {
  Q_OBJECT

 public:
  using GuardedApplication::GuardedApplication;

  bool notify(QObject* receiver, QEvent* event) override;

  [[nodiscard]] std::chrono::nanoseconds longestHandler() const { return longest_; }
  /// The name of the handler that took longest: the classes of the receiver's parent and of the
  /// receiver, and the type of the event.
  [[nodiscard]] const QString& longestName() const { return longest_name_; }

 private:
  int depth_ = 0;
  std::chrono::nanoseconds longest_{0};
  QString longest_name_;
};

}  // namespace tendon::gui
