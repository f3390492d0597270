#pragma once

#include <tendon/base/result.h>
#include <tendon/middleware/frame.h>
#include <tendon/security/role.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace tendon {

/// The name of every GCM. Its certificate also contains this name.
inline constexpr const char* kGcmName = "gcm";

/// The identity and the secrets of one end of a link. handshake.h describes how they are exchanged.
struct Hello {
  std::uint64_t instance = 0;  ///< identifies the process; new at each start
  /// The name of the process or program, for people: "robot", "gcm ls". With TLS, the name of a
  /// peer comes from its certificate. The name "robot" then certainly belongs to this process.
  /// Other programs are named "anna (gcm ls)", after the holder of the certificate.
  std::string name;
  /// The role of a peer, from its certificate. A peer without a certificate is an operator.
  Role role = Role::kOperator;
  /// Set only by an opener: the name of the peer that it accepts; empty accepts any.
  std::string wanted;
  std::uint64_t session = 0;  ///< the session token of a process that has joined, or 0
  std::uint64_t cookie = 0;   ///< LoopbackCookie(), never sent; 0 without a cookie
};

/// Returns the secret of this user on this machine. The secret is in a file of mode 0600 in
/// os::RuntimeFolder(). The first process that needs the file creates it. Fails with kDenied if the
/// file cannot be read or created.
Result<std::uint64_t> LoopbackCookie();

/// The peers without a certificate that an acceptor admits. kRefused: only peers that know the
/// cookie. kAllowed: also peers without a cookie (for tests). kFromElsewhere: all peers; used for
/// other machines, if Exposure allows them.
enum class UnauthenticatedPeers { kRefused, kAllowed, kFromElsewhere };

/// Decodes the body of a kRefusal; the message is printable.
[[nodiscard]] Error ReadRefusal(std::span<const std::byte> body, const std::string& peer);

}  // namespace tendon
