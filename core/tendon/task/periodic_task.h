#pragma once

#include <tendon/task/cycle_grid.h>
#include <tendon/task/threaded_task.h>

#include <chrono>
#include <string>

namespace tendon {

/// A task whose cycles, each one a call of Run(), are due at equally spaced, absolute times on the
/// steady clock, so that the times do not drift. If a cycle takes longer than the period, the task
/// skips to the next time on the grid. Skipped cycles count as overruns and are never made up in a
/// burst.
class PeriodicTask : public ThreadedTask {
 protected:
  /// `period` is 10 µs to 3600 s; otherwise throws ConfigurationError.
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
