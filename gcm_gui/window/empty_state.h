#pragma once

#include <gcm_gui/session/gcm_link.h>

#include <QWidget>

class QLabel;
class QLayout;
class QLineEdit;
class QPushButton;

namespace tendon::gui {

/// What the middle of the window shows while no component is known: what that means, buttons
/// that start a GCM or the demo, where that can be done, go to another machine and show the window
/// around, and the line for a terminal that changes it.
class EmptyState : public QWidget {
  Q_OBJECT

 public:
  /// What can be started on this machine.
  struct Offers {
    bool gcm = false;
    bool demo = false;
  };

  EmptyState(const GcmLink& link, Offers offers, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// One is to be started where none answers.
  void gcmRequested();
  void demoRequested();
  /// Another GCM is to be shown.
  void otherRequested();
  void tourRequested();

 private:
  [[nodiscard]] QWidget* buildDemo();
  [[nodiscard]] QLayout* buildWaysOn();
  void refresh();

  const GcmLink& link_;
  const Offers offers_;
  QLabel* title_;
  QLabel* text_;
  QWidget* demo_;
  QPushButton* start_;
  QLabel* terminal_;
  QLineEdit* command_;
};

}  // namespace tendon::gui
