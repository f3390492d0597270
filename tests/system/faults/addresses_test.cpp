#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>
#include <tendon/base/os/process.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/program.h"
#include "system/faults/harness/fault_test.h"
#include "system/faults/harness/islands.h"

namespace faults {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kLedgerOfDesk = "desk/client/Ledger";

/// The GCM and desk are on one host, robot is on another host.
class Addresses : public FaultTest {
 protected:
  void SetUp() override {
    if (!islands_.ok()) GTEST_SKIP() << islands_.reason();
    // No other program uses this port on the island.
    gcm_address_ = std::string(Islands::kHere) + ":10705";
    gcm_ = Run(islands_.Here(), "gcm", {"--insecure", "serve"});
    ASSERT_TRUE(Eventually([this] { return gcm_->out().starts_with("GCM at "); })) << gcm_->err();
  }

  [[nodiscard]] std::unique_ptr<Program> Run(Words island, const std::string& program,
                                             const Words& words) const {
    const Words command = Command(program, words);
    island.insert(island.end(), command.begin(), command.end());
    return std::make_unique<Program>(island, environment());
  }
  void StartRobot(const Words& addresses) {
    Words words{"--insecure", "--name", "robot", "--system", home_.path() / "system.json"};
    words.insert(words.end(), addresses.begin(), addresses.end());
    robot_ = Run(islands_.There(), "lcm", words);
    ASSERT_TRUE(Eventually([this] { return AddressOfRobot() != ""; })) << robot_->err();
  }
  void StartDesk() {
    desk_ = Run(islands_.Here(), "lcm",
                {"--insecure", "--listen", std::string(Islands::kHere) + ":0", "--name", "desk",
                 "--system", home_.path() / "system.json"});
  }
  /// Runs a verb on the GCM's host.
  [[nodiscard]] Outcome Ask(Words words) const {
    words.insert(words.begin(), "--insecure");
    const auto program = Run(islands_.Here(), "gcm", words);
    const auto exit_code = program->Wait();
    return {exit_code.value_or(-1), program->out(), program->err()};
  }
  [[nodiscard]] bool EventuallySays(const Words& words, const std::string& text) const {
    return Eventually([&] { return Ask(words).out.find(text) != std::string::npos; });
  }
  [[nodiscard]] nlohmann::json Robot() const {
    const Outcome listing = Ask({"--json", "ls"});
    const auto all = nlohmann::json::parse(listing.out, nullptr, false);
    if (all.is_discarded()) return nlohmann::json::object();
    for (const auto& process : all["processes"]) {
      if (process["name"] == "robot") return process;
    }
    return nlohmann::json::object();
  }
  [[nodiscard]] std::string AddressOfRobot() const { return Robot().value("address", ""); }
  void DoThere(const std::string& script) const {
    Words words = islands_.There();
    for (const std::string& word :
         {std::string("/bin/sh"), std::string("-c"), "PATH=$PATH:/usr/sbin:/sbin; " + script}) {
      words.push_back(word);
    }
    const Outcome done = RunProgram(words);
    ASSERT_EQ(done.exit_code, 0) << done.err;
  }

