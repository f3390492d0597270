#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>

#include <nlohmann/json.hpp>

#include "gcm_console/system_fixture.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

/// A connection that exists but has problems.
class UnhealthyTest : public SystemFixture {
 protected:
  void SetUp() override {
    StartGcm();
    hall = StartOne("hall", "clerk", "Clerk", "office");
    street = StartOne("street", "petitioner", "Petitioner", "office");
    ASSERT_TRUE(EventuallySays({"ls"}, "hall\talive")) << hall->err();
    ASSERT_TRUE(EventuallySays({"ls"}, "street\talive")) << street->err();
    ASSERT_EQ(Gcm({"connect", kDesk, "hall/clerk/Desk"}).exit_code, program::kOk);
  }

  static constexpr const char* kDesk = "street/petitioner/Desk";

  std::unique_ptr<Program> hall;
  std::unique_ptr<Program> street;
};

TEST_F(UnhealthyTest, ReportsAFullMailboxUntilItRecovers) {
  Outcome ill;
  ASSERT_TRUE(EventuallyTrue([&] {
    ill = Gcm({"explain", kDesk});
    return ill.out.find("calls were refused, because the mailbox was full") != std::string::npos;
  })) << ill.out
      << ill.err;
  EXPECT_EQ(ill.exit_code, program::kRefused);
  EXPECT_THAT(ill.out, HasSubstr("  6 BAD the connection is made, but "));
  EXPECT_THAT(ill.out, HasSubstr("fix: to find the component that is too slow: gcm top\n"));
  const json document = json::parse(Gcm({"explain", kDesk, "--json"}).out);
  EXPECT_EQ(document["connected"], true);
  EXPECT_EQ(document["steps"][5]["verdict"], "bad");

  ASSERT_EQ(Gcm({"suspend", "street/petitioner"}).exit_code, program::kOk);

  Outcome at_rest;
  ASSERT_TRUE(EventuallyTrue([&] {
    at_rest = Gcm({"explain", kDesk});
    return at_rest.out.find("  6 ok  the connection is made") != std::string::npos;
  })) << at_rest.out;
  EXPECT_THAT(at_rest.out, HasSubstr("  2 BAD petitioner is suspended: it makes no calls\n"
                                     "         fix: gcm start street/petitioner\n"));
  EXPECT_THAT(at_rest.out, HasSubstr("  7 ok  "));
  EXPECT_EQ(at_rest.exit_code, program::kRefused);
}

}  // namespace
