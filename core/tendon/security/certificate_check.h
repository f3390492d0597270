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

/// A certificate that was found valid.
struct CheckedCertificate {
  Certificate certificate;
  std::optional<std::filesystem::path> key;  ///< its private key, if the file exists
  std::string warning;                       ///< a future problem, such as expiry; or empty
};

/// The warning begins this many days before a certificate expires.
inline constexpr std::chrono::days kExpiresSoon{30};

/// Checks that the certificate in `file` (PEM) is valid at `now`: issued by the CA whose ca.crt and
/// crl.pem are in the folder `authority`, neither expired nor revoked, with a known role. The key
/// is `file` with the extension .key. It may be missing; if it exists, it must match and be
/// readable by its user only. Does not need the private key of the CA.
///
/// Errors: kDenied if the certificate is not valid, kNotFound for a missing file, kInvalid for a
/// malformed one. Reads files, each of at most 1 MiB.
Result<CheckedCertificate> CheckCertificate(const std::filesystem::path& file,
                                            const std::filesystem::path& authority,
                                            std::chrono::sys_seconds now);

/// The same for the certificate (PEM) of a peer that has proved that it owns the key. Errors begin
/// with "the certificate of 'robot'".
Result<Certificate> CheckPeerCertificate(std::string_view pem, openssl::TrustedAuthority& authority,
                                         std::chrono::sys_seconds now);

}  // namespace tendon
