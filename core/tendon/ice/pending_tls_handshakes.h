#pragma once

#include <openssl/ssl.h>
#include <tendon/base/clock.h>

#include <chrono>
#include <cstddef>
#include <map>
#include <mutex>

namespace tendon::ice {

/// The unfinished TLS handshakes of accepted connections. The timeout of Ice ends only a silent
/// handshake, not one in which the peer sends a byte from time to time. Therefore, when a handshake
/// begins while kMany are unfinished, this class ends the handshakes that are older than
/// kHandshakeTimeout, so that they do not use up the sockets. Thread-safe; called by OpenSSL.
class PendingTlsHandshakes {
 public:
  static constexpr std::chrono::seconds kHandshakeTimeout{3};
  static constexpr std::size_t kMany = 32;

  /// Begins to watch the handshakes of `context`. This object must outlive the handshakes.
  void Watch(SSL_CTX& context);

 private:
  struct TlsHandshake {
    SteadyTime since;
    int socket = -1;  // stays open until End()
  };

  static int ContextIndex();
  static int LinkIndex();
  static PendingTlsHandshakes* Of(const SSL& link);
  static void OnInfo(const SSL* link, int what, int value);
  static void OnFreed(void* parent, void* own, CRYPTO_EX_DATA* data, int index, long argument,
                      void* pointer);

  void Begin(const SSL& link);
  void End(const SSL& link);

  std::mutex mutex_;
  std::map<const SSL*, TlsHandshake> unfinished_;
};

}  // namespace tendon::ice
