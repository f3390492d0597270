#pragma once

#include <tendon/base/result.h>
#include <tendon/base/status.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace tendon {

/// The largest size in bytes of an encoded value: an argument, a result or an event. The sender
/// refuses a larger value, and the connection stays open.
inline constexpr std::size_t kMaxPayload = std::size_t{64} << 20U;
/// The largest size in bytes of a body: a value and the other fields of its message.
inline constexpr std::size_t kMaxBodySize = kMaxPayload + (std::size_t{64} << 10U);

/// Returns the error for a value that is too large, with code kInvalid: "'cloud' of 80 000 000 B
/// exceeds max_payload 67 108 864 B". If `owner` is given, the text ends with " of
/// robot/arm/Cloud".
[[nodiscard]] Error ExceedsMaxPayload(std::string_view what, std::size_t size,
                                      std::string_view owner = {});

/// Returns the error for a body of `size` bytes that a link has refused with `status`.
[[nodiscard]] Error WhyNotSent(Status status, const std::string& peer, std::size_t size);

}  // namespace tendon
