#pragma once

#include <tendon/task/callback_task.h>
#include <tendon/task/cycle_grid.h>

#include <chrono>
#include <string>

namespace tendon {

/// A periodic task that runs in the thread of main(), because windows and some devices require it:
///
///     manager.StartAll();
///     window.RunInThisThread();  // until another thread stops it
class MainTask : public CallbackTask {
 public:
  /// Makes the cycles of the task in the calling thread until the task has finished or is faulted.
  /// The task must be started before.
  void RunInThisThread();

  [[nodiscard]] double period() const override;

 protected:
  /// Throws ConfigurationError if `period` is not 10 µs to 3600 s.
  MainTask(std::string name, std::chrono::nanoseconds period);

  [[nodiscard]] std::chrono::nanoseconds row_period() const override { return grid_.period(); }

 private:
  CycleGrid grid_;
};

}  // namespace tendon
