#include <gcm_console/catalogue/find_term.h>
#include <gtest/gtest.h>

#include <string>

namespace {

using console::Expression;
using console::FindTerm;
using console::SystemItem;

bool Finds(const std::string& expression, const std::string& text) {
  const auto parsed = Expression::Parse(expression);
  EXPECT_TRUE(parsed) << parsed.error().message;
  return parsed && parsed->IsIn(text);
}

std::string MistakeIn(const std::string& expression) {
  const auto parsed = Expression::Parse(expression);
  return parsed ? "" : parsed.error().message;
}

TEST(Expression, FindsASubstringIgnoringCase) {
  EXPECT_TRUE(Finds("oin", "Joints"));
  EXPECT_TRUE(Finds("JOINTS", "joints"));
  EXPECT_FALSE(Finds("oinn", "Joints"));
  EXPECT_TRUE(Finds("x*", ""));
}

TEST(Expression, AnchorsMatchBothEnds) {
  EXPECT_TRUE(Finds("^arm$", "arm"));
  EXPECT_FALSE(Finds("^arm", "the arm"));
  EXPECT_FALSE(Finds("arm$", "armed"));
  EXPECT_TRUE(Finds("^$", ""));
  EXPECT_FALSE(Finds("^$", "a"));
}

TEST(Expression, SupportsRepetition) {
  EXPECT_TRUE(Finds("^ab*c$", "ac"));
  EXPECT_TRUE(Finds("^ab*c$", "abbbc"));
  EXPECT_FALSE(Finds("^ab+c$", "ac"));
  EXPECT_TRUE(Finds("^ab+c$", "abbc"));
  EXPECT_TRUE(Finds("^ab?c$", "ac"));
  EXPECT_FALSE(Finds("^ab?c$", "abbc"));
  EXPECT_TRUE(Finds("^(ab)+$", "ababab"));
  EXPECT_FALSE(Finds("^(ab)+$", "ababa"));
}

TEST(Expression, SupportsAlternatives) {
  EXPECT_TRUE(Finds("^(get|set|move)To$", "MoveTo"));
  EXPECT_FALSE(Finds("^(get|set|move)To$", "StopTo"));
  EXPECT_TRUE(Finds("^(a|b*)c$", "bbc"));
  EXPECT_TRUE(Finds("^(a|)c$", "c"));
  EXPECT_TRUE(Finds("a|b", "xb"));
}

TEST(Expression, SupportsCharacterClasses) {
  EXPECT_TRUE(Finds("^[a-c_]+$", "AbC_"));
  EXPECT_FALSE(Finds("^[a-c_]+$", "abd"));
  EXPECT_TRUE(Finds("^[^/.]+$", "arm"));
  EXPECT_FALSE(Finds("^[^/.]+$", "robot/arm"));
  EXPECT_TRUE(Finds("^[]a-]+$", "]-a"));
  EXPECT_TRUE(Finds("\\[\\d+\\]$", "position[12]"));
  EXPECT_TRUE(Finds("^[\\d.]+$", "1.5"));
  EXPECT_FALSE(Finds("a.c", "ac"));
  EXPECT_FALSE(Finds("a\\.c", "abc"));
}

TEST(Expression, ReportsAMistakeWithItsPlace) {
  const std::string expected = "; expected an expression such as Get|Set";
  EXPECT_EQ(MistakeIn(""),
            "an empty expression matches everything; expected an expression such as Get|Set");
  EXPECT_EQ(MistakeIn("a(b"), "missing ) at 'a(b'" + expected);
  EXPECT_EQ(MistakeIn("a[b"), "missing ] at '[b'" + expected);
  EXPECT_EQ(MistakeIn("*a"), "no argument for repetition operator at '*'" + expected);
  EXPECT_EQ(MistakeIn("[z-a]"), "invalid character class range at 'z-a'" + expected);
  EXPECT_EQ(MistakeIn(std::string(201, 'a')),
            "an expression may have at most 200 bytes, but the given expression has 201");
  EXPECT_EQ(MistakeIn("((a{100}){100}){100}"), "invalid repetition size at '{100}'" + expected);
}

// A matcher with backtracking would need almost infinite time for these patterns.
TEST(Expression, CatastrophicPatternsMatchQuickly) {
  const std::string many(2000, 'a');
  EXPECT_FALSE(Finds("^(a+)+$", many + "!"));
  EXPECT_FALSE(Finds("^(a|a)*$", many + "!"));
  EXPECT_FALSE(Finds("^((a*)*)*$", many + "!"));
  EXPECT_TRUE(Finds("^((a*)*)*$", many));
  std::string optional;
  for (int i = 0; i < 50; ++i) optional += "a?";
  EXPECT_TRUE(Finds("^" + optional + std::string(50, 'a') + "$", std::string(50, 'a')));
}

const SystemItem kGoal{.path = "robot/arm/Control.MoveTo",
                       .kind = "command",
                       .type = "arm.JointGoal",
                       .state = "",
                       .host = "lab"};
const SystemItem kRobot{
    .path = "desk/teleoperation/Robot", .kind = "required interface", .state = "active"};

bool Finds(const std::string& word, const SystemItem& item) {
  const auto term = FindTerm::Parse(word);
  EXPECT_TRUE(term) << term.error().message;
  return term && term->Fits(item);
}

TEST(FindTerm, MatchesASubstringOrAGlobOfThePath) {
  EXPECT_TRUE(Finds("moveto", kGoal));
  EXPECT_TRUE(Finds("robot/**", kGoal));
  EXPECT_FALSE(Finds("arm*", kGoal));
  EXPECT_FALSE(Finds("robots", kGoal));
}

TEST(FindTerm, TypeMatchesTheKindOrThePayload) {
  EXPECT_TRUE(Finds("type:command", kGoal));
  EXPECT_TRUE(Finds("type:cmd", kGoal));
  EXPECT_TRUE(Finds("type:jointgoal", kGoal));
  EXPECT_TRUE(Finds("type:arm.*", kGoal));
  EXPECT_FALSE(Finds("type:event", kGoal));
  EXPECT_TRUE(Finds("type:required", kRobot));
  EXPECT_TRUE(Finds("type:req", kRobot));
  EXPECT_FALSE(Finds("type:prov", kRobot));
}

TEST(FindTerm, TypeMatchesArgumentAndResult) {
  const SystemItem pose{.path = "robot/arm/Control.GetLinkPose",
                        .kind = "command",
                        .type = "arm.LinkId -> geometry_msgs.Pose"};
  EXPECT_TRUE(Finds("type:arm.*", pose));
  EXPECT_TRUE(Finds("type:geometry_msgs.*", pose));
  EXPECT_TRUE(Finds("type:/LinkId -> geo/", pose));
  EXPECT_FALSE(Finds("type:arm.*Pose", pose));
}

TEST(FindTerm, MatchesStateHostAndProcess) {
  EXPECT_TRUE(Finds("state:active", kRobot));
  EXPECT_FALSE(Finds("state:active", kGoal));
  EXPECT_TRUE(Finds("host:lab", kGoal));
  EXPECT_TRUE(Finds("proc:ro*", kGoal));
  EXPECT_FALSE(Finds("proc:robot", kRobot));  // "robot" here is an interface, not a process
}

TEST(FindTerm, AnExclamationMarkNegates) {
  EXPECT_FALSE(Finds("!moveto", kGoal));
  EXPECT_TRUE(Finds("!moveto", kRobot));
  EXPECT_FALSE(Finds("state:!active", kRobot));
  EXPECT_TRUE(Finds("state:!active", kGoal));
  EXPECT_TRUE(Finds("!state:!active", kRobot));
}

TEST(FindTerm, SlashesEncloseARegularExpression) {
  EXPECT_TRUE(Finds("/arm.*\\.(get|move)To$/", kGoal));
  EXPECT_FALSE(Finds("/^arm/", kGoal));
  EXPECT_FALSE(Finds("!/MoveTo/", kGoal));
  EXPECT_TRUE(Finds("type:/^arm\\.\\w+$/", kGoal));
  EXPECT_TRUE(Finds("type:/^req/", kRobot));
  EXPECT_TRUE(Finds("state:!/^a.*d$/", kRobot));
  EXPECT_TRUE(Finds("/[:t]el/", kRobot));  // the colon belongs to the expression, not to a key
}

TEST(FindTerm, RejectsABadExpression) {
  const auto term = FindTerm::Parse("!type:/a(b/");
  ASSERT_FALSE(term);
  EXPECT_EQ(term.error().message,
            "'!type:/a(b/': missing ) at 'a(b'; expected an expression such as Get|Set");
}

TEST(FindTerm, RejectsAnUnknownKey) {
  const auto term = FindTerm::Parse("tipe:x");
  ASSERT_FALSE(term);
  EXPECT_EQ(
      term.error().message,
      "'tipe:x': there is no 'tipe:'; did you mean 'type'? the known keys are type:, state:, host: "
      "and proc:");
}

}  // namespace
