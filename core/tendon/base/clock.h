#pragma once

#include <chrono>
#include <mutex>

namespace tendon {

/// Nanoseconds on the machine's steady clock (CLOCK_MONOTONIC): the time of rows, events and
/// leases. Never jumps; comparable between processes of one machine.
using SteadyTime = std::chrono::time_point<std::chrono::steady_clock, std::chrono::nanoseconds>;

/// Where a class gets the time from, so that a test can turn the hands.
class Clock {
 public:
  virtual ~Clock() = default;
  /// Thread-safe, wait-free in SteadyClock.
  [[nodiscard]] virtual SteadyTime Now() const noexcept = 0;
};

/// The real one.
const Clock& SteadyClock() noexcept;

/// The longest time anybody waits for: as good as for ever, and short enough to be added to now.
inline constexpr std::chrono::nanoseconds kLongestWait = std::chrono::hours(24 * 365);
/// When `timeout`, or the longest wait if that is less, will be over by the real clock.
[[nodiscard]] SteadyTime DeadlineAfter(std::chrono::nanoseconds timeout) noexcept;

/// Stands still until told otherwise.
class ManualClock final : public Clock {
 public:
  [[nodiscard]] SteadyTime Now() const noexcept override;
  void Advance(std::chrono::nanoseconds by);

 private:
  mutable std::mutex mutex_;
  SteadyTime now_{std::chrono::seconds(1)};
};

}  // namespace tendon
