#include <tendon/middleware/loopback.h>
#include <tendon/middleware/tcp.h>

#include "conformance/contract.h"

namespace tendon::conformance {
namespace {

Pair MakeLoopback(Exposure /*exposure*/) {
  const auto network = std::make_shared<LoopbackNetwork>();
  return {std::make_shared<LoopbackMiddleware>(network),
          std::make_shared<LoopbackMiddleware>(network)};
}

Pair MakeTcp(Exposure exposure) {
  return {MakeTcpMiddleware(exposure), MakeTcpMiddleware(exposure)};
}

const auto kKinds = testing::Values(Kind{"loopback", MakeLoopback}, Kind{"tcp", MakeTcp});

INSTANTIATE_TEST_SUITE_P(Plain, LinkContract, kKinds, NameOfKind);
INSTANTIATE_TEST_SUITE_P(Plain, AddressContract, kKinds, NameOfKind);
INSTANTIATE_TEST_SUITE_P(Plain, LifetimeContract, kKinds, NameOfKind);
INSTANTIATE_TEST_SUITE_P(Plain, PortContract, testing::Values(Kind{"tcp", MakeTcp}), NameOfKind);
INSTANTIATE_TEST_SUITE_P(Plain, UnfinishedContract, testing::Values(Kind{"tcp", MakeTcp}),
                         NameOfKind);
INSTANTIATE_TEST_SUITE_P(Plain, ExposureContract, testing::Values(Kind{"tcp", MakeTcp}),
                         NameOfKind);
INSTANTIATE_TEST_SUITE_P(Plain, CookieContract, kKinds, NameOfKind);
INSTANTIATE_TEST_SUITE_P(Plain, ChannelContract, kKinds, NameOfKind);
INSTANTIATE_TEST_SUITE_P(Plain, LargeMessageContract, kKinds, NameOfKind);
INSTANTIATE_TEST_SUITE_P(Plain, LaterReplyContract, testing::Values(Kind{"loopback", MakeLoopback}),
                         NameOfKind);

}  // namespace
}  // namespace tendon::conformance
