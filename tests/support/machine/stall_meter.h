#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>
#include <utility>

namespace tendon::test {

/// Measures the longest time in which this machine ran no thread of the test. Components miss their
/// deadlines during such a time. A test must not count this as a failure.
class StallMeter {
 public:
  using Time = std::chrono::milliseconds;

  [[nodiscard]] Time longest() const { return longest_; }
  /// Returns true if the machine stalled for so long that leases may have expired.
  [[nodiscard]] bool has_stood_still() const { return longest() >= kMuch; }

 private:
  static constexpr Time kMuch{500};  // a third of a lease

  void Measure(const std::stop_token& stop) {
    constexpr Time kNap(10);
    for (auto last = std::chrono::steady_clock::now(); !stop.stop_requested();) {
      std::this_thread::sleep_for(kNap);
      const auto now = std::chrono::steady_clock::now();
      const auto late = std::chrono::duration_cast<Time>(now - std::exchange(last, now)) - kNap;
      longest_ = std::max(longest_.load(), late);
    }
  }

  std::atomic<Time> longest_ = Time(0);
  std::jthread thread_{[this](const std::stop_token& stop) { Measure(stop); }};
};

}  // namespace tendon::test
