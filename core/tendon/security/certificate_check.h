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

/// What is known of a certificate that was found good.
struct CheckedCertificate {
  Certificate certificate;
  std::optional<std::filesystem::path> key;  ///< its private key, where it lies beside it
  std::string warning;                       ///< what will soon be wrong, or empty
};

/// Warned of before a certificate expires.
inline constexpr std::chrono::days kExpiresSoon{30};

/// Whether the certificate in `file` (PEM) is good at the time `now`: issued by the CA whose ca.crt
/// and crl.pem are in the folder `authority`, neither expired nor revoked, with one of our roles.
/// Its key, which is `file` with the extension .key, may be missing, but must belong to it and be
/// readable by nobody else. The private key of the CA is not needed.
///
/// Errors: kDenied where it is not good, kNotFound where a file is missing, kInvalid where one is
/// malformed. Reads files, and none of over 1 MiB.
Result<CheckedCertificate> CheckCertificate(const std::filesystem::path& file,
                                            const std::filesystem::path& authority,
                                            std::chrono::sys_seconds now);

/// The same of a certificate that a peer has shown (PEM), whose key it has proved to have. Errors
/// begin with "the certificate of 'robot'".
Result<Certificate> CheckShownCertificate(std::string_view pem,
                                          openssl::TrustedAuthority& authority,
                                          std::chrono::sys_seconds now);

}  // namespace tendon
