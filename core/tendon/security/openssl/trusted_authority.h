#pragma once

#include <tendon/base/result.h>
#include <tendon/security/openssl/handles.h>

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace tendon::openssl {

/// A CA, and whom it has revoked: those in its files, which are parsed again only where they have
/// changed. Thread-safe.
class TrustedAuthority {
 public:
  using Store = std::shared_ptr<X509_STORE>;

  explicit TrustedAuthority(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// What to verify certificates with now. Reads two files, which may take as long as the disk
  /// does; nobody else waits for that. Errors: kNotFound, kInvalid, kDenied.
  [[nodiscard]] Result<Store> Now();

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  /// What `text` was parsed to; null where that is something else.
  Store Find(const std::string& text);

  const std::filesystem::path folder_;
  std::mutex mutex_;
  std::string text_;  // of both files, as `store_` has them
  Store store_;
};

}  // namespace tendon::openssl
