#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>
#include <tendon/base/os/process.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "gcm_console/demo_fixture.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

/// Saves, changes and restores the demo system.
class SavedSystemTest : public DemoFixture {
 protected:
  [[nodiscard]] std::string InHome(const std::string& name) const {
    return (home.path() / name).string();
  }
  /// Saves the running system, and returns the file name.
  std::string Saved() const {
    const std::string file = InHome("saved.json");
    const Outcome outcome = Gcm({"save", file});
    EXPECT_EQ(outcome.exit_code, program::kOk) << outcome.err;
    return file;
  }

  /// Expects that the verb succeeds and prints no result.
  void ExpectSaysNothing(const Program::Words& words) const {
    const Outcome outcome = Gcm(words);
    EXPECT_EQ(outcome.exit_code, program::kOk) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
  /// Returns a hash of the catalogue that does not depend on data that changes at each start.
  [[nodiscard]] std::string ContentHash() const {
    return json::parse(Gcm({"status", "--json"}).out)["content_hash"];
  }
  [[nodiscard]] std::unique_ptr<Program> StartEmpty(const std::string& name) const {
    return std::make_unique<Program>(
        Program::Words{Binary("lcm"), "--name", name, "--gcm", address, "--timeout", kTestTimeout});
  }
};

TEST_F(SavedSystemTest, DiffFindsNoDifferenceAfterASave) {
  const Outcome saved = Gcm({"save", InHome("saved.json")});

  EXPECT_EQ(saved.exit_code, program::kOk) << saved.err;
  EXPECT_EQ(saved.out, InHome("saved.json") + "  2 processes, 5 components, 1 connection\n");
  const Outcome same = Gcm({"diff", InHome("saved.json")});
  EXPECT_EQ(same.exit_code, program::kOk) << same.out << same.err;
  EXPECT_EQ(same.out + same.err, "");
  // Equal except for the periods, which the demo file does not contain.
  ExpectSaysNothing({"diff", InHome("saved.json"), demo});
  const json file = json::parse(home.Read("saved.json"));
  EXPECT_EQ(file["name"], "saved");
  EXPECT_EQ(file["processes"][1]["components"][0]["class"], "SimulatedArm");
}

TEST_F(SavedSystemTest, ASaveKeepsExtraFieldsAndOverwritesNoOtherFile) {
  home.Write("lab.json", R"({"version": 1, "name": "lab", "comment": "of the lab", "processes": [
      {"name": "robot", "components": [{"name": "arm", "class": null}]}],
      "layout": {"robot/arm": [1, 2]}})");
  home.Write("notes.txt", "buy milk");

  EXPECT_EQ(Gcm({"save", InHome("lab.json")}).exit_code, program::kOk);
  const Outcome refused = Gcm({"save", InHome("notes.txt")});

  const json file = json::parse(home.Read("lab.json"));
  EXPECT_EQ(file["name"], "lab");
  EXPECT_EQ(file["comment"], "of the lab");
  EXPECT_EQ(file["layout"]["robot/arm"], json({1.0, 2.0}));
  EXPECT_EQ(file["processes"].size(), 2U);
  EXPECT_EQ(refused.exit_code, program::kUsage);
  EXPECT_THAT(refused.err, HasSubstr("nothing is saved: give another file, or remove this"));
  EXPECT_EQ(home.Read("notes.txt"), "buy milk");
}

