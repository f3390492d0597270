#pragma once

#include <tendon/base/clock.h>
#include <tendon/gcm/client.h>

#include <chrono>
#include <cstddef>
#include <map>
#include <mutex>
#include <vector>

namespace console {

/// Decides for which connections a request is sent now. For each required interface, there is at
/// most one request per second. The number of unanswered requests is limited, in total and for each
/// process. A connection that disappears and returns keeps its place in these limits. Thread-safe.
class QueryThrottle {
 public:
  static constexpr std::chrono::seconds kBetween{1};
  static constexpr std::size_t kMaxAtOnce = 64;
  static constexpr std::size_t kMaxOfOne = 8;

  /// Returns the connections in `there` for which a request is due. Connections that have waited
  /// longest come first. The caller must call End() for each returned connection.
  [[nodiscard]] std::vector<tendon::InterfaceName> Begin(
      const std::vector<tendon::InterfaceName>& there, tendon::SteadyTime now);
  /// Called when the reply has arrived, or when it cannot arrive any more.
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
