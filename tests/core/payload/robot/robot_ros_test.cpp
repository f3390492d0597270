#include <gtest/gtest.h>
#include <tendon/payload/schema.h>

#include <sstream>
#include <string>

#include "core/payload/fast_cdr.h"
#include "samples.h"
#include "support/encoded.h"

/// Compares with ROS 2: its message definitions, without their comments, and the bytes of Fast CDR.
namespace tendon::robot {
namespace {

using eprosima::fastcdr::Cdr;
using test::Encoded;
using test::WrittenByFastCdr;

/// Returns the definition without comments and separator lines.
std::string Definition(const Schema& schema) {
  std::string out;
  std::istringstream text(RosMessage(schema));
  for (std::string line; std::getline(text, line);) {
    line = line.substr(0, line.find('#'));
    while (!line.empty() && line.back() == ' ') line.pop_back();
    if (!line.empty() && line.front() != '=') out += line + "\n";
  }
  return out;
}

const std::string kHeader =
    "MSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n";
const std::string kTime = "MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n";
const std::string kVector3 = "MSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n";
const std::string kQuaternion =
    "MSG: geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w\n";

TEST(RobotRos, APoseEqualsThatOfRos) {
  EXPECT_EQ(RosTypeName(SchemaOf<Pose>()), "geometry_msgs/msg/Pose");
  EXPECT_EQ(Definition(SchemaOf<Pose>()),
            "geometry_msgs/Point position\n"
            "geometry_msgs/Quaternion orientation\n"
            "MSG: geometry_msgs/Point\nfloat64 x\nfloat64 y\nfloat64 z\n" +
                kQuaternion);
}

TEST(RobotRos, TwistAndWrenchEqualThoseOfRos) {
  EXPECT_EQ(Definition(SchemaOf<Twist>()),
            "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n" + kVector3);
  EXPECT_EQ(Definition(SchemaOf<Wrench>()),
            "geometry_msgs/Vector3 force\ngeometry_msgs/Vector3 torque\n" + kVector3);
}

TEST(RobotRos, TransformsEqualThoseOfTf2) {
  EXPECT_EQ(RosTypeName(SchemaOf<Transforms>()), "tf2_msgs/msg/TFMessage");
  EXPECT_EQ(Definition(SchemaOf<TransformStamped>()),
            "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform\n" +
                kTime + kHeader + kVector3 + kQuaternion +
                "MSG: geometry_msgs/Transform\n"
                "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n");
}

TEST(RobotRos, NamedJointsEqualThoseOfRos) {
  EXPECT_EQ(RosTypeName(SchemaOf<NamedJointState>()), "sensor_msgs/msg/JointState");
  EXPECT_EQ(Definition(SchemaOf<NamedJointState>()),
            "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\n"
            "float64[] effort\n" +
                kTime + kHeader);
}

TEST(RobotRos, JoystickAndImageEqualThoseOfRos) {
  EXPECT_EQ(RosTypeName(SchemaOf<Joystick>()), "sensor_msgs/msg/Joy");
  EXPECT_EQ(Definition(SchemaOf<Joystick>()),
            "std_msgs/Header header\nfloat32[] axes\nint32[] buttons\n" + kTime + kHeader);
  EXPECT_EQ(RosTypeName(SchemaOf<Image>()), "sensor_msgs/msg/Image");
  EXPECT_EQ(Definition(SchemaOf<Image>()),
            "std_msgs/Header header\nuint32 height\nuint32 width\nstring encoding\n"
            "uint8 is_bigendian\nuint32 step\nuint8[] data\n" +
                kTime + kHeader);
}

void WriteHeader(Cdr& cdr) { cdr << std::int32_t{1} << std::uint32_t{500'000'042} << "base"; }

TEST(RobotRos, AStampedTransformHasTheBytesOfFastCdr) {
  EXPECT_EQ(Encoded(Sample<TransformStamped>()), WrittenByFastCdr([](Cdr& cdr) {
              WriteHeader(cdr);
              cdr << "tool" << 1.0 << -2.0 << 3.0 << 0.5 << -0.5 << 0.5 << -0.5;
            }));
}

TEST(RobotRos, AJoystickHasTheBytesOfFastCdr) {
  EXPECT_EQ(Encoded(Sample<Joystick>()), WrittenByFastCdr([](Cdr& cdr) {
              WriteHeader(cdr);
              cdr << std::vector<float>{-1, 0.5F, 1} << std::vector<std::int32_t>{0, 1, 1, 0};
            }));
}

TEST(RobotRos, AnImageHasTheBytesOfFastCdr) {
  EXPECT_EQ(Encoded(Sample<Image>()), WrittenByFastCdr([](Cdr& cdr) {
              WriteHeader(cdr);
              cdr << std::uint32_t{2} << std::uint32_t{1} << "rgb8" << std::uint8_t{1}
                  << std::uint32_t{4} << std::vector<std::uint8_t>{1, 2, 3, 0, 255, 254, 253, 0};
            }));
}

}  // namespace
}  // namespace tendon::robot
