#pragma once

#include <tendon/base/result.h>
#include <tendon/security/openssl_handles.h>

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace tendon::openssl {

/// A CA with its revoked certificates. Parses its files again only after a change. Thread-safe.
class TrustedAuthority {
 public:
  using Store = std::shared_ptr<X509_STORE>;

  explicit TrustedAuthority(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The store that verifies certificates now. Reads two files and may wait for the disk; other
  /// threads do not wait meanwhile. Errors: kNotFound, kInvalid, kDenied.
  [[nodiscard]] Result<Store> Now();

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  /// The last store if it was made from `text`, otherwise null.
  Store Find(const std::string& text);

  const std::filesystem::path folder_;
  std::mutex mutex_;
  std::string text_;  // content of both files from which `store_` was made
  Store store_;
};

}  // namespace tendon::openssl
