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
  double round_trip = -1.0;   ///< s; below 0 if unknown, or if the connection is within one process
  std::uint64_t lost = 0;     ///< calls that were refused or replaced, and events that were lost
  std::uint64_t waiting = 0;  ///< calls in the mailbox of the server
  std::uint64_t capacity = 0;
  bool is_known = false;    ///< true after two replies
  bool is_awaited = false;  ///< true if replies may still arrive soon
};

/// Requests the health of connections from their processes while Look() is called regularly.
/// QueryThrottle limits the requests. A process that does not answer does not delay the others.
class ConnectionFeed {
 public:
  explicit ConnectionFeed(tendon::GcmClient& client) : client_(client) {}

  /// Returns the present connections, with their latest figures. With a `filter`, returns and polls
  /// only the connections whose text "REQUIRED PROVIDED" contains it. Never blocks.
  [[nodiscard]] std::vector<ConnectionFigures> Look(const std::string& filter = "");

 private:
  struct LatestReply;

  void AskSome() const;

  tendon::GcmClient& client_;
  std::map<tendon::InterfaceName, std::shared_ptr<LatestReply>> latest_;  // by required interface
  const std::shared_ptr<QueryThrottle> throttle_ = std::make_shared<QueryThrottle>();
};

}  // namespace console
