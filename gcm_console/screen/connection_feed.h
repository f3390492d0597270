#pragma once

#include <tendon/base/clock.h>
#include <tendon/gcm/client.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace console {

/// How a connection does, by what its process has counted.
struct ConnectionFigures {
  std::string required;
  std::string provided;
  std::string state;
  double rate = 0.0;          ///< calls and events a second, since it was asked before
  double round_trip = -1.0;   ///< s; below 0 within one process, or where it is not known
  std::uint64_t lost = 0;     ///< calls that were refused or replaced, and events that did not come
  std::uint64_t waiting = 0;  ///< calls, at the server
  std::uint64_t capacity = 0;
  bool is_known = false;  ///< whether it was asked twice
};

/// Asks the processes each second how their connections do, as long as somebody looks.
class ConnectionFeed {
 public:
  explicit ConnectionFeed(tendon::GcmClient& client) : client_(client) {}

  /// All connections that the catalogue has now, with what was heard of them. Never waits.
  [[nodiscard]] std::vector<ConnectionFigures> Look();

 private:
  struct Heard;

  void AskFor(const tendon::ConnectionDescription& connection,
              const std::shared_ptr<Heard>& heard) const;

  tendon::GcmClient& client_;
  std::map<std::string, std::shared_ptr<Heard>> heard_;  // by required interface
  tendon::SteadyTime next_{};
};

}  // namespace console
