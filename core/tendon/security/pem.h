#pragma once

#include <tendon/security/certificate.h>
#include <tendon/security/openssl_handles.h>

#include <chrono>
#include <string>
#include <string_view>

/// Functions that read and write PEM.
namespace tendon::openssl {

// These functions return the first object of their kind in a text; null if the text has none. A key
// with a passphrase cannot be read.
[[nodiscard]] CertificateHandle ReadCertificate(std::string_view pem);
[[nodiscard]] Key ReadKey(std::string_view pem);
[[nodiscard]] RevocationList ReadRevocationList(std::string_view pem);

[[nodiscard]] std::string PemOf(const X509& certificate);
[[nodiscard]] std::string PemOf(const X509_CRL& list);
/// Returns the key, not encrypted. The caller must call Wipe() on the result after use.
[[nodiscard]] std::string PemOf(const EVP_PKEY& key);

/// Overwrites a secret in memory.
void Wipe(std::string& secret);

/// Describes the certificate of a person or a process; fails for a certificate of a CA. The first
/// call parses the extensions and stores them in the object.
Result<Certificate> Describe(X509& certificate);

[[nodiscard]] std::string SerialOf(const X509& certificate);
/// Converts a time. Returns the epoch if `time` is invalid.
[[nodiscard]] std::chrono::sys_seconds TimeOf(const ASN1_TIME* time);

}  // namespace tendon::openssl
