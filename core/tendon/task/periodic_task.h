#pragma once

#include <tendon/task/cycle/cycle_grid.h>
#include <tendon/task/thread/threaded_task.h>

#include <chrono>
#include <string>

namespace tendon {

/// A task whose cycle is due at equal distances on the steady clock, by absolute times: it does not
/// drift. A cycle that takes longer than the period makes it skip to the next time on the grid;
/// skipped ones are counted as overruns, never caught up in a burst.
class PeriodicTask : public ThreadedTask {
 protected:
  /// `period` is 10 µs to 3600 s, else ConfigurationError.
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
