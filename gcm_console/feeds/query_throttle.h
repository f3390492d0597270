#pragma once

#include <tendon/base/clock.h>
#include <tendon/gcm/client.h>

#include <chrono>
#include <cstddef>
#include <map>
#include <mutex>
#include <vector>

namespace console {

/// Decides which connections to ask about now. Each required interface is asked at most once a
/// second. The number of unanswered requests is limited, in total and per process; connections that
/// disappear and return still count. Thread-safe.
class QueryThrottle {
 public:
  static constexpr std::chrono::seconds kBetween{1};
  static constexpr std::size_t kMostAtOnce = 64;
  static constexpr std::size_t kMostOfOne = 8;

  /// Returns the connections in `there` that are due, the longest waiting first. Call End() for
  /// each of them.
  [[nodiscard]] std::vector<tendon::InterfaceName> Begin(
      const std::vector<tendon::InterfaceName>& there, tendon::SteadyTime now);
  /// Ends a request. Call it when the answer has arrived, or cannot arrive any more.
  void End(const tendon::InterfaceName& required);

 private:
  struct Query {
    tendon::SteadyTime asked = tendon::SteadyTime::min();
    bool is_under_way = false;
    bool is_there = false;
  };

  std::mutex mutex_;
  std::map<tendon::InterfaceName, Query> queries_;
};

}  // namespace console
