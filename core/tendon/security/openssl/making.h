#pragma once

#include <tendon/security/certificate_authority.h>
#include <tendon/security/openssl/handles.h>

#include <chrono>

/// What a CA makes. Times: from an hour ago on, for the clocks of two hosts differ.
namespace tendon::openssl {

/// Of the curve P-256.
[[nodiscard]] Key MakeKey();

/// Signs itself.
[[nodiscard]] CertificateHandle MakeAuthority(EVP_PKEY& key, std::chrono::sys_seconds not_after);

struct Signer {
  const X509& certificate;
  EVP_PKEY& key;
};
/// For somebody who has `key`. The request was checked.
[[nodiscard]] CertificateHandle MakeCertificate(const CertificateAuthority::Request& request,
                                                EVP_PKEY& key, std::chrono::sys_seconds not_after,
                                                const Signer& signer);

/// Follows `former`, whose entries it keeps; null for the first of a CA. Is good as long as the CA.
[[nodiscard]] RevocationList MakeRevocationList(const X509_CRL* former,
                                                const std::vector<const X509*>& revoked,
                                                const Signer& signer);

/// Whether a certificate may name it: a domain name, or an address.
[[nodiscard]] bool IsHost(const std::string& host);

}  // namespace tendon::openssl
