#pragma once

#include <tendon/base/clock.h>

#include <chrono>
#include <cstddef>

namespace tendon {

/// While it lives something that may be large is handled in this process, or made, which may take a
/// thread of the middleware seconds: whatever else has arrived for that thread is not heard, and
/// nobody is to be blamed for his silence. Ends in the thread, and behind what began there later;
/// no lock and no allocation, but for what is not short and for the first of a thread.
class LargeInHand {
 public:
  LargeInHand();
  LargeInHand(const LargeInHand&) = delete;
  LargeInHand& operator=(const LargeInHand&) = delete;
  ~LargeInHand();

  /// Of fewer bytes it is known that they are handled soon.
  static constexpr std::size_t kLeast = std::size_t{4} << 20U;
  /// What is done sooner holds nobody up, and excuses nobody.
  static constexpr std::chrono::milliseconds kShort{250};
  /// For so long it excuses silence: who handles one longer than this hangs.
  static constexpr std::chrono::seconds kAtMost{30};

  /// When there last was one that was not short, and not too long: `now` while there is. Any
  /// thread.
  [[nodiscard]] static SteadyTime Last(SteadyTime now);

 private:
  const SteadyTime since_;
  const SteadyTime outer_since_;  // of the one in which it began, if any
};

}  // namespace tendon
