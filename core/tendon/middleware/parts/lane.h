#pragma once

#include <cstdint>

namespace tendon {

/// Messages of one lane of a channel arrive in the order in which they were sent. No message waits
/// for a large message of another lane. The numbers come from Channel::NewLane(), are valid at one
/// end of one channel, and are not sent.
using Lane = std::uint64_t;

/// The default lane.
inline constexpr Lane kCommonLane = 0;
/// A separate lane for one message: it has no order relative to other messages.
inline constexpr Lane kOwnLane = ~Lane{0};

}  // namespace tendon
