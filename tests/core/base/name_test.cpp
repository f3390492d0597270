#include <gtest/gtest.h>
#include <tendon/base/name.h>
#include <tendon/base/path.h>

#include <vector>

namespace {

using tendon::CheckName;
using tendon::IsWithinGlob;
using tendon::MatchesGlob;
using tendon::ParseInterfaceName;
using tendon::ParsePath;

std::string Refusal(const std::string& name) {
  const auto checked = CheckName("component", name);
  return checked ? "allowed" : checked.error().message;
}

TEST(Name, ARefusalNamesTheCharacterPositionAndRule) {
  EXPECT_EQ(Refusal("arm_2-left"), "allowed");
  EXPECT_EQ(Refusal(""), "component name is empty");
  EXPECT_EQ(Refusal("a b"),
            "component name 'a b' has ' ' at 2; allowed: letters digits _ - (max 64)");
  EXPECT_EQ(Refusal("a/b"),
            "component name 'a/b' has '/' at 2; allowed: letters digits _ - (max 64)");
  EXPECT_EQ(Refusal("a\x1b[2J"),
            "component name 'a\\x1b[2J' has '\\x1b' at 2; allowed: letters digits _ - (max 64)");
  EXPECT_EQ(Refusal(std::string(300, 'x')),
            "component name 'xxxxxxxxxxxxxxxxxxxx...' has 300 "
            "characters; allowed: letters digits _ - (max 64)");
}

TEST(Name, SuggestsTheNearestNameIfItIsClose) {
  const std::vector<std::string> known = {"arm", "camera", "teleoperation"};

  EXPECT_EQ(tendon::DidYouMean("arn", known), "; did you mean 'arm'?");
  EXPECT_EQ(tendon::DidYouMean("telopertaion", known), "; did you mean 'teleoperation'?");
  EXPECT_EQ(tendon::DidYouMean("gripper", known), "");
}

TEST(Name, SuggestsNothingForVeryShortNames) {
  const std::vector<std::string> known = {"a", "b2", "abc"};

  EXPECT_EQ(tendon::DidYouMean("b", known), "");
  EXPECT_EQ(tendon::DidYouMean("c", known), "");
  EXPECT_EQ(tendon::DidYouMean("xy", known), "");
  EXPECT_EQ(tendon::DidYouMean("b1", known), "; did you mean 'b2'?");
  EXPECT_EQ(tendon::DidYouMean("A", known), "; did you mean 'a'?") << "but for its case";
}

TEST(Name, SuggestsTheOnlyNameWithTheSamePrefix) {
  const std::vector<std::string> known = {"MoveTo", "GetJoints", "GetLinkPose", "Stop"};

  EXPECT_EQ(tendon::DidYouMean("Mov", known), "; did you mean 'MoveTo'?");
  EXPECT_EQ(tendon::DidYouMean("getl", known), "; did you mean 'GetLinkPose'?");
  EXPECT_EQ(tendon::DidYouMean("Get", known), "") << "there are two";
  EXPECT_EQ(tendon::DidYouMean("M", known), "");
}

TEST(Name, SuggestionsIgnoreCase) {
  const std::vector<std::string> known = {"MoveTo", "GetJoints", "Stop"};

  EXPECT_EQ(tendon::DidYouMean("movto", known), "; did you mean 'MoveTo'?");
  EXPECT_EQ(tendon::DidYouMean("STOP", known), "; did you mean 'Stop'?");
}

TEST(Name, SuggestsNothingForHugeNamesWithoutComparing) {
  const std::vector<std::string> known(1000, std::string(64, 'x'));

  EXPECT_EQ(tendon::DidYouMean(std::string(std::size_t{64} << 20U, 'x'), known), "");
}

TEST(InterfaceName, ParsesAndFormats) {
  const auto name = ParseInterfaceName("robot/arm/Control");

  ASSERT_TRUE(name.ok());
  EXPECT_EQ(*name, tendon::InterfaceName("robot", "arm", "Control"));
  EXPECT_EQ(ToString(*name), "robot/arm/Control");
  EXPECT_EQ(ToString(tendon::InterfaceName("arm", "Control")), "arm/Control");
}

TEST(InterfaceName, RefusesTextOfAnotherForm) {
  for (const char* text : {"", "robot", "robot/arm", "robot/arm/Control/x", "robot//Control"}) {
    EXPECT_FALSE(ParseInterfaceName(text).ok()) << text;
  }
}

TEST(Path, ParsesAllParts) {
  const auto path = ParsePath("robot/arm/state.Joints.position[0]");

  ASSERT_TRUE(path.ok());
  EXPECT_EQ(path->process, "robot");
  EXPECT_EQ(path->component, "arm");
  EXPECT_EQ(path->interface, "state");
  EXPECT_EQ(path->member, "Joints");
  EXPECT_EQ(path->field, ".position[0]");
  EXPECT_EQ(ToString(*path), "robot/arm/state.Joints.position[0]");
}

TEST(Path, AllowsMissingLaterParts) {
  for (const char* text : {"robot", "robot/arm", "robot/arm/state", "robot/arm/state.Joints"}) {
    const auto path = ParsePath(text);
    ASSERT_TRUE(path.ok()) << text;
    EXPECT_EQ(ToString(*path), text);
  }
}

TEST(Path, NamesEachMistake) {
  EXPECT_FALSE(ParsePath("").ok());
  EXPECT_FALSE(ParsePath("ro bot/arm").ok());
  const auto path = ParsePath("robot/arm/state.");
  ASSERT_FALSE(path.ok());
  EXPECT_EQ(path.error().message,
            "'robot/arm/state.' is not a path: nothing follows the '.'; expected "
            "process/component/interface.member");
}

TEST(Glob, OneStarMatchesWithinAName) {
  EXPECT_TRUE(MatchesGlob("robot/*/state", "robot/arm/state"));
  EXPECT_FALSE(MatchesGlob("robot/*", "robot/arm/state"));
  EXPECT_FALSE(MatchesGlob("*/arm", "robot/leg"));
  EXPECT_TRUE(MatchesGlob("a*m", "arm"));
}

TEST(Glob, TwoStarsMatchAcrossNames) {
  EXPECT_TRUE(MatchesGlob("**.position*", "robot/arm/state.position[0]"));
  EXPECT_TRUE(MatchesGlob("**", ""));
  EXPECT_FALSE(MatchesGlob("**x", "robot/arm"));
}

TEST(Glob, MatchesAnObjectAlsoByWhatContainsIt) {
  for (const char* pattern : {"robot", "robot/*", "robot/arm/state", "robot/arm/state.Joints"}) {
    EXPECT_TRUE(IsWithinGlob(pattern, "robot/arm/state.Joints")) << pattern;
  }
  EXPECT_FALSE(IsWithinGlob("rob", "robot/arm"));
  EXPECT_FALSE(IsWithinGlob("robot/arm/state", "robot/arm"));
  EXPECT_FALSE(IsWithinGlob("", "robot"));
}

}  // namespace
