#pragma once

#include <chrono>
#include <mutex>

namespace tendon {

/// A time of the machine's steady clock (CLOCK_MONOTONIC) in nanoseconds, used for rows, events and
/// leases. This clock never jumps, and processes of one machine can compare their times.
using SteadyTime = std::chrono::time_point<std::chrono::steady_clock, std::chrono::nanoseconds>;

/// A clock. Classes read the time from it, so that a test can set the time.
class Clock {
 public:
  virtual ~Clock() = default;
  /// Thread-safe, wait-free in SteadyClock.
  [[nodiscard]] virtual SteadyTime Now() const noexcept = 0;
};

/// The real clock.
const Clock& SteadyClock() noexcept;

/// The longest timeout. It is practically forever, but can be added to the present time without an
/// overflow.
inline constexpr std::chrono::nanoseconds kLongestWait = std::chrono::hours(24 * 365);
/// Returns the present time of the real clock plus `timeout`, which is limited to kLongestWait.
[[nodiscard]] SteadyTime DeadlineAfter(std::chrono::nanoseconds timeout) noexcept;

/// A clock for tests. Its time changes only in Advance().
class ManualClock final : public Clock {
 public:
  [[nodiscard]] SteadyTime Now() const noexcept override;
  void Advance(std::chrono::nanoseconds by);

 private:
  mutable std::mutex mutex_;
  SteadyTime now_{std::chrono::seconds(1)};
};

}  // namespace tendon
