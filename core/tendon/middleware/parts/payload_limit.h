#pragma once

#include <tendon/base/result.h>
#include <tendon/base/status.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace tendon {

/// A value that travels may have at most this many bytes when encoded: an argument, an answer, an
/// event. Larger ones are refused where they would be sent; the connection stays.
inline constexpr std::size_t kMaxPayload = std::size_t{64} << 20U;
/// A body may have so many: a payload, and what its message puts around it.
inline constexpr std::size_t kMaxBodySize = kMaxPayload + (std::size_t{64} << 10U);

/// "'cloud' of 80 000 000 B exceeds max_payload 67 108 864 B": an error of code kInvalid. `owner`,
/// if any, is whose it is: " of robot/arm/Cloud".
[[nodiscard]] Error ExceedsMaxPayload(std::string_view what, std::size_t size,
                                      std::string_view owner = {});

/// Why a body of `size` bytes was not sent to a peer, where a link has refused it so.
[[nodiscard]] Error WhyNotSent(Status status, const std::string& peer, std::size_t size);

}  // namespace tendon
