#include <tendon/task/periodic_task.h>

#include <utility>

namespace tendon {

PeriodicTask::PeriodicTask(std::string name, std::chrono::nanoseconds period)
    : ThreadedTask(std::move(name)), grid_(CheckedPeriod(period, this->name())) {}

PeriodicTask::~PeriodicTask() { Join(); }

double PeriodicTask::own_period() const {
  return std::chrono::duration<double>(grid_.period()).count();
}

void PeriodicTask::OnActive() { grid_.Begin(SteadyClock().Now()); }

void PeriodicTask::Loop() {
  const auto interrupted = [this] { return has_orders(); };
  while (SleepUntil(grid_.due(), options_in_use().spin, interrupted)) {
    if (!DoCycle(SteadyClock().Now(), grid_.due())) return;
    AddOverruns(grid_.Next(cycle_end()));
  }
}

}  // namespace tendon
