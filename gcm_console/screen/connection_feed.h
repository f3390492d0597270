#pragma once

#include <gcm_console/screen/asking_turns.h>
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
  bool is_known = false;    ///< whether it was asked twice
  bool is_awaited = false;  ///< whether it may become known soon
};

/// Asks the processes how their connections do, as long as somebody looks, in their AskingTurns. A
/// process that does not answer holds up no other one.
class ConnectionFeed {
 public:
  explicit ConnectionFeed(tendon::GcmClient& client) : client_(client) {}

  /// The connections that the catalogue has now and that have `filter` in "REQUIRED PROVIDED", with
  /// what was heard of them; the others are not asked for. Never waits.
  [[nodiscard]] std::vector<ConnectionFigures> Look(const std::string& filter = "");

 private:
  struct Heard;

  void AskSome() const;

  tendon::GcmClient& client_;
  std::map<tendon::InterfaceName, std::shared_ptr<Heard>> heard_;  // by required interface
  const std::shared_ptr<AskingTurns> turns_ = std::make_shared<AskingTurns>();
};

}  // namespace console
