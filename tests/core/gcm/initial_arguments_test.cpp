#include <gmock/gmock.h>
#include <tendon/gcm/initial_arguments.h>
#include <tests/core/gcm/argument_samples.h>

namespace tendon {
namespace {

using test::JointGoalSchema;
using test::JointStateSchema;
using test::MemberOf;
using test::Numbers;

std::vector<std::string> NamesOfReads(const std::vector<MatchingRead>& reads) {
  std::vector<std::string> names;
  for (const MatchingRead& read : reads) names.push_back(read.name + (read.is_whole ? "" : " ~"));
  return names;
}

TEST(MatchingReads, PreferAReadOfTheSameTypeAndName) {
  MemberDescription set = MemberOf("SetGains", CommandKind::kWrite);
  MemberDescription other = MemberOf("GetDefaults", CommandKind::kRead);
  MemberDescription get = MemberOf("GetGains", CommandKind::kRead);
  MemberDescription load = MemberOf("GetLoad", CommandKind::kRead);
  set.signature.in = FingerprintOf<double>();
  for (MemberDescription* read : {&other, &get}) read->signature.out = set.signature.in;
  load.signature.out = FingerprintOf<std::int32_t>();
  const auto reads = [&](const std::vector<MemberDescription>& commands) {
    return NamesOfReads(MatchingReads({.name = "Control", .commands = commands}, set));
  };

  EXPECT_THAT(reads({load, other, get, set}), testing::ElementsAre("GetGains"));
  EXPECT_THAT(reads({load, other, set}), testing::IsEmpty()) << "any number is like any other";
  set.in_type = "arm.Gains";
  EXPECT_THAT(reads({load, other, set}), testing::ElementsAre("GetDefaults"));
  EXPECT_THAT(reads({load, set}), testing::IsEmpty());
  EXPECT_THAT(NamesOfReads(MatchingReads({.name = "Control", .commands = {load, set}}, load)),
              testing::IsEmpty());
}

TEST(MatchingReads, IncludeReadsOfAnotherStructureLast) {
  MemberDescription move = MemberOf("MoveTo", CommandKind::kWrite);
  move.signature.in = FingerprintOf<double>();
  move.in_type = "arm.JointGoal";
  MemberDescription joints = MemberOf("GetJoints", CommandKind::kRead);
  joints.out_type = "arm.JointState";
  MemberDescription pose = MemberOf("GetPose", CommandKind::kQualifiedRead);
  pose.out_type = "arm.Pose";

  EXPECT_THAT(
      NamesOfReads(MatchingReads({.name = "Control", .commands = {pose, joints, move}}, move)),
      testing::ElementsAre("GetJoints ~"));
}

TEST(CommonFields, HaveTheSameNameUnitAndShape) {
  using testing::ElementsAre;
  using testing::IsEmpty;
  EXPECT_THAT(CommonFields(JointGoalSchema(2), JointStateSchema(2)), ElementsAre("position"));
  EXPECT_THAT(CommonFields(JointGoalSchema(2), JointStateSchema(3)), IsEmpty()) << "another shape";
  const Schema degrees = Schema::Structure("arm.JointState", {{"position", "deg", Numbers(2)}});
  EXPECT_THAT(CommonFields(JointGoalSchema(2), degrees), IsEmpty()) << "another unit";
  EXPECT_THAT(CommonFields(JointGoalSchema(2), Numbers(2)), IsEmpty());
  const Schema image = Schema::Structure(
      "arm.Image", {{"position", "rad", Numbers(2)}, {"data", "", Schema::Sequence(Numbers(2))}});
  EXPECT_THAT(CommonFields(JointGoalSchema(2), image), IsEmpty()) << "it may be large";
}

TEST(CommonFields, AreCopiedAndOtherFieldsKept) {
  EXPECT_EQ(WithFieldsOf(R"({"position":[0,0],"duration":1.5})",
                         R"({"position":[0.1,-1.5],"velocity":[3,4]})", {"position"}),
            R"({"position":[0.1,-1.5],"duration":1.5})");
  EXPECT_EQ(WithFieldsOf(R"({"position":[0,0]})", "nonsense", {"position"}),
            R"({"position":[0,0]})");
}

}  // namespace
}  // namespace tendon