TEST_F(SavedSystemTest, ASaveKeepsLostProcessesWithAWarning) {
  const std::string file = Saved();
  std::filesystem::permissions(
      file, std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  std::filesystem::create_symlink(file, InHome("link.json"));
  const json before = json::parse(home.Read("saved.json"));
  robot->Signal(SIGKILL);
  ASSERT_TRUE(EventuallySays({"ls"}, "robot\tlost"));

  const Outcome saved = Gcm({"save", InHome("link.json")});

  EXPECT_EQ(saved.exit_code, program::kOk) << saved.err;
  EXPECT_EQ(saved.out, InHome("link.json") + "  2 processes, 5 components, 1 connection\n");
  EXPECT_EQ(saved.err,
            "gcm: process 'robot' is not available now: kept as in the file, with 2 components\n");
  EXPECT_EQ(json::parse(home.Read("saved.json")), before);
  EXPECT_TRUE(std::filesystem::is_symlink(InHome("link.json")));
  EXPECT_EQ(std::filesystem::status(file).permissions(),
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  EXPECT_EQ(json::parse(Gcm({"save", file, "--json"}).out)["kept"].size(), 1U);
}

TEST_F(SavedSystemTest, AFailedApplyReportsTheRemainingSteps) {
  const std::string file = Saved();
  json wanted = json::parse(home.Read("saved.json"));
  wanted["processes"][1]["components"].push_back(
      // A library that is not loaded yet.
      {{"name", "extra"}, {"class", "Conter"}, {"library", "counter"}});
  home.Write("saved.json", wanted.dump());
  ASSERT_EQ(Gcm({"disconnect", "desk/supervisor/Robot"}).exit_code, program::kOk);

  const Outcome stopped = Gcm({"apply", file});
  EXPECT_EQ(stopped.exit_code, program::kNotFound) << stopped.err;  // no step was executed
  EXPECT_THAT(stopped.out,
              testing::MatchesRegex("1/3  BAD  create robot/extra .Conter of counter.: .*\n"
                                    "2/3  left connect desk/supervisor/Robot -> robot/arm/Control\n"
                                    "3/3  left start robot/extra\n"));
  EXPECT_THAT(stopped.err,
              HasSubstr("gcm: 0 steps done, 1 failed, 2 not executed, 7 objects untouched\n"));

  // Counter is already loaded now.
  wanted["processes"][1]["components"].back()["library"] = "legacy_arm";
  home.Write("saved.json", wanted.dump());
  const Outcome gone_on = Gcm({"apply", file, "--keep-going", "--json"});
  EXPECT_EQ(gone_on.exit_code, program::kPartial) << gone_on.err;
  const json steps = json::parse(gone_on.out)["steps"];
  EXPECT_EQ(steps[0]["outcome"], "failed");
  EXPECT_EQ(steps[1]["outcome"], "done");
  EXPECT_EQ(steps[2]["outcome"], "left");
  EXPECT_EQ(
      steps[2]["error"],
      "not executed, because an earlier step failed: create robot/extra (Conter of legacy_arm)");
}

TEST_F(SavedSystemTest, ApplyRestoresConnectionsAndIsIdempotent) {
  const std::string file = Saved();
  ASSERT_EQ(Gcm({"disconnect", "desk/supervisor/Robot"}).exit_code, program::kOk);

  const Outcome differs = Gcm({"diff", file});
  EXPECT_EQ(differs.exit_code, program::kRefused);
  EXPECT_EQ(differs.out, "- connection desk/supervisor/Robot -> robot/arm/Control\n");
  const Outcome planned = Gcm({"plan", file});
  EXPECT_EQ(planned.exit_code, program::kOk) << planned.err;
  EXPECT_EQ(planned.out, "  connect desk/supervisor/Robot -> robot/arm/Control\n");
  EXPECT_EQ(planned.err, "gcm: 1 step, 7 objects untouched\n");
  EXPECT_EQ(Gcm({"apply", file, "--dry-run"}).out, planned.out);
  EXPECT_EQ(Gcm({"diff", file}).exit_code, program::kRefused);  // no step was executed yet
  const Outcome applied = Gcm({"apply", file});
  EXPECT_EQ(applied.exit_code, program::kOk) << applied.err;
  EXPECT_EQ(applied.out, "1/1  ok   connect desk/supervisor/Robot -> robot/arm/Control\n");
  ExpectSaysNothing({"diff", file});
  const Outcome again = Gcm({"apply", file});
  EXPECT_EQ(again.exit_code, program::kOk);
  EXPECT_EQ(again.out, "");
  EXPECT_EQ(again.err, "gcm: 0 steps done, 0 failed, 0 not executed, 8 objects untouched\n");

  EXPECT_EQ(Gcm({"undo"}).exit_code, program::kOk);
  EXPECT_EQ(Gcm({"diff", file}).exit_code, program::kRefused);
}

TEST_F(SavedSystemTest, AnInterruptStopsApplyBetweenTwoSteps) {
  constexpr int kMany = 200;
  json components = json::array();
  for (int i = 0; i < kMany; ++i) {
    components.push_back(
        {{"name", "c" + std::to_string(i)}, {"class", "Counter"}, {"library", "counter"}});
  }
  const json robot_alone = {{{"name", "robot"}, {"components", std::move(components)}}};
  home.Write("many.json",
             json({{"version", 1}, {"name", "many"}, {"processes", robot_alone}}).dump());
  Program apply({Binary("gcm"), "--gcm", address, "--timeout", kTestTimeout, "apply",
                 InHome("many.json"), "--yes"});
  ASSERT_TRUE(EventuallyTrue([&] { return !apply.out().empty(); })) << apply.err();

  apply.Signal(SIGINT);

  EXPECT_EQ(apply.Wait(), program::kInterrupted) << apply.out() << apply.err();
  EXPECT_THAT(apply.out(), HasSubstr("  left start robot/c" + std::to_string(kMany - 1) + "\n"));
  EXPECT_THAT(apply.err(), HasSubstr(" 0 failed, "));
}

TEST_F(SavedSystemTest, ApplyRestoresTheSystemAfterAllProcessesWereKilled) {
  ASSERT_EQ(Gcm({"connect", "desk/teleoperation/Robot", "robot/arm/Control"}).exit_code, 0);
  const std::string file = Saved();
  const std::string before = Gcm({"tree"}).out;
  const std::string hash = ContentHash();
  ASSERT_EQ(Gcm({"disconnect", "desk/teleoperation/Robot"}).exit_code, 0);
  EXPECT_NE(ContentHash(), hash);
  robot->Signal(SIGKILL);
  desk->Signal(SIGKILL);
  gcm->Signal(SIGKILL);
  ASSERT_TRUE(robot->Wait() && desk->Wait() && gcm->Wait());
  StartGcm();
  robot = StartEmpty("robot");
  desk = StartEmpty("desk");
  ASSERT_TRUE(EventuallySays({"ls"}, "robot\talive"));
  ASSERT_TRUE(EventuallySays({"ls"}, "desk\talive"));

  const Outcome applied = Gcm({"apply", file});

  EXPECT_EQ(applied.exit_code, program::kOk) << applied.out << applied.err;
  EXPECT_THAT(applied.err, HasSubstr("gcm: 12 steps done, 0 failed, 0 not executed, 2 objects "
                                     "untouched; to undo these steps: gcm undo 12\n"));
  EXPECT_TRUE(EventuallyTrue([&] { return ContentHash() == hash; }))
      << before << "became" << Gcm({"tree"}).out;
  EXPECT_EQ(Gcm({"tree"}).out, before);
  ExpectSaysNothing({"diff", file});
  ExpectSaysNothing({"apply", file});
  EXPECT_EQ(ContentHash(), hash);
}

TEST_F(SavedSystemTest, ApplyPrintsItsUndoCommand) {
  const std::string before = Gcm({"tree"}).out;
  ASSERT_EQ(Gcm({"connect", "desk/teleoperation/Robot", "robot/arm/Control"}).exit_code, 0);
  ASSERT_EQ(Gcm({"stop", "robot/host_monitor"}).exit_code, 0);
  const std::string file = Saved();
  ASSERT_EQ(Gcm({"undo", "2"}).exit_code, 0);

  const Outcome applied = Gcm({"apply", file, "--yes"});

  ASSERT_EQ(applied.exit_code, program::kOk) << applied.out << applied.err;
  EXPECT_THAT(applied.err, testing::EndsWith("; to undo these steps: gcm undo 2\n"));
  const Outcome undone = Gcm({"undo", "2"});
  EXPECT_EQ(undone.exit_code, program::kOk) << undone.err;
  EXPECT_TRUE(EventuallyTrue([&] { return Gcm({"tree"}).out == before; }))
      << before << "became" << Gcm({"tree"}).out;
  EXPECT_THAT(Gcm({"apply", file, "--dry-run"}).err,
              testing::Not(HasSubstr("to undo these steps")));
}

TEST_F(SavedSystemTest, RemovingARunningComponentNeedsConfirmation) {
  const std::string file = Saved();
  ASSERT_EQ(Gcm({"connect", "desk/teleoperation/Robot", "robot/arm/Control"}).exit_code, 0);

  const Outcome refused = Gcm({"apply", file});
  EXPECT_EQ(refused.exit_code, program::kRefused);
  EXPECT_EQ(refused.out, "! disconnect desk/teleoperation/Robot -> robot/arm/Control\n");
  EXPECT_THAT(refused.err,
              HasSubstr("nothing was done, because the steps marked with ! stop, disconnect or "
                        "remove something that works; to execute these steps, too: gcm apply " +
                        file + " --yes"));
  EXPECT_EQ(Gcm({"diff", file}).out,
            "+ connection desk/teleoperation/Robot -> robot/arm/Control\n");

  EXPECT_EQ(Gcm({"apply", file, "--yes"}).exit_code, program::kOk);
  ExpectSaysNothing({"diff", file});
}

TEST_F(SavedSystemTest, ApplyReportsMissingProcessesAndNeedsKeepGoing) {
  const std::string file = Saved();
  ASSERT_EQ(Gcm({"disconnect", "desk/supervisor/Robot"}).exit_code, program::kOk);
  robot->Signal(SIGKILL);
  ASSERT_TRUE(EventuallySays({"ls"}, "robot\tlost"));
  const std::string missing =
      "process 'robot' with 2 components is not available; start this process: lcm --name robot";

  const Outcome refused = Gcm({"apply", file});
  EXPECT_EQ(refused.exit_code, program::kRefused);
  EXPECT_THAT(refused.err, HasSubstr(missing));
  EXPECT_THAT(refused.err, HasSubstr("gcm apply " + file + " --keep-going"));
  const Outcome partly = Gcm({"apply", file, "--keep-going"});

  EXPECT_EQ(partly.exit_code, program::kPartial);
  EXPECT_THAT(partly.err, HasSubstr(missing));
  EXPECT_THAT(Gcm({"show", "desk/supervisor/Robot"}).out, HasSubstr("pending"));
}

TEST_F(SavedSystemTest, ThreadOptionsAndRunsAfterAreSavedAndRestored) {
  const std::string file = Saved();
  json wanted = json::parse(home.Read("saved.json"));
  json& desk_parts = wanted["processes"][0]["components"];
  ASSERT_EQ(desk_parts[2]["name"], "teleoperation");
  EXPECT_EQ(desk_parts[2]["thread"], (json{{"policy", "normal"}}));
  desk_parts[2]["thread"]["spin"] = 1e-5;
  desk_parts[2]["runs_after"] = "supervisor";
  desk_parts[2].erase("period");  // the period of the supervisor
  home.Write("threads.json", wanted.dump());

  const Outcome differs = Gcm({"diff", InHome("threads.json")});
  EXPECT_EQ(differs.exit_code, program::kRefused);
  EXPECT_THAT(differs.out, testing::StartsWith("~ component desk/teleoperation: thread {"));
  EXPECT_THAT(differs.out, HasSubstr("; runs_after supervisor -> none\n"));
  EXPECT_THAT(Gcm({"plan", InHome("threads.json")}).out,
              HasSubstr("create desk/teleoperation (Teleoperation of teleoperation, which runs "
                        "after supervisor)\n"));
  const Outcome applied = Gcm({"apply", InHome("threads.json"), "--yes"});
  EXPECT_EQ(applied.exit_code, program::kOk) << applied.out << applied.err;
  ExpectSaysNothing({"diff", InHome("threads.json")});
  ExpectSaysNothing({"apply", InHome("threads.json")});
  // The file does not exist yet.
  EXPECT_EQ(Gcm({"save", InHome("again.json")}).exit_code, program::kOk);
  EXPECT_EQ(json::parse(home.Read("again.json"))["processes"], wanted["processes"]);

  EXPECT_EQ(Gcm({"apply", file, "--yes"}).exit_code, program::kOk);
  ExpectSaysNothing({"diff", file});
}

TEST_F(SavedSystemTest, JsonMatchesTheText) {
  const std::string file = Saved();
  ASSERT_EQ(Gcm({"disconnect", "desk/supervisor/Robot"}).exit_code, program::kOk);

  const json difference = json::parse(Gcm({"diff", file, "--json"}).out);
  EXPECT_EQ(difference["schema"], 1);
  EXPECT_EQ(difference["equal"], 7);
  EXPECT_EQ(difference["differences"][0]["kind"], "missing");
  const json plan = json::parse(Gcm({"plan", file, "--json"}).out);
  EXPECT_EQ(plan["steps"][0]["kind"], "connect");
  EXPECT_EQ(plan["steps"][0]["takes_away"], false);
  const json applied = json::parse(Gcm({"apply", file, "--json"}).out);
  EXPECT_EQ(applied["done"], 1);
  EXPECT_EQ(applied["left"], 0);
  EXPECT_EQ(json::parse(Gcm({"save", file, "--json"}).out)["components"], 5);
}

TEST_F(SavedSystemTest, APlanExitsWithTheCodeOfItsObstacle) {
  json wanted =
      json::parse(Gcm({"save", InHome("ends.json")}).exit_code == 0 ? home.Read("ends.json")
                                                                    : std::string("{}"));
  wanted["connections"].push_back(
      {{"required", "desk/teleoperation/Robot"}, {"provided", "desk/old_arm/Control"}});
  home.Write("unfit.json", wanted.dump());
  wanted["connections"].back()["provided"] = "robot/arm/Kontrol";
  home.Write("mistyped.json", wanted.dump());

  // gcm waits only briefly for the types. On a machine that stalls, the types may arrive too late,
  // so the test repeats the command.
  EXPECT_TRUE(EventuallyTrue([&] {
    return Gcm({"plan", InHome("unfit.json")}).err.find(" needed, ") != std::string::npos;
  }));
  EXPECT_EQ(Gcm({"plan", InHome("unfit.json")}).exit_code, program::kIncompatible);
  EXPECT_EQ(Gcm({"apply", InHome("unfit.json")}).exit_code, program::kIncompatible);
  const Outcome mistyped = Gcm({"plan", InHome("mistyped.json")});
  EXPECT_EQ(mistyped.exit_code, program::kNotFound);
  EXPECT_THAT(mistyped.err, HasSubstr("did you mean 'Control'?"));

  wanted["processes"].push_back({{"name", "nowhere"}, {"components", json::array()}});
  home.Write("both.json", wanted.dump());
  EXPECT_EQ(Gcm({"plan", InHome("both.json")}).exit_code, program::kRefused);
}

TEST_F(SavedSystemTest, RejectsABadFileWithLineAndColumn) {
  home.Write("bad.json", R"({"version": 1, "name": "x", "processes": [{"name": "a",
 "components": [{"name": "b", "class": "C", "preiod": 1}]}]})");
  home.Write("future.json", R"({"version": 99})");

  for (const std::string verb : {"diff", "plan", "apply"}) {
    const Outcome bad = Gcm({verb, InHome("bad.json")});
    EXPECT_EQ(bad.exit_code, program::kUsage);
    EXPECT_EQ(bad.err, "gcm: " + InHome("bad.json") +
                           ": line 2, column 45: processes[0].components[0]: unknown key "
                           "'preiod'; did you mean 'period'?\n");
    EXPECT_THAT(Gcm({verb, InHome("future.json")}).err,
                HasSubstr("the file has version 99, but this program reads version 1"));
    EXPECT_EQ(Gcm({verb, InHome("none.json")}).exit_code, program::kNotFound);
  }
}

