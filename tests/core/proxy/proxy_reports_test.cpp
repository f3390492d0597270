#include <gtest/gtest.h>
#include <tendon/proxy/proxy_reports.h>

#include <string>
#include <vector>

#include "support/log/log_record.h"

namespace tendon {
namespace {

using tendon_test::LogRecord;

TEST(RefusedPayloads, AreLoggedOnceByTheNetworkThread) {
  const LogRecord log("network");
  RefusedPayloads refused("robot/arm/Cloud");
  refused.Add(0x2000007, "cloud");
  refused.Add(8, "Move");

  refused.Note(0x2000007, 80'000'000);
  EXPECT_TRUE(log.texts().empty());
  refused.Report();
  refused.Report();

  EXPECT_EQ(refused.logged(), 1U);
  EXPECT_EQ(log.texts(), std::vector<std::string>{"'cloud' of 80 000 000 B exceeds max_payload "
                                                  "67 108 864 B of robot/arm/Cloud (1 so far)"});
}

TEST(RefusedPayloads, AreCountedButNotAllLogged) {
  const LogRecord log("network");
  RefusedPayloads refused("robot/arm/Cloud");
  refused.Add(1, "cloud");

  for (int i = 0; i < 5; ++i) {
    refused.Note(1, 80'000'000);
    refused.Report();
  }

  EXPECT_EQ(refused.logged(), 5U);
  EXPECT_EQ(log.texts().size(), 1U);
}

}  // namespace
}  // namespace tendon
