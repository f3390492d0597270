#include <gtest/gtest.h>
#include <tendon/recording/recording_selection.h>

#include <set>
#include <string>

namespace tendon::recording {
namespace {

TEST(SelectionTest, APatternSelectsAnObjectAndEverythingInIt) {
  ComponentDescription arm{.name = "arm"};
  arm.tables.push_back({.name = "state", .columns = {{.name = "Joints"}, {.name = "Load"}}});
  arm.provided.push_back({.name = "Control",
                          .commands = {{.name = "MoveTo", .signature = {CommandKind::kWrite}},
                                       {.name = "GetJoints", .signature = {CommandKind::kRead}}},
                          .events = {{.name = "Stopped"}, {.name = "Moved"}}});
  Catalogue catalogue;
  ASSERT_TRUE(catalogue.Apply({.revision = 1,
                               .kind = CatalogueChange::Kind::kProcess,
                               .process = "robot",
                               .processes = {{.name = "robot", .instance = 1}}}));
  ASSERT_TRUE(catalogue.Apply({.revision = 2,
                               .kind = CatalogueChange::Kind::kComponent,
                               .process = "robot",
                               .components = {arm}}));
  const auto selected_by = [&](const std::string& pattern) {
    const RecordingSelection selection = Select(catalogue, {pattern});
    std::set<std::string> all;
    for (const auto& table : selection.tables)
      all.insert(table.columns.begin(), table.columns.end());
    for (const auto& one : selection.events) all.insert(one.events.begin(), one.events.end());
    for (const auto& one : selection.commands) all.insert(one.commands.begin(), one.commands.end());
    return all;
  };
  using Names = std::set<std::string>;

  for (const char* const all : {"robot", "robot/arm", "**", "*/arm", "robot/*/*"}) {
    EXPECT_EQ(selected_by(all), (Names{"Joints", "Load", "MoveTo", "Moved", "Stopped"})) << all;
  }
  EXPECT_EQ(selected_by("robot/arm/state"), (Names{"Joints", "Load"}));
  EXPECT_EQ(selected_by("robot/arm/state.J*"), Names{"Joints"});
  EXPECT_EQ(selected_by("**.Moved"), Names{"Moved"});
  EXPECT_EQ(selected_by("robot/arm/Control.MoveTo"), Names{"MoveTo"});
  EXPECT_EQ(selected_by("robot/arm/Control.GetJoints"), Names{}) << "reads are not recorded";
  EXPECT_EQ(selected_by("desk"), Names{});
}

}  // namespace
}  // namespace tendon::recording