TEST_F(SavedSystemTest, APlanFindsImpossibleComponentsBeforeStoppingAnything) {
  const std::string before = ContentHash();
  std::ifstream saved(Saved());
  const json good = json::parse(saved);
  struct Mistake {
    std::string key;
    json value;
    std::string sentence;
  };
  for (const auto& [key, value, sentence] :
       {Mistake{"configuration", {{"nois", 0.001}}, "unknown key 'nois'"},
        Mistake{"class", "SimulatedAm",
                "has no class 'SimulatedAm' in simulated_arm; did you mean 'SimulatedArm'?"},
        Mistake{"library", "simulated_am", "did you mean 'simulated_arm'?"}}) {
    json bad = good;
    json& arm = bad["processes"][1]["components"][0];
    ASSERT_EQ(arm["name"], "arm");
    arm[key] = value;
    home.Write("bad.json", bad.dump());

    const Outcome plan = Gcm({"plan", InHome("bad.json")});
    EXPECT_EQ(plan.exit_code, program::kRefused) << plan.out;
    EXPECT_EQ(plan.out, "");
    EXPECT_THAT(plan.err, HasSubstr("robot/arm cannot be created as the file says: "));
    EXPECT_THAT(plan.err, HasSubstr(sentence));
    EXPECT_THAT(plan.err, HasSubstr("; this component is not changed\n"));
    Gcm({"apply", InHome("bad.json"), "--yes", "--keep-going"});
    EXPECT_EQ(ContentHash(), before);
  }
}

