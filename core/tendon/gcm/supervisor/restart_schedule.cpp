#include <tendon/gcm/supervisor/restart_schedule.h>

#include <algorithm>
#include <utility>

namespace tendon::server {

std::optional<std::chrono::milliseconds> RestartSchedule::PauseAfter(SteadyTime begin,
                                                                     SteadyTime now) {
  if (now - begin >= kLongEnough) pause_ = kFirstPause;
  while (!failures_.empty() && now - failures_.front() >= kLongEnough) failures_.pop_front();
  failures_.push_back(now);
  if (failures_.size() >= kMostFailures) return std::nullopt;
  return std::exchange(pause_, std::min(2 * pause_, kLongestPause));
}

}  // namespace tendon::server
