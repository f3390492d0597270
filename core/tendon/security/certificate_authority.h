#pragma once

#include <tendon/base/result.h>
#include <tendon/security/certificate.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace tendon {

/// A small certificate authority (CA). Its files are in a private folder of its user (mode 0700,
/// files 0600):
///
///     ca.crt       its certificate              \ a host needs these to check certificates
///     crl.pem      its revoked certificates     /
///     ca.key       its private key, which can make operators; never leaves the folder
///     issued/      a copy of each certificate, named by its serial number
///
/// All keys use the curve P-256. An object of this class contains no secret. The functions read and
/// write files and block on the disk. If two programs change a folder at the same time, the second
/// program gets an error. The functions throw only if OpenSSL cannot continue, for example because
/// memory is exhausted.
class CertificateAuthority {
 public:
  /// Creates a CA that is valid for ten years. Fails with kExists if the folder exists and is not
  /// empty.
  static Result<CertificateAuthority> Init(const std::filesystem::path& folder);
  /// Returns the error that Init() would return before it writes anything.
  static Result<void> CheckInit(const std::filesystem::path& folder);

  /// Opens an existing CA. Fails with kNotFound if there is no CA, and with kDenied if other users
  /// can read its key.
  static Result<CertificateAuthority> Open(const std::filesystem::path& folder);

  /// The content of a new certificate.
  struct Request {
    std::string name;  ///< like a process name: letters, digits, '_' and '-'
    Role role = Role::kViewer;
    Holder holder = Holder::kPerson;
    std::vector<std::string> hosts;  ///< names and addresses at which a process listens
    std::chrono::days validity{365};
  };
  /// The new certificate and its files.
  struct IssuedCertificate {
    Certificate certificate;
    std::filesystem::path certificate_file;
    std::filesystem::path key_file;  ///< of mode 0600
  };
  /// Creates a key and a certificate: NAME.key and NAME.crt in the folder `out`. The folder is
  /// created if it does not exist. Never overwrites a file. There may be several certificates for
  /// one name, so that a new one can be issued before the old one expires.
  Result<IssuedCertificate> Issue(const Request& request, const std::filesystem::path& out) const;
  /// Returns the error that Issue() would return before it writes anything.
  [[nodiscard]] Result<void> CheckIssue(const Request& request,
                                        const std::filesystem::path& out) const;

  /// Revokes all certificates with this name, and returns their serial numbers. Fails with
  /// kNotFound if none was issued, and with kExists if all are already revoked. Fails with kInvalid
  /// if a copy in issued/ cannot be read, because this copy may be one of these certificates.
  Result<std::vector<std::string>> Revoke(const std::string& name) const;
  /// Returns the serial numbers that Revoke() would revoke, or the error that it would return.
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