TEST_F(SavedSystemTest, ImportsAFileOfTheReferenceSystem) {
  home.Write("cisst.json", R"({"components": [{"class-name": "mtsArm",
      "constructor-arg": {"Name": "arm", "Period": 0.01}, "configure-parameter": "arm.cal"}]})");

  const Outcome imported =
      Gcm({"import", InHome("cisst.json"), InHome("new.json"), "--process", "robot"});

  EXPECT_EQ(imported.exit_code, program::kOk) << imported.err;
  EXPECT_THAT(imported.err, HasSubstr("kept as a comment"));
  const json file = json::parse(home.Read("new.json"));
  EXPECT_EQ(file["processes"][0]["components"][0]["class"], "mtsArm");

  const Outcome again =
      Gcm({"import", InHome("cisst.json"), InHome("new.json"), "--process", "desk"});
  EXPECT_EQ(again.exit_code, program::kRefused);
  EXPECT_THAT(again.err,
              HasSubstr("new.json already exists: give another file, or remove this file"));
  EXPECT_EQ(json::parse(home.Read("new.json")), file);
}

TEST_F(SavedSystemTest, UndoRevertsSeveralStepsAndHistoryListsThem) {
  const std::string teleoperation = "desk/teleoperation/Robot";
  ASSERT_EQ(Gcm({"disconnect", "desk/supervisor/Robot"}).exit_code, program::kOk);
  ASSERT_EQ(Gcm({"connect", teleoperation, "robot/arm/Control"}).exit_code, program::kOk);

  const Outcome undone = Gcm({"undo", "2"});
  EXPECT_EQ(undone.exit_code, program::kOk) << undone.err;
  EXPECT_EQ(undone.out,
            "undone: connect desk/teleoperation/Robot robot/arm/Control\n"
            "undone: disconnect desk/supervisor/Robot robot/arm/Control\n");
  EXPECT_TRUE(EventuallySays({"ls", "desk/supervisor"}, "-> robot/arm/Control\n"));

  const Outcome history = Gcm({"history"});
  EXPECT_THAT(history.out,
              testing::MatchesRegex(
                  "1\t[-0-9]* [:0-9]*\tgcm disconnect of [^@]+@[^\t]+\tundone\tdisconnect desk/"
                  "supervisor/Robot robot/arm/Control\n"
                  "2\t[-0-9]* [:0-9]*\tgcm connect of [^@]+@[^\t]+\tundone\tconnect desk/"
                  "teleoperation/Robot robot/arm/Control\n"));
  const json newest = json::parse(Gcm({"history", "--count", "1", "--json"}).out);
  ASSERT_EQ(newest["steps"].size(), 1U);
  EXPECT_EQ(newest["steps"][0]["id"], 2);
  EXPECT_EQ(newest["steps"][0]["who"], "gcm connect of " + tendon::os::UserAtHost());
  EXPECT_EQ(newest["steps"][0]["undone"], true);
  EXPECT_EQ(Gcm({"undo"}).err, "gcm: there is nothing to undo\n");
}

