#include <tendon/task/continuous_task.h>

#include <utility>

namespace tendon {

ContinuousTask::ContinuousTask(std::string name) : ThreadedTask(std::move(name)) {
  SetShortestInterval(std::chrono::milliseconds(1));
}

ContinuousTask::~ContinuousTask() { Join(); }

void ContinuousTask::Loop() {
  SteadyTime begin = SteadyClock().Now();
  while (!has_orders() && DoCycle(begin)) begin = cycle_end();
}

}  // namespace tendon
