#include <tendon/gcm/supervisor/restart_schedule.h>

namespace tendon::server {

std::optional<std::chrono::milliseconds> RestartSchedule::PauseAfter(SteadyTime begin,
                                                                     SteadyTime now) {
  if (now - begin >= kLongEnough) backoff_.Reset();
  while (!failures_.empty() && now - failures_.front() >= kLongEnough) failures_.pop_front();
  failures_.push_back(now);
  if (failures_.size() >= kMaxFailures) return std::nullopt;
  return backoff_.Next();
}

}  // namespace tendon::server
