#include <tendon/security/certificate_builder.h>

#include <openssl/ec.h>
#include <openssl/rand.h>
#include <tendon/security/pem.h>

#include <algorithm>
#include <ctime>
#include <string>

namespace tendon::openssl {
namespace {

using std::chrono::sys_seconds;
using Extension = Handle<X509_EXTENSION, X509_EXTENSION_free>;

constexpr std::chrono::hours kClocksDiffer(1);

sys_seconds FromNowOn() {
  return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now()) - kClocksDiffer;
}

Time TimeAt(sys_seconds when) {
  Time time(ASN1_TIME_set(nullptr, static_cast<std::time_t>(when.time_since_epoch().count())));
  Require(time != nullptr, "a time");
  return time;
}

/// Returns a unique number that cannot be guessed.
Number RandomSerial() {
  constexpr int kBits = 126;
  const Handle<BIGNUM, BN_free> random(BN_new());
  Require(random && BN_rand(random.get(), kBits, BN_RAND_TOP_ONE, BN_RAND_BOTTOM_ANY) == 1,
          "a random number");
  Number serial(BN_to_ASN1_INTEGER(random.get(), nullptr));
  Require(serial != nullptr, "a serial number");
  return serial;
}

void SetEntry(X509_NAME* name, const char* kind, std::string_view text) {
  Require(X509_NAME_add_entry_by_txt(name, kind, MBSTRING_UTF8,
                                     reinterpret_cast<const unsigned char*>(text.data()),
                                     static_cast<int>(text.size()), -1, 0) == 1,
          "a subject");
}

Extension MakeExtension(X509V3_CTX& context, int kind, const std::string& value) {
  Extension made(X509V3_EXT_conf_nid(nullptr, &context, kind, value.c_str()));
  Require(made != nullptr, value.c_str());
  return made;
}

/// Returns a certificate with the fields that all certificates have. It is not signed yet.
CertificateHandle Begin(EVP_PKEY& key, sys_seconds not_after) {
  CertificateHandle certificate(X509_new());
  Require(certificate != nullptr, "a certificate");
  constexpr long kVersion3 = 2;
  X509* made = certificate.get();
  Require(X509_set_version(made, kVersion3) == 1 &&
              X509_set_serialNumber(made, RandomSerial().get()) == 1 &&
              X509_set1_notBefore(made, TimeAt(FromNowOn()).get()) == 1 &&
              X509_set1_notAfter(made, TimeAt(not_after).get()) == 1 &&
              X509_set_pubkey(made, &key) == 1,
          "a certificate");
  SetEntry(X509_get_subject_name(made), "O", "Tendon");
  return certificate;
}

void Extend(X509& certificate, const X509& issuer,
            const std::vector<std::pair<int, std::string>>& values) {
  X509V3_CTX context;
  X509V3_set_ctx(&context, const_cast<X509*>(&issuer), &certificate, nullptr, nullptr, 0);
  for (const auto& [kind, value] : values) {
    Require(X509_add_ext(&certificate, MakeExtension(context, kind, value).get(), -1) == 1,
            value.c_str());
  }
}

bool IsAddress(const std::string& host) {
  return Handle<ASN1_OCTET_STRING, ASN1_OCTET_STRING_free>(a2i_IPADDRESS(host.c_str())) != nullptr;
}

/// "DNS:robot.local,IP:192.168.0.7"
std::string AlternativeNames(const std::vector<std::string>& hosts) {
  std::string names;
  for (const std::string& host : hosts) {
    if (!names.empty()) names += ',';
    names += (IsAddress(host) ? "IP:" : "DNS:") + host;
  }
  return names;
}

long NextNumber(const X509_CRL* former) {
  if (former == nullptr) return 1;
  const Number number(
      static_cast<ASN1_INTEGER*>(X509_CRL_get_ext_d2i(former, NID_crl_number, nullptr, nullptr)));
  return number ? ASN1_INTEGER_get(number.get()) + 1 : 1;
}

void AddEntry(X509_CRL& list, Handle<X509_REVOKED, X509_REVOKED_free> entry) {
  Require(entry && X509_CRL_add0_revoked(&list, entry.get()) == 1, "an entry of the CRL");
  (void)entry.release();  // the list owns the entry
}

}  // namespace

Key MakeKey() {
  Key key(EVP_EC_gen("P-256"));
  Require(key != nullptr, "a key");
  return key;
}

