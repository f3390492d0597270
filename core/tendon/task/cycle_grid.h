#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/os/thread.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <string>

namespace tendon {

/// The due times of a periodic cycle. They are equally spaced on the steady clock, so the cycle
/// does not drift. Used by one thread.
class CycleGrid {
 public:
  explicit CycleGrid(std::chrono::nanoseconds period) noexcept : period_(period) {}

  [[nodiscard]] std::chrono::nanoseconds period() const noexcept { return period_; }
  [[nodiscard]] SteadyTime due() const noexcept { return due_; }

  /// Starts a new grid. The first due time is one period after `now`.
  void Begin(SteadyTime now) noexcept { due_ = now + period_; }

  /// Advances to the next due time, and returns the number of skipped due times. If the next due
  /// time is one period or more in the past, skips to the latest due time that is not after `now`,
  /// so that missed cycles are not made in a burst.
  std::uint64_t Next(SteadyTime now) noexcept;

 private:
  std::chrono::nanoseconds period_;
  SteadyTime due_{};
};

/// Returns `period` if it is 10 µs to 3600 s; otherwise throws a ConfigurationError that names
/// `task`.
std::chrono::nanoseconds CheckedPeriod(std::chrono::nanoseconds period, const std::string& task);

/// Sleeps until the time `spin` before `time`, and then spins until `time`. Returns false at most
/// 50 ms after `interrupted()` has become true.
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