TEST_F(SavedSystemTest, UndoSkipsStepsOfAnEarlierRun) {
  ASSERT_EQ(Gcm({"disconnect", "desk/supervisor/Robot"}).exit_code, program::kOk);
  desk->Signal(SIGKILL);
  ASSERT_TRUE(EventuallySays({"ls"}, "desk\tlost"));
  desk = StartLcm("desk", demo);
  ASSERT_TRUE(EventuallySays({"ls", "desk/supervisor"}, "-> robot/arm/Control\n"));

  const Outcome refused = Gcm({"undo"});
  EXPECT_EQ(refused.exit_code, program::kRefused);
  EXPECT_THAT(refused.err,
              testing::MatchesRegex(
                  "gcm: cannot undo step 1 .disconnect desk/supervisor/Robot robot/arm/Control, by "
                  "gcm disconnect of .* at .*: process 'desk' was restarted since; to skip this "
                  "step and undo the step before it: gcm undo --skip\n"));
  const Outcome skipped = Gcm({"undo", "--skip"});

  EXPECT_THAT(skipped.err, HasSubstr("gcm: skipped and not undone: step 1 (disconnect"));
  EXPECT_THAT(skipped.err, HasSubstr("gcm: there is nothing to undo\n"));
  EXPECT_THAT(Gcm({"history"}).out, HasSubstr("\tskipped\t"));
}

}  // namespace
