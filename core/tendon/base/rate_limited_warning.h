#pragma once

#include <tendon/base/clock.h>

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace tendon {

/// A warning that peers can cause any number of times. Counts every occurrence, but logs at most
/// one warning in ten seconds, with the count. Thread-safe.
class RateLimitedWarning {
 public:
  explicit RateLimitedWarning(std::string source) : source_(std::move(source)) {}

  void Add(const std::string& text);
  [[nodiscard]] std::uint64_t count() const;

 private:
  const std::string source_;
  mutable std::mutex mutex_;
  std::uint64_t count_ = 0;
  std::optional<SteadyTime> last_logged_;
};

}  // namespace tendon
