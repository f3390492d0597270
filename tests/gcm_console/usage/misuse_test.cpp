#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "gcm_console/demo_fixture.h"

namespace {

using testing::HasSubstr;

/// Tests names that do not exist, or that name an object of another kind.
class MisuseTest : public DemoFixture {
 protected:
  struct Case {
    Program::Words words;
    int exit_code;
    std::string sentence;
  };

  void ExpectSentences(const std::vector<Case>& cases) const {
    for (const Case& one : cases) {
      const Outcome outcome = Gcm(one.words);
      EXPECT_EQ(outcome.exit_code, one.exit_code) << outcome.err;
      EXPECT_THAT(outcome.err, HasSubstr(one.sentence));
      EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
      EXPECT_EQ(outcome.out, "");
    }
  }
};

TEST_F(MisuseTest, ExplainsUnknownNames) {
  ExpectSentences({
      {{"hz", "robot/arm/state.Jonts"}, program::kNotFound, "did you mean 'Joints'?"},
      {{"hz", "robot/arm/Control"}, program::kNotFound, "is not a column of a state table"},
      {{"plot", "robot/arm"}, program::kNotFound, "is not a column of a state table"},
      {{"watch", "robto"}, program::kNotFound, "no process 'robto'; did you mean 'robot'?"},
      {{"hz", "robto"}, program::kNotFound, "no process 'robto'; did you mean 'robot'?"},
      {{"watch", "robot"}, program::kUsage, "'robot' is a process: give a column"},
      {{"candidates", "desk/teleoperation"},
       program::kUsage,
       "'desk/teleoperation' is not an interf"},
      {{"candidates", "desk/teleoperation/Robt"}, program::kNotFound, "did you mean 'Robot'?"},
      {{"candidates", "robot/arm/Control"}, program::kNotFound, "is a provided interface"},
      {{"explain", "desk"}, program::kUsage, "'desk' is not an interface"},
      {{"classes"}, program::kUsage, "there are several processes; give one of these: desk, robot"},
      {{"classes", "robt"}, program::kNotFound, "no process 'robt'; did you mean 'robot'?"},
      {{"classes", "robot", "SimulatedAm"}, program::kNotFound, "did you mean 'SimulatedArm'?"},
      {{"--json", "classes", "robot", "SimulatedAm"},
       program::kNotFound,
       "the process has no loaded class 'SimulatedAm'; did you mean 'SimulatedArm'?"},
      {{"suspend", "robot/amr"}, program::kNotFound, "no component 'robot/amr'; did you mean"},
      {{"suspend", "robot"}, program::kUsage, "'robot' does not name a component"},
      {{"restart", "robot/arm/Control"}, program::kUsage, "does not name a component"},
      {{"restart", "x/*"}, program::kNotFound, "no component matches 'x/*'"},
      {{"set", "robot/arm", "nois", "1"}, program::kNotFound, "did you mean 'noise'?"},
      {{"kill", "nobody"}, program::kNotFound, "no process 'nobody'; there is 'desk', 'robot'"},
      {{"disconnect", "99"}, program::kNotFound, "no connection has the number 99"},
      {{"connect", "--match", "x/**", "y/**"}, program::kNotFound, "interface matches 'x/**'"},
      {{"undo", "--step", "99"}, program::kRefused, "there is nothing to undo"},
      {{"create", "", "robot/two"}, program::kUsage, "no class is given"},
      {{"create", "Counter", "robot/two", "--arg", ""}, program::kUsage, "expected a JSON object"},
      {{"configure", "robot/arm"}, program::kUsage, "the configuration is missing"},
      {{"find", "type:"}, program::kUsage, "a value is missing after 'type:'"},
  });
}

TEST_F(MisuseTest, ExplainsUnusableFiles) {
  const std::string folder = home.path().string();
  const std::string pipe = folder + "/pipe";
  const std::string torn = folder + "/torn.json";
  ASSERT_EQ(mkfifo(pipe.c_str(), S_IRUSR | S_IWUSR), 0);
  std::ofstream(torn) << "{\"version\": 1,\n\"name\":";

  for (const std::string verb : {"plan", "diff", "apply"}) {
    ExpectSentences({
        {{verb, folder}, program::kUsage, folder + ": is a folder, not a file"},
        {{verb, pipe}, program::kUsage, pipe + ": is not a regular file"},
        {{verb, torn}, program::kUsage, torn + ": line 2, column 8: unexpected end"},
        {{verb, folder + "/none.json"}, program::kNotFound, "there is no such file"},
    });
  }
  const std::string to = folder + "/new.json";
  ExpectSentences({
      {{"diff", demo, pipe}, program::kUsage, pipe + ": is not a regular file"},
      {{"save", folder}, program::kUsage, "; nothing is saved: give another file"},
      {{"save", pipe}, program::kUsage, "; nothing is saved: give another file"},
      {{"import", folder, to, "--process", "robot"}, program::kUsage, folder + ": is a folder"},
      {{"import", pipe, to, "--process", "robot"},
       program::kUsage,
       pipe + ": is not a regular file"},
      {{"import", torn, to, "--process", "robot"},
       program::kUsage,
       torn + ": line 2, column 8: unexpected end"},
      {{"import", folder + "/none.json", to, "--process", "robot"},
       program::kNotFound,
       "there is no such file"},
      {{"import", torn}, program::kUsage, "to is missing; gcm import --help tells more"},
      {{"run", folder}, program::kUsage, "is a folder: give a file with one gcm command"},
      {{"plan", ""}, program::kUsage, "no file is given"},
      {{"run", folder + "/none.gcm"}, program::kNotFound, "there is no such file"},
  });
  EXPECT_FALSE(std::filesystem::exists(to));
}

}  // namespace
