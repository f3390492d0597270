#pragma once

#include <tendon/base/result.h>
#include <tendon/security/role.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace tendon {

/// Whom a certificate stands for. Only a process, which is an LCM or a GCM, may also be the end of
/// a link that others open.
enum class Holder : std::uint8_t { kPerson, kProcess };

/// "person", "process".
[[nodiscard]] std::string_view ToString(Holder holder) noexcept;

/// Who holds a certificate, and what that allows. Says nothing of whether it can be believed: that
/// is CheckCertificate().
struct Certificate {
  std::string name;           ///< the subject's CN: of a process, the name by which it joins
  Role role = Role::kViewer;  ///< the subject's OU
  Holder holder{};            ///< a process if its extended key usage includes serverAuth
  std::string serial;         ///< hexadecimal, as openssl(1) prints it
  std::chrono::sys_seconds not_before{};
  std::chrono::sys_seconds not_after{};

  bool operator==(const Certificate&) const = default;
};

/// A certificate is at most this long, and so is a key; a longer text is not looked into.
inline constexpr std::size_t kMaxCertificateSize = std::size_t{64} << 10U;

/// Reads the first certificate in a PEM text. kInvalid where it is none, is that of a CA, or has
/// not exactly one name and one role that we know.
Result<Certificate> ParseCertificate(std::string_view pem);

/// "2027-11-22 04:40:00Z".
[[nodiscard]] std::string DateText(std::chrono::sys_seconds time);

}  // namespace tendon
