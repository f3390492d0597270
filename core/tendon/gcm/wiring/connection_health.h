#pragma once

#include <tendon/manager/description.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tendon {

/// Something that is wrong with a connection that stands.
struct ConnectionFlaw {
  enum class Kind {
    kCallsRefused,  ///< calls find the server's mailbox full
    kEventsLost,    ///< events do not reach the client
    kMailboxFull,   ///< as many calls wait at the server as make one expect that
    kLate,          ///< the way to the other process and back takes long
  };

  Kind kind = Kind::kCallsRefused;
  std::uint64_t count = 0;                 ///< calls or events: all so far; of kMailboxFull, now
  std::uint64_t capacity = 0;              ///< kMailboxFull: how many can wait
  std::chrono::nanoseconds round_trip{0};  ///< kLate

  bool operator==(const ConnectionFlaw&) const = default;
};

/// The judgement of every program. `before` are its counts when it was looked at last: what was
/// lost until then is no flaw any more.
[[nodiscard]] std::vector<ConnectionFlaw> FlawsOf(const ConnectionCounts& now,
                                                  const std::optional<ConnectionCounts>& before);

/// "3 calls found no room".
[[nodiscard]] std::string ToString(const ConnectionFlaw& flaw);

}  // namespace tendon
