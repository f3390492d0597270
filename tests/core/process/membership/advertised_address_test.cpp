#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/process/membership/advertised_address.h>

namespace {

using tendon::AdvertisedAddress;
using tendon::AdvertisedAddressOf;
using tendon::GcmRoute;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

const GcmRoute kElsewhere{.to = "10.9.1.1:10705", .from = "10.9.1.2"};
const GcmRoute kByIpv6{.to = "[fd00::1]:10705", .from = "fd00::2"};
const GcmRoute kBeside{.to = "127.0.0.1:10705", .from = "127.0.0.1"};
/// A route by an address at which other hosts can also reach this host.
const GcmRoute kOnThisHost{.to = "10.9.1.2:10705", .from = "10.9.1.2"};

TEST(AdvertisedAddress, IsTheListenAddressIfReachable) {
  for (const char* listens : {"127.0.0.1:43211", "[::1]:43211", "10.9.1.2:43211"}) {
    EXPECT_EQ(AdvertisedAddressOf(listens, "", {}), (AdvertisedAddress{listens, ""}));
  }
  EXPECT_EQ(AdvertisedAddressOf("127.0.0.1:43211", "", kBeside),
            (AdvertisedAddress{"127.0.0.1:43211", ""}));
  EXPECT_EQ(AdvertisedAddressOf("10.9.1.2:43211", "", kElsewhere),
            (AdvertisedAddress{"10.9.1.2:43211", ""}));
  EXPECT_EQ(AdvertisedAddressOf("10.9.1.2:43211", "", kBeside),
            (AdvertisedAddress{"10.9.1.2:43211", ""}));
}

TEST(AdvertisedAddress, MayBeLocalOnTheHostOfTheGcm) {
  EXPECT_EQ(AdvertisedAddressOf("127.0.0.1:43211", "", kOnThisHost),
            (AdvertisedAddress{"127.0.0.1:43211", ""}));
  EXPECT_EQ(AdvertisedAddressOf("0.0.0.0:43211", "", kOnThisHost),
            (AdvertisedAddress{"10.9.1.2:43211", ""}));
}

TEST(AdvertisedAddress, OfAWildcardIsTheAddressFacingTheGcm) {
  EXPECT_EQ(AdvertisedAddressOf("0.0.0.0:43211", "", kElsewhere),
            (AdvertisedAddress{"10.9.1.2:43211", ""}));
  EXPECT_EQ(AdvertisedAddressOf("[::]:43211", "", kByIpv6),
            (AdvertisedAddress{"[fd00::2]:43211", ""}));

  const AdvertisedAddress beside_its_gcm = AdvertisedAddressOf("0.0.0.0:43211", "", kBeside);
  EXPECT_EQ(beside_its_gcm.address, "127.0.0.1:43211");
  EXPECT_THAT(beside_its_gcm.warning, HasSubstr("start it with --advertise"));
}

TEST(AdvertisedAddress, IsTheUsersChoiceWithTheActualPort) {
  EXPECT_EQ(AdvertisedAddressOf("0.0.0.0:43211", "10.9.1.7:80", kElsewhere),
            (AdvertisedAddress{"10.9.1.7:80", ""}));
  EXPECT_EQ(AdvertisedAddressOf("0.0.0.0:43211", "10.9.1.7", kElsewhere),
            (AdvertisedAddress{"10.9.1.7:43211", ""}));
  EXPECT_EQ(AdvertisedAddressOf("127.0.0.1:43211", "robot.local", {}),
            (AdvertisedAddress{"robot.local:43211", ""}));
  EXPECT_EQ(AdvertisedAddressOf("[::]:43211", "[fd00::7]", kByIpv6),
            (AdvertisedAddress{"[fd00::7]:43211", ""}));
}

TEST(AdvertisedAddress, WarnsIfOnlyItsHostCanReachIt) {
  for (const char* listens : {"127.0.0.1:43211", "127.0.1.1:43211", "localhost:43211"}) {
    const AdvertisedAddress own = AdvertisedAddressOf(listens, "", kElsewhere);
    EXPECT_EQ(own.address, listens);
    EXPECT_THAT(own.warning, AllOf(HasSubstr("only from its own host"),
                                   HasSubstr("start this process with --listen 10.9.1.2:0")));
  }
}

TEST(AdvertisedAddress, WarnsIfItIsOnAnotherNetwork) {
  const AdvertisedAddress own = AdvertisedAddressOf("10.8.1.2:43211", "", kElsewhere);

  EXPECT_EQ(own.address, "10.8.1.2:43211");
  EXPECT_THAT(own.warning,
              AllOf(HasSubstr("reaches its GCM from 10.9.1.2"), HasSubstr("--listen 10.9.1.2:0"),
                    HasSubstr("--listen 0.0.0.0:0")));
}

TEST(AdvertisedAddress, KeepsAddressesWithoutHostAndPort) {
  EXPECT_EQ(AdvertisedAddressOf("robot", "", GcmRoute{"gcm", ""}),
            (AdvertisedAddress{"robot", ""}));
  EXPECT_EQ(AdvertisedAddressOf("robot", "elsewhere", GcmRoute{"gcm", ""}),
            (AdvertisedAddress{"elsewhere", ""}));
}

TEST(AdvertisedAddress, RefusesUnreachableAddresses) {
  const auto mistake = [](const std::string& advertise) {
    const auto checked = tendon::CheckAdvertise(advertise);
    return checked ? std::string() : checked.error().message;
  };
  for (const char* good : {"10.9.1.2", "10.9.1.2:80", "robot.local", "[::1]", "[fd00::7]:80"}) {
    EXPECT_THAT(mistake(good), IsEmpty()) << good;
  }
  EXPECT_EQ(mistake("10.9.1.2:0"), "port '0': expected 1..65535");
  EXPECT_THAT(mistake("fd00::7"), HasSubstr("put an IPv6 host in brackets"));
  for (const char* bad : {"0.0.0.0", "0.0.0.0:80", "[::]"}) {
    EXPECT_THAT(mistake(bad), HasSubstr("is not an address that others can reach")) << bad;
  }
}

TEST(AdvertisedAddress, TheGcmDetectsLocalOnlyAddresses) {
  EXPECT_THAT(tendon::WhyOutOfReach("127.0.0.1:43211", "10.9.1.2:5"),
              HasSubstr("start this process with --listen 10.9.1.2:0"));
  EXPECT_THAT(tendon::WhyOutOfReach("0.0.0.0:43211", "10.9.1.2:5"), HasSubstr("--listen"));
  EXPECT_THAT(tendon::WhyOutOfReach("10.9.1.2:43211", "10.9.1.2:5"), IsEmpty());
  EXPECT_THAT(tendon::WhyOutOfReach("127.0.0.1:43211", "127.0.0.1:5"), IsEmpty());
  EXPECT_THAT(tendon::WhyOutOfReach("127.0.0.1:43211", ""), IsEmpty());
}

}  // namespace
