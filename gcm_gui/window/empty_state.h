#pragma once

#include <gcm_gui/session/link_state.h>

#include <QString>
#include <QStringList>
#include <QWidget>

class QLabel;
class QLayout;
class QLineEdit;
class QPushButton;

namespace tendon::gui {

/// The middle of the window while no component is known. It explains why, and has buttons to start
/// a GCM or the demo (if possible), to connect to another machine, to open a recording, and to take
/// the tour. It also shows a shell command that starts components.
class EmptyState : public QWidget {
  Q_OBJECT

 public:
  /// The programs that this window can start.
  struct Offers {
    bool gcm = false;
    bool demo = false;
    bool recordings = false;  ///< another window, for a recording
    QStringList recent{};     ///< recordings, latest first
  };

  EmptyState(const LinkState& link, Offers offers, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// Emitted when the user wants to start a GCM, because no GCM answers.
  void gcmRequested();
  void demoRequested();
  /// Emitted when the user wants to connect to another GCM.
  void otherRequested();
  void tourRequested();
  /// Emitted when the user wants to choose a recording, or to open this one.
  void recordingRequested();
  void recentRequested(const QString& file);

 private:
  [[nodiscard]] QWidget* buildDemo();
  [[nodiscard]] QLayout* buildWaysOn();
  [[nodiscard]] QWidget* buildRecordings();
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
