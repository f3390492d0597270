#pragma once

#include <tendon/base/clock.h>

#include <chrono>
#include <cstddef>

namespace tendon {

/// Marks the time in which a thread of the middleware handles or makes a large message, which may
/// take seconds. The thread does not read from its peers meanwhile, so their silence is not a
/// failure. Destroy the object in its thread, nested ones first. Locks and allocates only for the
/// first object of a thread, and for one that lives longer than kShort.
class LargeMessageInProgress {
 public:
  LargeMessageInProgress();
  LargeMessageInProgress(const LargeMessageInProgress&) = delete;
  LargeMessageInProgress& operator=(const LargeMessageInProgress&) = delete;
  ~LargeMessageInProgress();

  /// Smaller messages are always handled quickly.
  static constexpr std::size_t kLeast = std::size_t{4} << 20U;
  /// Shorter work delays nobody, so silence during it still counts as a failure.
  static constexpr std::chrono::milliseconds kShort{250};
  /// The longest silence that it excuses. A thread that takes longer counts as hanging.
  static constexpr std::chrono::seconds kAtMost{30};

  /// The last time at which work longer than kShort was in progress: `now` if it still is, up to
  /// kAtMost after its start. Any thread.
  [[nodiscard]] static SteadyTime Last(SteadyTime now);

 private:
  const SteadyTime since_;
  const SteadyTime outer_since_;  // start of the enclosing object, if any
};

}  // namespace tendon
