#pragma once

#include <tendon/base/result.h>
#include <tendon/security/openssl/handles.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace tendon {

/// Where a CA keeps what.
struct AuthorityFolder {
  std::filesystem::path path;

  [[nodiscard]] std::filesystem::path certificate() const { return path / "ca.crt"; }
  [[nodiscard]] std::filesystem::path key() const { return path / "ca.key"; }
  [[nodiscard]] std::filesystem::path revoked() const { return path / "crl.pem"; }
  [[nodiscard]] std::filesystem::path issued() const { return path / "issued"; }
  [[nodiscard]] std::filesystem::path lock() const { return path / "lock"; }
};

/// All of a regular file of at most 1 MiB.
Result<std::string> ReadSmallFile(const std::filesystem::path& file);

/// kDenied, with what to do, where others may read or write it.
Result<void> RequirePrivate(const std::filesystem::path& file);

/// A folder of mode 0700; one that is there is left as it is.
Result<void> MakePrivateFolder(const std::filesystem::path& folder);

/// A file of mode 0600; atomic, and waits for the disk.
Result<void> WritePrivateFile(const std::filesystem::path& file, std::string_view text);

/// The same of a private key, in a file that was not there; nobody else can read it at any moment.
Result<void> WriteKey(const std::filesystem::path& file, const EVP_PKEY& key);

// Those of a CA.
Result<openssl::CertificateHandle> ReadAuthority(const AuthorityFolder& folder);
Result<openssl::RevocationList> ReadRevoked(const AuthorityFolder& folder);
/// A private key that nobody else can read.
Result<openssl::Key> ReadPrivateKey(const std::filesystem::path& file);

}  // namespace tendon
