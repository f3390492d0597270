#pragma once

#include <tendon/base/clock.h>

#include <chrono>
#include <deque>
#include <optional>

namespace tendon::server {

/// When a process that fails again and again is started anew: after 0.5 s, then twice as long each
/// time, up to 10 s; at the beginning again once it has stood for a minute. Not at all any more
/// when it has failed five times within a minute.
class RestartSchedule {
 public:
  static constexpr std::chrono::milliseconds kFirstPause{500};
  static constexpr std::chrono::milliseconds kLongestPause{10'000};
  static constexpr std::chrono::minutes kLongEnough{1};
  static constexpr std::size_t kMostFailures = 5;

  /// It ran since `begin` and has failed `now`: how long to wait; nothing: it is given up.
  std::optional<std::chrono::milliseconds> PauseAfter(SteadyTime begin, SteadyTime now);

 private:
  std::deque<SteadyTime> failures_;  // those of the last minute
  std::chrono::milliseconds pause_{kFirstPause};
};

}  // namespace tendon::server
