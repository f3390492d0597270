#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/process/membership/own_address.h>

namespace {

using tendon::OwnAddress;
using tendon::OwnAddressOf;
using tendon::WayToGcm;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

const WayToGcm kElsewhere{.to = "10.9.1.1:10705", .from = "10.9.1.2"};
const WayToGcm kByIpv6{.to = "[fd00::1]:10705", .from = "fd00::2"};
const WayToGcm kBeside{.to = "127.0.0.1:10705", .from = "127.0.0.1"};
/// By an address that others reach it by, too.
const WayToGcm kOnThisHost{.to = "10.9.1.2:10705", .from = "10.9.1.2"};

TEST(OwnAddress, WhereItListensIsToldWhereThatLeadsToIt) {
  for (const char* listens : {"127.0.0.1:43211", "[::1]:43211", "10.9.1.2:43211"}) {
    EXPECT_EQ(OwnAddressOf(listens, "", {}), (OwnAddress{listens, ""}));
  }
  EXPECT_EQ(OwnAddressOf("127.0.0.1:43211", "", kBeside), (OwnAddress{"127.0.0.1:43211", ""}));
  EXPECT_EQ(OwnAddressOf("10.9.1.2:43211", "", kElsewhere), (OwnAddress{"10.9.1.2:43211", ""}));
  EXPECT_EQ(OwnAddressOf("10.9.1.2:43211", "", kBeside), (OwnAddress{"10.9.1.2:43211", ""}));
}

TEST(OwnAddress, OneOnTheHostOfItsGcmIsReachedByItHoweverThatIsCalled) {
  EXPECT_EQ(OwnAddressOf("127.0.0.1:43211", "", kOnThisHost), (OwnAddress{"127.0.0.1:43211", ""}));
  EXPECT_EQ(OwnAddressOf("0.0.0.0:43211", "", kOnThisHost), (OwnAddress{"10.9.1.2:43211", ""}));
}

TEST(OwnAddress, OneThatListensEverywhereTellsThatFromWhichItReachedTheGcm) {
  EXPECT_EQ(OwnAddressOf("0.0.0.0:43211", "", kElsewhere), (OwnAddress{"10.9.1.2:43211", ""}));
  EXPECT_EQ(OwnAddressOf("[::]:43211", "", kByIpv6), (OwnAddress{"[fd00::2]:43211", ""}));

  const OwnAddress beside_its_gcm = OwnAddressOf("0.0.0.0:43211", "", kBeside);
  EXPECT_EQ(beside_its_gcm.address, "127.0.0.1:43211");
  EXPECT_THAT(beside_its_gcm.warning, HasSubstr("start it with --advertise"));
}

TEST(OwnAddress, WhatItsUserSaysIsToldAlsoWithThePortThatTheSystemChose) {
  EXPECT_EQ(OwnAddressOf("0.0.0.0:43211", "10.9.1.7:80", kElsewhere),
            (OwnAddress{"10.9.1.7:80", ""}));
  EXPECT_EQ(OwnAddressOf("0.0.0.0:43211", "10.9.1.7", kElsewhere),
            (OwnAddress{"10.9.1.7:43211", ""}));
  EXPECT_EQ(OwnAddressOf("127.0.0.1:43211", "robot.local", {}),
            (OwnAddress{"robot.local:43211", ""}));
  EXPECT_EQ(OwnAddressOf("[::]:43211", "[fd00::7]", kByIpv6), (OwnAddress{"[fd00::7]:43211", ""}));
}

TEST(OwnAddress, OneThatOnlyItsHostReachesIsWarnedWhereTheGcmIsOnAnother) {
  for (const char* listens : {"127.0.0.1:43211", "127.0.1.1:43211", "localhost:43211"}) {
    const OwnAddress own = OwnAddressOf(listens, "", kElsewhere);
    EXPECT_EQ(own.address, listens);
    EXPECT_THAT(own.warning, AllOf(HasSubstr("from its own host alone"),
                                   HasSubstr("start it with --listen 10.9.1.2:0")));
  }
}

TEST(OwnAddress, OneThatListensOnAnotherNetworkThanThatOfTheGcmIsWarned) {
  const OwnAddress own = OwnAddressOf("10.8.1.2:43211", "", kElsewhere);

  EXPECT_EQ(own.address, "10.8.1.2:43211");
  EXPECT_THAT(own.warning,
              AllOf(HasSubstr("reaches its GCM from 10.9.1.2"), HasSubstr("--listen 10.9.1.2:0"),
                    HasSubstr("--listen 0.0.0.0:0")));
}

TEST(OwnAddress, OfAMiddlewareWithoutHostsAndPortsIsLeftAsItIs) {
  EXPECT_EQ(OwnAddressOf("robot", "", WayToGcm{"gcm", ""}), (OwnAddress{"robot", ""}));
  EXPECT_EQ(OwnAddressOf("robot", "elsewhere", WayToGcm{"gcm", ""}), (OwnAddress{"elsewhere", ""}));
}

TEST(OwnAddress, WhatLeadsNowhereIsNotAdvertised) {
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
    EXPECT_THAT(mistake(bad), HasSubstr("leads nowhere")) << bad;
  }
}

TEST(OwnAddress, TheGcmKnowsWhomOnlyHisHostReaches) {
  EXPECT_THAT(tendon::WhyOutOfReach("127.0.0.1:43211", "10.9.1.2:5"),
              HasSubstr("start it with --listen 10.9.1.2:0"));
  EXPECT_THAT(tendon::WhyOutOfReach("0.0.0.0:43211", "10.9.1.2:5"), HasSubstr("--listen"));
  EXPECT_THAT(tendon::WhyOutOfReach("10.9.1.2:43211", "10.9.1.2:5"), IsEmpty());
  EXPECT_THAT(tendon::WhyOutOfReach("127.0.0.1:43211", "127.0.0.1:5"), IsEmpty());
  EXPECT_THAT(tendon::WhyOutOfReach("127.0.0.1:43211", ""), IsEmpty());
}

}  // namespace
