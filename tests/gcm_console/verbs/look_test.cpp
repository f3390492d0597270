#include <gcm_console/feeds/query_throttle.h>
#include <gcm_console/verbs/path_details.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>

#include "gcm_console/demo_fixture.h"
#include "gcm_console/terminal.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

TEST(ExpiryText, HasFourDigitsInMillisecondsBelowASecond) {
  EXPECT_EQ(console::ExpiryText(0.1), "100 ms");
  EXPECT_EQ(console::ExpiryText(0.0004), "0.4 ms");
  EXPECT_EQ(console::ExpiryText(0.0625), "62.5 ms");
  EXPECT_EQ(console::ExpiryText(1.0), "1 s");
  EXPECT_EQ(console::ExpiryText(2.5), "2.5 s");
  EXPECT_EQ(console::ExpiryText(1.23456), "1.235 s");
  EXPECT_EQ(console::ExpiryText(3600.0), "3600 s");
  EXPECT_EQ(console::ExpiryText(0.99996), "1 s");
  EXPECT_EQ(console::ExpiryText(12345.6), "12346 s");
}

using LookTest = DemoFixture;

TEST_F(LookTest, StatusShowsProcessesConnectionsAndProblems) {
  const Outcome well = Gcm({"status"});
  EXPECT_EQ(well.exit_code, program::kOk);
  EXPECT_THAT(well.out, HasSubstr("process\trobot\talive\tcomponents: 2 active\n"));
  EXPECT_THAT(well.out,
              HasSubstr("connection\tdesk/supervisor/Robot\tactive\t-> robot/arm/Control\n"));
  EXPECT_EQ(Gcm({"-q", "status"}).err, "");
  ASSERT_EQ(Gcm({"stop", "desk/teleoperation"}).exit_code, program::kOk);
  EXPECT_EQ(Gcm({"status"}).err, "gcm: 2 processes, 1 connection; all is well\n");
  ASSERT_EQ(Gcm({"suspend", "robot/arm"}).exit_code, program::kOk);
  EXPECT_EQ(Gcm({"status"}).err,
            "gcm: 2 processes, 1 connection; no problem was found, but some connected components "
            "do not run: robot/arm\n");

  robot->Signal(SIGKILL);
  ASSERT_TRUE(EventuallySays({"status"}, "process\trobot\tlost\t"));
  EXPECT_THAT(Gcm({"status"}).err, HasSubstr("with a problem"));
  EXPECT_TRUE(EventuallySays({"status"},
                             "connection\tdesk/supervisor/Robot\tpending\t"
                             "-> robot/arm/Control: the connection of "
                             "desk/supervisor/Robot is pending for "));
}

TEST_F(LookTest, AComponentWithAnUnconnectedInterfaceIsShownAsWaiting) {
  const std::string path = "desk/teleoperation";
  EXPECT_THAT(Gcm({"ls", "desk"}).out,
              HasSubstr("teleoperation\tactive\tTeleoperation\t0.02\twaiting for Robot\n"));
  EXPECT_THAT(Gcm({"ls", "-l", "desk"}).out,
              HasSubstr(path + "\tcomponent\tTeleoperation\tactive\twaiting for Robot: not "
                               "connected\n"));
  EXPECT_THAT(Gcm({"tree"}).out, HasSubstr("  teleoperation  active, waiting for Robot\n"));
  EXPECT_THAT(Gcm({"show", path}).out, HasSubstr("waiting for\tRobot: not connected\n"));
  EXPECT_THAT(Gcm({"top"}).out, testing::ContainsRegex(path + "\tactive\t.*\twaiting for Robot\n"));
  const Outcome status = Gcm({"status"});
  EXPECT_THAT(status.out,
              HasSubstr("component\t" + path + "\tactive\twaiting for Robot: not connected\n"));
  EXPECT_EQ(status.err,
            "gcm: 2 processes, 1 connection; 1 object with a problem: see gcm doctor\n");
  const Outcome doctor = Gcm({"doctor"});
  EXPECT_EQ(doctor.exit_code, program::kRefused);
  EXPECT_THAT(doctor.out, testing::ContainsRegex("BAD  component " + path +
                                                 " +waiting for Robot: not connected\n +fix: gcm "
                                                 "candidates " +
                                                 path + "/Robot\n"));
  const json shown = json::parse(Gcm({"show", path, "--json"}).out);
  EXPECT_EQ(shown["component"]["waiting_for"],
            json::parse(R"([{"required": "Robot", "reason": "not connected"}])"));
}

TEST_F(LookTest, AComponentWithALostPeerIsShownAsWaitingWithAReason) {
  robot->Signal(SIGKILL);
  ASSERT_TRUE(EventuallySays({"ls"}, "robot\tlost"));

  EXPECT_TRUE(EventuallySays({"show", "desk/supervisor"}, "waiting for\tRobot: pending: "));
  EXPECT_THAT(Gcm({"doctor"}).out, HasSubstr("fix: gcm explain desk/supervisor/Robot"));
}

