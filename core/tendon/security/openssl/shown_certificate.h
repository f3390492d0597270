#pragma once

#include <tendon/security/certificate_check.h>
#include <tendon/security/credentials.h>
#include <tendon/security/openssl/handles.h>

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

namespace tendon::openssl {

/// The certificate that this program shows, and its key: those in its files, read again when there
/// is a renewed one. Thread-safe.
class ShownCertificate {
 public:
  struct Pair {
    CertificateHandle certificate;
    Key key;
  };

 private:
  struct Passkey {};
  struct Loaded {
    CheckedCertificate checked;
    std::string text;
    std::shared_ptr<const Pair> pair;
  };

 public:
  /// Errors: those of CheckCertificate(); kNotFound where there is no key. Warns of what soon will
  /// not be good.
  static Result<std::unique_ptr<ShownCertificate>> Read(const Credentials& credentials);

  /// What to show now. A renewed certificate takes the place of the one before as soon as it is
  /// good, has its key and says the same of its holder; until then it is logged what is wrong with
  /// it, and nothing changes. Reads a file.
  [[nodiscard]] std::shared_ptr<const Pair> Now();

  [[nodiscard]] const std::filesystem::path& file() const { return credentials_.certificate; }
  [[nodiscard]] const std::filesystem::path& key_file() const { return key_file_; }
  /// As it was read first. One that takes its place has the same name, role and holder.
  [[nodiscard]] const Certificate& certificate() const { return certificate_; }

  ShownCertificate(Passkey /*only from Read()*/, Credentials credentials, Loaded loaded);

 private:
  static Result<Loaded> Load(const Credentials& credentials);
  Result<void> Renew();

  const Credentials credentials_;
  const Certificate certificate_;
  const std::filesystem::path key_file_;
  std::mutex mutex_;
  std::string text_;  // of the file that was read
  std::shared_ptr<const Pair> pair_;
  std::string complaint_;  // the last that was logged
};

}  // namespace tendon::openssl
