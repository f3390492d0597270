#pragma once

#include <tendon/security/certificate_check.h>
#include <tendon/security/credentials.h>
#include <tendon/security/openssl_handles.h>

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

namespace tendon::openssl {

/// The certificate and key that this program shows to peers. Reloads them from the files when they
/// are renewed. Thread-safe.
class LocalCertificate {
 public:
  struct Pair {
    CertificateHandle certificate;
    Key key;
  };

 private:
  struct Passkey {};
  struct LoadedFiles {
    CheckedCertificate checked;
    std::string text;
    std::shared_ptr<const Pair> pair;
  };

 public:
  /// Reads the certificate and the key. Fails like CheckCertificate(), and with kNotFound if there
  /// is no key. Logs a warning if the certificate expires soon.
  static Result<std::unique_ptr<LocalCertificate>> Read(const Credentials& credentials);

  /// Returns the current certificate and key. Reads a file at each call. If the file has changed,
  /// the new certificate replaces the old one, provided that it is valid, has a key, and has the
  /// same name, role and holder. Otherwise the old certificate stays, and the log gives the reason.
  [[nodiscard]] std::shared_ptr<const Pair> Now();

  [[nodiscard]] const std::filesystem::path& file() const { return credentials_.certificate; }
  [[nodiscard]] const std::filesystem::path& key_file() const { return key_file_; }
  /// The certificate that was read first. A renewed one has the same name, role and holder.
  [[nodiscard]] const Certificate& certificate() const { return certificate_; }

  LocalCertificate(Passkey /*only from Read()*/, Credentials credentials, LoadedFiles loaded);

 private:
  static Result<LoadedFiles> Load(const Credentials& credentials);
  Result<void> Renew();

  const Credentials credentials_;
  const Certificate certificate_;
  const std::filesystem::path key_file_;
  std::mutex mutex_;
  std::string text_;  // content of the certificate file when it was last loaded
  std::shared_ptr<const Pair> pair_;
  std::string warning_;  // the last problem that was logged
};

}  // namespace tendon::openssl
