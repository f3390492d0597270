#pragma once

#include <gcm_gui/activity/activity_model.h>
#include <gcm_gui/session/system_actions.h>

#include <QObject>
#include <QString>
#include <vector>

namespace tendon::gui {

/// Does again what this window had undone, the last first, until something else is done. What
/// starts or stops a component is not done again by one key. GUI thread.
class Redo : public QObject {
  Q_OBJECT

 public:
  Redo(ActivityModel& activity, SystemActions& actions, QObject* parent = nullptr);

  /// Does it, or tells why not.
  void again();

 Q_SIGNALS:
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  void hearDone(const Action& action);

  SystemActions& actions_;
  std::vector<Action> undone_;  // the last at the back
  bool is_under_way_ = false;   // what is done next was asked for here
};

}  // namespace tendon::gui
