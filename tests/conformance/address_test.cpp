#include <gmock/gmock.h>

#include "conformance/contract.h"

namespace tendon::conformance {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST_P(AddressContract, PortZeroGivesAFreePort) {
  Host host;
  Start(host.accept());
  const auto second = pair_.server->Listen("127.0.0.1:0", host.accept());
  ASSERT_TRUE(second);

  EXPECT_TRUE(ParseAddress(listener_->address(), 1)) << listener_->address();
  EXPECT_TRUE(ParseAddress((*second)->address(), 1)) << (*second)->address();
  EXPECT_NE(listener_->address(), (*second)->address());
}

TEST_P(AddressContract, APortInUseIsRefusedByName) {
  Host host;
  Start(host.accept());

  const auto second = pair_.client->Listen(listener_->address(), host.accept());

  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().code, ErrorCode::kExists);
  EXPECT_THAT(second.error().message, StartsWith(listener_->address() + " is in use by "));
}

TEST_P(AddressContract, APortIsReusableAtOnceAfterALinkWasOpen) {
  Host host;
  Start(host.accept());
  const std::string address = listener_->address();
  const auto recorder = std::make_shared<Recorder>();
  const auto link = Open(recorder);
  ASSERT_TRUE(link);
  ASSERT_NE(host.guest().link, nullptr);

  listener_.reset();
  const auto again = pair_.server->Listen(address, host.accept());

  ASSERT_TRUE(again) << again.error().message;
  EXPECT_TRUE(recorder->WaitForClosed());
}

TEST_P(AddressContract, OpenFailsAsUnreachableIfNobodyListens) {
  Host host;
  Start(host.accept());
  const std::string address = listener_->address();
  listener_.reset();

  const auto link = pair_.client->Open(address, std::make_shared<Recorder>(), kTestTimeout);

  ASSERT_FALSE(link);
  EXPECT_EQ(link.error().code, ErrorCode::kUnreachable);
  EXPECT_THAT(link.error().message, HasSubstr(address));
}

TEST_P(AddressContract, AnUnknownHostIsUnreachable) {
  const Pair pair = GetParam().make(Exposure::kInsecure);

  const auto link =
      pair.client->Open("no-such-host.invalid:10705", std::make_shared<Recorder>(), kTestTimeout);

  ASSERT_FALSE(link);
  EXPECT_EQ(link.error().code, ErrorCode::kUnreachable);
  EXPECT_THAT(link.error().message, HasSubstr("no-such-host.invalid"));
}

TEST_P(ExposureContract, RemoteAddressesNeedTheInsecureOption) {
  Host host;
  const Pair pair = GetParam().make(Exposure::kLoopbackOnly);

  const auto listener = pair.server->Listen("0.0.0.0:0", host.accept());
  const auto link =
      pair.client->Open("192.0.2.1:10705", std::make_shared<Recorder>(), kTestTimeout);

  ASSERT_FALSE(listener);
  ASSERT_FALSE(link);
  EXPECT_EQ(listener.error().code, ErrorCode::kDenied);
  EXPECT_EQ(link.error().code, ErrorCode::kDenied);
  EXPECT_THAT(link.error().message, HasSubstr("--insecure"));
}

TEST_P(ExposureContract, TheInsecureOptionAllowsAnyAddress) {
  Host host;
  const Pair pair = GetParam().make(Exposure::kInsecure);

  const auto listener = pair.server->Listen("0.0.0.0:0", host.accept());
  ASSERT_TRUE(listener) << listener.error().message;
  const std::string address = (*listener)->address();
  const auto link = pair.client->Open("127.0.0.1" + address.substr(address.rfind(':')),
                                      std::make_shared<Recorder>(), kTestTimeout);

  EXPECT_TRUE(link) << link.error().message;
}

TEST_P(AddressContract, RefusesMalformedAddressesWithAMessage) {
  Host host;
  const Pair pair = GetParam().make(Exposure::kLoopbackOnly);
  for (const std::string address : {"", "nonsense", "127.0.0.1:", "127.0.0.1:abc",
                                    "127.0.0.1:65536", "127.0.0.1:-1", ":80", "::1:80"}) {
    const auto listener = pair.server->Listen(address, host.accept());
    const auto link = pair.client->Open(address, std::make_shared<Recorder>(), kTestTimeout);

    ASSERT_FALSE(listener) << address;
    ASSERT_FALSE(link) << address;
    EXPECT_EQ(listener.error().code, ErrorCode::kInvalid) << address;
    EXPECT_EQ(link.error().code, ErrorCode::kInvalid) << address;
  }
}

TEST_P(AddressContract, OpeningPortZeroIsRefused) {
  const Pair pair = GetParam().make(Exposure::kLoopbackOnly);

  const auto link = pair.client->Open("127.0.0.1:0", std::make_shared<Recorder>(), kTestTimeout);

  ASSERT_FALSE(link);
  EXPECT_EQ(link.error().message, "port '0': expected 1..65535");
}

TEST_P(AddressContract, LocalhostIsThisMachine) {
  Host host;
  Start(host.accept());
  const std::string address = listener_->address();

  const auto link = pair_.client->Open("localhost" + address.substr(address.rfind(':')),
                                       std::make_shared<Recorder>(), kTestTimeout);

  EXPECT_TRUE(link) << link.error().message;
}

}  // namespace
}  // namespace tendon::conformance
