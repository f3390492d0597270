#include <gcm_gui/system/plan_activity.h>

#include <gcm_gui/models/text.h>
#include <gcm_gui/system/plan_controller.h>

#include <utility>

namespace tendon::gui {

PlanActivity::PlanActivity(const PlanController& restore, const SystemDocument& document,
                           ActivityModel& activity)
    : restore_(restore), document_(document), activity_(activity) {
  connect(&restore, &PlanController::changed, this, &PlanActivity::look);
}

void PlanActivity::look() {
  const bool runs = restore_.phase() == PlanController::Phase::kRunning;
  if (runs && !running_) {
    Action action;
    action.verb = Action::Verb::kApply;
    action.argument = restore_.goal();
    if (restore_.goal() == document_.name()) action.file = document_.path();
    since_.start();
    running_ = activity_.begin(std::move(action));
  }
  if (runs || !running_) return;
  const auto& error = restore_.outcome().error;
  const double seconds = static_cast<double>(since_.elapsed()) / 1000;
  activity_.finish(*std::exchange(running_, std::nullopt), seconds,
                   error ? ToQString(error->message) : QString());
}

}  // namespace tendon::gui
