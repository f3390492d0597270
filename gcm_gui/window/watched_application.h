#pragma once

#include <QApplication>
#include <chrono>

namespace tendon::gui {

/// The application, which notes how much processor time its longest event handler took. Waiting for
/// the processor does not count, so a busy machine does not look like a stall.
class WatchedApplication : public QApplication {
  Q_OBJECT

 public:
  using QApplication::QApplication;

  bool notify(QObject* receiver, QEvent* event) override;

  [[nodiscard]] std::chrono::nanoseconds longestHandler() const { return longest_; }
  /// What it was: the receiver's class and the event's type.
  [[nodiscard]] const QString& longestName() const { return longest_name_; }

 private:
  int depth_ = 0;
  std::chrono::nanoseconds longest_{0};
  QString longest_name_;
};

}  // namespace tendon::gui
