#include "conformance/peer_kinds.h"

#include <tendon/middleware/tcp.h>

namespace tendon::conformance {

std::shared_ptr<Middleware> MiddlewareOf(const std::string& kind) {
  return kind == "tcp" ? MakeTcpMiddleware(Exposure::kLoopbackOnly) : nullptr;
}

}  // namespace tendon::conformance
