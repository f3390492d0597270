#include <gcm_console/console.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>
#include <tendon/base/os/process.h>
#include <tendon/base/text.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <thread>

#include "gcm_console/demo_fixture.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

using ConsoleTest = DemoFixture;

TEST_F(ConsoleTest, ListsAndShowsTheSystem) {
  EXPECT_TRUE(EventuallySays({"ls"}, "robot\talive"));
  EXPECT_THAT(Gcm({"ls", "robot/arm"}).out,
              HasSubstr("Control\tprovided\t7\t<- desk/supervisor/Robot"));
  EXPECT_THAT(Gcm({"ls", "robot/arm/Control"}).out,
              HasSubstr("MoveTo\twrite command\tarm.JointGoal"));
  EXPECT_THAT(Gcm({"tree"}).out, HasSubstr("Robot  required  not connected"));
  EXPECT_THAT(Gcm({"show", "robot/arm"}).out, HasSubstr("class\tSimulatedArm"));
  EXPECT_EQ(Gcm({"ls", "robot/arm/Control.MoveTo"}).out, "MoveTo\twrite command\tarm.JointGoal\n");

  const json document = json::parse(Gcm({"ls", "--json"}).out);
  EXPECT_EQ(document["schema"], 1);
  EXPECT_EQ(document["processes"].size(), 2U);
}

TEST_F(ConsoleTest, ConnectsMovesTheArmAndDisconnects) {
  const Outcome connected = Gcm({"connect", "desk/teleoperation/Robot", "robot/arm/Control"});
  EXPECT_EQ(connected.exit_code, program::kOk) << connected.err;
  EXPECT_THAT(connected.out, HasSubstr("desk/teleoperation/Robot -> robot/arm/Control  "));
  EXPECT_TRUE(EventuallySays({"ls", "desk/teleoperation"}, "-> robot/arm/Control\n"));

  EXPECT_TRUE(EventuallyTrue([&] {
    const Outcome got = Gcm({"get", "robot/arm/state.Joints.velocity[0]"});
    EXPECT_EQ(got.exit_code, program::kOk) << got.err;
    return std::abs(std::strtod(got.out.c_str(), nullptr)) > 0.01;
  }));

  const Outcome disconnected = Gcm({"disconnect", "desk/teleoperation/Robot"});
  EXPECT_EQ(disconnected.exit_code, program::kOk) << disconnected.err;
  EXPECT_THAT(Gcm({"tree"}).out, HasSubstr("Robot  required  not connected"));
}

TEST_F(ConsoleTest, UndoRevertsAConnect) {
  ASSERT_EQ(Gcm({"connect", "desk/teleoperation/Robot", "robot/arm/Control"}).exit_code, 0);

  const Outcome undone = Gcm({"undo"});

  EXPECT_EQ(undone.exit_code, program::kOk) << undone.err;
  EXPECT_THAT(Gcm({"tree"}).out, HasSubstr("Robot  required  not connected"));
}

/// The demo system with a second arm: spare/arm/Control.
class ReplaceTest : public ConsoleTest {
 protected:
  void SetUp() override {
    ConsoleTest::SetUp();
    const std::string file = (home.path() / "spare.json").string();
    std::ofstream(file) << R"({"version": 1, "name": "spare", "processes": [{"name": "spare",
        "components": [{"name": "arm", "class": "SimulatedArm", "library": "simulated_arm"}]}]})";
    spare = StartLcm("spare", file);
    ASSERT_TRUE(EventuallySays({"ls", "spare"}, "arm\tactive")) << spare->err();
    ASSERT_EQ(Gcm({"connect", teleoperation, "spare/arm/Control"}).exit_code, program::kOk);
  }
  const std::string teleoperation = "desk/teleoperation/Robot";
  std::unique_ptr<Program> spare;
};

