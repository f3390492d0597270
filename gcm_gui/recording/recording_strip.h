#pragma once

#include <gcm_gui/recording/recording_controller.h>

#include <QFrame>
#include <QString>

class QLabel;
class QPushButton;
class QToolButton;

namespace tendon::gui {

class StateLabel;

/// A line across the window. During a recording, it shows the subject, the figures and a Stop
/// button. Afterwards, it shows the outcome until the user closes it. Otherwise, it is hidden.
class RecordingStrip : public QFrame {
  Q_OBJECT

 public:
  explicit RecordingStrip(RecordingController& controller, QWidget* parent = nullptr);

  /// The whole text of the line, for screen readers.
  [[nodiscard]] QString text() const;

 Q_SIGNALS:
  void showInFolderRequested(const QString& file);
  void copyPathRequested(const QString& file);
  void folderRequested();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void build();
  void refresh();
  void showRecording();
  void showReport(const RecordingReport& report);
  void setMessage(const QString& message);
  void elideMessage();

  RecordingController& controller_;
  QString message_;
  QLabel* dot_;  // shown with title_ during a recording; otherwise state_ is shown
  QLabel* title_;
  StateLabel* state_;
  QLabel* message_label_;
  StateLabel* interruptions_;
  QLabel* length_;
  QLabel* rows_;
  QLabel* rate_;
  QLabel* size_;
  QLabel* free_;
  QLabel* lost_;
  QPushButton* stop_;
  QToolButton* show_;
  QToolButton* copy_;
  QToolButton* folder_;
  QToolButton* close_;
};

}  // namespace tendon::gui
