#include <gtest/gtest.h>
#include <tendon/middleware/middleware.h>

namespace tendon {
namespace {

std::string RefusalOf(const std::string& address, std::uint16_t lowest_port = 1) {
  const auto place = ParseAddress(address, lowest_port);
  if (place) return "accepted as " + ToString(*place);
  EXPECT_EQ(place.error().code, ErrorCode::kInvalid);
  return place.error().message;
}

TEST(Address, HasAHostAndAPort) {
  const auto place = ParseAddress("robot-1.lab:10705", 1);

  ASSERT_TRUE(place);
  EXPECT_EQ(place->host, "robot-1.lab");
  EXPECT_EQ(place->port, 10705);
  EXPECT_EQ(ToString(*place), "robot-1.lab:10705");
}

TEST(Address, Ipv6NeedsBrackets) {
  const auto place = ParseAddress("[::1]:80", 1);

  ASSERT_TRUE(place);
  EXPECT_EQ(place->host, "::1");
  EXPECT_EQ(ToString(*place), "[::1]:80");
  EXPECT_EQ(RefusalOf("::1:80"),
            "address '::1:80': put an IPv6 host in brackets, such as [::1]:10705");
}

TEST(Address, LocalhostResolvesToALoopbackAddress) {
  EXPECT_EQ(ParseAddress("localhost:80", 1)->host, "127.0.0.1");
}

TEST(Address, ReportsAnInvalidPort) {
  EXPECT_EQ(RefusalOf("h:abc"), "port 'abc': expected 1..65535");
  EXPECT_EQ(RefusalOf("h:"), "port '': expected 1..65535");
  EXPECT_EQ(RefusalOf("h:0"), "port '0': expected 1..65535");
  EXPECT_EQ(RefusalOf("h:65536"), "port '65536': expected 1..65535");
  EXPECT_EQ(RefusalOf("h:-1"), "port '-1': expected 1..65535");
  EXPECT_EQ(RefusalOf("h:8 "), "port '8 ': expected 1..65535");
  EXPECT_EQ(RefusalOf("h:-1", 0), "port '-1': expected 0..65535");
  EXPECT_TRUE(ParseAddress("h:0", 0));
}

TEST(Address, RefusesAHostWithSpecialCharacters) {
  EXPECT_EQ(RefusalOf("10705"), "address '10705': expected host:port, such as 127.0.0.1:10705");
  EXPECT_EQ(RefusalOf(":80"), "address ':80': expected a host before the ':'");
  for (const std::string host : {"a b", "a\"b", "a\x1b[31m", "a/b", "-h"}) {
    EXPECT_FALSE(ParseAddress(host + ":80", 1)) << host;
  }
}

TEST(Exposure, ThisMachineIsAlwaysAllowed) {
  for (const std::string host : {"127.0.0.1", "127.255.3.4", "localhost", "::1"}) {
    EXPECT_TRUE(CheckExposure(host, Exposure::kLoopbackOnly)) << host;
  }
}

TEST(Exposure, DeniesRemoteAndDisguisedHosts) {
  for (const std::string host :
       {"0.0.0.0", "192.168.0.1", "128.0.0.1", "::", "robot", "127.0.0.1.example.org",
        "127.example.org", "127.0.0", "127.0.0.256", "127.0.0.1.1", "127.0.0.", ""}) {
    const auto allowed = CheckExposure(host, Exposure::kLoopbackOnly);

    ASSERT_FALSE(allowed) << host;
    EXPECT_EQ(allowed.error().code, ErrorCode::kDenied);
    EXPECT_TRUE(CheckExposure(host, Exposure::kInsecure)) << host;
  }
}

TEST(Exposure, TheRefusalNamesTheRemedy) {
  EXPECT_EQ(CheckExposure("10.0.0.7", Exposure::kLoopbackOnly).error().message,
            "host '10.0.0.7' is on another machine and the connection is not encrypted: use "
            "127.0.0.1, encrypt the connection with --certificate, or allow unencrypted "
            "connections with --insecure");
}

}  // namespace
}  // namespace tendon