TEST_F(LookTest, NoComponentWaitsWhenAllAreConnected) {
  ASSERT_EQ(Gcm({"connect", "desk/teleoperation/Robot", "robot/arm/Control"}).exit_code,
            program::kOk);

  EXPECT_EQ(Gcm({"status"}).err, "gcm: 2 processes, 2 connections; all is well\n");
  EXPECT_THAT(Gcm({"tree"}).out, testing::Not(HasSubstr("waiting")));
  EXPECT_EQ(Gcm({"doctor"}).exit_code, program::kOk);
}

TEST_F(LookTest, StatusLimitsItsQueriesToOneProcess) {
  const auto is_told = [](const std::string& out) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = out.find(" is pending for ", at)) != out.npos; ++at) ++count;
    return count;
  };
  const std::size_t most = console::QueryThrottle::kMaxOfOne;
  for (std::size_t i = 0; i <= most; ++i) {
    const std::string component = "desk/waiting_" + std::to_string(i);
    ASSERT_EQ(Gcm({"create", "Teleoperation", component}).exit_code, program::kOk);
    (void)Gcm({"connect", component + "/Robot", "nowhere/arm/Control"});
  }

  const auto asks_no_more = [&] {
    const std::string out = Gcm({"status"}).out;
    EXPECT_LE(is_told(out), most) << out;
    EXPECT_THAT(out, HasSubstr("connection\tdesk/waiting_" + std::to_string(most) +
                               "/Robot\tpending\t-> nowhere/arm/Control"));
    return is_told(out) == most;
  };
  EXPECT_TRUE(EventuallyTrue(asks_no_more));
}

TEST_F(LookTest, ColorAlwaysColoursAPipe) {
  EXPECT_THAT(Gcm({"--color", "always", "ls"}).out, HasSubstr("robot\t\x1b[32malive\x1b[0m\t"));
  EXPECT_THAT(Gcm({"ls"}).out, HasSubstr("robot\talive\t"));
}

TEST_F(LookTest, FindsByNamePatternTypeStateAndHost) {
  EXPECT_THAT(Gcm({"find", "joints"}).out, HasSubstr("robot/arm/state.Joints\tcolumn\t"));
  EXPECT_EQ(Gcm({"find", "robot/*/Control.Stop"}).out, "robot/arm/Control.Stop\tcommand\t\t\t\n");
  EXPECT_THAT(Gcm({"find", "type:arm.JointGoal"}).out,
              HasSubstr("robot/arm/Control.MoveTo\tcommand\tarm.JointGoal"));
  EXPECT_THAT(Gcm({"find", "state:alive", "ro"}).out, StartsWith("robot\tprocess\t\talive"));
  EXPECT_THAT(json::parse(Gcm({"find", "host:*", "robot", "--json"}).out)["things"].size(),
              testing::Gt(10U));

  const Outcome none = Gcm({"find", "nothing-like-it"});
  EXPECT_EQ(none.exit_code, program::kNotFound);
  EXPECT_EQ(none.err, "gcm: nothing matches 'nothing-like-it'; to list all names: gcm ls -R\n");
  const Outcome unknown = Gcm({"find", "tipe:x"});
  EXPECT_EQ(unknown.exit_code, program::kUsage);
  EXPECT_THAT(unknown.err, HasSubstr("there is no 'tipe:'; did you mean 'type'?"));
}

TEST_F(LookTest, ListsRecursivelyInDetailAndByKind) {
  const std::string deep = Gcm({"ls", "-R", "robot"}).out;
  EXPECT_THAT(deep, HasSubstr("robot/arm\tcomponent\tSimulatedArm\tactive\t\n"));
  EXPECT_THAT(deep, HasSubstr("robot/arm/Control.MoveTo\tcommand\tarm.JointGoal\t\t\n"));

  const std::string flat = Gcm({"ls", "-l", "robot/arm"}).out;
  EXPECT_THAT(flat, HasSubstr("robot/arm/Control\tprovided interface\t\tconnected\t"
                              "<- desk/supervisor/Robot\n"));
  EXPECT_THAT(flat, testing::Not(HasSubstr("MoveTo")));

  std::istringstream lines(Gcm({"ls", "--type", "req,event"}).out);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    EXPECT_TRUE(line.find("\trequired interface\t") != std::string::npos ||
                line.find("\tevent\t") != std::string::npos)
        << line;
  }
  EXPECT_GT(count, 2);
}

TEST_F(LookTest, GraphPrintsTextDotOrJson) {
  EXPECT_THAT(Gcm({"graph"}).out, HasSubstr("desk/supervisor\n  Robot  -> robot/arm/Control\n"));
  const std::string dot = Gcm({"graph", "--dot"}).out;
  EXPECT_THAT(dot, StartsWith("digraph system {\n"));
  EXPECT_THAT(dot, HasSubstr("\"desk/supervisor\" -> \"robot/arm\" [label=\"Robot -> Control\"]"));
  EXPECT_EQ(json::parse(Gcm({"graph", "--json"}).out)["connections"][0]["state"], "active");
}

