#include <tendon/security/authority_folder.h>

#include <tendon/base/os/file.h>
#include <tendon/security/pem.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <system_error>

namespace tendon {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxFileSize = std::size_t{1} << 20U;
constexpr fs::perms kOthers = fs::perms::group_all | fs::perms::others_all;

Error Failure(const std::string& what, const fs::path& file, const std::error_code& reason) {
  return {ErrorCode::kFailed, "cannot " + what + " " + file.string() + ": " + reason.message()};
}

std::string ModeText(fs::perms mode) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "%04o", static_cast<unsigned>(mode & fs::perms::all));
  return text.data();
}

}  // namespace

Result<std::string> ReadSmallFile(const fs::path& file) {
  std::error_code reason;
  const fs::file_status status = fs::status(file, reason);
  if (status.type() == fs::file_type::not_found) {
    return Error{ErrorCode::kNotFound, "there is no file " + file.string()};
  }
  if (status.type() != fs::file_type::regular) {
    return Error{ErrorCode::kInvalid, file.string() + " is not an ordinary file"};
  }
  std::ifstream stream(file, std::ios::binary);
  std::string text;
  while (stream && text.size() <= kMaxFileSize) {
    constexpr std::size_t kPiece = std::size_t{16} << 10U;
    const std::size_t before = text.size();
    text.resize(before + kPiece);
    stream.read(text.data() + before, kPiece);
    text.resize(before + static_cast<std::size_t>(stream.gcount()));
  }
  if (!stream.is_open() || stream.bad()) {
    return Error{ErrorCode::kDenied,
                 "cannot read " + file.string() + ": check that you own it and may read it"};
  }
  if (text.size() <= kMaxFileSize) return text;
  return Error{ErrorCode::kInvalid, file.string() + " is larger than the limit of 1 MiB"};
}

Result<void> RequirePrivate(const fs::path& file) {
  std::error_code reason;
  const fs::perms mode = fs::status(file, reason).permissions();
  if (!reason && (mode & kOthers) == fs::perms::none) return {};
  return Error{ErrorCode::kDenied,
               file.string() + " can be read by others (mode " + ModeText(mode) + "): chmod 600 " +
                   file.string() +
                   ", and issue another certificate if somebody else may have read the key"};
}

Result<void> MakePrivateFolder(const fs::path& folder) {
  std::error_code reason;
  if (fs::is_directory(folder, reason)) return {};
  if (folder.has_parent_path()) fs::create_directories(folder.parent_path(), reason);
  fs::create_directory(folder, reason);
  if (!reason) fs::permissions(folder, fs::perms::owner_all, reason);
  if (reason) return Failure("create the folder", folder, reason);
  return {};
}

Result<void> WritePrivateFile(const fs::path& file, std::string_view text) {
  if (auto written = os::ReplaceDurably(file, text); !written) return written;
  std::error_code reason;
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write, reason);
  if (reason) return Failure("protect", file, reason);
  return {};
}

Result<void> WriteKey(const fs::path& file, const EVP_PKEY& key) {
  std::string text = openssl::PemOf(key);
  auto kept = os::ReadOrMakePrivateFile(file, text);
  const bool is_ours = kept && *kept == text;
  openssl::Wipe(text);
  if (!kept) return kept.error();
  openssl::Wipe(*kept);
  if (is_ours) return os::AppendDurably(file, "");  // flushes the content to the disk
  return Error{ErrorCode::kExists, file.string() + " already exists: it is not overwritten"};
}

Result<openssl::CertificateHandle> ReadAuthority(const AuthorityFolder& folder) {
  const auto text = ReadSmallFile(folder.certificate());
  if (!text && text.error().code == ErrorCode::kNotFound) {
    return Error{ErrorCode::kNotFound, "there is no CA in " + folder.path.string() +
                                           "; to make a CA: gcm cert init; if the CA is in another "
                                           "folder, give that folder with --ca"};
  }
  if (!text) return text.error();
  auto certificate = openssl::ReadCertificate(*text);
  if (certificate) return certificate;
  return Error{ErrorCode::kInvalid, folder.certificate().string() + " is not a certificate (PEM)"};
}

Result<openssl::RevocationList> ReadRevoked(const AuthorityFolder& folder) {
  const auto text = ReadSmallFile(folder.revoked());
  if (!text) return Error{text.error().code, text.error().message + ": copy this file from the CA"};
  auto list = openssl::ReadRevocationList(*text);
  if (list) return list;
  return Error{ErrorCode::kInvalid,
               folder.revoked().string() + " is not a list of revoked certificates (PEM)"};
}

Result<openssl::Key> ReadPrivateKey(const fs::path& file) {
  auto text = ReadSmallFile(file);
  if (!text) return text.error();
  if (auto safe = RequirePrivate(file); !safe) return safe.error();
  auto key = openssl::ReadKey(*text);
  openssl::Wipe(*text);
  if (key) return key;
  return Error{ErrorCode::kInvalid,
               file.string() + " is not a private key (PEM, without a passphrase)"};
}

}  // namespace tendon
