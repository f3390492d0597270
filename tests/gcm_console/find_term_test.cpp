#include <gcm_console/catalogue/find_term.h>
#include <gtest/gtest.h>

namespace {

using console::FindTerm;
using console::Thing;

const Thing kGoal{.path = "robot/arm/Control.MoveTo",
                  .noun = "command",
                  .type = "arm.JointGoal",
                  .state = "",
                  .host = "lab"};
const Thing kRobot{
    .path = "desk/teleoperation/Robot", .noun = "required interface", .state = "active"};

bool Finds(const std::string& word, const Thing& thing) {
  const auto term = FindTerm::Parse(word);
  EXPECT_TRUE(term) << term.error().message;
  return term && term->Fits(thing);
}

TEST(FindTerm, IsAPartOfThePathOrAllOfIt) {
  EXPECT_TRUE(Finds("moveto", kGoal));
  EXPECT_TRUE(Finds("robot/**", kGoal));
  EXPECT_FALSE(Finds("arm*", kGoal));
  EXPECT_FALSE(Finds("robots", kGoal));
}

TEST(FindTerm, OfATypeIsWhatItIsOrWhatItCarries) {
  EXPECT_TRUE(Finds("type:command", kGoal));
  EXPECT_TRUE(Finds("type:cmd", kGoal));
  EXPECT_TRUE(Finds("type:jointgoal", kGoal));
  EXPECT_TRUE(Finds("type:arm.*", kGoal));
  EXPECT_FALSE(Finds("type:event", kGoal));
  EXPECT_TRUE(Finds("type:required", kRobot));
  EXPECT_TRUE(Finds("type:req", kRobot));
  EXPECT_FALSE(Finds("type:prov", kRobot));
}

TEST(FindTerm, OfAQuestionAndItsAnswerEachTypeIsFound) {
  const Thing pose{.path = "robot/arm/Control.GetLinkPose",
                   .noun = "command",
                   .type = "arm.LinkId -> geometry_msgs.Pose"};
  EXPECT_TRUE(Finds("type:arm.*", pose));
  EXPECT_TRUE(Finds("type:geometry_msgs.*", pose));
  EXPECT_TRUE(Finds("type:/LinkId -> geo/", pose));
  EXPECT_FALSE(Finds("type:arm.*Pose", pose));
}

TEST(FindTerm, LooksAtStateHostAndProcess) {
  EXPECT_TRUE(Finds("state:active", kRobot));
  EXPECT_FALSE(Finds("state:active", kGoal));
  EXPECT_TRUE(Finds("host:lab", kGoal));
  EXPECT_TRUE(Finds("proc:ro*", kGoal));
  EXPECT_FALSE(Finds("proc:robot", kRobot));  // that is the interface
}

TEST(FindTerm, AnExclamationMarkTurnsItAround) {
  EXPECT_FALSE(Finds("!moveto", kGoal));
  EXPECT_TRUE(Finds("!moveto", kRobot));
  EXPECT_FALSE(Finds("state:!active", kRobot));
  EXPECT_TRUE(Finds("state:!active", kGoal));
  EXPECT_TRUE(Finds("!state:!active", kRobot));
}

TEST(FindTerm, BetweenSlashesIsARegularExpression) {
  EXPECT_TRUE(Finds("/arm.*\\.(get|move)To$/", kGoal));
  EXPECT_FALSE(Finds("/^arm/", kGoal));
  EXPECT_FALSE(Finds("!/MoveTo/", kGoal));
  EXPECT_TRUE(Finds("type:/^arm\\.\\w+$/", kGoal));
  EXPECT_TRUE(Finds("type:/^req/", kRobot));
  EXPECT_TRUE(Finds("state:!/^a.*d$/", kRobot));
  EXPECT_TRUE(Finds("/[:t]el/", kRobot));  // no key
}

TEST(FindTerm, AnExpressionThatIsNoneIsRefused) {
  const auto term = FindTerm::Parse("!type:/a(b/");
  ASSERT_FALSE(term);
  EXPECT_EQ(term.error().message,
            "'!type:/a(b/': missing ) at 'a(b'; expected an expression such as Get|Set");
}

TEST(FindTerm, AKeyThatThereIsNotIsNamed) {
  const auto term = FindTerm::Parse("tipe:x");
  ASSERT_FALSE(term);
  EXPECT_EQ(term.error().message,
            "'tipe:x': there is no 'tipe:'; did you mean 'type'? known are type:, state:, host: "
            "and proc:");
}

}  // namespace
