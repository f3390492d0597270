#include <tendon/base/rate_limited_warning.h>

#include <tendon/base/log.h>

namespace tendon {

void RateLimitedWarning::Add(const std::string& text) {
  constexpr std::chrono::seconds kPause{10};
  std::unique_lock lock(mutex_);
  ++count_;
  const SteadyTime now = SteadyClock().Now();
  if (last_logged_ && now - *last_logged_ < kPause) return;
  last_logged_ = now;
  const std::uint64_t count = count_;
  lock.unlock();
  Log(LogLevel::kWarning, source_, text + " (" + std::to_string(count) + " so far)");
}

std::uint64_t RateLimitedWarning::count() const {
  const std::scoped_lock lock(mutex_);
  return count_;
}

}  // namespace tendon
