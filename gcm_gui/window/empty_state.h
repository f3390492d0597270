#pragma once

#include <gcm_gui/session/gcm_link.h>

#include <QWidget>

class QLabel;
class QLineEdit;

namespace tendon::gui {

/// What the middle of the window shows while no component is known: what that means, buttons
/// that start the demo, where that can be done, and go to another machine, and the line for a
/// terminal that changes it.
class EmptyState : public QWidget {
  Q_OBJECT

 public:
  /// `offers_demo`: there is one, for a GCM on this machine.
  EmptyState(const GcmLink& link, bool offers_demo, QWidget* parent = nullptr);

 Q_SIGNALS:
  void demoRequested();
  /// Another GCM is to be shown.
  void otherRequested();

 private:
  [[nodiscard]] QWidget* buildDemo();
  void refresh();

  const GcmLink& link_;
  const bool offers_demo_;
  QLabel* title_;
  QLabel* text_;
  QWidget* demo_;
  QLabel* terminal_;
  QLineEdit* command_;
};

}  // namespace tendon::gui
