#pragma once

#include <tendon/base/clock.h>

#include <chrono>
#include <cstddef>

namespace tendon {

/// Marks the time during which a thread of the middleware encodes or handles a large message, which
/// may take seconds. The thread does not read from its peers during this time, so their silence
/// must not count as a failure.
///
/// An object must be destroyed in the thread that created it, and nested objects in reverse order.
/// Locks a mutex and allocates memory only for the first object of a thread; an object that lives
/// longer than kShort locks a second time.
class LargeMessageInProgress {
 public:
  LargeMessageInProgress();
  LargeMessageInProgress(const LargeMessageInProgress&) = delete;
  LargeMessageInProgress& operator=(const LargeMessageInProgress&) = delete;
  ~LargeMessageInProgress();

  /// The size in bytes from which a message counts as large. Smaller messages need no object.
  static constexpr std::size_t kMin = std::size_t{4} << 20U;
  /// Shorter work is ignored: it does not excuse the silence of a peer.
  static constexpr std::chrono::milliseconds kShort{250};
  /// A large message excuses the silence of a peer for at most this time. A thread that handles a
  /// message for a longer time counts as hanging.
  static constexpr std::chrono::seconds kAtMost{30};

  /// Returns the last time when work longer than kShort was in progress in this process. For work
  /// that is still in progress, returns `now`, but at most kAtMost after the start of the work. Any
  /// thread.
  [[nodiscard]] static SteadyTime Last(SteadyTime now);

 private:
  const SteadyTime since_;
  const SteadyTime outer_since_;  // start of the enclosing object; kNothing without one
};

}  // namespace tendon
