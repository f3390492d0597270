#pragma once

#include <gcm_gui/recording/recording_controller.h>

#include <QList>
#include <QObject>
#include <QString>

class QAction;
class QMenu;
class QWidget;

namespace tendon::gui {

class Commands;
class RecordButton;
class RecordingStrip;

/// The window's handling of recordings: button, strip, menu and keys.
class WindowRecording : public QObject {
  Q_OBJECT

 public:
  WindowRecording(RecordingRunner& runner, ActivityModel& activity,
                  RecordingController::Sources sources, QWidget& window);

  [[nodiscard]] RecordingController& controller() { return controller_; }
  // The caller places both and takes ownership.
  [[nodiscard]] RecordButton& button() const { return *button_; }
  [[nodiscard]] RecordingStrip& strip() const { return *strip_; }

  void addCommands(Commands& commands);

 Q_SIGNALS:
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  void addScopes(Commands& commands);
  void choose(RecordingScope scope);
  void refresh();
  void askForFolder();
  void showInFolder(const QString& file);
  void copyPath(const QString& file);

  QWidget& window_;
  RecordingController controller_;
  QMenu* menu_;
  RecordButton* button_;
  RecordingStrip* strip_;
  QAction* toggle_ = nullptr;
  QAction* save_last_ = nullptr;
  QList<QAction*> scopes_;  // in the order of RecordingScope
};

}  // namespace tendon::gui
