#include <tendon/security/local_certificate.h>

#include <tendon/base/log.h>
#include <tendon/security/authority_folder.h>
#include <tendon/security/pem.h>

#include <chrono>
#include <utility>

namespace tendon::openssl {
namespace {

constexpr const char* kSource = "certificate";

void Warn(const std::filesystem::path& file, const std::string& warning) {
  if (!warning.empty()) Log(LogLevel::kWarning, kSource, file.string() + " " + warning);
}

}  // namespace

LocalCertificate::LocalCertificate(Passkey /*only from Read()*/, Credentials credentials,
                                   LoadedFiles loaded)
    : credentials_(std::move(credentials)),
      certificate_(std::move(loaded.checked.certificate)),
      key_file_(*loaded.checked.key),
      text_(std::move(loaded.text)),
      pair_(std::move(loaded.pair)) {}

Result<std::unique_ptr<LocalCertificate>> LocalCertificate::Read(const Credentials& credentials) {
  auto loaded = Load(credentials);
  if (!loaded) return loaded.error();
  Warn(credentials.certificate, loaded->checked.warning);
  return std::make_unique<LocalCertificate>(Passkey{}, credentials, *std::move(loaded));
}

Result<LocalCertificate::LoadedFiles> LocalCertificate::Load(const Credentials& credentials) {
  const std::filesystem::path& file = credentials.certificate;
  auto checked =
      CheckCertificate(file, credentials.authority,
                       std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now()));
  if (!checked) return checked.error();
  if (!checked->key) {
    return Error{ErrorCode::kNotFound, file.string() +
                                           " has no private key (.key) in the same folder: use a "
                                           "certificate and a key that were issued together"};
  }
  auto text = ReadSmallFile(file);
  if (!text) return text.error();
  auto key = ReadPrivateKey(*checked->key);
  if (!key) return key.error();
  auto pair = std::make_shared<Pair>();
  pair->certificate = ReadCertificate(*text);
  pair->key = *std::move(key);
  const auto described = pair->certificate ? Describe(*pair->certificate)
                                           : Error{ErrorCode::kInvalid, "no certificate"};
  const bool belongs =
      pair->certificate && X509_check_private_key(pair->certificate.get(), pair->key.get()) == 1;
  if (!described || *described != checked->certificate || !belongs) {
    return Error{ErrorCode::kInvalid, file.string() + " is being changed: try again"};
  }
  return LoadedFiles{
      .checked = *std::move(checked), .text = *std::move(text), .pair = std::move(pair)};
}

std::shared_ptr<const LocalCertificate::Pair> LocalCertificate::Now() {
  const std::scoped_lock lock(mutex_);
  const auto renewed = Renew();
  const std::string warning = renewed ? std::string() : renewed.error().message;
  if (!warning.empty() && warning != warning_) {
    Log(LogLevel::kWarning, kSource, "this program keeps its previous certificate: " + warning);
  }
  warning_ = warning;
  return pair_;
}

Result<void> LocalCertificate::Renew() {
  const std::filesystem::path& file = credentials_.certificate;
  const auto text = ReadSmallFile(file);
  if (!text) return text.error();
  if (*text == text_) return {};
  auto loaded = Load(credentials_);
  if (!loaded) return loaded.error();
  const Certificate& renewed = loaded->checked.certificate;
  if (renewed.name != certificate_.name || renewed.role != certificate_.role ||
      renewed.holder != certificate_.holder) {
    return Error{ErrorCode::kDenied, file.string() + " now belongs to the " +
                                         std::string(ToString(renewed.holder)) + " '" +
                                         renewed.name + "' with the role " +
                                         std::string(ToString(renewed.role)) +
                                         ": start this program again to use that certificate"};
  }
  Log(LogLevel::kInfo, kSource,
      "this program now uses the renewed certificate " + file.string() + ", valid until " +
          DateText(renewed.not_after));
  Warn(file, loaded->checked.warning);
  text_ = std::move(loaded->text);
  pair_ = std::move(loaded->pair);
  return {};
}

}  // namespace tendon::openssl