TEST_F(ReplaceTest, OneUndoRevertsAReplace) {
  const Outcome replaced = Gcm({"connect", teleoperation, "robot/arm/Control", "--replace"});
  EXPECT_EQ(replaced.exit_code, program::kOk) << replaced.err;
  EXPECT_TRUE(EventuallySays({"ls", "desk/teleoperation"}, "-> robot/arm/Control\n"));

  const Outcome undone = Gcm({"undo"});

  EXPECT_EQ(undone.out,
            "undone: replace desk/teleoperation/Robot robot/arm/Control; it is "
            "connected to spare/arm/Control\n")
      << undone.err;
  EXPECT_TRUE(EventuallySays({"ls", "desk/teleoperation"}, "-> spare/arm/Control\n"));
}

TEST_F(ReplaceTest, AMistypedProcessReplacesNothing) {
  const Outcome replaced = Gcm({"connect", teleoperation, "robbot/arm/Control", "--replace"});

  EXPECT_EQ(replaced.exit_code, program::kNotFound) << replaced.out;
  EXPECT_THAT(replaced.err, HasSubstr("desk/teleoperation/Robot stays connected to "
                                      "spare/arm/Control"));
  EXPECT_THAT(replaced.err, HasSubstr("no process 'robbot'; did you mean 'robot'?"));
  EXPECT_THAT(Gcm({"ls", "desk/teleoperation"}).out, HasSubstr("-> spare/arm/Control\n"));
}

TEST_F(ReplaceTest, UndoKeepsTheNewConnectionIfTheOldServerIsLost) {
  ASSERT_EQ(Gcm({"connect", teleoperation, "robot/arm/Control", "--replace"}).exit_code,
            program::kOk);
  spare->Signal(SIGKILL);
  ASSERT_TRUE(EventuallySays({"ls"}, "spare\tlost"));

  const Outcome undone = Gcm({"undo"});

  EXPECT_EQ(undone.exit_code, program::kRefused) << undone.out;
  EXPECT_THAT(undone.err, HasSubstr("start it again first"));
  EXPECT_THAT(Gcm({"ls", "desk/teleoperation"}).out, HasSubstr("-> robot/arm/Control\n"));
}

TEST_F(ConsoleTest, AConnectToALostProcessIsPending) {
  robot->Signal(SIGKILL);
  ASSERT_TRUE(EventuallySays({"ls"}, "robot\tlost"));

  const Outcome connected = Gcm({"connect", "desk/teleoperation/Robot", "robot/arm/Control"});

  EXPECT_EQ(connected.exit_code, program::kRefused);
  EXPECT_EQ(connected.err, "");
  EXPECT_THAT(connected.out,
              testing::StartsWith("desk/teleoperation/Robot -> robot/arm/Control  pending: "));
}

TEST_F(ConsoleTest, AConnectToAnUnknownProcessIsPendingWithAWarning) {
  const std::string why =
      "gcm: no process 'robbot'; did you mean 'robot'? the connection waits for this process; to "
      "cancel the connection: gcm disconnect desk/teleoperation/Robot\n";

  const Outcome connected = Gcm({"connect", "desk/teleoperation/Robot", "robbot/arm/Control"});

  EXPECT_EQ(connected.exit_code, program::kNotFound);
  EXPECT_EQ(connected.out, "desk/teleoperation/Robot -> robbot/arm/Control  pending\n");
  EXPECT_EQ(connected.err, why);
  const Outcome explained = Gcm({"explain", "desk/teleoperation/Robot"});
  EXPECT_EQ(explained.exit_code, program::kNotFound) << explained.out;
  EXPECT_THAT(explained.out, HasSubstr("  1 BAD no process 'robbot'; did you mean 'robot'?\n"));
}

TEST_F(ConsoleTest, ReportsTheDifferenceBetweenTwoTypesOfOneName) {
  const Program::Words ends = {"desk/teleoperation/Robot", "desk/old_arm/Control"};
  const std::string difference = " needed, ";

  // gcm waits only briefly for the types. On a machine that stalls, the types may arrive too late,
  // so the test repeats the command.
  EXPECT_TRUE(EventuallySays({"candidates", ends[0]}, difference));
  EXPECT_TRUE(EventuallySays({"explain", ends[0], ends[1]}, difference));
  EXPECT_TRUE(EventuallyTrue([&] {
    return Gcm({"connect", ends[0], ends[1]}).err.find(difference) != std::string::npos;
  }));
}

