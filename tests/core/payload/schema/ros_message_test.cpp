#include <gtest/gtest.h>
#include <tendon/payload/schema.h>
#include <tests/core/payload/sample_types.h>

namespace tendon {
namespace {

const std::string kRule(80, '=');

TEST(RosMessage, HasFieldsWithUnitsAsComments) {
  EXPECT_EQ(RosTypeName(SchemaOf<sample::JointState>()), "sample/msg/JointState");
  EXPECT_EQ(RosMessage(SchemaOf<sample::JointState>()),
            "float64[7] position  # rad\n"
            "float64[7] velocity  # rad/s\n");
}

TEST(RosMessage, AppendsEachNestedMessageOnce) {
  const Schema& point = SchemaOf<sample::Point>();
  const Schema schema = Schema::Structure(
      "arm.kinematics.Path", {{"start", "", point}, {"via", "m", Schema::Sequence(point)}});

  EXPECT_EQ(RosTypeName(schema), "arm_kinematics/msg/Path");
  EXPECT_EQ(RosMessage(schema),
            "sample/Point start\n"
            "sample/Point[] via  # m\n" +
                kRule +
                "\nMSG: sample/Point\n"
                "float64 x\nfloat64 y\nfloat64 z\n");
}

TEST(RosMessage, AnEnumIsAnInt32WithConstants) {
  const Schema schema = Schema::Structure("arm.A", {{"mode", "", SchemaOf<sample::Mode>()}});

  EXPECT_EQ(RosMessage(schema),
            "int32 MODE_OFF=0\nint32 MODE_TRACKING=5\nint32 MODE_FAULT=-1\nint32 mode\n");
}

TEST(RosMessage, ADurationEqualsThatOfRos) {
  const Schema schema =
      Schema::Structure("arm.A", {{"period", "", SchemaOf<std::chrono::seconds>()}});

  EXPECT_EQ(RosMessage(schema), "builtin_interfaces/Duration period\n" + kRule +
                                    "\nMSG: builtin_interfaces/Duration\n"
                                    "int32 sec\nuint32 nanosec\n");
}

TEST(RosMessage, NestedListsAreFlattenedOrBecomeMessages) {
  using Grid = std::array<std::array<float, 2>, 3>;
  const Schema schema = Schema::Structure(
      "arm.A", {{"grid", "", SchemaOf<Grid>()},
                {"via_points", "", SchemaOf<std::vector<std::array<double, 3>>>()}});

  EXPECT_EQ(RosMessage(schema),
            "float32[6] grid\n"
            "arm/AViaPoints[] via_points\n" +
                kRule +
                "\nMSG: arm/AViaPoints\n"
                "float64[3] data\n");
}

TEST(RosMessage, OfNoneIsEmptyAndOfANumberHasOneField) {
  EXPECT_EQ(RosMessage(SchemaOf<None>()), "");
  EXPECT_EQ(RosTypeName(SchemaOf<double>()), "tendon/msg/Value");
  EXPECT_EQ(RosMessage(SchemaOf<double>()), "float64 data\n");
}

}  // namespace
}  // namespace tendon
