#pragma once

#include <gcm_gui/activity/events_model.h>
#include <gcm_gui/models/selection.h>
#include <gcm_gui/session/system_reports.h>

#include <QTimer>
#include <QWidget>
#include <cstddef>

class QComboBox;
class QLabel;
class QLineEdit;
class QToolButton;

namespace tendon::gui {

class RowView;

/// Shows the events of all components or of the selected ones, with their rate, a filter and a
/// pause button. Subscribes to events when it is shown for the first time.
class EventsPage : public QWidget {
  Q_OBJECT

 public:
  static constexpr std::size_t kKept = 5000;

  EventsPage(SystemReports& reports, Selection& selection, QWidget* parent = nullptr);

  [[nodiscard]] const EventsModel& events() const { return events_; }

 Q_SIGNALS:
  /// Emitted when the user clicks the origin of an event.
  void pathChosen(const QString& path);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* buildBar();
  void listen();
  void showRate();

  SystemReports& reports_;
  Selection& selection_;
  EventsModel events_{kKept};
  bool is_listening_ = false;
  QTimer rate_timer_;

  QComboBox* whose_;
  QLineEdit* words_;
  QLabel* rate_;
  QToolButton* pause_;
  RowView* list_;
};

/// Returns the counts as text: "3 events · 12.5 a second · 4 lost".
[[nodiscard]] QString CountsText(const EventsModel& events);

}  // namespace tendon::gui
