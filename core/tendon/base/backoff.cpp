#include <tendon/base/backoff.h>

#include <tendon/base/os/process.h>

#include <algorithm>
#include <cstdint>

namespace tendon {

std::chrono::milliseconds Backoff::Next() {
  last_ = std::clamp(2 * last_, shortest_, longest_);
  if (jitter_ <= 0.0) return last_;
  constexpr std::uint64_t kSteps = 1000;
  const double part = static_cast<double>(os::RandomNumber() % kSteps) / kSteps;
  const double left_out = static_cast<double>(last_.count()) * jitter_ * part;
  return last_ - std::chrono::milliseconds(static_cast<std::int64_t>(left_out));
}

}  // namespace tendon
