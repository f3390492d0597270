#pragma once

#include <tendon/security/certificate_authority.h>
#include <tendon/security/openssl/handles.h>

#include <chrono>

/// Creates the objects of a CA. They are valid from an hour ago, because clocks differ.
namespace tendon::openssl {

/// On the curve P-256.
[[nodiscard]] Key MakeKey();

/// Self-signed.
[[nodiscard]] CertificateHandle MakeAuthority(EVP_PKEY& key, std::chrono::sys_seconds not_after);

struct Signer {
  const X509& certificate;
  EVP_PKEY& key;
};
/// For the owner of `key`. The request must be checked.
[[nodiscard]] CertificateHandle MakeCertificate(const CertificateAuthority::Request& request,
                                                EVP_PKEY& key, std::chrono::sys_seconds not_after,
                                                const Signer& signer);

/// Keeps the entries of `former`; null for the first list of a CA. Valid as long as the CA.
[[nodiscard]] RevocationList MakeRevocationList(const X509_CRL* former,
                                                const std::vector<const X509*>& revoked,
                                                const Signer& signer);

/// Whether a certificate may contain `host`: a domain name or an address.
[[nodiscard]] bool IsHost(const std::string& host);

}  // namespace tendon::openssl
