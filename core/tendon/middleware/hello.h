#pragma once

#include <tendon/base/result.h>
#include <tendon/middleware/frame.h>
#include <tendon/security/role.h>

#include <cstdint>
#include <span>
#include <string>

namespace tendon {

/// What a GCM calls itself, and what its certificate must say.
inline constexpr const char* kGcmName = "gcm";

/// Who is at an end of a link, and what it knows; handshake/handshake.h says how the ends learn it.
struct Hello {
  /// The newest that this end speaks; as a peer's, the one that both speak.
  std::uint16_t protocol_version = FrameHeader::kProtocolVersion;
  std::uint16_t oldest_version = FrameHeader::kOldestVersion;  ///< that this end speaks
  std::uint64_t instance = 0;  ///< of the process, new at each start
  /// Of the process or program, for people: "robot", "gcm ls". As a peer's under TLS, that of its
  /// certificate: "robot" is a process of this name and nobody else, others are "anna (gcm ls)".
  std::string name;
  /// Of a peer: by its certificate, or an operator, who knows the cookie.
  Role role = Role::kOperator;
  std::string wanted;         ///< of an opener: who alone may be at the other end; empty for any
  std::uint64_t session = 0;  ///< the token of a joined process, or 0
  std::uint64_t cookie = 0;   ///< LoopbackCookie(), which is never sent; 0 for none
};

/// The secret of this user on this machine: a file of mode 0600 in os::RuntimeFolder(), made by
/// whoever needs it first. kDenied where it cannot be read or made.
Result<std::uint64_t> LoopbackCookie();

/// Whom an acceptor lets in: those who know the cookie; in tests also those who show none; or, from
/// addresses off this machine, where Exposure let them in, anyone. Who has shown a certificate is
/// none.
enum class Strangers { kRefused, kAllowed, kFromElsewhere };

/// The body of a kRefusal as the reason, in words that print.
[[nodiscard]] Error ReadRefusal(std::span<const std::byte> body, const std::string& peer);

}  // namespace tendon
