#pragma once

#include <tendon/base/result.h>
#include <tendon/security/openssl_handles.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace tendon {

/// The files of a CA in its folder.
struct AuthorityFolder {
  std::filesystem::path path;

  [[nodiscard]] std::filesystem::path certificate() const { return path / "ca.crt"; }
  [[nodiscard]] std::filesystem::path key() const { return path / "ca.key"; }
  [[nodiscard]] std::filesystem::path revoked() const { return path / "crl.pem"; }
  [[nodiscard]] std::filesystem::path issued() const { return path / "issued"; }
  [[nodiscard]] std::filesystem::path lock() const { return path / "lock"; }
};

/// The content of a regular file of at most 1 MiB.
Result<std::string> ReadSmallFile(const std::filesystem::path& file);

/// kDenied, with the remedy, if other users can read or write the file.
Result<void> RequirePrivate(const std::filesystem::path& file);

/// Creates a folder of mode 0700; leaves an existing one as it is.
Result<void> MakePrivateFolder(const std::filesystem::path& folder);

/// Writes a file of mode 0600 atomically, and waits until it is on the disk.
Result<void> WritePrivateFile(const std::filesystem::path& file, std::string_view text);

/// The same for a private key, to a new file that other users can never read.
Result<void> WriteKey(const std::filesystem::path& file, const EVP_PKEY& key);

// The files of a CA.
Result<openssl::CertificateHandle> ReadAuthority(const AuthorityFolder& folder);
Result<openssl::RevocationList> ReadRevoked(const AuthorityFolder& folder);
/// Reads a private key; fails if other users can read the file.
Result<openssl::Key> ReadPrivateKey(const std::filesystem::path& file);

}  // namespace tendon
