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
  /// kCallsRefused, kEventsLost: the total number. kMailboxFull: the number of waiting calls.
  std::uint64_t count = 0;
  std::uint64_t capacity = 0;              ///< kMailboxFull: capacity of the mailbox
  std::chrono::nanoseconds round_trip{0};  ///< kLate

  bool operator==(const ConnectionFlaw&) const = default;
};

/// Returns the flaws of a connection. All programs use these rules. `before` has the counts of the
/// last check; only calls that were refused and events that were lost after this check are
/// reported. Without `before`, refused calls and lost events are not reported.
[[nodiscard]] std::vector<ConnectionFlaw> FlawsOf(const ConnectionCounts& now,
                                                  const std::optional<ConnectionCounts>& before);

/// For example "3 calls were refused, because the mailbox was full".
[[nodiscard]] std::string ToString(const ConnectionFlaw& flaw);

}  // namespace tendon
