#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/os/thread.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <string>

namespace tendon {

/// The times at which a periodic cycle is due: equal distances on the steady clock, so it does not
/// drift. One thread.
class CycleGrid {
 public:
  explicit CycleGrid(std::chrono::nanoseconds period) noexcept : period_(period) {}

  [[nodiscard]] std::chrono::nanoseconds period() const noexcept { return period_; }
  [[nodiscard]] SteadyTime due() const noexcept { return due_; }

  /// A new grid, of which the first time is a period after `now`.
  void Begin(SteadyTime now) noexcept { due_ = now + period_; }

  /// Goes on to the next time; where that is a whole period ago or more, to the latest on the grid
  /// that is not after `now`, so that nothing is caught up in a burst. Returns how many were
  /// skipped.
  std::uint64_t Next(SteadyTime now) noexcept;

 private:
  std::chrono::nanoseconds period_;
  SteadyTime due_{};
};

/// Its argument, or ConfigurationError where that is not 10 µs to 3600 s; `task` is named.
std::chrono::nanoseconds CheckedPeriod(std::chrono::nanoseconds period, const std::string& task);

/// Sleeps until `time`, the last `spin` of it awake; false as soon as `interrupted()`, which a
/// sleeper notices within 50 ms.
template <typename Predicate>
bool SleepUntil(SteadyTime time, std::chrono::nanoseconds spin, Predicate interrupted) {
  constexpr std::chrono::milliseconds kSlice(50);
  const SteadyTime wake = time - spin;
  while (!interrupted()) {
    const SteadyTime slice_end = SteadyClock().Now() + kSlice;
    os::SleepUntil(std::min(wake, slice_end));
    if (wake > slice_end) continue;
    while (spin.count() > 0 && SteadyClock().Now() < time) {
    }
    return !interrupted();
  }
  return false;
}

}  // namespace tendon