TEST_F(LookTest, HzMeasuresTheRateByTheTablesClock) {
  const Outcome measured = Gcm({"--json", "hz", "robot/arm/state", "--count", "2"});

  ASSERT_EQ(measured.exit_code, program::kOk) << measured.err;
  std::istringstream lines(measured.out);
  std::string line;
  ASSERT_TRUE(std::getline(lines, line));
  const json first = json::parse(line);
  EXPECT_EQ(first["schema"], 1);
  EXPECT_GT(first["rows"], 0);
  EXPECT_LE(first["shortest_s"], first["period_s"]);
  EXPECT_GE(first["longest_s"], first["period_s"]);
  ASSERT_TRUE(std::getline(lines, line));
  EXPECT_FALSE(std::getline(lines, line));
}

TEST_F(LookTest, ATerminalGetsTitlesAndColoursUnlessDisabled) {
  const auto shown = [&](const std::string& words, const std::string& end,
                         const std::map<std::string, std::string>& environment = {}) {
    Terminal terminal(
        Binary("gcm") + " --gcm " + address + " --timeout " + kTestTimeout + " " + words,
        environment);
    EXPECT_TRUE(terminal.Shows(end)) << terminal.seen();
    EXPECT_EQ(terminal.program().Wait(), program::kOk);
    return terminal.seen();
  };

  const std::string usual = shown("ls robot", "HostMonitor");
  EXPECT_THAT(usual, HasSubstr("\x1b[1mCOMPONENT\x1b[0m"));
  EXPECT_THAT(usual, HasSubstr("\x1b[32mactive\x1b[0m"));
  EXPECT_THAT(shown("--no-header ls robot", "HostMonitor"), testing::Not(HasSubstr("COMPONENT")));
  for (const std::string& plain : {shown("--color never ls robot", "HostMonitor"),
                                   shown("ls robot", "HostMonitor", {{"NO_COLOR", "1"}}),
                                   shown("ls robot", "HostMonitor", {{"TERM", "dumb"}})}) {
    EXPECT_THAT(plain, testing::Not(HasSubstr("\x1b[")));
  }
}

TEST_F(LookTest, ShowPrintsTheArgumentAndAnExampleCall) {
  const Outcome shown = Gcm({"show", "robot/arm/Control.MoveTo"});

  EXPECT_EQ(shown.exit_code, program::kOk) << shown.err;
  EXPECT_THAT(shown.out, HasSubstr("\nargument\nposition\tfloat64[7]\trad\t"));
  const auto begin = shown.out.find("\ngcm call robot/arm/Control.MoveTo '");
  ASSERT_NE(begin, std::string::npos) << shown.out;
  const auto quote = shown.out.find('\'', begin);
  const std::string argument = shown.out.substr(quote + 1, shown.out.rfind('\'') - quote - 1);
  EXPECT_THAT(
      shown.out,
      HasSubstr("\ngcm get robot/arm/Control.GetJoints  # the current values of: position\n"));
  const Outcome called = Gcm({"call", "robot/arm/Control.MoveTo", argument});
  EXPECT_EQ(called.exit_code, program::kOk) << called.err << argument;
}

TEST_F(LookTest, ShowPrintsTheTimingOfATask) {
  std::string shown;
  ASSERT_TRUE(EventuallyTrue([&] {
    shown = Gcm({"show", "robot/arm"}).out;
    return shown.find("\nrate\t") != shown.npos;
  })) << shown;

  EXPECT_THAT(shown,
              testing::ContainsRegex("\nrate\t[0-9.]+ Hz\nlate\t[0-9]+ us, at most [0-9]+ us\n"
                                     "compute\t[0-9.]+ us\nload\t[0-9.]+ %\nskipped\t[0-9]+\n"));
  EXPECT_THAT(Gcm({"show", "robot"}).out, testing::Not(HasSubstr("rate\t")));
}

TEST_F(LookTest, VerboseNamesTheGcmItAsks) {
  EXPECT_THAT(Gcm({"-v", "ls"}).err, StartsWith("gcm: GCM at " + address + " answered within "));
}

TEST_F(LookTest, ExplainsCommonMistakes) {
  EXPECT_EQ(Gcm({"connect", "robot/arm/Control", "desk/teleoperation/Robot"}).err,
            "gcm: robot/arm/Control is a provided interface, but the required interface comes "
            "first; in the right order: gcm connect desk/teleoperation/Robot robot/arm/Control\n");
  EXPECT_EQ(Gcm({"explain", "robot/arm/Control", "desk/teleoperation/Robot"}).err,
            "gcm: robot/arm/Control is a provided interface, but the required interface comes "
            "first; in the right order: gcm explain desk/teleoperation/Robot robot/arm/Control\n");
  EXPECT_THAT(Gcm({"watch", "robot/arm/state"}).err,
              StartsWith("gcm: 'robot/arm/state' is a whole table: give one of its columns ("));
  const Outcome head = Shell("watch robot/arm/state.Joints.position[0] | head -1");
  EXPECT_EQ(head.exit_code, 0);
  EXPECT_EQ(head.err, "");
}

}  // namespace
