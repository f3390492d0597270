#pragma once

#include <tendon/base/result.h>
#include <tendon/security/role.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace tendon {

/// The kind of holder of a certificate. Only a process (an LCM or a GCM) may accept links.
enum class Holder : std::uint8_t { kPerson, kProcess };

/// "person", "process".
[[nodiscard]] std::string_view ToString(Holder holder) noexcept;

/// The name, the role and the kind of a certificate's holder. A Certificate need not be valid;
/// CheckCertificate() checks this.
struct Certificate {
  std::string name;           ///< CN of the subject; for a process, the name with which it joins
  Role role = Role::kViewer;  ///< OU of the subject
  Holder holder{};            ///< a process if the extended key usage includes serverAuth
  std::string serial;         ///< hexadecimal, as openssl(1) prints it
  std::chrono::sys_seconds not_before{};
  std::chrono::sys_seconds not_after{};

  bool operator==(const Certificate&) const = default;
};

/// The largest size of a certificate in bytes. A longer text is refused without parsing.
inline constexpr std::size_t kMaxCertificateSize = std::size_t{64} << 10U;

/// Reads the first certificate in a PEM text. Fails with kInvalid if the text has no certificate,
/// or if the certificate belongs to a CA or does not have exactly one name and one known role.
Result<Certificate> ParseCertificate(std::string_view pem);

/// Returns a time as text: "2027-11-22 04:40:00Z".
[[nodiscard]] std::string DateText(std::chrono::sys_seconds time);

}  // namespace tendon
