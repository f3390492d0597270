#pragma once

#include <tendon/base/result.h>
#include <tendon/middleware/frame.h>
#include <tendon/security/role.h>

#include <cstdint>
#include <span>
#include <string>

namespace tendon {

/// The name of every GCM, also in its certificate.
inline constexpr const char* kGcmName = "gcm";

/// One end of a link: its identity and secrets. handshake.h describes the exchange.
struct Hello {
  std::uint64_t instance = 0;  ///< of the process; new at each start
  /// Of the process or program, for people: "robot", "gcm ls". A peer's name under TLS comes from
  /// its certificate: "robot" is then certain to be that process; other programs are named "anna
  /// (gcm ls)".
  std::string name;
  /// A peer's role: from its certificate; operator without one.
  Role role = Role::kOperator;
  std::string wanted;         ///< only for an opener: the peer that it accepts; empty for any
  std::uint64_t session = 0;  ///< the session token of a process that has joined, or 0
  std::uint64_t cookie = 0;   ///< LoopbackCookie(), which is never sent; 0 for none
};

/// The secret of this user on this machine: a file of mode 0600 in os::RuntimeFolder(), created by
/// the first process that needs it. kDenied if it cannot be read or created.
Result<std::uint64_t> LoopbackCookie();

/// The peers without a certificate that an acceptor admits: only peers that know the cookie; also
/// peers that send no cookie (for tests); or all peers (on other machines, if Exposure allows
/// these).
enum class UnauthenticatedPeers { kRefused, kAllowed, kFromElsewhere };

/// Decodes the body of a kRefusal; the message is printable.
[[nodiscard]] Error ReadRefusal(std::span<const std::byte> body, const std::string& peer);

}  // namespace tendon
