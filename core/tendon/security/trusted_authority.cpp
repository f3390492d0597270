#include <tendon/security/trusted_authority.h>

#include <openssl/x509_vfy.h>
#include <tendon/security/authority_folder.h>

namespace tendon::openssl {
namespace {

/// Returns the text of both files; empty if one of them cannot be read.
std::string TextOf(const AuthorityFolder& files) {
  const auto certificate = ReadSmallFile(files.certificate());
  const auto revoked = ReadSmallFile(files.revoked());
  return certificate && revoked ? *certificate + '\0' + *revoked : std::string();
}

}  // namespace

Result<TrustedAuthority::Store> TrustedAuthority::Now() {
  const AuthorityFolder files{folder_};
  std::string text = TextOf(files);
  if (auto known = Find(text)) return known;
  // The files are read again here, after `text`. If they change between the two reads, the store is
  // newer than `text`, and the next call parses the files again.
  const auto certificate = ReadAuthority(files);
  if (!certificate) return certificate.error();
  const auto revoked = ReadRevoked(files);
  if (!revoked) return revoked.error();
  Store store(X509_STORE_new(), &X509_STORE_free);
  Require(store && X509_STORE_add_cert(store.get(), certificate->get()) == 1 &&
              X509_STORE_add_crl(store.get(), revoked->get()) == 1,
          "a store of certificates");
  const std::scoped_lock lock(mutex_);
  store_ = store;
  text_ = std::move(text);
  return store;
}

TrustedAuthority::Store TrustedAuthority::Find(const std::string& text) {
  const std::scoped_lock lock(mutex_);
  return !text.empty() && text == text_ ? store_ : nullptr;
}

}  // namespace tendon::openssl
