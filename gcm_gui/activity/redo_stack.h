#pragma once

#include <gcm_gui/activity/activity_model.h>
#include <gcm_gui/session/system_requests.h>

#include <QObject>
#include <QString>
#include <vector>

namespace tendon::gui {

/// Redoes the actions that this window has undone, the last one first, until the user does
/// something else. It never redoes a start or stop of a component. GUI thread.
class RedoStack : public QObject {
  Q_OBJECT

 public:
  RedoStack(ActivityModel& activity, SystemActions& actions, QObject* parent = nullptr);

  /// Redoes the last undone action, or emits a notice() with the reason why this is impossible.
  void again();

 Q_SIGNALS:
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  void onDone(const Action& action);

  SystemActions& actions_;
  std::vector<Action> undone_;  // the last one at the back
  bool is_under_way_ = false;   // the next finished action is a redo of this object
};

}  // namespace tendon::gui
