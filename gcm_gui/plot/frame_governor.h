#pragma once

#include <algorithm>
#include <chrono>

namespace tendon::gui {

/// How long to wait from one frame to the next: frames get rarer when they are dear, so that
/// drawing leaves half of the thread to everything else. Data is not touched by it.
class FrameGovernor {
 public:
  using Time = std::chrono::microseconds;

  static constexpr Time kShortest{16'000};
  static constexpr Time kLongest{250'000};

  /// A frame took so long. A dear one counts at once, cheap ones bit by bit.
  void drew(Time cost) { cost_ = std::max(cost, cost_ + (cost - cost_) / kForgetting); }
  [[nodiscard]] Time interval() const { return std::clamp(2 * cost_, kShortest, kLongest); }

 private:
  static constexpr int kForgetting = 8;  // frames

  Time cost_{0};
};

}  // namespace tendon::gui
