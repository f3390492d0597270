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

/// Returns the content of a regular file of at most 1 MiB.
Result<std::string> ReadSmallFile(const std::filesystem::path& file);

/// Fails with kDenied if other users can read or write the file. The error gives the remedy.
Result<void> RequirePrivate(const std::filesystem::path& file);

/// Creates a folder of mode 0700. Does not change an existing folder.
Result<void> MakePrivateFolder(const std::filesystem::path& folder);

/// Writes a file of mode 0600 atomically, and waits until it is on the disk.
Result<void> WritePrivateFile(const std::filesystem::path& file, std::string_view text);

/// Writes a private key to a new file of mode 0600, which other users cannot read at any time.
/// Fails with kExists if the file exists.
Result<void> WriteKey(const std::filesystem::path& file, const EVP_PKEY& key);

// These functions read the files of a CA.
Result<openssl::CertificateHandle> ReadAuthority(const AuthorityFolder& folder);
Result<openssl::RevocationList> ReadRevoked(const AuthorityFolder& folder);
/// Reads a private key; fails if other users can read the file.
Result<openssl::Key> ReadPrivateKey(const std::filesystem::path& file);

}  // namespace tendon
