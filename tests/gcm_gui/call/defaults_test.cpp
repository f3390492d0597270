#include <gcm_gui/call/call_panel.h>
#include <gcm_gui/call/defaults/common_fields.h>
#include <gcm_gui/call/defaults/matching_read.h>
#include <gmock/gmock.h>

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

#include "support/fakes.h"

namespace tendon::gui {
namespace {

MemberDescription MemberOf(const std::string& name, CommandKind kind) {
  MemberDescription member;
  member.name = name;
  member.signature.kind = kind;
  return member;
}

std::vector<std::string> NamesOf(const std::vector<MatchingRead>& reads) {
  std::vector<std::string> names;
  for (const MatchingRead& read : reads) names.push_back(read.name + (read.is_whole ? "" : " ~"));
  return names;
}

TEST(MatchingReads, BeginWithOneThatAnswersTheTypeAndIsNamedLikewise) {
  MemberDescription set = MemberOf("SetGains", CommandKind::kWrite);
  MemberDescription other = MemberOf("GetDefaults", CommandKind::kRead);
  MemberDescription get = MemberOf("GetGains", CommandKind::kRead);
  MemberDescription load = MemberOf("GetLoad", CommandKind::kRead);
  set.signature.in = FingerprintOf<double>();
  for (MemberDescription* read : {&other, &get}) read->signature.out = set.signature.in;
  load.signature.out = FingerprintOf<std::int32_t>();
  const auto reads = [&](const std::vector<MemberDescription>& commands) {
    return NamesOf(MatchingReads({.name = "Control", .commands = commands}, set));
  };

  EXPECT_THAT(reads({load, other, get, set}), testing::ElementsAre("GetGains"));
  EXPECT_THAT(reads({load, other, set}), testing::IsEmpty()) << "any number is like any other";
  set.in_type = "arm.Gains";
  EXPECT_THAT(reads({load, other, set}), testing::ElementsAre("GetDefaults"));
  EXPECT_THAT(reads({load, set}), testing::IsEmpty());
  EXPECT_THAT(NamesOf(MatchingReads({.name = "Control", .commands = {load, set}}, load)),
              testing::IsEmpty());
}

TEST(MatchingReads, GoOnWithThoseThatAnswerAnotherStructure) {
  MemberDescription move = MemberOf("MoveTo", CommandKind::kWrite);
  move.signature.in = FingerprintOf<double>();
  move.in_type = "arm.JointGoal";
  MemberDescription joints = MemberOf("GetJoints", CommandKind::kRead);
  joints.out_type = "arm.JointState";
  MemberDescription pose = MemberOf("GetPose", CommandKind::kQualifiedRead);
  pose.out_type = "arm.Pose";

  EXPECT_THAT(NamesOf(MatchingReads({.name = "Control", .commands = {pose, joints, move}}, move)),
              testing::ElementsAre("GetJoints ~"));
}

Schema Numbers(std::uint32_t length) {
  return Schema::Array(Schema(Schema::Kind::kFloat64), length);
}

Schema PostureSchema() {
  return Schema::Structure("arm.JointGoal", {{"position", "rad", Numbers(2)},
                                             {"duration", "s", Schema(Schema::Kind::kFloat64)}});
}

TEST(CommonFields, AreThoseOfTheSameNameUnitAndShape) {
  using testing::ElementsAre;
  using testing::IsEmpty;
  EXPECT_THAT(CommonFields(PostureSchema(), JointSchema(2)), ElementsAre("position"));
  EXPECT_THAT(CommonFields(PostureSchema(), JointSchema(3)), IsEmpty()) << "another shape";
  const Schema degrees = Schema::Structure("arm.JointState", {{"position", "deg", Numbers(2)}});
  EXPECT_THAT(CommonFields(PostureSchema(), degrees), IsEmpty()) << "another unit";
  EXPECT_THAT(CommonFields(PostureSchema(), Numbers(2)), IsEmpty());
}

TEST(CommonFields, AreTakenAndTheOthersStay) {
  EXPECT_EQ(WithFieldsOf(R"({"position":[0,0],"duration":1.5})",
                         R"({"position":[0.1,-1.5],"velocity":[3,4]})", {"position"}),
            R"({"position":[0.1,-1.5],"duration":1.5})");
  EXPECT_EQ(WithFieldsOf(R"({"position":[0,0]})", "nonsense", {"position"}),
            R"({"position":[0,0]})");
}

/// A form whose reading has another type, as the demo's MoveTo.
class FormDefaultsTest : public ::testing::Test {
 protected:
  FormDefaultsTest() {
    calls_.schema = PostureSchema();
    calls_.schemas[FingerprintOf<double>()] = JointSchema(2);
    calls_.schemas[FingerprintOf<float>()] = Numbers(2);
    panel_.resize(312, 400);
  }

  void Open() {
    panel_.showCommand("robot/arm/Control.MoveTo", MemberOf("MoveTo", CommandKind::kWrite),
                       {{.name = "GetTool", .type = FingerprintOf<float>(), .is_whole = false},
                        {.name = "GetJoints", .type = FingerprintOf<double>(), .is_whole = false}});
    panel_.show();
  }
  QString Field(const char* name) { return panel_.findChild<QLineEdit*>(name)->text(); }
  QString Status() { return panel_.findChild<QLabel*>("call.status")->text(); }

  ScriptedCalls calls_;
  CallPanel panel_{calls_};
};

TEST_F(FormDefaultsTest, BeginsWhereTheArmIs) {
  Open();
  ASSERT_EQ(calls_.read, QStringList{"robot/arm/Control.GetJoints"});

  calls_.value(std::string(R"({"position":[0.1,-1.5],"velocity":[3,4]})"));

  EXPECT_EQ(Status(), "position as GetJoints says now");
  QTest::mouseClick(panel_.findChild<QPushButton*>("call.call"), Qt::LeftButton);
  ASSERT_EQ(calls_.calls.size(), 1);
  EXPECT_THAT(calls_.calls[0].toStdString(), testing::HasSubstr(R"("position":[0.1,-1.5])"));
}

TEST_F(FormDefaultsTest, SaysThatItsValuesAreNotThePresentOnes) {
  Open();

  calls_.value(Error{ErrorCode::kTimeout, "no answer"});

  EXPECT_EQ(Status(), "Not the present values: GetJoints does not say them");
}

}  // namespace
}  // namespace tendon::gui
