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

/// TLS for one communicator, with certificates at both ends. Ice checks that the certificate of a
/// peer was issued by the CA. This class checks revocation and role, and stores why a peer was
/// refused. Thread-safe.
class Tls : public std::enable_shared_from_this<Tls> {
  struct Key {};

 public:
  /// Reads the certificate and key of this program. Fails with kDenied, kNotFound or kInvalid if
  /// one of them is not valid. Logs a warning if the certificate expires soon. A renewed
  /// certificate is used for the next link.
  static Result<std::shared_ptr<Tls>> Make(Credentials credentials);

  /// Adds TLS to the settings. Must be called before a communicator is created with them.
  void AddTo(Ice::Properties& settings) const;
  /// Installs the checks of certificates. Must be called before the first connection is made.
  void CheckPeersOf(const Ice::Communicator& communicator);

  /// Returns the error for a link to `place` that was not opened because of the peer's certificate.
  /// If this class has refused the peer, uses its own reason. Otherwise uses `reason`, which comes
  /// from Ice.
  Error NotTrusted(const HostPort& place, const std::string& reason);
  /// The error if the peer closed the connection. Most likely, the peer does not trust the
  /// certificate of this program.
  [[nodiscard]] Error NotAccepted(const HostPort& place) const;

  /// The certificate of this program.
  [[nodiscard]] const Certificate& certificate() const { return own_->certificate(); }
  /// Sets the certificate of this program for the handshake of one link. Returns false if this
  /// fails.
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
  std::optional<RefusedPeer> refused_;  // last refused peer of a link that this process opened
};

/// Returns the certificate of the peer; empty without TLS. Throws an Ice exception if the
/// connection is already closed, because a missing certificate would then look like a peer without
/// TLS.
std::optional<Certificate> CertificateOf(const Ice::Connection& connection);

}  // namespace tendon::ice
