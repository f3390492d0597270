#pragma once

#include <gcm_console/feeds/query_throttle.h>
#include <tendon/gcm/client.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace console {

/// The health of a connection, from the counters of its process.
struct ConnectionFigures {
  std::string required;
  std::string provided;
  std::string state;
  double rate = 0.0;          ///< calls and events per second, averaged since the previous request
  double round_trip = -1.0;   ///< s; below 0 within one process, or if unknown
  std::uint64_t lost = 0;     ///< calls refused or replaced, and events lost
  std::uint64_t waiting = 0;  ///< calls waiting at the server
  std::uint64_t capacity = 0;
  bool is_known = false;    ///< true once there are two replies
  bool is_awaited = false;  ///< true if replies may still arrive soon
};

/// Polls the processes for the health of their connections while Look() is called, within the
/// limits of QueryThrottle. A process that does not answer does not delay the others.
class ConnectionFeed {
 public:
  explicit ConnectionFeed(tendon::GcmClient& client) : client_(client) {}

  /// The present connections that contain `filter` in "REQUIRED PROVIDED", with the latest figures;
  /// others are not polled. Never waits.
  [[nodiscard]] std::vector<ConnectionFigures> Look(const std::string& filter = "");

 private:
  struct LatestAnswer;

  void AskSome() const;

  tendon::GcmClient& client_;
  std::map<tendon::InterfaceName, std::shared_ptr<LatestAnswer>> latest_;  // by required interface
  const std::shared_ptr<QueryThrottle> throttle_ = std::make_shared<QueryThrottle>();
};

}  // namespace console
