#pragma once

#include <openssl/ssl.h>
#include <tendon/base/clock.h>

#include <chrono>
#include <map>
#include <mutex>

namespace tendon::ice {

/// The TLS handshakes of those who came and have not finished theirs. Ice gives up who says nothing
/// for a while, but not one who says a byte now and then: whoever comes while there are kMany cuts
/// off those who have taken longer than kPatience, so that nobody holds sockets that others want.
/// Thread-safe; called by OpenSSL.
class Handshakes {
 public:
  static constexpr std::chrono::seconds kPatience{3};
  static constexpr std::size_t kMany = 32;

  /// Hears of those of `context`, and must outlive the last of them.
  void Watch(SSL_CTX& context);

 private:
  struct Begun {
    SteadyTime since;
    int socket = -1;  // open until End()
  };

  static int ContextIndex();
  static int LinkIndex();
  static Handshakes* Of(const SSL& link);
  static void OnInfo(const SSL* link, int what, int value);
  static void OnFreed(void* parent, void* own, CRYPTO_EX_DATA* data, int index, long argument,
                      void* pointer);

  void Begin(const SSL& link);
  void End(const SSL& link);

  std::mutex mutex_;
  std::map<const SSL*, Begun> begun_;
};

}  // namespace tendon::ice
