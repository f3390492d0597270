#pragma once

#include <tendon/base/result.h>
#include <tendon/security/certificate.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace tendon {

namespace openssl {
class TrustedAuthority;
}

/// A certificate that has been checked and is valid.
struct CheckedCertificate {
  Certificate certificate;
  std::optional<std::filesystem::path> key;  ///< file of its private key, if it exists
  std::string warning;  ///< a problem in the future, such as expiry; may be empty
};

/// A certificate that expires in less than this time causes a warning.
inline constexpr std::chrono::days kExpiresSoon{30};

/// Checks that the certificate in `file` (PEM) is valid at `now`. The certificate must be issued by
/// the CA whose ca.crt and crl.pem are in the folder `authority`, must not be expired or revoked,
/// and must have a known role.
///
/// The private key is in the file with the extension .key, which may be missing. If the file
/// exists, the key must match the certificate, and only its user may be able to read it. The
/// private key of the CA is not needed.
///
/// Fails with kDenied if the certificate is not valid, with kNotFound for a missing file, and with
/// kInvalid for a malformed file. Reads files of at most 1 MiB each.
Result<CheckedCertificate> CheckCertificate(const std::filesystem::path& file,
                                            const std::filesystem::path& authority,
                                            std::chrono::sys_seconds now);

/// Checks the certificate (PEM) of a peer in the same way. The peer must already have proved that
/// it owns the key. Errors begin with "the certificate of 'robot'".
Result<Certificate> CheckPeerCertificate(std::string_view pem, openssl::TrustedAuthority& authority,
                                         std::chrono::sys_seconds now);

}  // namespace tendon