TEST_F(ConsoleTest, CallsCommandsOfEveryKind) {
  const Outcome stop = Gcm({"call", "robot/arm/Control.Stop"});
  EXPECT_EQ(stop.exit_code, program::kOk) << stop.err;

  const Outcome move =
      Gcm({"call", "robot/arm/Control.MoveTo", R"({"position":[0.1,0,0,0,0,0,0],"duration":0.5})"});
  EXPECT_EQ(move.exit_code, program::kOk) << move.err;

  const Outcome joints = Gcm({"call", "robot/arm/Control.GetJoints"});
  ASSERT_EQ(joints.exit_code, program::kOk) << joints.err;
  EXPECT_EQ(json::parse(joints.out)["position"].size(), 7U);

  const json document = json::parse(Gcm({"call", "robot/arm/Control.GetJoints", "--json"}).out);
  EXPECT_EQ(document["schema"], 1);
  EXPECT_EQ(document["path"], "robot/arm/Control.GetJoints");
  EXPECT_EQ(document["value"]["position"].size(), 7U);
}

TEST_F(ConsoleTest, WatchPrintsEveryRowInOrder) {
  const Outcome watched = Gcm({"watch", "robot/arm/state.Joints.position[0]", "--count", "500"});

  ASSERT_EQ(watched.exit_code, program::kOk) << watched.err;
  std::uint64_t lost = 0;
  // Gaps are reported before the summary.
  const std::size_t summary = watched.err.find("gcm: 500 rows, ");
  ASSERT_NE(summary, watched.err.npos) << watched.err;
  ASSERT_EQ(std::sscanf(watched.err.c_str() + summary, "gcm: 500 rows, %lu lost", &lost), 1)
      << watched.err;
  std::istringstream lines(watched.out);
  std::int64_t time = 0;
  std::uint64_t tick = 0;
  double value = 0.0;
  std::uint64_t last = 0;
  std::uint64_t missing = 0;
  int rows = 0;
  while (lines >> time >> tick >> value) {
    ASSERT_TRUE(rows == 0 || tick > last) << tick << " after " << last;
    missing += rows == 0 ? 0 : tick - last - 1;
    ++rows;
    last = tick;
  }
  EXPECT_EQ(rows, 500);
  // Rows may be lost on a machine that stalls, but every loss must be reported.
  EXPECT_LE(missing, lost);
}

