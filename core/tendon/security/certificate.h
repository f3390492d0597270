#pragma once

#include <tendon/base/result.h>
#include <tendon/security/role.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace tendon {

/// The kind of holder of a certificate. Only a process (an LCM or a GCM) may also accept links.
enum class Holder : std::uint8_t { kPerson, kProcess };

/// "person", "process".
[[nodiscard]] std::string_view ToString(Holder holder) noexcept;

/// The holder of a certificate, and its rights. Does not say whether the certificate is valid: see
/// CheckCertificate().
struct Certificate {
  std::string name;           ///< the subject's CN; for a process, the name under which it joins
  Role role = Role::kViewer;  ///< the subject's OU
  Holder holder{};            ///< a process if its extended key usage includes serverAuth
  std::string serial;         ///< hexadecimal, as openssl(1) prints it
  std::chrono::sys_seconds not_before{};
  std::chrono::sys_seconds not_after{};

  bool operator==(const Certificate&) const = default;
};

/// The most bytes of a certificate or a key; a longer text is refused without parsing.
inline constexpr std::size_t kMaxCertificateSize = std::size_t{64} << 10U;

/// Reads the first certificate in a PEM text. kInvalid if there is none, if it belongs to a CA, or
/// if it does not have exactly one name and one known role.
Result<Certificate> ParseCertificate(std::string_view pem);

/// "2027-11-22 04:40:00Z".
[[nodiscard]] std::string DateText(std::chrono::sys_seconds time);

}  // namespace tendon
