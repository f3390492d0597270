#pragma once

#include <gcm_gui/session/link_state.h>

#include <QWidget>

class QLabel;
class QLayout;
class QLineEdit;
class QPushButton;

namespace tendon::gui {

/// The middle of the window while no component is known. It explains this state and has buttons to
/// start a GCM or the demo (if possible), to go to another machine and to take the tour, and a
/// shell command that starts components.
class EmptyState : public QWidget {
  Q_OBJECT

 public:
  /// The programs that can be started on this machine.
  struct Offers {
    bool gcm = false;
    bool demo = false;
  };

  EmptyState(const LinkState& link, Offers offers, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// The user wants to start a GCM because none answers.
  void gcmRequested();
  void demoRequested();
  /// The user wants to see another GCM.
  void otherRequested();
  void tourRequested();

 private:
  [[nodiscard]] QWidget* buildDemo();
  [[nodiscard]] QLayout* buildWaysOn();
  void refresh();

  const LinkState& link_;
  const Offers offers_;
  QLabel* title_;
  QLabel* text_;
  QWidget* demo_;
  QPushButton* start_;
  QLabel* terminal_;
  QLineEdit* command_;
};

}  // namespace tendon::gui
