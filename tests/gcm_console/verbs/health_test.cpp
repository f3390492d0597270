#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>
#include <tendon/gcm/text.h>

#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "gcm_console/demo_fixture.h"
#include "gcm_console/terminal.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

/// An idle process, and a process that is as busy as possible.
class HealthTest : public SystemFixture {
 protected:
  void SetUp() override {
    StartGcm();
    const auto system = home.path() / "busy.json";
    std::ofstream(system)
        << R"({"version": 1, "name": "busy", "processes": [{"name": "busy", "components": [
        {"class": "Chatterbox", "name": "chatterbox", "library": "chatterbox"}]}]})";
    busy = StartLcm("busy", system.string());
    idle = StartIdle();
  }
  [[nodiscard]] std::unique_ptr<Program> StartIdle() const {
    return std::make_unique<Program>(Program::Words{Binary("lcm"), "--name", "idle", "--gcm",
                                                    address, "--timeout", kTestTimeout});
  }

  /// Returns the health of a process; empty if there is none.
  [[nodiscard]] json HealthIn(const json& processes, const std::string& name) const {
    for (const json& process : processes) {
      if (process["name"] == name) return process["health"];
    }
    return json::object();
  }
  [[nodiscard]] json HealthOf(const std::string& process) const {
    const json listed = json::parse(Gcm({"--json", "ls"}).out, nullptr, false);
    return listed.is_object() ? HealthIn(listed["processes"], process) : json::object();
  }
  testing::AssertionResult EventuallyTells(const std::string& process) const {
    json health;
    const bool tells = EventuallyTrue([&] {
      health = HealthOf(process);
      return health.contains("cpu_cores") && health.contains("clock_offset_s");
    });
    return tells ? testing::AssertionSuccess()
                 : testing::AssertionFailure() << process << " tells " << health;
  }

  /// Waits until the output matches. Health that is older than three seconds is not printed, so on
  /// a busy machine the command is repeated.
  testing::AssertionResult EventuallyMatches(const Program::Words& line,
                                             const std::string& pattern) const {
    std::string out;
    const bool matches = EventuallyTrue([&] {
      out = Gcm(line).out;
      return std::regex_search(out, std::regex(pattern));
    });
    return matches ? testing::AssertionSuccess() : testing::AssertionFailure() << out;
  }

  std::unique_ptr<Program> busy;
  std::unique_ptr<Program> idle;
};

TEST_F(HealthTest, ABusyProcessReportsMoreCpuThanAnIdleOne) {
  ASSERT_TRUE(EventuallyTells("busy")) << busy->err().substr(0, 1000);
  ASSERT_TRUE(EventuallyTells("idle")) << idle->err();

  json working;
  json resting;
  ASSERT_TRUE(EventuallyTrue([&] {
    working = HealthOf("busy");
    resting = HealthOf("idle");
    return working.contains("clock_offset_s") &&
           working.value("cpu_cores", 0.0) > 2 * resting.value("cpu_cores", 1.0);
  })) << working
      << resting;
  EXPECT_GT(working["memory_bytes"], 1'000'000);
  EXPECT_EQ(working["clock_offset_s"], 0.0);  // both processes are on one host
  EXPECT_GE(working["clock_uncertainty_s"], 0.0);
  EXPECT_GE(working["age_s"], 0.0);
}

