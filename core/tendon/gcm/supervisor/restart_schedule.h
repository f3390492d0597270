#pragma once

#include <tendon/base/backoff.h>
#include <tendon/base/clock.h>

#include <chrono>
#include <cstddef>
#include <deque>
#include <optional>

namespace tendon::server {

/// Decides when a process that fails repeatedly is restarted. The first pause is 0.5 s. Each
/// further pause is twice as long, up to 10 s. When the process has run for a minute, the pauses
/// begin at 0.5 s again. After five failures within a minute, the process is not restarted.
class RestartSchedule {
 public:
  static constexpr std::chrono::milliseconds kFirstPause{500};
  static constexpr std::chrono::milliseconds kLongestPause{10'000};
  static constexpr std::chrono::minutes kLongEnough{1};
  static constexpr std::size_t kMaxFailures = 5;

  /// Called when a process that has run since `begin` has failed at `now`. Returns the pause before
  /// the restart. Returns nothing if the process should not be restarted.
  std::optional<std::chrono::milliseconds> PauseAfter(SteadyTime begin, SteadyTime now);

 private:
  std::deque<SteadyTime> failures_;  // failures of the last minute
  Backoff backoff_{kFirstPause, kLongestPause};
};

}  // namespace tendon::server
