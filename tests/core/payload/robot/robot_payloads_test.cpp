#include <gtest/gtest.h>
#include <tendon/payload/fingerprint.h>
#include <tendon/payload/json.h>
#include <tendon/payload/numeric_field.h>

#include "samples.h"
#include "support/encoded.h"

namespace tendon::robot {
namespace {

using test::Encoded;

template <typename T>
class RobotPayload : public testing::Test {};

using All = testing::Types<Point, Vector3, Quaternion, Pose, Transform, Twist, Wrench,
                           JointState<2>, JointControl, JointCommand<2>, NamedJointState, Header,
                           TransformStamped, Transforms, Joystick, Image>;
TYPED_TEST_SUITE(RobotPayload, All);

TYPED_TEST(RobotPayload, RoundTripsThroughBytes) {
  const auto value = Sample<TypeParam>();
  TypeParam decoded{};
  ASSERT_NE(decoded, value);

  ASSERT_TRUE(Decode(Encoded(value), decoded));

  EXPECT_EQ(decoded, value);
}

TYPED_TEST(RobotPayload, RefusesABodyTruncatedAtAnyByte) {
  const auto body = Encoded(Sample<TypeParam>());
  for (std::size_t size = 0; size < body.size(); ++size) {
    TypeParam decoded{};
    EXPECT_FALSE(Decode(std::span(body).first(size), decoded)) << size;
  }
}

TYPED_TEST(RobotPayload, RoundTripsThroughJson) {
  const auto value = Sample<TypeParam>();

  const auto read = FromJson<TypeParam>(ToJson(value));

  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(*read, value);
}

TYPED_TEST(RobotPayload, RoundTripsWithOnlyItsSchema) {
  const auto schema = Schema::Parse(SchemaOf<TypeParam>().TextWithHelp());
  ASSERT_TRUE(schema) << schema.error().message;
  const auto body = Encoded(Sample<TypeParam>());

  const auto json = ToJson(*schema, body);
  ASSERT_TRUE(json) << json.error().message;
  const auto back = FromJson(*schema, *json);

  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(*back, body);
  EXPECT_EQ(*json, ToJson(Sample<TypeParam>()));
}

struct Pin {
  std::string name;
  std::string fingerprint;
};

template <typename T>
Pin PinOf() {
  return {SchemaOf<T>().TypeName(), ToString(FingerprintOf<T>())};
}

/// If one of these numbers changes, existing processes and recordings are no longer compatible.
TEST(RobotPayloads, TheirFingerprintsNeverChange) {
  const std::vector<std::pair<Pin, Pin>> pins{
      {PinOf<Point>(), {"geometry_msgs.Point", "c33fb9e6ec229e2e086741484d8206ec"}},
      {PinOf<Vector3>(), {"geometry_msgs.Vector3", "a363ff9f60c752909180eb261bd4d75b"}},
      {PinOf<Quaternion>(), {"geometry_msgs.Quaternion", "a057fb01a7fbd2db15a5d39a5e457e8d"}},
      {PinOf<Pose>(), {"geometry_msgs.Pose", "40b44b2ee8a4e9b8284d98f460d034e8"}},
      {PinOf<Transform>(), {"geometry_msgs.Transform", "99ad3cf70b1f0282f5f27a591e1a47be"}},
      {PinOf<Twist>(), {"geometry_msgs.Twist", "335855b5a360ae60d0405f634f8ff1ff"}},
      {PinOf<Wrench>(), {"geometry_msgs.Wrench", "c0744da51409845d271b393fa8c4d9fa"}},
      {PinOf<JointState<7>>(), {"robot.JointState", "976d1df3e1fd47ab509d25e3eee2852a"}},
      {PinOf<JointControl>(), {"robot.JointControl", "c05267da0466a8abba1aeaa20cc61d55"}},
      {PinOf<JointCommand<7>>(), {"robot.JointCommand", "df2795fed5d8869b4384e1a5bc705ba3"}},
      {PinOf<NamedJointState>(), {"sensor_msgs.JointState", "06303d1642471feca0fdd57d2a8ef460"}},
      {PinOf<Header>(), {"std_msgs.Header", "da18a9dd2a8351376900e092430febc3"}},
      {PinOf<TransformStamped>(),
       {"geometry_msgs.TransformStamped", "1d409a16780e85940fc9a56ccfe1d58d"}},
      {PinOf<Transforms>(), {"tf2_msgs.TFMessage", "c17a9f36a5ab1b066a5dec6ff0dd50f8"}},
      {PinOf<Joystick>(), {"sensor_msgs.Joy", "4c70c80825f12e89f6f67105478ec0a7"}},
      {PinOf<Image>(), {"sensor_msgs.Image", "627d4b94d6af54b77ca5772c58ccdd5d"}},
  };
  for (const auto& [is, was] : pins) {
    EXPECT_EQ(is.name, was.name);
    EXPECT_EQ(is.fingerprint, was.fingerprint) << was.name;
  }
}

template <typename T>
std::string UnitOf(const char* path) {
  const auto field = FindNumericField(SchemaOf<T>(), path);
  return field ? field->unit : field.error().message;
}

TEST(RobotPayloads, CarryTheirUnits) {
  EXPECT_EQ(UnitOf<JointState<7>>(".position[6]"), "rad");
  EXPECT_EQ(UnitOf<JointState<7>>(".velocity[0]"), "rad/s");
  EXPECT_EQ(UnitOf<JointCommand<7>>(".effort[0]"), "N m");
  EXPECT_EQ(UnitOf<NamedJointState>(".position[0]"), "rad or m");
  EXPECT_EQ(UnitOf<Pose>(".position.z"), "m");
  EXPECT_EQ(UnitOf<Twist>(".linear.x"), "m/s");
  EXPECT_EQ(UnitOf<Twist>(".angular.x"), "rad/s");
  EXPECT_EQ(UnitOf<Wrench>(".force.y"), "N");
  EXPECT_EQ(UnitOf<Wrench>(".torque.y"), "N m");
  EXPECT_EQ(UnitOf<Transforms>(".transforms[0].transform.translation.x"), "m");
}

TEST(RobotPayloads, ControlLoopTypesHaveAFixedSize) {
  static_assert(FixedPayload<JointState<7>> && FixedPayload<JointCommand<7>>);
  static_assert(FixedPayload<Pose> && FixedPayload<Transform>);
  static_assert(FixedPayload<Twist> && FixedPayload<Wrench>);
  EXPECT_EQ(kEncodedSize<Pose>, 56U);
  EXPECT_EQ(kEncodedSize<JointState<6>>, 144U);
}

TEST(RobotPayloads, AnotherNumberOfJointsIsAnotherType) {
  EXPECT_EQ(FirstDifference(SchemaOf<JointState<7>>(), SchemaOf<JointState<6>>()),
            "position of robot.JointState: float64[7] needed, float64[6] offered");
}

TEST(RobotPayloads, RefusesAnAxisOutOfRange) {
  const auto read = FromJson<Joystick>(
      R"({"header": {"stamp": {"sec": 0, "nanosec": 0}, "frame_id": ""}, "axes": [1.5], "buttons": []})");

  ASSERT_FALSE(read);
  EXPECT_NE(read.error().message.find("axes[0]"), std::string::npos) << read.error().message;
}

}  // namespace
}  // namespace tendon::robot
