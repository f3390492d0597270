#include <tendon/ice/ice_middleware.h>

#include "support/network_kinds.h"

namespace {

NetworkKind::Join MakeIce() {
  return [] { return tendon::MakeIceMiddleware(tendon::Exposure::kLoopbackOnly); };
}

}  // namespace

std::vector<NetworkKind> NetworkKinds() {
  std::vector<NetworkKind> kinds = PlainNetworkKinds();
  kinds.push_back({.name = "ice", .make = MakeIce});
  return kinds;
}
