#include <tendon/ice/tls.h>

#include <IceSSL/IceSSL.h>
#include <IceSSL/OpenSSL.h>
#include <openssl/err.h>
#include <openssl/ssl.h>
#include <tendon/base/log.h>
#include <tendon/ice/settings.h>
#include <tendon/security/certificate_check.h>

#include <chrono>
#include <exception>
#include <utility>

namespace tendon::ice {
namespace {

/// Returns the certificate of the peer as PEM text; empty without a certificate.
std::string ShownBy(const IceSSL::ConnectionInfo& info) {
  return info.certs.empty() ? std::string() : info.certs.front()->encode();
}

std::chrono::sys_seconds Now() {
  return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
}

/// Converts the reason of OpenSSL, as Ice reports it, to a text for users.
std::string InOurWords(const std::string& reason, const Credentials& credentials) {
  const auto says = [&reason](const char* words) { return reason.find(words) != reason.npos; };
  if (says("self-signed") || says("self signed") || says("issuer certificate")) {
    return "its certificate was not issued by the CA in " + credentials.authority.string();
  }
  if (says("purpose")) return "its certificate belongs to a person, not to a process";
  if (says("expired")) return "its certificate has expired: issue another with gcm cert issue";
  if (says("not yet valid"))
    return "its certificate is not valid yet: check the clocks of both machines";
  return OnOneLine(reason);
}

/// Called by OpenSSL in each handshake to set the certificate. Returns 1 to continue the handshake.
int ShowOwnOf(SSL* link, void* tls) {
  try {
    return static_cast<Tls*>(tls)->ShowOwn(*link) ? 1 : 0;
    // OpenSSL is C code, so no exception may leave this function.
  } catch (const std::exception& failure) {
    Log(LogLevel::kError, "ice",
        std::string("the certificate of this program cannot be used in a TLS handshake: ") +
            failure.what());
    return 0;
  }
}

}  // namespace

Result<std::shared_ptr<Tls>> Tls::Make(Credentials credentials) {
  // Uses absolute paths, because the files are read again later, when the program may have another
  // working directory.
  credentials = {.certificate = std::filesystem::absolute(credentials.certificate),
                 .authority = std::filesystem::absolute(credentials.authority)};
  auto own = openssl::LocalCertificate::Read(credentials);
  if (!own) return own.error();
  return std::make_shared<Tls>(Key{}, std::move(credentials), *std::move(own));
}

void Tls::AddTo(Ice::Properties& settings) const {
  settings.setProperty("Ice.Plugin.IceSSL", "IceSSL:createIceSSL");
  settings.setProperty("IceSSL.Protocols", "TLS1_2, TLS1_3");
  settings.setProperty("IceSSL.VerifyPeer", "2");
  settings.setProperty("IceSSL.Trace.Security", "1");  // logs why a peer is refused
  settings.setProperty("IceSSL.VerifyDepthMax", "2");
  settings.setProperty("IceSSL.CAs", (credentials_.authority / "ca.crt").string());
  settings.setProperty("IceSSL.CertFile", own_->file().string());
  settings.setProperty("IceSSL.KeyFile", own_->key_file().string());
}

void Tls::CheckPeersOf(const Ice::Communicator& communicator) {
  const auto plugin = std::dynamic_pointer_cast<IceSSL::OpenSSL::Plugin>(
      communicator.getPluginManager()->getPlugin("IceSSL"));
  SSL_CTX_set_cert_cb(plugin->getContext(), &ShowOwnOf, this);
  handshakes_.Watch(*plugin->getContext());
  SSL_CTX_set_num_tickets(plugin->getContext(), 0);  // sessions are never resumed
  plugin->setCertificateVerifier(
      [self = shared_from_this()](const auto& peer) { return self->IsGood(*peer); });
}

bool Tls::ShowOwn(SSL& link) {
  const auto own = own_->Now();
  const bool is_shown = SSL_use_cert_and_key(&link, own->certificate.get(), own->key.get(), nullptr,
                                             1 /*instead of what there is*/) == 1;
  if (!is_shown) ERR_clear_error();
  return is_shown;
}

bool Tls::IsGood(const Ice::ConnectionInfo& peer) {
  const auto checked = CheckPeerCertificate(
      ShownBy(dynamic_cast<const IceSSL::ConnectionInfo&>(peer)), authority_, Now());
  if (checked) return true;
  const auto place = std::dynamic_pointer_cast<Ice::IPConnectionInfo>(peer.underlying);
  const std::string address = place ? place->remoteAddress : "an unknown peer";
  audit_.Write(address, LogLevel::kWarning, address + " was refused: " + checked.error().message);
  if (!peer.incoming && place) {
    const std::scoped_lock lock(mutex_);
    refused_ = {static_cast<std::uint16_t>(place->remotePort), checked.error(),
                SteadyClock().Now()};
  }
  return false;
}

Error Tls::NotTrusted(const HostPort& place, const std::string& reason) {
  const std::scoped_lock lock(mutex_);
  constexpr std::chrono::seconds kFresh(5);
  const bool is_ours =
      refused_ && refused_->port == place.port && SteadyClock().Now() - refused_->when < kFresh;
  const std::string why = is_ours ? std::exchange(refused_, std::nullopt)->why.message
                                  : InOurWords(reason, credentials_);
  return {ErrorCode::kDenied, ToString(place) + " is not trusted: " + why};
}

Error Tls::NotAccepted(const HostPort& place) const {
  return {ErrorCode::kUnreachable, ToString(place) + " does not accept " +
                                       credentials_.certificate.string() +
                                       ", or does not use TLS: see the log of that program"};
}

std::optional<Certificate> CertificateOf(const Ice::Connection& connection) {
  const auto info = std::dynamic_pointer_cast<IceSSL::ConnectionInfo>(connection.getInfo());
  if (!info) return std::nullopt;
  auto certificate = ParseCertificate(ShownBy(*info));
  if (!certificate) throw Ice::SecurityException("tendon", 0, certificate.error().message);
  return *std::move(certificate);
}

}  // namespace tendon::ice
