#include <gcm_console/completion/path_completion.h>
#include <gtest/gtest.h>
#include <tests/core/gcm/samples.h>

namespace console {
namespace {

class WholePathTest : public testing::Test {
 protected:
  WholePathTest() {
    using Kind = tendon::CatalogueChange::Kind;
    for (const std::string process : {"robot", "desk"}) {
      Apply({.kind = Kind::kProcess,
             .process = process,
             .processes = {tendon::test::ProcessNamed(process, 1)}});
    }
    for (const auto& component :
         {tendon::test::Arm(), tendon::test::Arm("arm2"), tendon::test::Teleoperation("tele")}) {
      Apply({.kind = Kind::kComponent, .process = "robot", .components = {component}});
    }
  }
  void Apply(tendon::CatalogueChange change) {
    change.revision = catalogue_.revision() + 1;
    EXPECT_TRUE(catalogue_.Apply(change));
  }

  tendon::Catalogue catalogue_;
};

TEST_F(WholePathTest, ExpandsAnUnambiguousPrefix) {
  EXPECT_EQ(WholePath(catalogue_, WordKind::kProcess, "r"), "robot");
  EXPECT_EQ(WholePath(catalogue_, WordKind::kComponent, "r/t"), "robot/tele");
  EXPECT_EQ(WholePath(catalogue_, WordKind::kRequired, "r/t/R"), "robot/tele/Robot");
  EXPECT_EQ(WholePath(catalogue_, WordKind::kCommand, "r/arm2/C.S"), "r/arm2/C.S");  // Stop, Scale
  EXPECT_EQ(WholePath(catalogue_, WordKind::kCommand, "r/arm2/C.St"), "robot/arm2/Control.Stop");
}

TEST_F(WholePathTest, AnExactNameWinsOverLongerNames) {
  EXPECT_EQ(WholePath(catalogue_, WordKind::kProvided, "r/arm/C"), "robot/arm/Control");
  EXPECT_EQ(WholePath(catalogue_, WordKind::kComponent, "r/a"), "r/a");  // arm, arm2
}

TEST_F(WholePathTest, FieldsOfAMemberStayAsTheyAre) {
  EXPECT_EQ(WholePath(catalogue_, WordKind::kCommand, "r/arm/C.G[2]"),
            "robot/arm/Control.GetJoints[2]");
  EXPECT_EQ(WholePath(catalogue_, WordKind::kCommand, "r/arm/C.G.x[0].y"),
            "robot/arm/Control.GetJoints.x[0].y");
}

TEST_F(WholePathTest, KeepsUnknownNamesAndPatterns) {
  for (const std::string path : {"x", "r/x", "r/*", "**", "", "r//", "/", "r/arm/C.M.", "r/"}) {
    const std::string whole = WholePath(catalogue_, WordKind::kPath, path);
    if (path == "r/arm/C.M.") {
      EXPECT_EQ(whole, "robot/arm/Control.MoveTo.");
    } else {
      EXPECT_EQ(whole, path);
    }
  }
}

TEST_F(WholePathTest, UsesTheTopLevelIfNoLocalNameMatches) {
  EXPECT_EQ(PathFrom(catalogue_, "robot", "arm/Control"), "robot/arm/Control");
  EXPECT_EQ(PathFrom(catalogue_, "robot", "robot/arm/Control.Stop"), "robot/arm/Control.Stop");
  EXPECT_EQ(PathFrom(catalogue_, "robot/arm", "desk/"), "desk");
  EXPECT_EQ(PathFrom(catalogue_, "robot", "desk"), "robot/desk") << "what is gone is no process";
  EXPECT_EQ(PathFrom(catalogue_, "robot", "nothing/arm"), "robot/nothing/arm");
  EXPECT_EQ(PathFrom(catalogue_, "robot/arm", "r/a/s"), "r/a/s") << "short, from the top";
  EXPECT_EQ(PathFrom(catalogue_, "robot/arm", ".."), "robot");
  EXPECT_EQ(PathFrom(catalogue_, "", "robot/arm"), "robot/arm");

  Apply({.kind = tendon::CatalogueChange::Kind::kComponent,
         .process = "robot",
         .components = {tendon::test::Arm("desk")}});
  EXPECT_EQ(PathFrom(catalogue_, "robot", "desk/Control"), "robot/desk/Control");
  Apply({.kind = tendon::CatalogueChange::Kind::kProcess,
         .process = "t",
         .processes = {tendon::test::ProcessNamed("t", 1)}});
  EXPECT_EQ(PathFrom(catalogue_, "robot", "t/Robot"), "robot/t/Robot") << "short for tele";
}

}  // namespace
}  // namespace console
