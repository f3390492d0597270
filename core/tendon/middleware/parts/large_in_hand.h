#pragma once

#include <tendon/base/clock.h>

namespace tendon {

/// While it lives a large message is handled in this process, which may take a thread of the
/// middleware seconds: whatever else has arrived for that thread is not heard, and nobody is to be
/// blamed for his silence. Thread-safe.
class LargeInHand {
 public:
  LargeInHand();
  LargeInHand(const LargeInHand&) = delete;
  LargeInHand& operator=(const LargeInHand&) = delete;
  ~LargeInHand();

  /// `now` while there is one; else when the last one was done with.
  [[nodiscard]] static SteadyTime Last(SteadyTime now);
};

}  // namespace tendon
