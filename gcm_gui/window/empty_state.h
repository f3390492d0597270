#pragma once

#include <gcm_gui/session/gcm_link.h>

#include <QWidget>

class QLabel;
class QLineEdit;

namespace tendon::gui {

/// What the middle of the window shows while no component is known: what that means, and the line
/// for a terminal that changes it.
class EmptyState : public QWidget {
  Q_OBJECT

 public:
  explicit EmptyState(const GcmLink& link, QWidget* parent = nullptr);

 private:
  void refresh();

  const GcmLink& link_;
  QLabel* title_;
  QLabel* text_;
  QLineEdit* command_;
};

}  // namespace tendon::gui
