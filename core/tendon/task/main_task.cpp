#include <tendon/task/main_task.h>

#include <utility>

namespace tendon {

MainTask::MainTask(std::string name, std::chrono::nanoseconds period)
    : CallbackTask(std::move(name)), grid_(CheckedPeriod(period, this->name())) {}

double MainTask::period() const { return std::chrono::duration<double>(grid_.period()).count(); }

void MainTask::RunInThisThread() {
  grid_.Begin(SteadyClock().Now());
  const auto is_over = [this] { return !IsRunning(state()); };
  while (SleepUntil(grid_.due(), std::chrono::nanoseconds(0), is_over)) {
    CycleDue(grid_.due());
    SkipCycles(grid_.Next(SteadyClock().Now()));
  }
}

}  // namespace tendon
