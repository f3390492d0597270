#pragma once

#include <tendon/security/certificate_authority.h>
#include <tendon/security/openssl_handles.h>

#include <chrono>

/// Creates the objects of a CA. Their validity begins an hour ago, because clocks differ.
namespace tendon::openssl {

/// On the curve P-256.
[[nodiscard]] Key MakeKey();

/// Self-signed.
[[nodiscard]] CertificateHandle MakeAuthority(EVP_PKEY& key, std::chrono::sys_seconds not_after);

struct Signer {
  const X509& certificate;
  EVP_PKEY& key;
};
/// A certificate for the owner of `key`. The caller must have checked the request.
[[nodiscard]] CertificateHandle MakeCertificate(const CertificateAuthority::Request& request,
                                                EVP_PKEY& key, std::chrono::sys_seconds not_after,
                                                const Signer& signer);

/// Makes a list with the entries of `former`, which is null for the first list of a CA, and new
/// ones. Valid as long as the CA.
[[nodiscard]] RevocationList MakeRevocationList(const X509_CRL* former,
                                                const std::vector<const X509*>& revoked,
                                                const Signer& signer);

/// Whether a certificate may contain `host`: a domain name or an address.
[[nodiscard]] bool IsHost(const std::string& host);

}  // namespace tendon::openssl
