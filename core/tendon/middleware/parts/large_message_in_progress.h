#pragma once

#include <tendon/base/clock.h>

#include <chrono>
#include <cstddef>

namespace tendon {

/// Marks a thread of the middleware that handles or makes something large, which may take seconds.
/// That thread does not hear its peers meanwhile, so nobody must take their silence for a failure.
/// Destroy it in its thread, nested ones first. Locks and allocates only for the first one of a
/// thread and for one that takes longer than kShort.
class LargeMessageInProgress {
 public:
  LargeMessageInProgress();
  LargeMessageInProgress(const LargeMessageInProgress&) = delete;
  LargeMessageInProgress& operator=(const LargeMessageInProgress&) = delete;
  ~LargeMessageInProgress();

  /// Fewer bytes than this are known to be handled soon.
  static constexpr std::size_t kLeast = std::size_t{4} << 20U;
  /// A shorter one delays nobody, so it excuses no silence.
  static constexpr std::chrono::milliseconds kShort{250};
  /// The longest silence that it excuses. A thread that takes longer hangs.
  static constexpr std::chrono::seconds kAtMost{30};

  /// When one that takes longer than kShort was last under way: `now` if one is, but for at most
  /// kAtMost after its start. Any thread.
  [[nodiscard]] static SteadyTime Last(SteadyTime now);

 private:
  const SteadyTime since_;
  const SteadyTime outer_since_;  // of the enclosing one, if any
};

}  // namespace tendon
