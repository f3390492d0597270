#pragma once

#include <tendon/base/clock.h>

#include <array>
#include <chrono>
#include <cstddef>

namespace tendon {

/// Estimates how far the steady clock of another process is ahead of the clock of this process. The
/// other process replies to requests with its time. The clock filter of NTP (RFC 5905, section 10)
/// evaluates the replies:
///
///  - The other process read its clock after the request was sent and before the reply arrived.
///    Therefore, the error is at most half of the round trip, even if the two directions take
///    different times. Of the last eight replies, the one with the smallest error bound is used.
///    The bound grows with age, because two clocks may drift apart by 100 ppm.
///  - If zero is within the bound, the offset is zero: processes of one host share one clock.
///  - If two replies contradict each other, a clock has jumped. The older replies are discarded.
///
/// The correction of rows follows the estimate smoothly, by at most 500 ppm. If correction and
/// estimate differ by more than 128 ms, the correction jumps, because a smooth change would take
/// minutes.
///
/// Not thread-safe; a copy is cheap.
class ClockOffset {
 public:
  /// The offset: the other clock minus the clock of this process, with its largest possible error.
  struct Estimate {
    std::chrono::nanoseconds offset{0};
    std::chrono::nanoseconds uncertainty = kUnknown;
  };
  /// The uncertainty before the first reply.
  static constexpr std::chrono::nanoseconds kUnknown = std::chrono::nanoseconds::max();

  /// Limits a time from another process to 0 to 50 years, so that sums and differences do not
  /// overflow.
  [[nodiscard]] static SteadyTime Sensible(SteadyTime time);

  /// Adds a measurement. `sent` and `arrived` are the times of request and reply on the clock of
  /// this process. `there` is the time of the other clock in between. Ignores impossible replies.
  void Add(SteadyTime sent, SteadyTime there, SteadyTime arrived);

  /// Returns the estimate for the time `now` of this process's clock.
  [[nodiscard]] Estimate At(SteadyTime now) const;
  /// Returns the correction for a row, to be subtracted from `there`, the row's time on the other
  /// clock. The correction is continuous, except for the jumps described above.
  [[nodiscard]] std::chrono::nanoseconds SlewedAt(SteadyTime there) const;

 private:
  struct Measurement {
    std::chrono::nanoseconds offset{0};
    std::chrono::nanoseconds bound = kUnknown;
    SteadyTime arrived;
  };

  [[nodiscard]] Estimate Best(SteadyTime now) const;

  std::array<Measurement, 8> measurements_;
  std::size_t count_ = 0;  // number of measurements since the start or the last jump
  // The correction was `offset_` at the time `since_` of the other clock, and moves towards
  // target_.
  SteadyTime since_;
  std::chrono::nanoseconds offset_{0};
  std::chrono::nanoseconds target_{0};
};

}  // namespace tendon
