#pragma once

#include <tendon/security/certificate.h>
#include <tendon/security/openssl/handles.h>

#include <chrono>
#include <string>
#include <string_view>

/// From and to text.
namespace tendon::openssl {

// The first of its kind in a text, or null. A key behind a passphrase is none: nobody is asked.
[[nodiscard]] CertificateHandle ReadCertificate(std::string_view pem);
[[nodiscard]] Key ReadKey(std::string_view pem);
[[nodiscard]] RevocationList ReadRevocationList(std::string_view pem);

[[nodiscard]] std::string PemOf(const X509& certificate);
[[nodiscard]] std::string PemOf(const X509_CRL& list);
/// Not encrypted; call Wipe() on it.
[[nodiscard]] std::string PemOf(const EVP_PKEY& key);

/// Leaves no trace of a secret in memory.
void Wipe(std::string& secret);

/// The certificate of somebody, as opposed to that of a CA. Its extensions are found out on the
/// first call, and kept in the object.
Result<Certificate> Describe(X509& certificate);

[[nodiscard]] std::string SerialOf(const X509& certificate);
/// The epoch for what is no time.
[[nodiscard]] std::chrono::sys_seconds TimeOf(const ASN1_TIME* time);

}  // namespace tendon::openssl