TEST_F(ConsoleTest, WatchAtARatePrintsOneRowOfEachPeriod) {
  for (const Program::Words& more : {Program::Words{}, {"--latest"}}) {
    Program::Words words = {"watch", "robot/arm/state.Joints.position[0]", "--hz", "20", "--count",
                            "5"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome watched = Gcm(words);

    ASSERT_EQ(watched.exit_code, program::kOk) << watched.err;
    EXPECT_THAT(watched.err, HasSubstr("gcm: 5 rows, "));
    std::istringstream lines(watched.out);
    std::int64_t time = 0;
    std::string rest;
    std::int64_t last = 0;
    int rows = 0;
    for (; std::getline(lines >> time, rest); last = time) {
      EXPECT_GT(time / 50'000'000, last / 50'000'000) << watched.out;
      ++rows;
    }
    EXPECT_EQ(rows, 5) << watched.out;
  }
}

TEST_F(ConsoleTest, WatchWritesItsSummaryToTheGivenStream) {
  const Outcome folder = RunProgram({"/bin/sh", "-c", "printf %s \"$XDG_RUNTIME_DIR\""});
  // The programs keep their cookie in this folder.
  setenv("XDG_RUNTIME_DIR", folder.out.c_str(), 1);
  std::ostringstream out;
  std::ostringstream err;
  int exit_code = -1;
  std::thread([&] {  // signals are held only in this thread
    exit_code = console::RunCommandLine({"--gcm", address, "--timeout", kTestTimeout, "watch",
                                         "robot/arm/state.Joints.position[0]", "--count", "3"},
                                        out, err, 0);
  })
      .join();

  EXPECT_EQ(exit_code, program::kOk);
  EXPECT_THAT(err.str(), HasSubstr("gcm: 3 rows, "));
}

TEST_F(ConsoleTest, WatchPrintsArraysAndWholeColumns) {
  const Outcome array = Gcm({"watch", "robot/arm/state.Joints.position", "--count", "1"});
  EXPECT_EQ(array.exit_code, program::kOk) << array.err;
  EXPECT_THAT(array.err, HasSubstr("gcm: 1 row, "));
  EXPECT_EQ(json::parse(array.out.substr(array.out.rfind('\t'))).size(), 7U) << array.out;

  const Outcome whole = Gcm({"watch", "robot/arm/state.Refused", "--count", "1", "--for", "1min"});
  EXPECT_EQ(whole.exit_code, program::kOk) << whole.err;
  EXPECT_THAT(whole.err, HasSubstr("gcm: 1 row, "));
  EXPECT_THAT(whole.out, testing::EndsWith("\t0\n"));

  const Outcome none = Gcm({"watch", "robot/arm/state.Joints.positio"});
  EXPECT_EQ(none.exit_code, program::kNotFound);
  EXPECT_EQ(none.err,
            "gcm: robot/arm/state.Joints.positio: there is no field 'positio'; did you mean "
            "'position'?\n");
  EXPECT_EQ(none.out, "");
}

/// Returns the complete lines that the program has printed so far.
std::istringstream LinesOf(const Program& program) {
  const std::string out = program.out();
  return std::istringstream(out.substr(0, out.rfind('\n') + 1));
}

TEST_F(ConsoleTest, WatchPrintsAllMatchingColumnsOfSeveralTables) {
  const std::string arm = "robot/arm/state.Joints.position[0]";
  const std::string flange = "desk/supervisor/state.Flange";
  Program watch({Binary("gcm"), "--gcm", address, "watch", "robot/*/state.Joints.position[0]", arm,
                 "**/state.Flange"});
  std::set<std::size_t> seen;  // the indexes of the columns that have had a value
  ASSERT_TRUE(EventuallyTrue([&] {
    std::istringstream lines = LinesOf(watch);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream cells(line);
      std::vector<std::string> row;
      for (std::string cell; std::getline(cells, cell, '\t');) row.push_back(cell);
      EXPECT_EQ(row.size(), 4U) << line;
      EXPECT_EQ(std::count(row.begin(), row.end(), "-"), 1) << line;
      seen.insert(row.back() == "-" ? 0 : 1);
    }
    return seen.size() == 2;
  })) << watch.out()
      << watch.err();

  Program lines({Binary("gcm"), "--gcm", address, "--jsonl", "watch", arm, flange});
  std::set<std::string> paths;
  EXPECT_TRUE(EventuallyTrue([&] {
    std::istringstream all = LinesOf(lines);
    for (std::string line; std::getline(all, line);) {
      const json row = json::parse(line);
      EXPECT_EQ(row["values"].size(), 1U) << line;
      paths.insert(row["values"].begin().key());
    }
    return paths == std::set<std::string>{arm, flange};
  })) << lines.out()
      << lines.err();
}

TEST_F(ConsoleTest, WatchSkipsMatchingColumnsWithoutTheField) {
  const Outcome some = Gcm({"--jsonl", "watch", "robot/*/state.*.position[0]", "--count", "2"});
  EXPECT_EQ(some.exit_code, program::kOk) << some.err;
  EXPECT_THAT(some.err, HasSubstr("gcm: robot/arm/state.Refused.position[0]: there is no field "
                                  "'position'\n"));
  std::istringstream lines(some.out);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_TRUE(json::parse(line)["values"].contains("robot/arm/state.Joints.position[0]")) << line;
  }

  const Outcome none = Gcm({"watch", "robot/arm/state.*.positio"});
  EXPECT_EQ(none.exit_code, program::kNotFound);
  EXPECT_THAT(none.err, HasSubstr("gcm: robot/arm/state.Joints.positio: there is no field"));
  EXPECT_THAT(none.err,
              testing::EndsWith("gcm: no matching column has this part; to list the parts of a "
                                "column: gcm show COLUMN\n"));
}

