#pragma once

#include <tendon/base/result.h>
#include <tendon/security/openssl_handles.h>

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace tendon::openssl {

/// A CA with its revoked certificates. Its files are parsed again only if they have changed.
/// Thread-safe.
class TrustedAuthority {
 public:
  using Store = std::shared_ptr<X509_STORE>;

  explicit TrustedAuthority(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Returns the store with which certificates are verified now. Reads two files and may block on
  /// the disk, but does not block other threads. Fails with kNotFound, kInvalid or kDenied.
  [[nodiscard]] Result<Store> Now();

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  /// Returns the last store if it was made from `text`, otherwise null.
  Store Find(const std::string& text);

  const std::filesystem::path folder_;
  std::mutex mutex_;
  std::string text_;  // content of both files from which `store_` was made
  Store store_;
};

}  // namespace tendon::openssl
