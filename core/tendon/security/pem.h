#pragma once

#include <tendon/security/certificate.h>
#include <tendon/security/openssl_handles.h>

#include <chrono>
#include <string>
#include <string_view>

/// Reading and writing PEM.
namespace tendon::openssl {

// The first object of its kind in a text, or null. A key with a passphrase is not read.
[[nodiscard]] CertificateHandle ReadCertificate(std::string_view pem);
[[nodiscard]] Key ReadKey(std::string_view pem);
[[nodiscard]] RevocationList ReadRevocationList(std::string_view pem);

[[nodiscard]] std::string PemOf(const X509& certificate);
[[nodiscard]] std::string PemOf(const X509_CRL& list);
/// Not encrypted; call Wipe() on the result after use.
[[nodiscard]] std::string PemOf(const EVP_PKEY& key);

/// Overwrites a secret in memory.
void Wipe(std::string& secret);

/// Describes a certificate of a person or a process, not of a CA. The first call parses its
/// extensions and stores them in the object.
Result<Certificate> Describe(X509& certificate);

[[nodiscard]] std::string SerialOf(const X509& certificate);
/// The epoch if `time` is invalid.
[[nodiscard]] std::chrono::sys_seconds TimeOf(const ASN1_TIME* time);

}  // namespace tendon::openssl
