#pragma once

#include <tendon/base/clock.h>

#include <chrono>

namespace tendon {

/// While it lives something that may be large is handled in this process, or made, which may take a
/// thread of the middleware seconds: whatever else has arrived for that thread is not heard, and
/// nobody is to be blamed for his silence. Thread-safe; a lock, no allocation.
class LargeInHand {
 public:
  LargeInHand();
  LargeInHand(const LargeInHand&) = delete;
  LargeInHand& operator=(const LargeInHand&) = delete;
  ~LargeInHand();

  /// What is done sooner holds nobody up, and excuses nobody.
  static constexpr std::chrono::milliseconds kShort{250};
  /// For so long it excuses silence: who handles one longer than this hangs.
  static constexpr std::chrono::seconds kAtMost{30};

  /// When there last was one that was not short, and not too long: `now` while there is.
  [[nodiscard]] static SteadyTime Last(SteadyTime now);

 private:
  struct Hand;
  static Hand& TheHand();

  SteadyTime since_;
  LargeInHand* older_ = nullptr;
  LargeInHand* newer_ = nullptr;
};

}  // namespace tendon
