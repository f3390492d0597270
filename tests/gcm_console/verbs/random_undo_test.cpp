#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>

#include <array>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "gcm_console/demo_fixture.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

/// Makes random changes of all kinds that can be undone, with real processes.
class UndoneSystemTest : public DemoFixture {
 protected:
  [[nodiscard]] std::string Hash() const {
    return json::parse(Gcm({"status", "--json"}).out)["content_hash"];
  }
  [[nodiscard]] std::size_t Steps() const {
    return json::parse(Gcm({"history", "--count", "1000", "--json"}).out)["steps"].size();
  }
  void Must(const Program::Words& words) const {
    const Outcome outcome = Gcm(words);
    ASSERT_EQ(outcome.exit_code, program::kOk) << words[0] << ": " << outcome.err;
  }
  /// Makes a random change. If the change is impossible now, it is refused and becomes no step.
  void DoSomething(std::mt19937& random) const {
    const auto one_of = [&random](const auto& words) {
      return std::string(words[random() % words.size()]);
    };
    const std::string arm = one_of(std::array{"arm", "spare"});
    const std::string required = one_of(std::array{"supervisor", "teleoperation"});
    const std::string verb =
        one_of(std::array{"connect", "connect", "disconnect", "start", "suspend", "stop", "restart",
                          "rm", "create", "create", "configure"});
    const std::string wanted = "desk/" + required + "/Robot";
    if (verb == "connect") {
      Gcm({verb, wanted, "robot/" + arm + "/Control", "--replace"});
    } else if (verb == "disconnect") {
      Gcm({verb, wanted});
    } else if (verb == "create") {
      Gcm({verb, "SimulatedArm", arm, "--in", "robot"});
    } else if (verb == "configure") {
      Gcm({verb, "robot/" + arm, "--arg",
           R"({"noise": 0.00)" + std::to_string(random() % 8 + 1) + "}"});
    } else {
      Gcm({verb, "robot/" + arm});
    }
  }
};

class RandomUndoTest : public UndoneSystemTest, public testing::WithParamInterface<unsigned> {};

INSTANTIATE_TEST_SUITE_P(From, RandomUndoTest, testing::Values(13U, 2026U));

/// Twenty changes; fifty if TENDON_FULL_FAULTS is set.
TEST_P(RandomUndoTest, AsManyUndosAsChangesGiveTheFirstState) {
  // NOLINTNEXTLINE(concurrency-mt-unsafe): read only
  const std::size_t steps = std::getenv("TENDON_FULL_FAULTS") != nullptr ? 50 : 20;
  const std::string before = Hash();
  std::mt19937 random(GetParam());
  while (Steps() < steps) DoSomething(random);

  const Outcome undone = Gcm({"undo", std::to_string(Steps())});

  EXPECT_EQ(undone.exit_code, program::kOk) << undone.err << Gcm({"history"}).out;
  EXPECT_TRUE(EventuallyTrue([&] { return Hash() == before; })) << Gcm({"tree"}).out;
}

TEST_F(UndoneSystemTest, UndoingADisconnectFromARemovedComponentIsPending) {
  const std::string before = Hash();
  Must({"rm", "robot/arm"});
  ASSERT_TRUE(EventuallySays({"show", "desk/supervisor/Robot"}, "pending"));
  Must({"disconnect", "desk/supervisor/Robot"});

  EXPECT_THAT(Gcm({"undo", "--dry-run"}).out, HasSubstr("would be undone: disconnect"));
  Must({"undo"});
  EXPECT_TRUE(EventuallySays({"show", "desk/supervisor/Robot"}, "pending"));
  Must({"undo"});

  EXPECT_TRUE(EventuallyTrue([&] { return Hash() == before; })) << Gcm({"tree"}).out;
}

TEST_F(UndoneSystemTest, RestartingASuspendedComponentCanBeUndone) {
  Must({"suspend", "robot/host_monitor"});
  const std::string suspended = Hash();
  Must({"restart", "robot/host_monitor"});
  EXPECT_THAT(Gcm({"history"}).out, HasSubstr("\tdone\tstart robot/host_monitor\n"));

  Must({"undo"});

  EXPECT_TRUE(EventuallyTrue([&] { return Hash() == suspended; })) << Gcm({"tree"}).out;
  Must({"restart", "robot/arm"});
  EXPECT_THAT(Gcm({"undo", "--dry-run"}).out, HasSubstr("suspend robot/host_monitor"))
      << "what runs before and after a restart has not changed";
}

}  // namespace
