#pragma once

#include <tendon/base/result.h>
#include <tendon/security/certificate.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace tendon {

/// A small certificate authority in a private folder of its user (0700, files 0600):
///
///     ca.crt       its certificate              \ a host needs these to check certificates
///     crl.pem      its revoked certificates     /
///     ca.key       its private key, which can make operators; never leaves the folder
///     issued/      a copy of each certificate, named by its serial number
///
/// All keys are of the curve P-256. An object of this class holds no secret. Functions read and
/// write files and wait for the disk. If two programs change one folder at once, the second one
/// fails. Functions throw only if OpenSSL cannot continue, for example without memory.
class CertificateAuthority {
 public:
  /// Creates a CA that lasts ten years. kExists unless the folder is empty or missing.
  static Result<CertificateAuthority> Init(const std::filesystem::path& folder);
  /// Returns the error that Init() would return before it writes anything.
  static Result<void> CheckInit(const std::filesystem::path& folder);

  /// Opens an existing CA. kNotFound if there is none, kDenied if other users can read its key.
  static Result<CertificateAuthority> Open(const std::filesystem::path& folder);

  /// The content of a new certificate.
  struct Request {
    std::string name;  ///< as a process name: letters, digits, '_' and '-'
    Role role = Role::kViewer;
    Holder holder = Holder::kPerson;
    std::vector<std::string> hosts;  ///< names and addresses at which a process listens
    std::chrono::days validity{365};
  };
  /// The new certificate and its files.
  struct IssuedCertificate {
    Certificate certificate;
    std::filesystem::path certificate_file;
    std::filesystem::path key_file;  ///< 0600
  };
  /// Creates a key and a certificate, NAME.key and NAME.crt in the folder `out`, which is created
  /// if missing. Never overwrites a file. A name may have several certificates, so that a new one
  /// can be issued before the old one expires.
  Result<IssuedCertificate> Issue(const Request& request, const std::filesystem::path& out) const;
  /// Returns the error that Issue() would return before it writes anything.
  [[nodiscard]] Result<void> CheckIssue(const Request& request,
                                        const std::filesystem::path& out) const;

  /// Revokes all certificates of that name; returns their serial numbers. kNotFound if none was
  /// issued, kExists if all are revoked already, kInvalid if a copy in issued/ cannot be read,
  /// because it could be one of them.
  Result<std::vector<std::string>> Revoke(const std::string& name) const;
  /// The serial numbers that Revoke() would revoke, or its error.
  [[nodiscard]] Result<std::vector<std::string>> Revocable(const std::string& name) const;

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] std::chrono::sys_seconds not_after() const { return not_after_; }

 private:
  CertificateAuthority(std::filesystem::path folder, std::chrono::sys_seconds not_after)
      : folder_(std::move(folder)), not_after_(not_after) {}

  std::filesystem::path folder_;
  std::chrono::sys_seconds not_after_;
};

}  // namespace tendon
