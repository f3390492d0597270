#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/payload/json.h>
#include <tendon/payload/schema/ros_parser.h>
#include <tests/core/payload/random_value.h>
#include <tests/core/payload/sample_types.h>

#include <random>
#include <string>

namespace tendon {
namespace {

using testing::HasSubstr;

constexpr const char* kPoseStamped = R"(# A pose with a frame
std_msgs/Header header
Pose pose
================================================================================
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
================================================================================
MSG: geometry_msgs/Pose
Point position
geometry_msgs/msg/Quaternion orientation
================================================================================
MSG: geometry_msgs/Point
float64 x
float64 y 0.5
float64 z  # in m
================================================================================
MSG: geometry_msgs/Quaternion
float64 x 0
float64 w 1
)";

TEST(RosParser, ReadsNestedMessagesOfSeveralPackages) {
  const auto schema = ParseRosMessage("geometry_msgs/msg/PoseStamped", kPoseStamped);

  ASSERT_TRUE(schema) << schema.error().message;
  EXPECT_EQ(schema->Text(), R"(struct geometry_msgs.PoseStamped {
  header: struct std_msgs.Header {
    stamp: duration
    frame_id: string
  }
  pose: struct geometry_msgs.Pose {
    position: struct geometry_msgs.Point {
      x: float64
      y: float64
      z: float64
    }
    orientation: struct geometry_msgs.Quaternion {
      x: float64
      w: float64
    }
  }
})");
}

TEST(RosParser, ReadsBoundsDefaultsListsAndLeavesOutConstants) {
  const auto schema = ParseRosMessage("a/msg/B",
                                      "int32 SPEED=5\n"
                                      "string NAME = \"a # b\"\r\n"
                                      "string<=10 text \"x = y\"\r\n"
                                      "char[3] letters [1, 2, 3]\n"
                                      "\tbyte[<=4]\tdata # up to four\n"
                                      "string<=5[<=10] names\n"
                                      "builtin_interfaces/msg/Duration[] spans\n");

  ASSERT_TRUE(schema) << schema.error().message;
  EXPECT_EQ(schema->Text(),
            "struct a.B {\n  text: string\n  letters: uint8[3]\n  data: uint8[]\n"
            "  names: string[]\n  spans: duration[]\n}");
}

TEST(RosParser, AnEmptyMessageTakesAByteAsInRos) {
  const auto schema = ParseRosMessage("std_msgs/msg/Empty", "# nothing\n");

  ASSERT_TRUE(schema);
  EXPECT_TRUE(schema->is_none());
}

/// The bytes of a value mean the same by the text that we print as by our own schema.
template <typename T>
void ExpectSameBytes() {
  std::mt19937 random(8);
  T value{};
  sample::Randomise(random, value);
  std::vector<std::byte> body;
  Encode(value, body);

  const auto schema = ParseRosMessage(RosTypeName(SchemaOf<T>()), RosMessage(SchemaOf<T>()));

  ASSERT_TRUE(schema) << schema.error().message;
  const auto json = ToJson(*schema, body);
  ASSERT_TRUE(json) << json.error().message;
  const auto again = FromJson(*schema, *json);
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(*again, body);
}

TEST(RosParser, ReadsWhatWePrint) {
  ExpectSameBytes<sample::Numbers>();
  ExpectSameBytes<sample::JointState>();
  ExpectSameBytes<sample::Dynamic>();
  ExpectSameBytes<sample::Fixed>();
}

std::string MistakeIn(const std::string& text) {
  const auto schema = ParseRosMessage("a/msg/B", text);
  return schema ? "" : schema.error().message;
}

TEST(RosParser, RefusesWhatItCannotReadRight) {
  EXPECT_THAT(MistakeIn("Pose pose\n"), HasSubstr("the definition of 'Pose' is missing"));
  EXPECT_THAT(MistakeIn("wstring text\n"), HasSubstr("wstring is not read"));
  EXPECT_THAT(MistakeIn("float64\n"), HasSubstr("'float64' is no field"));
  EXPECT_THAT(MistakeIn("float64[x] y\n"), HasSubstr("'float64[x]' is no type"));
  EXPECT_THAT(MistakeIn("float64[4294967295] y\nfloat64 y\n"), HasSubstr("2 GiB"));
  EXPECT_THAT(MistakeIn("float64 y\nfloat64 y\n"), HasSubstr("two fields have this name"));
  EXPECT_THAT(MistakeIn("B inner\n"), HasSubstr("the message contains itself"));
  EXPECT_THAT(MistakeIn("C inner\n===\nMSG: a/C\nB inner\n"), HasSubstr("contains itself"));
  EXPECT_THAT(MistakeIn("Point p\n===\nMSG: b/Point\nbool x\n===\nMSG: c/Point\nbool x\n"),
              HasSubstr("the definition of 'Point' is missing"));
  EXPECT_FALSE(ParseRosMessage("", "float64 x\n"));
  EXPECT_FALSE(ParseRosMessage("a/msg/B", std::string((1U << 20U) + 1, '\n')));
}

TEST(RosParser, RefusesATypeThatGrowsWithoutBounds) {
  std::string text = "M0 a\nM0 b\n";
  for (int i = 0; i < 60; ++i) {
    const std::string next = "M" + std::to_string(i + 1);
    text += "===\nMSG: a/M" + std::to_string(i) + "\n" + next + " a\n" + next + " b\n";
  }
  text += "===\nMSG: a/M60\nbool x\n";

  EXPECT_THAT(MistakeIn(text), HasSubstr("more than 1 MiB of text"));
}

}  // namespace
}  // namespace tendon
