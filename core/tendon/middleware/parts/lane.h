#pragma once

#include <cstdint>

namespace tendon {

/// What travels together on a channel: messages of one lane arrive in the order in which they were
/// sent, and no message waits for a large one of another lane. Numbers are those of one end of one
/// channel, Channel::NewLane(); nothing of them is sent.
using Lane = std::uint64_t;

/// Of whatever names no other.
inline constexpr Lane kCommonLane = 0;
/// Of this message alone: it keeps no order with any other.
inline constexpr Lane kOwnLane = ~Lane{0};

}  // namespace tendon
