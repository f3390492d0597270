#pragma once

#include <tendon/task/task.h>

#include <chrono>
#include <string>

namespace tendon {

/// A task whose cycle is due at equal distances on the steady clock, by absolute times: it does not
/// drift. A cycle that takes longer than the period makes it skip to the next time on the grid;
/// skipped ones are counted as overruns, never caught up in a burst.
class PeriodicTask : public Task {
 public:
  [[nodiscard]] double period() const override {
    return std::chrono::duration<double>(period_).count();
  }

 protected:
  /// `period` is 10 µs to 3600 s, else ConfigurationError.
  PeriodicTask(std::string name, std::chrono::nanoseconds period);
  ~PeriodicTask() override;

  void Loop() override;
  [[nodiscard]] std::chrono::nanoseconds row_period() const override { return period_; }

 private:
  /// False when a stop was asked for meanwhile.
  bool SleepUntil(SteadyTime time) const;

  std::chrono::nanoseconds period_;
};

}  // namespace tendon
