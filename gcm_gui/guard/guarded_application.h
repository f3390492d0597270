#pragma once

#include <QApplication>

namespace tendon::gui {

/// An application that continues after an exception in an event handler: the exception is caught at
/// the widget or object that received the event, and reported by the ExceptionGuard.
class GuardedApplication : public QApplication {
  Q_OBJECT

 public:
  using QApplication::QApplication;

  /// Runs QApplication::exec(), and restarts it if an exception leaves notify().
  static int exec();

  bool notify(QObject* receiver, QEvent* event) override;
};

}  // namespace tendon::gui
