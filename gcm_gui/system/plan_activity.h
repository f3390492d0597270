#pragma once

#include <gcm_gui/activity/activity_model.h>

#include <QElapsedTimer>
#include <QObject>
#include <optional>

namespace tendon::gui {

class PlanController;
class SystemDocument;

/// Records each executed plan in the activity list, as one action with the shell command for the
/// plan's file. GUI thread; all arguments must outlive this object.
class PlanActivity : public QObject {
  Q_OBJECT

 public:
  PlanActivity(const PlanController& restore, const SystemDocument& document,
               ActivityModel& activity);

 private:
  void look();

  const PlanController& restore_;
  const SystemDocument& document_;
  ActivityModel& activity_;
  std::optional<ActivityModel::Id> running_;
  QElapsedTimer since_;
};

}  // namespace tendon::gui
