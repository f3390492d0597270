#pragma once

#include <tendon/base/clock.h>

#include <chrono>

namespace tendon {

/// While it lives a large message is handled in this process, or made, which may take a thread of
/// the middleware seconds: whatever else has arrived for that thread is not heard, and nobody is to
/// be blamed for his silence. Thread-safe.
class LargeInHand {
 public:
  LargeInHand();
  LargeInHand(const LargeInHand&) = delete;
  LargeInHand& operator=(const LargeInHand&) = delete;
  ~LargeInHand();

  /// For so long it excuses silence: who handles one longer than this hangs.
  static constexpr std::chrono::seconds kAtMost{30};

  /// `now` while there is one, and has not been for too long; else when there last was one.
  [[nodiscard]] static SteadyTime Last(SteadyTime now);
};

}  // namespace tendon
