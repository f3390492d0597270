#include <tendon/task/signal_task.h>

#include <utility>

namespace tendon {

SignalTask::SignalTask(std::string name) : ThreadedTask(std::move(name), Posts::kWake) {}

SignalTask::~SignalTask() { Join(); }

void SignalTask::Loop() {
  constexpr std::chrono::hours kLong(1);
  const auto is_due = [this] { return has_orders() || inbox()->has_queued(); };
  while (!has_orders()) {
    const SteadyTime before = SteadyClock().Now();
    if (!wakeup().WaitUntil(is_due, before + kLong) || has_orders()) continue;
    if (!DoCycle(SteadyClock().Now())) return;
  }
}

}  // namespace tendon