  const Islands islands_;
};

INSTANTIATE_TEST_SUITE_P(Over, Addresses, testing::ValuesIn(Middlewares()), NameOfMiddleware);

TEST_P(Addresses, AWildcardListenerAdvertisesItsAddressTowardsTheGcm) {
  ASSERT_NO_FATAL_FAILURE(StartRobot({"--listen", "0.0.0.0:0"}));
  StartDesk();

  EXPECT_THAT(AddressOfRobot(), ContainsRegex("^10[.]77[.]0[.]2:[1-9][0-9]+$"));
  EXPECT_TRUE(EventuallyExecutesMore()) << robot_->err() << desk_->err();
  EXPECT_THAT(robot_->err(), Not(ContainsRegex("start (it|this process) with")));
}

TEST_P(Addresses, AnAdvertisedHostGetsTheEphemeralPort) {
  ASSERT_NO_FATAL_FAILURE(StartRobot({"--listen", "0.0.0.0:0", "--advertise", Islands::kThere}));
  StartDesk();

  EXPECT_THAT(AddressOfRobot(), ContainsRegex("^10[.]77[.]0[.]2:[1-9][0-9]+$"));
  EXPECT_TRUE(EventuallyExecutesMore()) << robot_->err() << desk_->err();
}

TEST_P(Addresses, AProcessReachableOnlyLocallyIsReportedEverywhere) {
  ASSERT_NO_FATAL_FAILURE(StartRobot({}));
  StartDesk();
  const std::string remedy = "start this process with --listen 10.77.0.2:0";

  EXPECT_TRUE(Eventually([&] { return robot_->err().find(remedy) != std::string::npos; }))
      << robot_->err();
  EXPECT_THAT(Robot().value("reason", ""), HasSubstr(remedy));
  EXPECT_THAT(Ask({"status"}).out, HasSubstr(remedy));
  EXPECT_THAT(Ask({"doctor"}).out,
              AllOf(ContainsRegex("BAD +process robot .*only from its own host"),
                    HasSubstr("fix: " + remedy)));
  ASSERT_TRUE(EventuallySays({"explain", kLedgerOfDesk}, "the connection is pending"));
  EXPECT_THAT(
      Ask({"explain", kLedgerOfDesk}).out,
      AllOf(HasSubstr("(seen from host " + tendon::os::HostName() + ")"), HasSubstr("fix: ")));
}

TEST_P(Addresses, WarnsOfListeningOnAnotherNetwork) {
  ASSERT_NO_FATAL_FAILURE(DoThere("ip addr add 10.78.0.2/24 dev v1"));
  ASSERT_NO_FATAL_FAILURE(StartRobot({"--listen", "10.78.0.2:0"}));

  EXPECT_THAT(AddressOfRobot(), testing::StartsWith("10.78.0.2:"));
  ASSERT_TRUE(Eventually([&] {
    return robot_->err().find("reaches its GCM from 10.77.0.2") != std::string::npos;
  })) << robot_->err();
  EXPECT_THAT(robot_->err(), HasSubstr("--listen 10.77.0.2:0"));
}

/// The robot works. The host of the desk has no route to it.
TEST_P(Addresses, AMissingRouteIsBlamedOnTheRightHost) {
  ASSERT_NO_FATAL_FAILURE(StartRobot({"--listen", "0.0.0.0:0", "--advertise", "10.99.0.1"}));
  StartDesk();
  const std::string no_route =
      "host '" + tendon::os::HostName() + "' has no route to " + AddressOfRobot();

  ASSERT_TRUE(EventuallySays({"explain", kLedgerOfDesk}, no_route))
      << Ask({"explain", kLedgerOfDesk}).out;

  EXPECT_THAT(
      Ask({"explain", kLedgerOfDesk}).out,
      AllOf(HasSubstr("fix: give host " + tendon::os::HostName() + " a route to this address"),
            Not(HasSubstr("firewall"))));
  ASSERT_TRUE(EventuallySays({"doctor"}, no_route)) << Ask({"doctor"}).out;
  EXPECT_THAT(Ask({"doctor"}).out,
              AllOf(HasSubstr(no_route), HasSubstr("fix: give host " + tendon::os::HostName() +
                                                   " a route to this address")));
}

TEST_P(Addresses, AnUnroutableGcmGivesNoAdviceToStartOne) {
  Words command = islands_.Here();
  for (const std::string& word :
       {Built("bin/gcm"), std::string("--gcm"), std::string("10.99.0.1:10705"),
        std::string("--timeout"), std::string("500"), std::string("--middleware"), GetParam(),
        std::string("--insecure"), std::string("ls")}) {
    command.push_back(word);
  }

  const Outcome listing = RunProgram(command);

  EXPECT_EQ(listing.exit_code, program::kUnreachable);
  EXPECT_THAT(listing.err, AllOf(HasSubstr("has no route to"), Not(HasSubstr("start one with"))));
}

TEST_P(Addresses, AClientIsNotWarnedAboutInsecure) {
  EXPECT_THAT(gcm_->err(), HasSubstr("--insecure: everybody who can reach"));

  const Outcome listing = Ask({"ls"});

  EXPECT_EQ(listing.exit_code, program::kOk) << listing.err;
  EXPECT_THAT(listing.err, Not(HasSubstr("--insecure")));
}

TEST_P(Addresses, APendingPairIsNotReportedAsConnected) {
  ASSERT_NO_FATAL_FAILURE(StartRobot({}));  // no other host can reach the robot
  StartDesk();
  ASSERT_TRUE(EventuallySays({"explain", kLedgerOfDesk}, "the connection is pending"));

  const Outcome again = Ask({"connect", kLedgerOfDesk, "robot/ledger/Control"});

  EXPECT_EQ(again.exit_code, program::kRefused);
  EXPECT_THAT(again.err, AllOf(HasSubstr(std::string(kLedgerOfDesk) + " waits to be connected to "),
                               HasSubstr("gcm explain"), Not(HasSubstr("is connected to"))));
}

}  // namespace
}  // namespace faults
