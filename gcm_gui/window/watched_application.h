#pragma once

#include <gcm_gui/fence/fenced_application.h>

#include <chrono>
#include <cstdint>

namespace tendon::gui {

/// The application, which notes how much processor time its longest event handler took, and how
/// often handlers have waited. Waiting for the processor does not count, so a busy machine does not
/// look like a stall; nor does the event loop's own waiting for the next event, nor what Qt waits
/// while it paints: it shares large areas with threads of its own.
class WatchedApplication : public FencedApplication {
  Q_OBJECT

 public:
  using FencedApplication::FencedApplication;

  bool notify(QObject* receiver, QEvent* event) override;

  [[nodiscard]] std::chrono::nanoseconds longestHandler() const { return longest_; }
  /// What it was: the classes of the receiver's parent and of the receiver, and the event's type.
  [[nodiscard]] const QString& longestName() const { return longest_name_; }
  /// How often handlers have given up the processor to wait for something.
  [[nodiscard]] std::int64_t waits() const { return waits_; }
  /// Each that has waited, by its name and how often: "GraphView/QTimer 1 · 2 times".
  [[nodiscard]] const QStringList& waiters() const { return waiters_; }
  /// From now on anew.
  void forgetHandlers();

 private:
  static constexpr qsizetype kMostWaiters = 20;

  bool paint(QObject* receiver, QEvent* event);

  int depth_ = 0;
  std::chrono::nanoseconds longest_{0};
  QString longest_name_;
  std::int64_t waits_ = 0;
  std::int64_t painting_waits_ = 0;  // in the handler that runs
  QStringList waiters_;
};

}  // namespace tendon::gui
