#pragma once

#include <Ice/Ice.h>
#include <tendon/base/clock.h>
#include <tendon/base/result.h>
#include <tendon/ice/pending_tls_handshakes.h>
#include <tendon/middleware/middleware.h>
#include <tendon/process/audit_log.h>
#include <tendon/security/certificate.h>
#include <tendon/security/credentials.h>
#include <tendon/security/local_certificate.h>
#include <tendon/security/trusted_authority.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace tendon::ice {

/// TLS for one communicator, with certificates at both ends. Ice checks the CA of a peer; this
/// class checks revocation and role, and stores the reason of a refusal. Thread-safe.
class Tls : public std::enable_shared_from_this<Tls> {
  struct Key {};

 public:
  /// kDenied, kNotFound or kInvalid if our own certificate or key is not valid. Logs a warning if
  /// it expires soon. A certificate renewed later is used for the next link.
  static Result<std::shared_ptr<Tls>> Make(Credentials credentials);

  /// Adds TLS to the settings. Call it before a communicator is created with them.
  void AddTo(Ice::Properties& settings) const;
  /// Installs the checks of certificates. Call it before the first connection.
  void CheckPeersOf(const Ice::Communicator& communicator);

  /// The error for a link to `place` that was not opened: Ice's reason against the peer's
  /// certificate, or our own reason.
  Error NotTrusted(const HostPort& place, const std::string& reason);
  /// The same if the peer closed the connection: most likely it does not trust our certificate.
  [[nodiscard]] Error NotAccepted(const HostPort& place) const;

  /// Our own certificate.
  [[nodiscard]] const Certificate& certificate() const { return own_->certificate(); }
  /// Sets our certificate for the handshake of one link. Returns false if there is none.
  bool ShowOwn(SSL& link);

  Tls(Key /*only from Make()*/, Credentials credentials,
      std::unique_ptr<openssl::LocalCertificate> own)
      : credentials_(std::move(credentials)),
        own_(std::move(own)),
        authority_(credentials_.authority) {}

 private:
  struct RefusedPeer {
    std::uint16_t port = 0;
    Error why;
    SteadyTime when;
  };

  bool IsGood(const Ice::ConnectionInfo& peer);

  const Credentials credentials_;
  const std::unique_ptr<openssl::LocalCertificate> own_;
  openssl::TrustedAuthority authority_;
  PendingTlsHandshakes handshakes_;
  AuditLog audit_;
  std::mutex mutex_;
  std::optional<RefusedPeer> refused_;  // the last refused peer of an opened link
};

/// The certificate of the peer; empty without TLS. Throws an Ice exception if the connection is
/// already closed, because a peer with a certificate must not be treated as one without TLS.
std::optional<Certificate> CertificateOf(const Ice::Connection& connection);

}  // namespace tendon::ice
