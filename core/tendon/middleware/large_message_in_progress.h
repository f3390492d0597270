#pragma once

#include <tendon/base/clock.h>

#include <chrono>
#include <cstddef>

namespace tendon {

/// Exists while a thread of the middleware encodes or handles a large message, which may take
/// seconds. The thread does not read from its peers during this time, so their silence must not
/// count as a failure. Destroy the object in the thread that created it; destroy nested objects
/// first. Locks and allocates only for the first object of a thread, and for an object that lives
/// longer than kShort.
class LargeMessageInProgress {
 public:
  LargeMessageInProgress();
  LargeMessageInProgress(const LargeMessageInProgress&) = delete;
  LargeMessageInProgress& operator=(const LargeMessageInProgress&) = delete;
  ~LargeMessageInProgress();

  /// The size in bytes from which a message counts as large. Smaller messages need no object.
  static constexpr std::size_t kLeast = std::size_t{4} << 20U;
  /// Work that takes less time is not taken into account: a peer that is silent during it is still
  /// counted as failed.
  static constexpr std::chrono::milliseconds kShort{250};
  /// The longest silence of a peer that large messages excuse. A thread that needs more time for a
  /// message counts as hanging.
  static constexpr std::chrono::seconds kAtMost{30};

  /// The last time at which work longer than kShort was in progress: `now` if it still is, up to
  /// kAtMost after its start. Any thread.
  [[nodiscard]] static SteadyTime Last(SteadyTime now);

 private:
  const SteadyTime since_;
  const SteadyTime outer_since_;  // start of the enclosing object, if any
};

}  // namespace tendon
