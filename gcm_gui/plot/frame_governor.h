#pragma once

#include <algorithm>
#include <chrono>

namespace tendon::gui {

/// Chooses the time between two frames. If drawing a frame is slow, frames are drawn less often, so
/// that drawing takes at most half of the thread's time. The data is not affected.
class FrameGovernor {
 public:
  using Time = std::chrono::microseconds;

  static constexpr Time kShortest{16'000};
  static constexpr Time kLongest{250'000};

  /// Records how long a frame took. A longer time takes effect at once, a shorter time gradually.
  void drew(Time cost) { cost_ = std::max(cost, cost_ + (cost - cost_) / kForgetting); }
  [[nodiscard]] Time interval() const { return std::clamp(2 * cost_, kShortest, kLongest); }

 private:
  static constexpr int kForgetting = 8;  // frames

  Time cost_{0};
};

}  // namespace tendon::gui
