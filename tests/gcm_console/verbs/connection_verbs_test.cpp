#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>

#include <nlohmann/json.hpp>

#include "gcm_console/demo_fixture.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

/// Tests `gcm connect` and `gcm disconnect` with more than one pair of names.
class ConnectionVerbsTest : public DemoFixture {};

constexpr const char* kTeleoperation = "desk/teleoperation/Robot";

TEST_F(ConnectionVerbsTest, ADryRunReportsChangesAndMakesNone) {
  const Outcome connected = Gcm({"connect", kTeleoperation, "robot/arm/Control", "--dry-run"});
  EXPECT_EQ(connected.exit_code, program::kOk) << connected.err;
  EXPECT_EQ(connected.out, "desk/teleoperation/Robot -> robot/arm/Control\twould be connected\n");
  EXPECT_EQ(Gcm({"disconnect", "desk/supervisor/Robot", "--dry-run"}).out,
            "desk/supervisor/Robot -> robot/arm/Control\twould be disconnected\n");

  const Outcome refused = Gcm({"connect", kTeleoperation, "desk/old_arm/Control", "--dry-run"});
  EXPECT_EQ(refused.exit_code, program::kIncompatible) << refused.err;
  const Outcome taken = Gcm({"connect", "desk/supervisor/Robot", "robot/arm/Control", "--dry-run"});
  EXPECT_EQ(taken.exit_code, program::kRefused) << taken.err;
  const Outcome unknown = Gcm({"connect", kTeleoperation, "robto/arm/Control", "--dry-run"});
  EXPECT_EQ(unknown.exit_code, program::kNotFound);
  EXPECT_EQ(unknown.err,
            "gcm: no process 'robto'; did you mean 'robot'? the connection would wait for this "
            "process\n");

  EXPECT_THAT(Gcm({"tree"}).out, HasSubstr("Robot  required  not connected"));
  EXPECT_THAT(Gcm({"ls", "desk/supervisor"}).out, HasSubstr("-> robot/arm/Control\n"));
}

TEST_F(ConnectionVerbsTest, ADryRunReportsTheTypeDifference) {
  // gcm waits only briefly for the types. On a machine that stalls, the types may arrive too late,
  // so the test repeats the command.
  EXPECT_TRUE(EventuallyTrue([&] {
    const Outcome dry = Gcm({"connect", kTeleoperation, "desk/old_arm/Control", "--dry-run"});
    return dry.err.find(" needed, ") != std::string::npos;
  }));
}

TEST_F(ConnectionVerbsTest, MatchConnectsFreeCompatibleInterfaces) {
  const Outcome dry = Gcm({"connect", "--match", "desk/**", "robot/**", "--dry-run"});
  EXPECT_EQ(dry.out, "desk/teleoperation/Robot -> robot/arm/Control\twould be connected\n");

  const Outcome matched = Gcm({"connect", "--match", "desk/**", "robot/**"});
  EXPECT_EQ(matched.exit_code, program::kOk) << matched.err;
  EXPECT_EQ(matched.out, "desk/teleoperation/Robot -> robot/arm/Control\tconnected\n");
  EXPECT_TRUE(EventuallySays({"ls", "desk/teleoperation"}, "-> robot/arm/Control\n"));

  const Outcome again = Gcm({"connect", "--match", "desk/**", "robot/**"});
  EXPECT_EQ(again.exit_code, program::kOk);
  EXPECT_EQ(again.out, "");
  EXPECT_EQ(again.err, "gcm: all interfaces that 'desk/**' matches are already connected\n");
}

TEST_F(ConnectionVerbsTest, MatchReportsAmbiguousInterfacesAndConnectsTheRest) {
  for (const std::string name : {"second", "third"}) {
    ASSERT_EQ(Gcm({"create", "SimulatedArm", name, "--in", "robot"}).exit_code, program::kOk);
  }

  const Outcome unclear = Gcm({"connect", "--match", "desk/**", "robot/**"});
  EXPECT_EQ(unclear.exit_code, program::kNotFound);
  EXPECT_EQ(unclear.err,
            "gcm: desk/teleoperation/Robot: 3 interfaces match equally well: robot/arm/Control, "
            "robot/second/Control, robot/third/Control\n");

  const Outcome unfit = Gcm({"--json", "connect", "--match", "desk/**", "desk/old_arm/*"});
  EXPECT_EQ(unfit.exit_code, program::kIncompatible);
  const json result = json::parse(unfit.out)["results"][0];
  EXPECT_EQ(result["path"], kTeleoperation);
  EXPECT_EQ(result["done"], false);
  EXPECT_EQ(result["reason"],
            "no interface that matches 'desk/old_arm/*' can be connected to this required "
            "interface; to list the possible interfaces: gcm candidates desk/teleoperation/Robot");

  EXPECT_EQ(Gcm({"connect", "--match", "dusk/**", "robot/**"}).exit_code, program::kNotFound);
  EXPECT_EQ(Gcm({"connect", "--match", "desk/**", "robot/**", "--replace"}).exit_code,
            program::kUsage);
}

TEST_F(ConnectionVerbsTest, DisconnectsByConnectionNumber) {
  const json made =
      json::parse(Gcm({"--json", "connect", kTeleoperation, "robot/arm/Control"}).out);
  const std::string number = made["id"].dump();
  EXPECT_THAT(Gcm({"show", kTeleoperation}).out, HasSubstr("number\t" + number + "\n"));

  EXPECT_EQ(Gcm({"disconnect", number, "--dry-run"}).out,
            "desk/teleoperation/Robot -> robot/arm/Control\twould be disconnected\n");
  EXPECT_EQ(Gcm({"disconnect", "desk/" + number}).out, "desk/teleoperation/Robot  disconnected\n");
  EXPECT_EQ(Gcm({"disconnect", number}).err, "gcm: no connection has the number " + number + "\n");
  EXPECT_EQ(Gcm({"disconnect", "robot/" + number}).exit_code, program::kNotFound);
}

TEST_F(ConnectionVerbsTest, ShowPrintsTheHealthOfAConnection) {
  EXPECT_TRUE(EventuallySays({"show", "desk/supervisor/Robot"}, "round trip\t"));
  const std::string shown = Gcm({"show", "desk/supervisor/Robot"}).out;
  EXPECT_THAT(shown, HasSubstr("connected for\t"));
  EXPECT_THAT(shown, HasSubstr("mailbox\t0 of 64 used\n"));
  EXPECT_THAT(shown, HasSubstr("refused\t0\n"));
  EXPECT_THAT(shown, HasSubstr("lost events\t0\n"));
  const json counts = json::parse(Gcm({"--json", "show", "desk/supervisor/Robot"}).out)["counts"];
  EXPECT_GT(counts["age_s"], 0.0);
  EXPECT_GT(counts["round_trip_s"], 0.0);
  EXPECT_EQ(counts["capacity"], 64);

  EXPECT_THAT(Gcm({"show", kTeleoperation}).out, testing::Not(HasSubstr("connected for")));
  EXPECT_THAT(Gcm({"show", "robot/arm"}).out, HasSubstr("mailbox\t0 of 64 used\n"));
}

}  // namespace
