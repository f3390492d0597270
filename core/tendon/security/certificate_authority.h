#pragma once

#include <tendon/base/result.h>
#include <tendon/security/certificate.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace tendon {

/// A small CA in a folder that only its user can look into (0700, files 0600):
///
///     ca.crt       its certificate        \ what a host needs that checks others' certificates
///     crl.pem      what it has revoked    /
///     ca.key       its private key: whoever has it can make operators; never leaves the folder
///     issued/      a copy of each certificate, named by its serial number
///
/// All keys are of the curve P-256. An object of this class holds no secret. Functions read and
/// write files and wait for the disk; of two programs that change one folder at once, the second is
/// refused. They throw only what OpenSSL makes impossible to go on from, such as no memory.
class CertificateAuthority {
 public:
  /// Makes one that lasts ten years. kExists unless the folder is empty or missing.
  static Result<CertificateAuthority> Init(const std::filesystem::path& folder);
  /// What Init() would refuse to begin with, as things are.
  static Result<void> CheckInit(const std::filesystem::path& folder);

  /// One that is there. kNotFound where there is none, kDenied where others can read its key.
  static Result<CertificateAuthority> Open(const std::filesystem::path& folder);

  /// For whom a certificate is to be.
  struct Request {
    std::string name;  ///< as of a process: letters, digits, '_' and '-'
    Role role = Role::kViewer;
    Holder holder = Holder::kPerson;
    std::vector<std::string> hosts;  ///< names and addresses at which a process listens
    std::chrono::days validity{365};
  };
  /// What was made, and where it lies.
  struct Issued {
    Certificate certificate;
    std::filesystem::path certificate_file;
    std::filesystem::path key_file;  ///< 0600
  };
  /// Makes a key and a certificate, NAME.key and NAME.crt in the folder `out`, which is made when
  /// missing. Never overwrites a file. A name may have several certificates: a new one is issued
  /// before the old one expires.
  Result<Issued> Issue(const Request& request, const std::filesystem::path& out) const;
  /// What Issue() would refuse to begin with, as things are.
  [[nodiscard]] Result<void> CheckIssue(const Request& request,
                                        const std::filesystem::path& out) const;

  /// Revokes all certificates of that name; returns their serial numbers. kNotFound where none was
  /// issued, kExists where all are revoked already, kInvalid where a copy cannot be read: it could
  /// be one of them.
  Result<std::vector<std::string>> Revoke(const std::string& name) const;
  /// The serial numbers of those that Revoke() would revoke, or why it would refuse.
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