TEST_F(ConsoleTest, WatchRejectsAGlobForFields) {
  const Outcome refused = Gcm({"watch", "robot/arm/state.Joints.*"});

  EXPECT_EQ(refused.exit_code, program::kUsage);
  EXPECT_EQ(refused.err,
            "gcm: 'robot/arm/state.Joints.*': * can stand for columns, but not for parts of a "
            "column; write the part without *, or use the whole column: robot/arm/state.Joints\n");
}

TEST_F(ConsoleTest, WatchReportsAGlobWithoutMatches) {
  const Outcome none = Gcm({"watch", "robot/*/state.Jonts"});

  EXPECT_EQ(none.exit_code, program::kNotFound);
  EXPECT_EQ(none.err,
            "gcm: no column matches 'robot/*/state.Jonts'; to list the columns: gcm ls -R --type "
            "state\n");
}

TEST_F(ConsoleTest, CandidatesListsCompatibleAndNearlyCompatibleInterfaces) {
  const Outcome listed = Gcm({"candidates", "desk/teleoperation/Robot"});
  EXPECT_EQ(listed.exit_code, program::kOk) << listed.err;
  EXPECT_THAT(listed.out, testing::StartsWith("robot/arm/Control\tyes\t"));
  EXPECT_THAT(listed.out, HasSubstr("\ndesk/old_arm/Control\tno\t"));
  EXPECT_THAT(Gcm({"candidates", "desk/supervisor/Robot"}).out,
              testing::StartsWith("robot/arm/Control\tconnected\t"));

  const json document = json::parse(Gcm({"candidates", "desk/supervisor/Robot", "--json"}).out);
  EXPECT_EQ(document["schema"], 1);
  EXPECT_EQ(document["candidates"][0]["provided"], "robot/arm/Control");
  EXPECT_EQ(document["candidates"][0]["fits"], true);
}

TEST_F(ConsoleTest, ExplainChecksSevenSteps) {
  const Outcome good = Gcm({"explain", "desk/supervisor/Robot"});
  EXPECT_EQ(good.exit_code, program::kOk) << good.out;
  EXPECT_THAT(good.out, testing::StartsWith("desk/supervisor/Robot -> robot/arm/Control\n"));
  EXPECT_THAT(good.out, HasSubstr("\n  7 ok  process 'robot' answers within "));

  const Outcome possible = Gcm({"explain", "desk/teleoperation/Robot"});
  EXPECT_EQ(possible.exit_code, program::kOk) << possible.out;
  EXPECT_THAT(possible.out,
              HasSubstr("next: gcm connect desk/teleoperation/Robot robot/arm/Control\n"));

  const Outcome bad = Gcm({"explain", "desk/teleoperation/Robot", "desk/old_arm/Control"});
  EXPECT_EQ(bad.exit_code, program::kIncompatible) << bad.out;
  EXPECT_THAT(bad.out, HasSubstr("\n  4 BAD signatures match: "));
  EXPECT_THAT(bad.out, HasSubstr("\n  5 -   "));
  EXPECT_THAT(bad.out, HasSubstr("\n  left over: nothing in desk\n"));
  EXPECT_THAT(possible.out, HasSubstr("  left over: nothing in robot\n"));
  EXPECT_THAT(good.out, testing::Not(HasSubstr("left over")));

  const json document = json::parse(Gcm({"explain", "desk/supervisor/Robot", "--json"}).out);
  EXPECT_EQ(document["steps"].size(), 7U);
  EXPECT_EQ(document["connected"], true);
  EXPECT_EQ(Gcm({"explain", "desk/supervisor/Robt"}).exit_code, program::kNotFound);
}

TEST_F(ConsoleTest, AnInterruptedWatchPrintsItsSummary) {
  Program watch({Binary("gcm"), "--gcm", address, "watch", "robot/arm/state.Joints"});
  ASSERT_TRUE(EventuallyTrue([&] { return !watch.out().empty(); })) << watch.err();

  watch.Signal(SIGINT);

  EXPECT_EQ(watch.Wait(), program::kInterrupted);
  const std::string out = watch.out();
  const auto rows = static_cast<std::uint64_t>(std::count(out.begin(), out.end(), '\n'));
  EXPECT_THAT(watch.err(), HasSubstr("gcm: " + tendon::Counted(rows, "row", "rows") + ", "));
}

