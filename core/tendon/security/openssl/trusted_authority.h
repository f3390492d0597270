#pragma once

#include <tendon/base/result.h>
#include <tendon/security/openssl/handles.h>

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace tendon::openssl {

/// A CA with its revoked certificates, from its files. Parses them again only after a change.
/// Thread-safe.
class TrustedAuthority {
 public:
  using Store = std::shared_ptr<X509_STORE>;

  explicit TrustedAuthority(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The store that verifies certificates now. Reads two files, which may take as long as the disk
  /// does; other threads do not wait for that. Errors: kNotFound, kInvalid, kDenied.
  [[nodiscard]] Result<Store> Now();

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  /// The store for `text`; null if the last one is for another text.
  Store Find(const std::string& text);

  const std::filesystem::path folder_;
  std::mutex mutex_;
  std::string text_;  // of both files, as in `store_`
  Store store_;
};

}  // namespace tendon::openssl
