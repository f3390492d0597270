#pragma once

#include <chrono>
#include <mutex>

namespace tendon {

/// Nanoseconds on the machine's steady clock (CLOCK_MONOTONIC): the time of rows, events and
/// leases. Never jumps; comparable between processes of one machine.
using SteadyTime = std::chrono::time_point<std::chrono::steady_clock, std::chrono::nanoseconds>;

/// The source of time for a class, so that a test can set the time.
class Clock {
 public:
  virtual ~Clock() = default;
  /// Thread-safe, wait-free in SteadyClock.
  [[nodiscard]] virtual SteadyTime Now() const noexcept = 0;
};

/// The real clock.
const Clock& SteadyClock() noexcept;

/// The longest wait: practically forever, but short enough to be added to the present time.
inline constexpr std::chrono::nanoseconds kLongestWait = std::chrono::hours(24 * 365);
/// The present time plus `timeout`, which is limited to kLongestWait. Real clock.
[[nodiscard]] SteadyTime DeadlineAfter(std::chrono::nanoseconds timeout) noexcept;

/// Stands still until Advance().
class ManualClock final : public Clock {
 public:
  [[nodiscard]] SteadyTime Now() const noexcept override;
  void Advance(std::chrono::nanoseconds by);

 private:
  mutable std::mutex mutex_;
  SteadyTime now_{std::chrono::seconds(1)};
};

}  // namespace tendon
