#include <tendon/ice/ice_middleware.h>
#include <tendon/middleware/tcp.h>

#include "conformance/peer_kinds.h"

namespace tendon::conformance {

std::shared_ptr<Middleware> MiddlewareOf(const std::string& kind) {
  if (kind == "ice") return MakeIceMiddleware(Exposure::kLoopbackOnly);
  return kind == "tcp" ? MakeTcpMiddleware(Exposure::kLoopbackOnly) : nullptr;
}

}  // namespace tendon::conformance