TEST_F(ConsoleTest, RefusalsHaveAMessageAndAnExitCode) {
  struct Case {
    Program::Words words;
    int exit_code;
    std::string sentence;
  };
  const std::vector<Case> cases = {
      {{"ls", "robt"}, program::kNotFound, "no process 'robt'; did you mean 'robot'?"},
      {{"connect", "desk/teleop/Robot", "robot/arm/Control"},
       program::kNotFound,
       "no component 'desk/teleop'; did you mean 'teleoperation'?"},
      {{"connect", "desk/teleoperation/Robot", "robot/arn/Control"},
       program::kNotFound,
       "did you mean 'arm'?"},
      {{"connect", "desk/teleoperation", "robot/arm/Control"},
       program::kUsage,
       "expected process/component/interface"},
      {{"connect", "desk/teleoperation/Robot", "desk/old_arm/Control"},
       program::kIncompatible,
       "does not fit"},
      {{"disconnect", "desk/teleoperation/Robot"}, program::kRefused, "not connected"},
      {{"call", "robot/arm/Control.MoveTo", R"({"position":[0.1,0,0,0,0,0,"x"],"duration":1})"},
       program::kUsage,
       "position[6]"},
      {{"call", "robot/arm/Control.Mov"}, program::kNotFound, "no command 'robot/arm/Control.Mov'"},
      {{"get", "robot/arm/state.Jonts"}, program::kNotFound, "did you mean 'Joints'?"},
      {{"get", "robot/arm/Control.Stop"}, program::kUsage, "use gcm call"},
      {{"ls", "robot/arm/Control.Mov"}, program::kNotFound, "no member 'robot/arm/Control.Mov'"},
      {{"ls", "robot/arm/state.Joints.position"}, program::kUsage, "gcm get"},
      {{"watch", "robot/arm/Control.GetJoints"}, program::kNotFound, "is not a column"},
  };
  for (const Case& one : cases) {
    const Outcome outcome = Gcm(one.words);
    EXPECT_EQ(outcome.exit_code, one.exit_code) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(one.sentence));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_THAT(Gcm({"tree"}).out, HasSubstr("Robot  required  not connected"));
}

TEST_F(ConsoleTest, AReadOnlyConsoleShowsAllAndChangesNothing) {
  EXPECT_THAT(Gcm({"--read-only", "ls"}).out, HasSubstr("robot\talive"));
  EXPECT_EQ(Gcm({"--read-only", "watch", "robot/arm/state.Joints", "--count", "1"}).exit_code,
            program::kOk);

  for (const Program::Words& words :
       {Program::Words{"--read-only", "connect", "desk/teleoperation/Robot", "robot/arm/Control"},
        {"--read-only", "disconnect", "desk/supervisor/Robot"},
        {"--read-only", "call", "robot/arm/Control.Stop"},
        {"--read-only", "undo"}}) {
    const Outcome outcome = Gcm(words);
    EXPECT_EQ(outcome.exit_code, program::kDenied) << words[1];
    EXPECT_THAT(outcome.err,
                HasSubstr("needs the role operator, but 'gcm " + words[1] + " of " +
                          tendon::os::UserAtHost() + "' is a viewer here: try again as operator"));
  }

  const auto says = [](const Program& program, const std::string& line) {
    return EventuallyTrue([&] { return program.err().find(line) != std::string::npos; });
  };
  EXPECT_TRUE(says(*robot, "call a command arm/Control.Stop: refused")) << robot->err();
  EXPECT_TRUE(says(*gcm, "): undo: refused")) << gcm->err();
}

TEST_F(ConsoleTest, AKilledProcessIsLostUntilItRestarts) {
  robot->Signal(SIGKILL);
  ASSERT_TRUE(EventuallySays({"ls"}, "robot\tlost"));

  robot = StartLcm("robot", demo);

  ASSERT_TRUE(EventuallySays({"ls"}, "robot\talive"));
}

}  // namespace
