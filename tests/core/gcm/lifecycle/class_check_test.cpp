#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/gcm/lifecycle/class_check.h>
#include <tests/core/gcm/samples.h>

#include <string>
#include <vector>

namespace tendon {
namespace {

/// Returns the plug-ins of the process `robot`: one is loaded, another one is only available.
message::Classes Known() {
  return {.classes = {{.name = "Arm", .library = "arms", .configuration = {}, .defaults = {}}},
          .plugins = {"arms", "tools"}};
}

std::string WhyNot(const std::string& class_name, const std::string& library) {
  const auto checked = CheckCreation(
      Known(),
      {.process = "robot", .component = "one", .class_name = class_name, .library = library});
  return checked ? "" : checked.error().message;
}

TEST(ClassCheck, KnowsTheClassesOfLoadedPlugIns) {
  EXPECT_EQ(WhyNot("Arm", "arms"), "");
  EXPECT_EQ(WhyNot("Arm", ""), "");
  EXPECT_EQ(WhyNot("Am", "arms"), "process 'robot' has no class 'Am' in arms; did you mean 'Arm'?");
  EXPECT_TRUE(WhyNot("Gripper", "").starts_with("process 'robot' has no class 'Gripper'"));
}

TEST(ClassCheck, KnowsOnlyTheNameOfAnUnloadedPlugIn) {
  EXPECT_EQ(WhyNot("Gripper", "tools"), "");
  EXPECT_EQ(WhyNot("Gripper", "tool"), "no plug-in 'tool'; did you mean 'tools'?");
}

/// Returns the obstacles if an empty process must get these components.
std::vector<std::string> Obstacles(const std::vector<SystemFile::Component>& components) {
  Catalogue catalogue;
  CatalogueChange there{.revision = 1,
                        .kind = CatalogueChange::Kind::kProcess,
                        .process = "robot",
                        .processes = {test::ProcessNamed("robot", 1)}};
  EXPECT_TRUE(catalogue.Apply(there));
  const SystemFile wanted{
      .name = "lab", .processes = {{.name = "robot", .components = components}}, .connections = {}};
  EXPECT_EQ(ProcessesToAsk(catalogue, wanted), std::vector<std::string>{"robot"});
  return MakeCheckedPlan(catalogue, wanted, {{"robot", Known()}}).obstacles;
}

TEST(ClassCheck, APlugInLoadedByThePlanMayHaveTheClass) {
  const SystemFile::Component gripper{.name = "one", .class_name = "Gripper", .library = {}};
  const SystemFile::Component wrench{.name = "two", .class_name = "Wrench", .library = "tools"};

  EXPECT_EQ(Obstacles({gripper}).size(), 1U);
  EXPECT_TRUE(Obstacles({wrench, gripper}).empty());
}

TEST(ClassCheck, ReportsAChangedPlugInFileForAMissingClass) {
  message::Classes known = Known();
  known.loaded = {{.name = "arms",
                   .file = "/opt/arms.so",
                   .written = 1,
                   .state = PluginState::kChanged,
                   .written_now = 2}};
  const auto checked = CheckCreation(
      known, {.process = "robot", .component = "one", .class_name = "Gripper", .library = "arms"});

  ASSERT_FALSE(checked);
  EXPECT_THAT(
      checked.error().message,
      testing::MatchesRegex(
          "process 'robot' has no class 'Gripper' in arms; process 'robot' runs /opt/arms.so of "
          ".*; the file was written again at .*: restart the process to use the new file"));
}

TEST(ClassCheck, APlanNotesOutdatedPlugIns) {
  ProcessDescription robot = test::ProcessNamed("robot", 1);
  robot.plugins = {{.name = "simulated_arm", .file = "/opt/a.so", .state = PluginState::kChanged},
                   {.name = "unused", .file = "/opt/b.so", .state = PluginState::kChanged}};
  Catalogue catalogue;
  ASSERT_TRUE(catalogue.Apply({.revision = 1,
                               .kind = CatalogueChange::Kind::kProcess,
                               .process = "robot",
                               .processes = {robot}}));
  ASSERT_TRUE(catalogue.Apply({.revision = 2,
                               .kind = CatalogueChange::Kind::kComponent,
                               .process = "robot",
                               .components = {test::Arm()}}));
  const SystemFile wanted{
      .name = "lab",
      .processes = {{.name = "robot",
                     .components = {{.name = "arm", .class_name = "SimulatedArm", .library = {}}}}},
      .connections = {}};

  const Plan plan = MakeCheckedPlan(catalogue, wanted, {});

  ASSERT_EQ(plan.notes.size(), 1U);
  EXPECT_THAT(plan.notes[0], testing::HasSubstr("process 'robot' runs /opt/a.so of "));
}

}  // namespace
}  // namespace tendon
