#pragma once

#include <QApplication>

namespace tendon::gui {

/// An application that survives exceptions in event handlers: an exception ends at the widget or
/// object that received the event, and the ExceptionGuard reports it.
class GuardedApplication : public QApplication {
  Q_OBJECT

 public:
  using QApplication::QApplication;

  /// QApplication::exec(), restarted if an exception passes notify().
  static int exec();

  bool notify(QObject* receiver, QEvent* event) override;
};

}  // namespace tendon::gui
