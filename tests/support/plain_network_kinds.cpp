#include <tendon/middleware/loopback.h>
#include <tendon/middleware/tcp.h>

#include "support/network_kinds.h"

namespace {

NetworkKind::Join MakeLoopback() {
  return [network = std::make_shared<tendon::LoopbackNetwork>()] {
    return std::make_shared<tendon::LoopbackMiddleware>(network);
  };
}

NetworkKind::Join MakeTcp() {
  return [] { return tendon::MakeTcpMiddleware(tendon::Exposure::kLoopbackOnly); };
}

}  // namespace

std::vector<NetworkKind> PlainNetworkKinds() {
  return {{.name = "loopback", .make = MakeLoopback}, {.name = "tcp", .make = MakeTcp}};
}
