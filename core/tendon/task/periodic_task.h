#pragma once

#include <tendon/task/cycle_grid.h>
#include <tendon/task/threaded_task.h>

#include <chrono>
#include <string>

namespace tendon {

/// A task that calls Run() periodically. The due times of the cycles are equally spaced, absolute
/// times on the steady clock, so they do not drift. If a cycle takes longer than the period, the
/// task continues at the next due time. Skipped cycles are counted as overruns, and are never made
/// later in a burst.
class PeriodicTask : public ThreadedTask {
 protected:
  /// Throws ConfigurationError if `period` is not 10 µs to 3600 s.
  PeriodicTask(std::string name, std::chrono::nanoseconds period);
  ~PeriodicTask() override;

  void OnActive() override;
  void Loop() override;
  [[nodiscard]] double own_period() const override;
  [[nodiscard]] std::chrono::nanoseconds row_period() const override { return grid_.period(); }

 private:
  CycleGrid grid_;
};

}  // namespace tendon
