#include <tendon/ice/ice_middleware.h>
#include <tendon/middleware/tcp.h>

#include <cstdlib>

#include "conformance/peer_kinds.h"

namespace tendon::conformance {

std::shared_ptr<Middleware> MiddlewareOf(const std::string& kind) {
  if (kind == "ice") return MakeIceMiddleware(Exposure::kLoopbackOnly);
  if (kind == "tls") {
    return *MakeIceMiddleware(
        Credentials{.certificate = getenv("TENDON_CERTIFICATE"), .authority = getenv("TENDON_CA")});
  }
  return kind == "tcp" ? MakeTcpMiddleware(Exposure::kLoopbackOnly) : nullptr;
}

}  // namespace tendon::conformance
