#pragma once

#include <tendon/security/certificate_authority.h>
#include <tendon/security/openssl_handles.h>

#include <chrono>
#include <string>
#include <vector>

/// Functions that create the certificates and lists of a CA. Their validity begins one hour in the
/// past, because the clocks of machines differ.
namespace tendon::openssl {

/// Creates a key on the curve P-256.
[[nodiscard]] Key MakeKey();

/// Creates the self-signed certificate of a CA.
[[nodiscard]] CertificateHandle MakeAuthority(EVP_PKEY& key, std::chrono::sys_seconds not_after);

struct Signer {
  const X509& certificate;
  EVP_PKEY& key;
};
/// Creates a certificate for the owner of `key`. The caller must check the request before.
[[nodiscard]] CertificateHandle MakeCertificate(const CertificateAuthority::Request& request,
                                                EVP_PKEY& key, std::chrono::sys_seconds not_after,
                                                const Signer& signer);

/// Creates a revocation list with the entries of the list `former` and with the certificates
/// `revoked`. `former` is null for the first list of a CA. The new list is valid as long as the CA.
[[nodiscard]] RevocationList MakeRevocationList(const X509_CRL* former,
                                                const std::vector<const X509*>& revoked,
                                                const Signer& signer);

/// Returns true if `host` is a domain name or an address, so that a certificate may contain it.
[[nodiscard]] bool IsHost(const std::string& host);

}  // namespace tendon::openssl
