#pragma once

#include <tendon/base/result.h>
#include <tendon/middleware/frame.h>

#include <cstdint>
#include <span>
#include <string>

namespace tendon {

/// Who is at an end of a link, and what it knows; handshake/handshake.h says how the ends learn it.
struct Hello {
  std::uint16_t protocol_version = FrameHeader::kProtocolVersion;
  std::uint64_t instance = 0;  ///< of the process, new at each start
  std::string name;            ///< of the process or program, for people: "robot", "gcm ls"
  std::uint64_t session = 0;   ///< the token of a joined process, or 0
  std::uint64_t cookie = 0;    ///< LoopbackCookie(), which is never sent; 0 for none
};

/// The secret of this user on this machine: a file of mode 0600 in os::RuntimeFolder(), made by
/// whoever needs it first. kDenied where it cannot be read or made.
Result<std::uint64_t> LoopbackCookie();

/// Whom an acceptor lets in: those who know the cookie; in tests also those who show none; or, from
/// addresses off this machine, where Exposure let them in, anyone.
enum class Strangers { kRefused, kAllowed, kFromElsewhere };

/// The body of a kRefusal as the reason.
[[nodiscard]] Error ReadRefusal(std::span<const std::byte> body, const std::string& peer);

}  // namespace tendon
