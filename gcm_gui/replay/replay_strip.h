#pragma once

#include <gcm_gui/replay/time_slider.h>

#include <QFrame>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace tendon::gui {

class ReplaySession;
class ReplayStripe;
class StateLabel;

/// The head of a window that shows a recording: the stripe, the buttons and the slider for the
/// moment. If the file is not complete, a line names the missing parts.
class ReplayStrip final : public QFrame {
  Q_OBJECT

 public:
  /// `session` must outlive this object.
  explicit ReplayStrip(ReplaySession& session, QWidget* parent = nullptr);

  [[nodiscard]] const ReplayStripe& stripe() const { return *stripe_; }
  [[nodiscard]] TimeSlider& slider() const { return *slider_; }
  /// Shows which parts of the file are missing; empty if the file is complete.
  [[nodiscard]] QString warning() const { return warning_text_; }

 Q_SIGNALS:
  /// One sentence for the user.
  void notice(const QString& text);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  [[nodiscard]] QWidget* buildControls();
  /// Shows the speed, and whether the recording is played in a loop.
  void setUpChoices();
  [[nodiscard]] QWidget* buildWarning();
  QToolButton* addButton(const QString& icon, const QString& name, const QString& text,
                         const QString& key);
  void refresh();
  void showMoment();
  void showWarning();
  void elideWarning();

  ReplaySession& session_;
  ReplayStripe* stripe_;
  QPushButton* play_;
  QLabel* moment_;
  QLabel* length_;
  TimeSlider* slider_;
  QProgressBar* busy_;
  QComboBox* speed_;
  QToolButton* loop_;
  QWidget* controls_ = nullptr;
  QWidget* warning_ = nullptr;
  StateLabel* warning_state_ = nullptr;
  QLabel* warning_label_ = nullptr;
  QToolButton* copy_ = nullptr;
  QToolButton* reload_ = nullptr;
  QString warning_text_;
  bool is_dismissed_ = false;
};

}  // namespace tendon::gui
