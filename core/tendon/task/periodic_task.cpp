#include <tendon/base/os/thread.h>
#include <tendon/task/periodic_task.h>

#include <utility>

namespace tendon {

using namespace std::chrono_literals;

PeriodicTask::PeriodicTask(std::string name, std::chrono::nanoseconds period)
    : Task(std::move(name)), period_(period) {
  if (period < 10us || period > 3600s) {
    throw ConfigurationError("period of '" + this->name() + "' must be 10 us..3600 s, got " +
                             std::to_string(period.count()) + " ns");
  }
}

PeriodicTask::~PeriodicTask() { Join(); }

void PeriodicTask::Loop() {
  const auto seconds = [](std::chrono::nanoseconds time) {
    return std::chrono::duration<double>(time).count();
  };
  os::SetTimerSlack(1);
  SteadyTime due = SteadyClock().Now() + period_;
  SteadyTime last{};
  while (SleepUntil(due)) {
    const SteadyTime begin = SteadyClock().Now();
    cycle().period = last == SteadyTime{} ? 0.0 : seconds(begin - last);
    cycle().lateness = seconds(begin - due);
    last = begin;
    if (!DoCycle(begin)) return;
    const SteadyTime end = SteadyClock().Now();
    cycle().compute = seconds(end - begin);
    cycle().load = seconds(end - begin) / seconds(period_);
    due += period_;
    if (end >= due + period_) {
      const auto missed = (end - due) / period_;
      cycle().overruns += static_cast<std::uint64_t>(missed);
      due += missed * period_;
    }
  }
}

bool PeriodicTask::SleepUntil(SteadyTime time) const {
  constexpr auto kSlice = 50ms;  // how long a stop may have to wait for a slow task
  while (!stop_requested()) {
    const SteadyTime slice_end = SteadyClock().Now() + kSlice;
    if (time <= slice_end) {
      os::SleepUntil(time);
      return !stop_requested();
    }
    os::SleepUntil(slice_end);
  }
  return false;
}

}  // namespace tendon
