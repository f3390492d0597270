#include <tendon/security/pem.h>

#include <openssl/crypto.h>
#include <openssl/err.h>
#include <openssl/pem.h>
#include <tendon/base/name.h>

#include <ctime>
#include <utility>

namespace tendon::openssl {
namespace {

using Memory = Handle<BIO, BIO_free_all>;

Memory Over(std::string_view text) {
  Memory memory(BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
  Require(memory != nullptr, "memory");
  return memory;
}

/// Used instead of OpenSSL's function, which would ask for a passphrase at the terminal.
int NoPassphrase(char* /*buffer*/, int /*size*/, int /*writes*/, void* /*context*/) { return -1; }

template <typename Write>
std::string Written(Write write) {
  const Memory memory(BIO_new(BIO_s_secmem()));
  Require(memory != nullptr && write(memory.get()) == 1, "PEM");
  char* text = nullptr;
  const auto size = BIO_get_mem_data(memory.get(), &text);
  return {text, static_cast<std::size_t>(size)};
}

/// Returns the entry of a kind in a subject; empty unless there is exactly one.
std::string OnlyEntry(const X509_NAME* subject, int kind) {
  const int at = X509_NAME_get_index_by_NID(subject, kind, -1);
  if (at < 0 || X509_NAME_get_index_by_NID(subject, kind, at) >= 0) return {};
  const ASN1_STRING* text = X509_NAME_ENTRY_get_data(X509_NAME_get_entry(subject, at));
  return {reinterpret_cast<const char*>(ASN1_STRING_get0_data(text)),
          static_cast<std::size_t>(ASN1_STRING_length(text))};
}

std::pair<bool, Holder> HolderKindOf(X509& certificate) {
  const bool is_authority = X509_check_ca(&certificate) != 0;
  const std::uint32_t usage = X509_get_extended_key_usage(&certificate);
  const bool serves = usage != UINT32_MAX && (usage & XKU_SSL_SERVER) != 0;
  return {is_authority, serves ? Holder::kProcess : Holder::kPerson};
}

}  // namespace

CertificateHandle ReadCertificate(std::string_view pem) {
  CertificateHandle read(PEM_read_bio_X509(Over(pem).get(), nullptr, &NoPassphrase, nullptr));
  ERR_clear_error();
  return read;
}

Key ReadKey(std::string_view pem) {
  Key read(PEM_read_bio_PrivateKey(Over(pem).get(), nullptr, &NoPassphrase, nullptr));
  ERR_clear_error();
  return read;
}

RevocationList ReadRevocationList(std::string_view pem) {
  RevocationList read(PEM_read_bio_X509_CRL(Over(pem).get(), nullptr, &NoPassphrase, nullptr));
  ERR_clear_error();
  return read;
}

std::string PemOf(const X509& certificate) {
  return Written([&](BIO* to) { return PEM_write_bio_X509(to, &certificate); });
}

std::string PemOf(const X509_CRL& list) {
  return Written([&](BIO* to) { return PEM_write_bio_X509_CRL(to, &list); });
}

std::string PemOf(const EVP_PKEY& key) {
  return Written([&](BIO* to) {
    return PEM_write_bio_PrivateKey(to, &key, nullptr, nullptr, 0, nullptr, nullptr);
  });
}

void Wipe(std::string& secret) {
  OPENSSL_cleanse(secret.data(), secret.size());
  secret.clear();
}

Result<Certificate> Describe(X509& certificate) {
  const auto [is_authority, holder] = HolderKindOf(certificate);
  if (is_authority) {
    return Error{ErrorCode::kInvalid,
                 "it is the certificate of a CA, which identifies no person or process"};
  }
  const X509_NAME* subject = X509_get_subject_name(&certificate);
  const std::string name = OnlyEntry(subject, NID_commonName);
  if (auto checked = CheckName("certificate", name); !checked) return checked.error();
  const std::string unit = OnlyEntry(subject, NID_organizationalUnitName);
  const auto role = ParseRole(unit);
  if (!role) return role.error();
  return Certificate{.name = name,
                     .role = *role,
                     .holder = holder,
                     .serial = SerialOf(certificate),
                     .not_before = TimeOf(X509_get0_notBefore(&certificate)),
                     .not_after = TimeOf(X509_get0_notAfter(&certificate))};
}

std::string SerialOf(const X509& certificate) {
  using Digits = Handle<char, [](char* text) { OPENSSL_free(text); }>;
  const Handle<BIGNUM, BN_free> number(
      ASN1_INTEGER_to_BN(X509_get0_serialNumber(&certificate), nullptr));
  Require(number != nullptr, "a serial number");
  const Digits digits(BN_bn2hex(number.get()));
  Require(digits != nullptr, "a serial number");
  return digits.get();
}

std::chrono::sys_seconds TimeOf(const ASN1_TIME* time) {
  using namespace std::chrono;  // NOLINT(google-build-using-namespace): a dozen of its names
  std::tm parts{};
  if (ASN1_TIME_to_tm(time, &parts) != 1) return {};
  constexpr int kFirstYear = 1900;
  const year_month_day day{year(parts.tm_year + kFirstYear),
                           month(static_cast<unsigned>(parts.tm_mon) + 1),
                           std::chrono::day(static_cast<unsigned>(parts.tm_mday))};
  return sys_days(day) + hours(parts.tm_hour) + minutes(parts.tm_min) + seconds(parts.tm_sec);
}

}  // namespace tendon::openssl
