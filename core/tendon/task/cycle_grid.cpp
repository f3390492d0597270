#include <tendon/task/cycle_grid.h>

#include <tendon/base/error.h>

namespace tendon {

using namespace std::chrono_literals;

std::uint64_t CycleGrid::Next(SteadyTime now) noexcept {
  due_ += period_;
  if (now < due_ + period_) return 0;
  const auto missed = (now - due_) / period_;
  due_ += missed * period_;
  return static_cast<std::uint64_t>(missed);
}

std::chrono::nanoseconds CheckedPeriod(std::chrono::nanoseconds period, const std::string& task) {
  if (period >= 10us && period <= 3600s) return period;
  throw ConfigurationError("period of '" + task + "' must be 10 us..3600 s, got " +
                           std::to_string(period.count()) + " ns");
}

}  // namespace tendon
