#include <gtest/gtest.h>
#include <tendon/gcm/client/json_field.h>
#include <tendon/gcm/text.h>

namespace tendon {
namespace {

TEST(OutdatedPlugin, ReportsAFindingAndARemedy) {
  PluginDescription plugin{.name = "arm", .file = "/opt/a: b.so", .written = 1};
  EXPECT_FALSE(FindOutdatedPlugin("robot", plugin));
  EXPECT_EQ(OutdatedPluginText("robot", plugin), "");

  plugin.state = PluginState::kGone;
  const auto gone = FindOutdatedPlugin("robot", plugin);
  ASSERT_TRUE(gone);
  EXPECT_EQ(gone->finding, "process 'robot' runs " + PluginText(plugin) + "; the file is missing");
  EXPECT_EQ(gone->remedy, "restore the plug-in file before you restart the process");

  plugin.state = PluginState::kChanged;
  const auto changed = FindOutdatedPlugin("robot", plugin);
  ASSERT_TRUE(changed);
  EXPECT_EQ(changed->finding, "process 'robot' runs " + PluginText(plugin) + "; the file was " +
                                  PluginChangeText(plugin));
  EXPECT_EQ(OutdatedPluginText("robot", plugin), changed->finding + ": " + changed->remedy);
}

TEST(JsonField, FollowsFieldsAndElements) {
  const std::string json = R"({"position":[1,2.5],"tool":{"name":"gripper"}})";

  EXPECT_EQ(*client::JsonField(json, ""), json);
  EXPECT_EQ(*client::JsonField(json, ".position[1]"), "2.5");
  EXPECT_EQ(*client::JsonField(json, ".tool.name"), "\"gripper\"");
  EXPECT_EQ(*client::JsonField("[[1,2],[3]]", "[1][0]"), "3");
}

TEST(JsonField, KeepsNumbersAsWritten) {
  const std::string json =
      R"( { "uptime" : 2000000000.123456789 , "last":18446744073709551615,"zero":-0.0,)"
      R"("te\"xt":"a \"},]","empty":[],"none":{},"list":[ [1.50,"]"] , {"x":1e-3} ] } )";

  EXPECT_EQ(*client::JsonField(json, ".uptime"), "2000000000.123456789");
  EXPECT_EQ(*client::JsonField(json, ".last"), "18446744073709551615");
  EXPECT_EQ(*client::JsonField(json, ".zero"), "-0.0");
  EXPECT_EQ(*client::JsonField(json, ".te\"xt"), R"("a \"},]")");
  EXPECT_EQ(*client::JsonField(json, ".list[0][0]"), "1.50");
  EXPECT_EQ(*client::JsonField(json, ".list[1].x"), "1e-3");
  EXPECT_EQ(*client::JsonField(json, ".list[0]"), R"([1.50,"]"])");
  EXPECT_FALSE(client::JsonField(json, ".empty[0]"));
  EXPECT_FALSE(client::JsonField(json, ".none.x"));
}

TEST(JsonField, ReportsTheUnknownPartOfAPath) {
  const std::string json = R"({"position":[1,2.5]})";

  EXPECT_EQ(client::JsonField(json, ".positon").error().message,
            "there is no field 'positon'; did you mean 'position'?");
  for (const std::string field :
       {".position[2]", ".position[-1]", ".position[x]", ".position[]", ".position[0",
        ".position.x", ".position[0].x", "[0]", ".", "["}) {
    EXPECT_FALSE(client::JsonField(json, field)) << field;
  }
}

TEST(JsonField, RefusesDeepNesting) {
  EXPECT_EQ(client::JsonField(std::string(100'000, '['), "[0]").error().message,
            "nesting deeper than 64");
}

TEST(ChangesText, ShowsOldAndNewParameters) {
  message::HistoryEntry step{.verb = "configure",
                             .lifecycle = {.process = "robot", .component = "arm"}};
  step.lifecycle.former = R"({"noise":0.001,"home":[0,1],"gone":"x"})";
  step.lifecycle.configuration = R"({"noise":0.5,"home":[0,1],"mode":"fast"})";
  EXPECT_EQ(ChangesText(step),
            "gone \"x\" -> default, mode default -> \"fast\", noise 0.001 -> 0.5");

  step.lifecycle.former.clear();
  step.lifecycle.configuration = R"({"text":")" + std::string(1000, 'a') + R"("})";
  EXPECT_LT(ChangesText(step).size(), 120U);
  step.lifecycle.configuration = "no object";
  EXPECT_EQ(ChangesText(step), "");
  step.verb = "create";
  step.lifecycle.configuration = R"({"noise":0.5})";
  EXPECT_EQ(ChangesText(step), "");
}

const message::ProgramVersion kOwn{.release = "1.2.3", .protocol = 7};

TEST(VersionText, RecognizesTheSameRelease) {
  const VersionReport told = CompareVersion(kOwn, kOwn);
  EXPECT_EQ(told.text, "version 1.2.3, protocol 7");
  EXPECT_TRUE(told.is_own);
}

TEST(VersionText, ReportsAnotherReleaseOrProtocol) {
  for (const message::ProgramVersion& other :
       {message::ProgramVersion{.release = "1.2.4", .protocol = 7},
        message::ProgramVersion{.release = "1.2.3", .protocol = 6}}) {
    const VersionReport told = CompareVersion(other, kOwn);
    EXPECT_EQ(told.text, VersionText(other) + ", but this program has another version");
    EXPECT_FALSE(told.is_own);
  }
}

TEST(VersionText, AnUnresponsiveProgramHasAnUnknownVersion) {
  const VersionReport told = CompareVersion(Error{ErrorCode::kTimeout, "no reply"}, kOwn);
  EXPECT_EQ(told.text, "of an unknown version (no reply)");
  EXPECT_FALSE(told.is_own);
}

}  // namespace
}  // namespace tendon
