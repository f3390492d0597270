#pragma once

#include <tendon/manager/component_description.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tendon {

/// A problem of an active connection.
struct ConnectionFlaw {
  enum class Kind {
    kCallsRefused,  ///< calls were refused because the server's mailbox was full
    kEventsLost,    ///< events did not reach the client
    kMailboxFull,   ///< the server's mailbox is nearly full
    kLate,          ///< the round trip to the other process is long
  };

  Kind kind = Kind::kCallsRefused;
  std::uint64_t count = 0;                 ///< total calls or events; kMailboxFull: waiting now
  std::uint64_t capacity = 0;              ///< kMailboxFull: the capacity
  std::chrono::nanoseconds round_trip{0};  ///< kLate

  bool operator==(const ConnectionFlaw&) const = default;
};

/// The flaws of a connection, by the same rules in all programs. `before` has the counts at the
/// last check: earlier losses are not reported again.
[[nodiscard]] std::vector<ConnectionFlaw> FlawsOf(const ConnectionCounts& now,
                                                  const std::optional<ConnectionCounts>& before);

/// For example "3 calls found the mailbox full".
[[nodiscard]] std::string ToString(const ConnectionFlaw& flaw);

}  // namespace tendon
