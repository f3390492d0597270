#include <tendon/task/callback_task.h>

#include <tendon/task/task_lifecycle.h>

namespace tendon {

bool CallbackTask::CycleDue(SteadyTime due) {
  const std::unique_lock lock(driving_, std::try_to_lock);
  if (!lock) return false;
  if (has_orders()) ObeyOrders();
  if (state() != ComponentState::kActive) return false;
  const SteadyTime now = SteadyClock().Now();
  return DoCycle(now, due == SteadyTime::min() ? now : due);
}

void CallbackTask::SkipCycles(std::uint64_t cycles) {
  const std::unique_lock lock(driving_, std::try_to_lock);
  if (lock) AddOverruns(cycles);
}

Result<void> CallbackTask::Launch() {
  PrepareStart();
  GiveOrder(LifecycleRequest::kStart);
  return {};
}

void CallbackTask::ServeWaiting() {
  const std::unique_lock lock(driving_, std::try_to_lock);
  if (!lock || !has_orders()) return;
  ObeyOrders();
  TaskLifecycle::Unbind(*this);  // because the driver's thread executes the cycles
}

}  // namespace tendon
