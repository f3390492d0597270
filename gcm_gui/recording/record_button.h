#pragma once

#include <gcm_gui/recording/recording_controller.h>

#include <QWidget>

class QMenu;
class QPushButton;

namespace tendon::gui {

/// Starts and stops a recording. The arrow beside it opens a menu that chooses what to record.
class RecordButton : public QWidget {
  Q_OBJECT

 public:
  /// `menu` must outlive this object.
  RecordButton(RecordingController& controller, QMenu& menu, QWidget* parent = nullptr);

  /// Places both parts between two widgets of the same window in the tab order.
  void setTabPlace(QWidget* before, QWidget* after);
  /// Shows or hides the text. Without the text, the button shows only its icon.
  void setTextShown(bool shown);
  /// Returns the part of the button's width that the text takes, in pixels.
  [[nodiscard]] int textWidth() const;

 private:
  void refresh();

  RecordingController& controller_;
  QPushButton* button_;
  QPushButton* arrow_;
  bool is_text_shown_ = true;
};

}  // namespace tendon::gui
