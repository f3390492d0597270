#pragma once

#include <tendon/base/clock.h>
#include <tendon/task/cycle_statistics.h>
#include <tendon/task/time_spread.h>

#include <chrono>
#include <cstdint>

namespace tendon {

/// Computes the columns `Cycle` and `CycleSummary` from the times of a task's cycles. This takes
/// some tens of nanoseconds in each cycle, and a few microseconds more once a second. Allocates no
/// memory. Used by one thread.
class CycleMeter {
 public:
  static constexpr std::chrono::nanoseconds kWindow = std::chrono::seconds(1);
  static constexpr std::uint64_t kFewestCycles = 10;

  [[nodiscard]] const CycleStatistics& cycle() const noexcept { return cycle_; }
  [[nodiscard]] const CycleSummary& summary() const noexcept { return summary_; }

  /// Resets everything. `period` is the wanted period; 0 without a period.
  void Start(std::chrono::duration<double> period) noexcept;
  /// Called when cycles are interrupted. The time until the next cycle is then not part of the
  /// statistics.
  void Interrupt() noexcept { last_begin_ = {}; }
  void Begin(SteadyTime begin, SteadyTime due) noexcept;
  /// Ends the cycle of the last Begin().
  void End(SteadyTime end) noexcept;
  void AddOverruns(std::uint64_t cycles) noexcept { cycle_.overruns += cycles; }

 private:
  void CloseWindow(SteadyTime now) noexcept;

  CycleStatistics cycle_;
  CycleSummary summary_;
  std::chrono::duration<double> wanted_period_{0.0};
  SteadyTime last_begin_{};
  SteadyTime window_begin_{};
  TimeSpread period_;
  TimeSpread lateness_;
  TimeSpread compute_;
};

}  // namespace tendon
