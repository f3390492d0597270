#include <tendon/ice/ice_middleware.h>

#include "conformance/contract.h"

namespace tendon::conformance {
namespace {

Pair MakeIce(Exposure exposure) {
  return {MakeIceMiddleware(exposure), MakeIceMiddleware(exposure)};
}

const auto kIce = testing::Values(Kind{"ice", MakeIce});

INSTANTIATE_TEST_SUITE_P(WithIce, LinkContract, kIce, NameOfKind);
INSTANTIATE_TEST_SUITE_P(WithIce, AddressContract, kIce, NameOfKind);
INSTANTIATE_TEST_SUITE_P(WithIce, LifetimeContract, kIce, NameOfKind);
INSTANTIATE_TEST_SUITE_P(WithIce, PortContract, kIce, NameOfKind);
INSTANTIATE_TEST_SUITE_P(WithIce, ChannelContract, kIce, NameOfKind);
INSTANTIATE_TEST_SUITE_P(WithIce, LargeMessageContract, kIce, NameOfKind);

}  // namespace
}  // namespace tendon::conformance
