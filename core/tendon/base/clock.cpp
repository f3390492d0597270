#include <tendon/base/clock.h>

#include <algorithm>

namespace tendon {
namespace {

class RealClock final : public Clock {
 public:
  [[nodiscard]] SteadyTime Now() const noexcept override {
    return std::chrono::steady_clock::now();
  }
};

}  // namespace

const Clock& SteadyClock() noexcept {
  static const RealClock kClock;
  return kClock;
}

SteadyTime DeadlineAfter(std::chrono::nanoseconds timeout) noexcept {
  return SteadyClock().Now() + std::min(timeout, kLongestWait);
}

SteadyTime ManualClock::Now() const noexcept {
  const std::scoped_lock lock(mutex_);
  return now_;
}

void ManualClock::Advance(std::chrono::nanoseconds by) {
  const std::scoped_lock lock(mutex_);
  now_ += by;
}

}  // namespace tendon