CertificateHandle MakeAuthority(EVP_PKEY& key, sys_seconds not_after) {
  CertificateHandle certificate = Begin(key, not_after);
  X509* made = certificate.get();
  constexpr std::size_t kDigits = 8;
  // The name must be unique, so that users can distinguish CAs.
  SetEntry(X509_get_subject_name(made), "CN", "Tendon CA " + SerialOf(*made).substr(0, kDigits));
  Require(X509_set_issuer_name(made, X509_get_subject_name(made)) == 1, "an issuer");
  Extend(*made, *made,
         {{NID_basic_constraints, "critical,CA:TRUE,pathlen:0"},
          {NID_key_usage, "critical,keyCertSign,cRLSign"},
          {NID_subject_key_identifier, "hash"}});
  Require(X509_sign(made, &key, EVP_sha256()) > 0, "signing");
  return certificate;
}

CertificateHandle MakeCertificate(const CertificateAuthority::Request& request, EVP_PKEY& key,
                                  sys_seconds not_after, const Signer& signer) {
  CertificateHandle certificate = Begin(key, not_after);
  X509* made = certificate.get();
  SetEntry(X509_get_subject_name(made), "OU", ToString(request.role));
  SetEntry(X509_get_subject_name(made), "CN", request.name);
  Require(X509_set_issuer_name(made, X509_get_subject_name(&signer.certificate)) == 1, "an issuer");
  const bool serves = request.holder == Holder::kProcess;
  std::vector<std::pair<int, std::string>> extensions = {
      {NID_basic_constraints, "critical,CA:FALSE"},
      {NID_key_usage, "critical,digitalSignature"},
      {NID_ext_key_usage, serves ? "serverAuth,clientAuth" : "clientAuth"},
      {NID_subject_key_identifier, "hash"},
      {NID_authority_key_identifier, "keyid:always"}};
  if (!request.hosts.empty()) {
    extensions.emplace_back(NID_subject_alt_name, AlternativeNames(request.hosts));
  }
  Extend(*made, signer.certificate, extensions);
  Require(X509_sign(made, &signer.key, EVP_sha256()) > 0, "signing");
  return certificate;
}

RevocationList MakeRevocationList(const X509_CRL* former, const std::vector<const X509*>& revoked,
                                  const Signer& signer) {
  RevocationList list(X509_CRL_new());
  Require(list != nullptr, "a CRL");
  X509_CRL* made = list.get();
  constexpr long kVersion2 = 1;
  Require(X509_CRL_set_version(made, kVersion2) == 1 &&
              X509_CRL_set_issuer_name(made, X509_get_subject_name(&signer.certificate)) == 1 &&
              X509_CRL_set1_lastUpdate(made, TimeAt(FromNowOn()).get()) == 1 &&
              X509_CRL_set1_nextUpdate(made, X509_get0_notAfter(&signer.certificate)) == 1,
          "a CRL");
  const auto* entries = former ? X509_CRL_get_REVOKED(const_cast<X509_CRL*>(former)) : nullptr;
  for (int i = 0; i < sk_X509_REVOKED_num(entries); ++i) {
    AddEntry(*made, Handle<X509_REVOKED, X509_REVOKED_free>(
                        X509_REVOKED_dup(sk_X509_REVOKED_value(entries, i))));
  }
  const Time now = TimeAt(FromNowOn() + kClocksDiffer);
  for (const X509* certificate : revoked) {
    Handle<X509_REVOKED, X509_REVOKED_free> entry(X509_REVOKED_new());
    Require(entry && X509_REVOKED_set_revocationDate(entry.get(), now.get()) == 1, "a CRL");
    const Number serial(ASN1_INTEGER_dup(X509_get0_serialNumber(certificate)));
    Require(serial && X509_REVOKED_set_serialNumber(entry.get(), serial.get()) == 1, "a CRL");
    AddEntry(*made, std::move(entry));
  }
  X509V3_CTX context;
  X509V3_set_ctx(&context, const_cast<X509*>(&signer.certificate), nullptr, nullptr, made, 0);
  const Extension issuer = MakeExtension(context, NID_authority_key_identifier, "keyid:always");
  const Number number(ASN1_INTEGER_new());
  Require(number && ASN1_INTEGER_set(number.get(), NextNumber(former)) == 1 &&
              X509_CRL_add_ext(made, issuer.get(), -1) == 1 &&
              X509_CRL_add1_ext_i2d(made, NID_crl_number, number.get(), 0, 0) == 1 &&
              X509_CRL_sort(made) == 1 && X509_CRL_sign(made, &signer.key, EVP_sha256()) > 0,
          "signing the CRL");
  return list;
}

bool IsHost(const std::string& host) {
  constexpr std::size_t kLongest = 253;
  if (IsAddress(host)) return true;
  if (host.empty() || host.size() > kLongest || host.front() == '-' || host.front() == '.') {
    return false;
  }
  return std::all_of(host.begin(), host.end(), [](unsigned char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
           c == '.';
  });
}

}  // namespace tendon::openssl
