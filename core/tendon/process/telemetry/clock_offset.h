#pragma once

#include <tendon/base/clock.h>

#include <array>
#include <chrono>
#include <cstddef>

namespace tendon {

/// How far the steady clock of another process is ahead of ours, from questions that it answers
/// with its time; by the clock filter of NTP (RFC 5905, section 10):
///
///  - The answer was given somewhere between question and arrival, so half the round trip bounds
///    the error, however unlike the two ways are. Of the last eight answers that with the smallest
///    bound counts. A bound grows with its age, as two clocks may drift apart by 100 ppm.
///  - Where zero is within the bound, the offset is zero: processes of one host share one clock.
///  - Answers that cannot both be true show that a clock has jumped. The older ones are forgotten.
///
/// What rows are corrected by follows the estimate smoothly: by at most 500 ppm, unless it is over
/// 128 ms away, where that would take minutes.
///
/// Not thread-safe; a copy is cheap.
class ClockOffset {
 public:
  /// The other's clock minus ours is within `uncertainty` of `offset`.
  struct Estimate {
    std::chrono::nanoseconds offset{0};
    std::chrono::nanoseconds uncertainty = kUnknown;
  };
  /// The uncertainty before the first answer.
  static constexpr std::chrono::nanoseconds kUnknown = std::chrono::nanoseconds::max();

  /// A time that another process claims, as one that sums and differences do not overflow with:
  /// from 0 to 50 years.
  [[nodiscard]] static SteadyTime Sensible(SteadyTime time);

  /// A question was sent and its answer has arrived, by our clock; the other's showed `there` in
  /// between. An answer that cannot be is passed over.
  void Add(SteadyTime sent, SteadyTime there, SteadyTime arrived);

  /// By our clock.
  [[nodiscard]] Estimate At(SteadyTime now) const;
  /// To be taken off the time of what happened at `there`, by the other's clock. A line without
  /// jumps, but for those above.
  [[nodiscard]] std::chrono::nanoseconds SlewedAt(SteadyTime there) const;

 private:
  struct Answer {
    std::chrono::nanoseconds offset{0};
    std::chrono::nanoseconds bound = kUnknown;
    SteadyTime arrived;
  };

  [[nodiscard]] Estimate Best(SteadyTime now) const;

  std::array<Answer, 8> answers_;
  std::size_t count_ = 0;  // of answers ever, or since a jump
  // What rows are corrected by: from `offset_` at `since_`, by the other's clock, towards target_.
  SteadyTime since_;
  std::chrono::nanoseconds offset_{0};
  std::chrono::nanoseconds target_{0};
};

}  // namespace tendon
