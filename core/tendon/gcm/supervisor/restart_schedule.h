#pragma once

#include <tendon/base/clock.h>

#include <chrono>
#include <deque>
#include <optional>

namespace tendon::server {

/// When a process that fails again and again is restarted: after 0.5 s, then after twice the last
/// pause, up to 10 s; from 0.5 s again once it has run for a minute. Given up after five failures
/// within a minute.
class RestartSchedule {
 public:
  static constexpr std::chrono::milliseconds kFirstPause{500};
  static constexpr std::chrono::milliseconds kLongestPause{10'000};
  static constexpr std::chrono::minutes kLongEnough{1};
  static constexpr std::size_t kMostFailures = 5;

  /// The process ran since `begin` and has failed `now`. Returns the pause; nothing: give up.
  std::optional<std::chrono::milliseconds> PauseAfter(SteadyTime begin, SteadyTime now);

 private:
  std::deque<SteadyTime> failures_;  // those of the last minute
  std::chrono::milliseconds pause_{kFirstPause};
};

}  // namespace tendon::server
