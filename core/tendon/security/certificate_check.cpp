#include <tendon/security/certificate_check.h>

#include <openssl/err.h>
#include <openssl/x509_vfy.h>
#include <tendon/security/authority_folder.h>
#include <tendon/security/pem.h>
#include <tendon/security/trusted_authority.h>

#include <ctime>
#include <system_error>

namespace tendon {
namespace {

namespace fs = std::filesystem;
using std::chrono::sys_seconds;

constexpr const char* kIssueAnother = ": issue another with gcm cert issue";

/// Converts an error code of X509_verify_cert() to an Error for users.
Error NotGood(const std::string& what, int reason, X509& certificate, const fs::path& authority) {
  const auto denied = [&what](const std::string& why) {
    return Error{ErrorCode::kDenied, what + " " + why};
  };
  switch (reason) {
    case X509_V_ERR_CERT_HAS_EXPIRED:
      return denied("expired on " + DateText(openssl::TimeOf(X509_get0_notAfter(&certificate))) +
                    kIssueAnother);
    case X509_V_ERR_CERT_NOT_YET_VALID:
      return denied("is not valid before " +
                    DateText(openssl::TimeOf(X509_get0_notBefore(&certificate))) +
                    ": check the clock of this machine");
    case X509_V_ERR_CRL_NOT_YET_VALID:
      return denied("cannot be checked: the revocation list " +
                    AuthorityFolder{authority}.revoked().string() +
                    " is dated in the future: check the clock of this machine");
    case X509_V_ERR_INVALID_PURPOSE:
      return denied("is the certificate of a CA, or was not issued for connections (clientAuth)" +
                    std::string(kIssueAnother));
    case X509_V_ERR_CERT_REVOKED:
      return denied("was revoked (serial " + openssl::SerialOf(certificate) + ")" + kIssueAnother);
    case X509_V_ERR_UNABLE_TO_GET_ISSUER_CERT_LOCALLY:
    case X509_V_ERR_DEPTH_ZERO_SELF_SIGNED_CERT:
    case X509_V_ERR_SELF_SIGNED_CERT_IN_CHAIN:
    case X509_V_ERR_UNABLE_TO_VERIFY_LEAF_SIGNATURE:
    case X509_V_ERR_CERT_SIGNATURE_FAILURE:
      return denied(
          "was not issued by the CA in " + authority.string() +
          ": issue a certificate with that CA, or give the folder of the right CA with --ca");
    default:
      return denied("cannot be trusted: " + std::string(X509_verify_cert_error_string(reason)));
  }
}

/// Checks the chain up to the CA. Returns 0 if it is valid, otherwise the error code of OpenSSL.
int VerifyChain(X509& certificate, X509_STORE& authority, sys_seconds now) {
  const openssl::Handle<X509_STORE_CTX, X509_STORE_CTX_free> context(X509_STORE_CTX_new());
  openssl::Require(
      context && X509_STORE_CTX_init(context.get(), &authority, &certificate, nullptr) == 1,
      "a verification");
  X509_VERIFY_PARAM* rules = X509_STORE_CTX_get0_param(context.get());
  X509_VERIFY_PARAM_set_time(rules, static_cast<std::time_t>(now.time_since_epoch().count()));
  openssl::Require(
      X509_VERIFY_PARAM_set_flags(rules, X509_V_FLAG_CRL_CHECK | X509_V_FLAG_X509_STRICT) == 1 &&
          X509_VERIFY_PARAM_set_purpose(rules, X509_PURPOSE_SSL_CLIENT) == 1,
      "a verification");
  const bool holds = X509_verify_cert(context.get()) == 1;
  const int reason = holds ? X509_V_OK : X509_STORE_CTX_get_error(context.get());
  ERR_clear_error();
  return !holds && reason == X509_V_OK ? X509_V_ERR_UNSPECIFIED : reason;
}

/// Checks a certificate. `what` names it in error messages.
Result<Certificate> Check(const std::string& what, X509& certificate,
                          openssl::TrustedAuthority& authority, sys_seconds now) {
  const auto store = authority.Now();
  if (!store) return store.error();
  const int reason = VerifyChain(certificate, **store, now);
  if (reason != X509_V_OK) return NotGood(what, reason, certificate, authority.folder());
  auto described = openssl::Describe(certificate);
  if (!described) return Error{ErrorCode::kDenied, what + ": " + described.error().message};
  return described;
}

/// Returns the file of the private key beside a certificate, after checking the key; empty if there
/// is no such file.
Result<std::optional<fs::path>> FindKey(const fs::path& file, const X509& certificate) {
  fs::path key_file = file;
  key_file.replace_extension(".key");
  std::error_code reason;
  if (!fs::exists(key_file, reason)) return std::optional<fs::path>();
  const auto key = ReadPrivateKey(key_file);
  if (!key) return key.error();
  if (X509_check_private_key(&certificate, key->get()) == 1) return std::optional(key_file);
  ERR_clear_error();
  return Error{ErrorCode::kDenied, key_file.string() + " does not belong to " + file.string() +
                                       ": use a certificate and a key that were issued together"};
}

std::string WarningOf(const Certificate& certificate, sys_seconds now) {
  const auto left = certificate.not_after - now;
  if (left >= kExpiresSoon) return {};
  const auto days = std::chrono::floor<std::chrono::days>(left).count();
  return "expires on " + DateText(certificate.not_after) + ", in " + std::to_string(days) +
         (days == 1 ? " day" : " days") + kIssueAnother;
}

}  // namespace

Result<CheckedCertificate> CheckCertificate(const fs::path& file, const fs::path& authority,
                                            sys_seconds now) {
  const auto text = ReadSmallFile(file);
  if (!text) return text.error();
  if (text->find("PRIVATE KEY-----") != text->npos) {
    return Error{ErrorCode::kInvalid,
                 file.string() +
                     " contains a private key: check the file of the certificate instead, and keep "
                     "the key in a separate file"};
  }
  const auto certificate = openssl::ReadCertificate(*text);
  if (!certificate || text->size() > kMaxCertificateSize) {
    return Error{ErrorCode::kInvalid, file.string() + " is not a certificate (PEM)"};
  }
  openssl::TrustedAuthority issuer(authority);
  auto checked = Check(file.string(), *certificate, issuer, now);
  if (!checked) return checked.error();
  auto key = FindKey(file, *certificate);
  if (!key) return key.error();
  std::string warning = WarningOf(*checked, now);
  return CheckedCertificate{
      .certificate = *std::move(checked), .key = *std::move(key), .warning = std::move(warning)};
}

Result<Certificate> CheckPeerCertificate(std::string_view pem, openssl::TrustedAuthority& authority,
                                         sys_seconds now) {
  const auto certificate = openssl::ReadCertificate(pem.substr(0, kMaxCertificateSize));
  if (!certificate) return Error{ErrorCode::kDenied, "its certificate cannot be read"};
  const auto described = openssl::Describe(*certificate);
  const std::string what = described ? "the certificate of '" + described->name + "'"
                                     : "the certificate that the peer shows";
  return Check(what, *certificate, authority, now);
}

}  // namespace tendon
