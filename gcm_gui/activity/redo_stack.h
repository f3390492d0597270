#pragma once

#include <gcm_gui/activity/activity_model.h>
#include <gcm_gui/session/system_requests.h>

#include <QObject>
#include <QString>
#include <vector>

namespace tendon::gui {

/// Redoes the actions that were undone in this window, starting with the action that was undone
/// last. Another action of the user clears the stack. Never redoes the start or stop of a
/// component. GUI thread.
class RedoStack : public QObject {
  Q_OBJECT

 public:
  RedoStack(ActivityModel& activity, SystemActions& actions, QObject* parent = nullptr);

  /// Redoes the action that was undone last. If this is impossible, emits a notice() with the
  /// reason.
  void again();

 Q_SIGNALS:
  /// Emitted with one sentence for the user.
  void notice(const QString& text);

 private:
  void onDone(const Action& action);

  SystemActions& actions_;
  std::vector<Action> undone_;  // the last element is the action that was undone last
  bool is_under_way_ = false;   // a redo was requested; the next finished action is this redo
};

}  // namespace tendon::gui
