#pragma once

#include <Ice/Ice.h>
#include <tendon/base/clock.h>
#include <tendon/base/result.h>
#include <tendon/ice/strangers/handshakes.h>
#include <tendon/middleware/middleware.h>
#include <tendon/process/access/audit_log.h>
#include <tendon/security/certificate.h>
#include <tendon/security/credentials.h>
#include <tendon/security/openssl/shown_certificate.h>
#include <tendon/security/openssl/trusted_authority.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace tendon::ice {

/// TLS for one communicator, with certificates at both ends. Peers are judged once by Ice, which
/// knows the CA, and once by us, who know the revoked, the roles and why. Thread-safe.
class Tls : public std::enable_shared_from_this<Tls> {
  struct Key {};

 public:
  /// kDenied, kNotFound or kInvalid where what this program itself would show is not good. Warns of
  /// what soon will not be. A certificate that is renewed later is shown with the next link.
  static Result<std::shared_ptr<Tls>> Make(Credentials credentials);

  /// Before a communicator is made of the settings.
  void AddTo(Ice::Properties& settings) const;
  /// Before anything is connected.
  void Judge(const Ice::Communicator& communicator);

  /// Why no link was opened to `place`: what Ice had against its certificate, or our judgement.
  Error NotTrusted(const HostPort& place, const std::string& reason);
  /// The same where it hung up: most often it is the one who does not trust.
  [[nodiscard]] Error NotAccepted(const HostPort& place) const;

  /// One's own.
  [[nodiscard]] const Certificate& certificate() const { return own_->certificate(); }
  /// For the handshake of one link: false where there is none to show.
  bool ShowOwn(SSL& link);

  Tls(Key /*only from Make()*/, Credentials credentials,
      std::unique_ptr<openssl::ShownCertificate> own)
      : credentials_(std::move(credentials)),
        own_(std::move(own)),
        authority_(credentials_.authority) {}

 private:
  struct Refused {
    std::uint16_t port = 0;
    Error why;
    SteadyTime when;
  };

  bool IsGood(const Ice::ConnectionInfo& peer);

  const Credentials credentials_;
  const std::unique_ptr<openssl::ShownCertificate> own_;
  openssl::TrustedAuthority authority_;
  Handshakes handshakes_;
  AuditLog audit_;
  std::mutex mutex_;
  std::optional<Refused> refused_;  // the last one that was opened here
};

/// Of the peer of a connection; nothing without TLS. Throws what Ice throws where it is closed
/// already: who has a certificate must not be taken for one who needs none.
std::optional<Certificate> CertificateOf(const Ice::Connection& connection);

}  // namespace tendon::ice
