#pragma once

#include <gcm_gui/activity/events_model.h>
#include <gcm_gui/session/system_reports.h>

#include <QTimer>
#include <QWidget>
#include <cstddef>

class QLabel;

namespace tendon::gui {

/// Shows the latest events of one component and their rate. It is subscribed to the events only
/// while it is visible.
class EventList : public QWidget {
  Q_OBJECT

 public:
  static constexpr std::size_t kKept = 100;

  explicit EventList(SystemReports& reports, QWidget* parent = nullptr);

  /// Sets the component by its path, such as "robot/arm"; empty for none.
  void show(const QString& component);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void listen();
  void showRate();

  SystemReports& reports_;
  EventsModel events_{kKept};
  QString component_;
  QTimer rate_timer_;
  QLabel* rate_;
};

}  // namespace tendon::gui
