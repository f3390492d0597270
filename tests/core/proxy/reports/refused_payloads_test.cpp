#include <gtest/gtest.h>
#include <tendon/base/log.h>
#include <tendon/proxy/reports/refused_payloads.h>

#include <mutex>
#include <string>
#include <vector>

namespace tendon {
namespace {

/// What is logged from now on.
std::vector<std::string>& Lines() {
  static std::vector<std::string> lines;
  static std::once_flag once;
  std::call_once(once, [] {
    AddLogSink(
        [](LogLevel, std::string_view, std::string_view message) { lines.emplace_back(message); });
  });
  lines.clear();
  return lines;
}

TEST(RefusedPayloads, AreToldOnceByTheNetworkThread) {
  auto& lines = Lines();
  RefusedPayloads refused("robot/arm/Cloud");
  refused.Add(0x2000007, "cloud");
  refused.Add(8, "Move");

  refused.Note(0x2000007, 80'000'000);
  EXPECT_TRUE(lines.empty());
  refused.Tell();
  refused.Tell();

  EXPECT_EQ(refused.logged(), 1U);
  EXPECT_EQ(lines, std::vector<std::string>{"'cloud' of 80 000 000 B exceeds max_payload "
                                            "67 108 864 B of robot/arm/Cloud (1 such so far)"});
}

TEST(RefusedPayloads, AreCountedButNotAllLogged) {
  auto& lines = Lines();
  RefusedPayloads refused("robot/arm/Cloud");
  refused.Add(1, "cloud");

  for (int i = 0; i < 5; ++i) {
    refused.Note(1, 80'000'000);
    refused.Tell();
  }

  EXPECT_EQ(refused.logged(), 5U);
  EXPECT_EQ(lines.size(), 1U);
}

}  // namespace
}  // namespace tendon
