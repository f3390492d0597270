#include <tendon/ice/refusals.h>

namespace tendon::ice {

void Refusals::Add(const std::string& who, const std::string& why) {
  const SteadyTime now = SteadyClock().Now();
  const std::scoped_lock lock(mutex_);
  for (const LogLimiter::Suppressed& one : limiter_.TakeSuppressed(now)) {
    Log(one.level, "audit",
        one.source + " was refused " + std::to_string(one.count) + " times more");
  }
  if (!limiter_.Admit(who, LogLevel::kWarning, now)) return;
  Log(LogLevel::kWarning, "audit", who + " was refused: " + why);
}

}  // namespace tendon::ice
