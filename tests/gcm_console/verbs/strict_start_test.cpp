#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>

#include <string>

#include "gcm_console/system_fixture.h"

namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A system with a component that needs a provider that does not exist yet.
class StrictStartTest : public SystemFixture {
 protected:
  void SetUp() override { StartGcm(); }

  /// Starts empty processes, to which system files are applied.
  void StartEmpty() {
    for (auto* process : {&robot, &desk}) {
      const std::string name = process == &robot ? "robot" : "desk";
      *process = std::make_unique<Program>(Program::Words{Binary("lcm"), "--name", name, "--gcm",
                                                          address, "--timeout", kTestTimeout});
      ASSERT_TRUE(EventuallySays({"ls"}, name + "\talive")) << (*process)->err();
    }
  }
  /// Returns a file with an arm and a client of the arm. `more` is additional text for the file.
  [[nodiscard]] std::string File(const std::string& more,
                                 const std::string& state = "active") const {
    home.Write("system.json", R"({"version": 1, "name": "lab", )" + more + R"("processes": [
        {"name": "robot", "components": [
            {"name": "arm", "class": "SimulatedArm", "library": "simulated_arm"}]},
        {"name": "desk", "components": [
            {"name": "teleoperation", "class": "Teleoperation", "library": "teleoperation",
             "state": ")" + state +
                                  R"("}]}]})");
    return (home.path() / "system.json").string();
  }
  static std::string Connections() {
    return R"("connections": [{"required": "desk/teleoperation/Robot",
                               "provided": "robot/arm/Control"}], )";
  }

  std::unique_ptr<Program> robot;
  std::unique_ptr<Program> desk;
};

TEST_F(StrictStartTest, StrictStartNamesTheUnconnectedInterface) {
  StartEmpty();
  ASSERT_EQ(Gcm({"apply", File("", "constructed")}).exit_code, program::kOk);
  const std::string reason =
      "gcm: desk/teleoperation: component 'teleoperation' is not started, because it would wait "
      "for Robot: not connected; make these connections first\n";

  for (const Program::Words& words : {Program::Words{"start", "desk/teleoperation", "--strict"},
                                      {"start", "desk/teleoperation", "--strict", "--dry-run"}}) {
    const Outcome refused = Gcm(words);
    EXPECT_EQ(refused.exit_code, program::kRefused);
    EXPECT_EQ(refused.err, reason);
  }
  EXPECT_THAT(Gcm({"ls", "desk"}).out, HasSubstr("teleoperation\tconstructed\t"));

  EXPECT_EQ(Gcm({"start", "desk/teleoperation"}).exit_code, program::kOk)
      << "connecting is a click";
  ASSERT_EQ(Gcm({"stop", "desk/teleoperation"}).exit_code, program::kOk);
  ASSERT_EQ(Gcm({"connect", "desk/teleoperation/Robot", "robot/arm/Control"}).exit_code,
            program::kOk);
  EXPECT_EQ(Gcm({"start", "**", "--strict"}).exit_code, program::kOk);
}

TEST_F(StrictStartTest, APlanOfAStrictFileRefusesBeforeAnyChange) {
  StartEmpty();
  ASSERT_EQ(Gcm({"apply", File("", "constructed")}).exit_code, program::kOk);
  ASSERT_EQ(Gcm({"stop", "robot/arm"}).exit_code, program::kOk);

  for (const char* verb : {"plan", "apply"}) {
    const Outcome refused = Gcm({verb, File(R"("strict": true, )")});
    EXPECT_EQ(refused.exit_code, program::kRefused) << verb;
    EXPECT_THAT(refused.err, HasSubstr("gcm: desk/teleoperation is not started, because it lacks a "
                                       "connection for Robot, and the file is strict"));
    EXPECT_THAT(refused.out, AllOf(HasSubstr("start robot/arm"), Not(HasSubstr("desk"))));
  }
  EXPECT_THAT(Gcm({"ls", "robot"}).out, Not(HasSubstr("arm\tactive"))) << "nothing was done";

  const Outcome applied = Gcm({"apply", File(R"("strict": true, )" + Connections())});
  EXPECT_EQ(applied.exit_code, program::kOk) << applied.out << applied.err;
  EXPECT_THAT(Gcm({"ls", "desk"}).out, HasSubstr("teleoperation\tactive\t"));
}

TEST_F(StrictStartTest, AProcessRefusesAStrictStartThatThePlanAllowed) {
  StartEmpty();

  const Outcome applied = Gcm({"apply", File(R"("strict": true, )")});

  EXPECT_EQ(applied.exit_code, program::kPartial);
  EXPECT_THAT(applied.out,
              HasSubstr("BAD  start desk/teleoperation: component 'teleoperation' is "
                        "not started, because it would wait for Robot: not connected"));
  EXPECT_THAT(Gcm({"ls", "desk"}).out, HasSubstr("teleoperation\tconstructed\t"));
}

TEST_F(StrictStartTest, AnLcmObeysItsStrictFile) {
  const std::string file = File(R"("strict": true, )");
  desk = StartLcm("desk", file);
  ASSERT_TRUE(EventuallyTrue([this] {
    return desk->err().find(
               "component 'teleoperation' is not started, because it would wait for Robot: not "
               "connected; make these connections first") != std::string::npos;
  })) << desk->err();
  EXPECT_TRUE(EventuallySays({"ls", "desk"}, "teleoperation\tconstructed\t"));
}

TEST_F(StrictStartTest, AnLcmWaitsForAPeerThatItsStrictFileConnects) {
  const std::string file = File(R"("strict": true, )" + Connections());
  desk = StartLcm("desk", file);
  ASSERT_TRUE(EventuallySays({"show", "desk/teleoperation/Robot"}, "pending")) << desk->err();
  EXPECT_THAT(Gcm({"ls", "desk"}).out, HasSubstr("teleoperation\tconstructed\t"));

  robot = StartLcm("robot", file);

  EXPECT_TRUE(EventuallySays({"ls", "desk"}, "teleoperation\tactive\t")) << desk->err();
}

TEST_F(StrictStartTest, ASavedFileStaysStrict) {
  const std::string file = File(R"("strict": true, )" + Connections());
  robot = StartLcm("robot", file);
  desk = StartLcm("desk", file);
  ASSERT_TRUE(EventuallySays({"ls", "desk"}, "teleoperation\tactive\t")) << desk->err();

  ASSERT_EQ(Gcm({"save", file}).exit_code, program::kOk);

  EXPECT_THAT(home.Read("system.json"), HasSubstr("\"strict\": true"));
}

TEST_F(StrictStartTest, ReportsABadStrictFlagWithItsPlace) {
  const Outcome refused = Gcm({"plan", File(R"("strict": "yes", )")});

  EXPECT_EQ(refused.exit_code, program::kUsage);
  EXPECT_THAT(refused.err, HasSubstr("strict: expected true or false, got string 'yes'"));
}

}  // namespace
