#include <gcm_console/catalogue/path_target.h>
#include <gtest/gtest.h>
#include <tests/core/gcm/samples.h>

namespace console {
namespace {

using tendon::ErrorCode;

class PathTargetTest : public testing::Test {
 protected:
  PathTargetTest() {
    using Kind = tendon::CatalogueChange::Kind;
    Apply({.kind = Kind::kProcess,
           .process = "robot",
           .processes = {tendon::test::ProcessNamed("robot", 1)}});
    for (const auto& component : {tendon::test::Arm(), tendon::test::Teleoperation()}) {
      Apply({.kind = Kind::kComponent, .process = "robot", .components = {component}});
    }
  }

  void Apply(tendon::CatalogueChange change) {
    change.revision = catalogue_.revision() + 1;
    EXPECT_TRUE(catalogue_.Apply(change));
  }

  /// Returns the types of a member, as in the column TYPE.
  std::string Types(const std::string& path) {
    const auto target = FindTarget(catalogue_, path);
    EXPECT_TRUE(target) << target.error().message;
    return target ? TypesOf(*target->member) : "";
  }
  tendon::Error ErrorOf(const std::string& path) {
    const auto target = FindTarget(catalogue_, path);
    EXPECT_FALSE(target) << path;
    return target ? tendon::Error{} : target.error();
  }

  tendon::Catalogue catalogue_;
};

TEST_F(PathTargetTest, FindsTheTargetAtEachDepth) {
  EXPECT_EQ(FindTarget(catalogue_, "robot")->component, nullptr);
  EXPECT_EQ(FindTarget(catalogue_, "robot/arm")->component->name, "arm");
  EXPECT_EQ(FindTarget(catalogue_, "robot/arm/Control")->provided->name, "Control");
  EXPECT_EQ(FindTarget(catalogue_, "robot/teleoperation/Robot")->required->name, "Robot");
  EXPECT_EQ(FindTarget(catalogue_, "robot/arm/Control.Stop")->noun, "command");
  EXPECT_EQ(FindTarget(catalogue_, "robot/teleoperation/Robot.MoveTo")->noun, "function");
}

TEST_F(PathTargetTest, ShowsTypesOfArgumentAndResult) {
  EXPECT_EQ(Types("robot/arm/Control.Stop"), "");
  EXPECT_EQ(Types("robot/arm/Control.MoveTo"), "float64[7]");
  EXPECT_EQ(Types("robot/arm/Control.GetJoints"), "float64[7]");
  EXPECT_EQ(Types("robot/arm/Control.Scale"), "float64 -> float64[7]");
}

TEST_F(PathTargetTest, ShowsNoTypeForNone) {
  tendon::MemberDescription stop{
      .name = "Stop",
      .signature = tendon::SignatureOf<tendon::None, tendon::None>(tendon::CommandKind::kVoid),
      .in_type = "tendon.None",
      .out_type = "tendon.None"};
  EXPECT_EQ(TypesOf(stop), "");
}

TEST_F(PathTargetTest, SuggestsSimilarNamesForMissingOnes) {
  EXPECT_EQ(ErrorOf("robt").message, "no process 'robt'; did you mean 'robot'?");
  EXPECT_EQ(ErrorOf("robot/arn").message, "no component 'robot/arn'; did you mean 'arm'?");
  EXPECT_EQ(ErrorOf("robot/arm/Contrl").message,
            "no interface 'robot/arm/Contrl'; did you mean 'Control'?");
  EXPECT_EQ(ErrorOf("robot/arm/Control.Stp").message,
            "no member 'robot/arm/Control.Stp'; did you mean 'Stop'?");
  EXPECT_EQ(ErrorOf("robot/arm/Control.Stp").code, ErrorCode::kNotFound);
  EXPECT_EQ(ErrorOf("robot/arm/Control.GetJoints[0]").code, ErrorCode::kInvalid);
}

}  // namespace
}  // namespace console
