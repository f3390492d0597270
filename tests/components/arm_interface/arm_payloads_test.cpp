#include <components/arm_interface/arm_payloads.h>
#include <gtest/gtest.h>
#include <tendon/payload/codec.h>
#include <tendon/payload/json.h>
#include <tendon/payload/numeric_field.h>

namespace arm {
namespace {

template <typename T>
std::string UnitOf(const char* path) {
  const auto field = tendon::FindNumericField(tendon::SchemaOf<T>(), path);
  return field ? field->unit : field.error().message;
}

TEST(ArmPayloads, DescribeTheirUnits) {
  EXPECT_EQ(UnitOf<JointState>(".position[6]"), "rad");
  EXPECT_EQ(UnitOf<JointState>(".velocity[0]"), "rad/s");
  EXPECT_EQ(UnitOf<JointGoal>(".position[3]"), "rad");
  EXPECT_EQ(UnitOf<JointGoal>(".duration"), "s");
  EXPECT_EQ(UnitOf<LimitFault>(".position"), "rad");
}

TEST(ArmPayloads, JsonWritesLinksByName) {
  EXPECT_EQ(tendon::ToJson(LinkId::kFlange), "\"flange\"");
  const auto link = tendon::FromJson<LinkId>("\"link_4\"");
  ASSERT_TRUE(link);
  EXPECT_EQ(*link, LinkId::kLink4);
}

TEST(ArmPayloads, AnUnknownLinkDoesNotDecode) {
  std::vector<std::byte> body;
  tendon::Encode(std::int32_t{9}, body);
  LinkId link = LinkId::kBase;

  EXPECT_FALSE(tendon::Decode(body, link));
}

}  // namespace
}  // namespace arm
