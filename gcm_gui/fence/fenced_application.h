#pragma once

#include <QApplication>

namespace tendon::gui {

/// The application, which goes on when an event handler throws: the exception ends at the widget or
/// object that the event was for, and is told by the Fence.
class FencedApplication : public QApplication {
  Q_OBJECT

 public:
  using QApplication::QApplication;

  /// QApplication::exec(), begun anew should an exception come out of it past notify().
  static int exec();

  bool notify(QObject* receiver, QEvent* event) override;
};

}  // namespace tendon::gui