TEST_F(HealthTest, EachVerbThatShowsProcessesShowsHealth) {
  ASSERT_TRUE(EventuallyTells("idle")) << idle->err();

  EXPECT_TRUE(EventuallySays({"ls", "-l"}, "idle\tprocess\t\talive\tcpu "));
  EXPECT_TRUE(EventuallyMatches({"ls", "-l"}, "idle.* %, memory "));
  EXPECT_TRUE(EventuallyMatches({"show", "idle"},
                                "cpu\t[0-9.]+ %\nmemory\t[0-9.]+ MiB\nclock\t0.0 ms off \\(\\+-"));
  EXPECT_TRUE(EventuallyMatches({"--json", "show", "idle"}, "\"memory_bytes\""));
  EXPECT_TRUE(EventuallyMatches(
      {"doctor"}, "process idle .*, cpu [0-9.]+ %, memory .*, version [0-9.]+, protocol [0-9]+\n"));
  EXPECT_TRUE(EventuallyMatches({"doctor"}, "ok   GCM .*, version [0-9.]+, protocol [0-9]+\n"));
  EXPECT_TRUE(EventuallyTrue([&] {
    const json top = json::parse(Gcm({"--json", "top"}).out, nullptr, false);
    return top.is_object() && HealthIn(top["processes"], "idle").contains("cpu_cores");
  }));

  Terminal terminal(Binary("gcm") + " --gcm " + address + " --timeout " + kTestTimeout + " top", {},
                    100);
  EXPECT_TRUE(terminal.Shows(" MiB")) << terminal.seen();
  terminal.Type("q");
  EXPECT_EQ(terminal.program().Wait(), program::kOk);
}

TEST_F(HealthTest, ALostProcessIsAFaultAndALeftOneIsNot) {
  ASSERT_TRUE(EventuallySays({"ls"}, "idle\talive"));

  idle->Signal(SIGTERM);
  EXPECT_TRUE(EventuallyMatches({"doctor"}, "-    process idle +left: deregistered"));

  idle = StartIdle();
  ASSERT_TRUE(EventuallySays({"ls"}, "idle\talive"));
  idle->Signal(SIGKILL);
  EXPECT_TRUE(EventuallyMatches({"doctor"}, "BAD  process idle +lost: "));
}

TEST_F(HealthTest, ALostProcessHasNoHealth) {
  ASSERT_TRUE(EventuallyTells("idle")) << idle->err();

  idle->Signal(SIGKILL);

  ASSERT_TRUE(EventuallySays({"ls"}, "idle\tlost"));
  EXPECT_EQ(HealthOf("idle"), json::object());
  EXPECT_THAT(Gcm({"show", "idle"}).out, HasSubstr("cpu\t-\nmemory\t-\nclock\t-\n"));
}

TEST(HealthText, ShowsDashesForUnknownValues) {
  using tendon::message::ProcessHealth;
  const ProcessHealth known{.cpu = 1.254,
                            .memory = 35'750'000,
                            .clock_offset = std::chrono::microseconds(-1500),
                            .clock_uncertainty = std::chrono::microseconds(120)};
  EXPECT_EQ(tendon::CpuText(&known), "125.4 %");
  EXPECT_EQ(tendon::MemoryText(&known), "34.1 MiB");
  EXPECT_EQ(tendon::ClockText(&known), "-1.5 ms off (+-0.1 ms)");

  const ProcessHealth unknown;
  for (const ProcessHealth* health : {&unknown, static_cast<const ProcessHealth*>(nullptr)}) {
    EXPECT_EQ(tendon::CpuText(health), "-");
    EXPECT_EQ(tendon::MemoryText(health), "-");
    EXPECT_EQ(tendon::ClockText(health), "-");
  }
}

TEST(HealthText, FindsOnlyRecentHealthOfALiveProcess) {
  using tendon::ProcessState;
  tendon::message::SystemHealth system{{{.process = "robot", .instance = 7}}};
  tendon::ProcessDescription robot{.name = "robot", .instance = 7};
  EXPECT_EQ(FindHealth(system, robot), &system.processes[0]);

  for (const ProcessState state :
       {ProcessState::kSuspect, ProcessState::kLost, ProcessState::kLeft}) {
    robot.state = state;
    EXPECT_EQ(FindHealth(system, robot), nullptr);
  }
  robot.state = ProcessState::kAlive;
  system.processes[0].age = tendon::kFreshHealth + std::chrono::nanoseconds(1);
  EXPECT_EQ(FindHealth(system, robot), nullptr);
  system.processes[0].age = {};
  robot.instance = 8;
  EXPECT_EQ(FindHealth(system, robot), nullptr);
}

}  // namespace
