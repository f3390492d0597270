#pragma once

#include <openssl/ssl.h>
#include <tendon/base/clock.h>

#include <chrono>
#include <map>
#include <mutex>

namespace tendon::ice {

/// The unfinished TLS handshakes of accepted connections. Ice's timeout ends a silent handshake,
/// but not one that sends a byte now and then. When kMany are unfinished, a new one ends those
/// older than kPatience, so that they cannot occupy sockets that others need. Thread-safe; called
/// by OpenSSL.
class PendingTlsHandshakes {
 public:
  static constexpr std::chrono::seconds kPatience{3};
  static constexpr std::size_t kMany = 32;

  /// Watches the handshakes of `context`; this object must outlive them.
  void Watch(SSL_CTX& context);

 private:
  struct Unfinished {
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
  std::map<const SSL*, Unfinished> unfinished_;
};

}  // namespace tendon::ice
