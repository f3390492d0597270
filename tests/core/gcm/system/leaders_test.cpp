#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/gcm/system_file.h>

#include <string>
#include <vector>

namespace tendon {
namespace {

/// Returns a system file with an arm, and a host monitor with these members.
std::string RobotWith(const std::string& members) {
  return R"({"version": 1, "name": "x", "processes": [{"name": "robot", "components": [
  {"name": "arm", "class": "SimulatedArm"},
  {"name": "host", "class": "HostMonitor", )" +
         members + "}]}]}";
}

/// Returns the mistake in a system file; empty if the file is valid.
std::string MistakeIn(const std::string& text) {
  const auto system = ParseSystemFile(text, "x");
  return system ? "" : system.error().message;
}

TEST(LeadersTest, AreReadFromAndWrittenToAFile) {
  const auto system =
      ParseSystemFile(RobotWith(R"("runs_after": "arm", "thread": {"cpus": [900]})"), "x");

  ASSERT_TRUE(system) << system.error().message;
  const auto* host = system->FindComponent("robot", "host");
  EXPECT_EQ(host->runs_after, "arm");
  // Valid, because the file may be for another machine.
  EXPECT_EQ(host->thread->cpus, std::vector{900});
  EXPECT_FALSE(system->FindComponent("robot", "arm")->tells_thread());
  EXPECT_EQ(*ParseSystemFile(*SystemFileText(*system), "x"), *system);
}

TEST(LeadersTest, ErrorsNameTheirPosition) {
  const auto error = [](const std::string& members) { return MistakeIn(RobotWith(members)); };

  EXPECT_EQ(
      error(R"("runs_after": "arn")"),
      "x: line 3, column 44: processes[0].components[1].runs_after: the process has no component "
      "'arn'; did you mean 'arm'?");
  EXPECT_EQ(
      error(R"("runs_after": 7)"),
      "x: line 3, column 44: processes[0].components[1].runs_after: expected string, got number");
  EXPECT_THAT(error(R"("runs_after": "a b")"), testing::HasSubstr("has ' ' at 2"));
  EXPECT_EQ(error(R"("runs_after": "host")"),
            "x: line 1, column 61: processes[0].components: runs_after forms a cycle: 'host' "
            "runs after 'host'");
}

TEST(LeadersTest, RefusesARingNamingItsMembers) {
  const auto ring = [](int size) {
    std::string components;
    for (int i = 0; i < size; ++i) {
      components += std::string(i == 0 ? "" : ",") + R"({"name": "c)" + std::to_string(i) +
                    R"(", "class": "A", "runs_after": "c)" + std::to_string((i + 1) % size) + "\"}";
    }
    return MistakeIn(R"({"version": 1, "name": "x", "processes": [{"name": "p", "components": [)" +
                     components + R"(, {"name": "d", "class": "A", "runs_after": "c1"}]}]})");
  };

  EXPECT_THAT(ring(3), testing::EndsWith("'c0' runs after 'c1', which runs after 'c2', which runs "
                                         "after 'c0'"));
  const std::string large = ring(10'000);
  EXPECT_LT(large.size(), 1000U);
  EXPECT_THAT(large, testing::EndsWith("... (9980 more), which runs after 'c0'"));
}

}  // namespace
}  // namespace tendon
