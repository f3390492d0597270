#include <tendon/task/signal_task.h>

#include <tendon/task/task_lifecycle.h>

#include <algorithm>
#include <utility>

namespace tendon {

SignalTask::SignalTask(std::string name) : ThreadedTask(std::move(name), PostWakeup::kWake) {}

SignalTask::~SignalTask() { Join(); }

void SignalTask::Loop() {
  constexpr std::chrono::hours kLong(1);
  const auto is_due = [this] { return has_orders() || inbox()->has_queued(); };
  while (!has_orders()) {
    const SteadyTime latest = SteadyClock().Now() + kLong;
    const SteadyTime expiry = TaskLifecycle::NextExpiry(*this);
    const bool was_called = wakeup().WaitUntil(is_due, std::min(latest, expiry));
    if (has_orders() || !(was_called || expiry < latest)) continue;
    if (!DoCycle(SteadyClock().Now())) return;
  }
}

}  // namespace tendon
