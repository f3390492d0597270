#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/payload/codec.h>
#include <tendon/recording/condition.h>

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace tendon::recording {

enum class Gear : std::int32_t { kPark, kDrive };

struct Dashboard {
  std::array<double, 3> speed{};  ///< m/s
  std::uint64_t trips = 0;
  bool is_belted = false;
  Gear gear = Gear::kPark;
};

}  // namespace tendon::recording

template <>
inline constexpr auto tendon::kPayload<tendon::recording::Gear> =
    tendon::DescribeEnum("test.Gear", tendon::Enumerator{"park", tendon::recording::Gear::kPark},
                         tendon::Enumerator{"drive", tendon::recording::Gear::kDrive});
template <>
inline constexpr auto tendon::kPayload<tendon::recording::Dashboard> = tendon::Describe(
    "test.Dashboard", tendon::Field{"speed", &tendon::recording::Dashboard::speed, "m/s"},
    tendon::Field{"trips", &tendon::recording::Dashboard::trips},
    tendon::Field{"is_belted", &tendon::recording::Dashboard::is_belted},
    tendon::Field{"gear", &tendon::recording::Dashboard::gear});

namespace tendon::recording {
namespace {

using testing::HasSubstr;

std::vector<std::byte> Encoded(const Dashboard& dashboard) {
  std::vector<std::byte> body;
  Encode(dashboard, body);
  return body;
}

/// Returns the error for a condition; empty if the condition is accepted.
std::string RefusalOf(const std::string& text) {
  const auto condition = ParseCondition(text);
  if (!condition) return condition.error().message;
  if (!condition->comparison) return {};
  const auto test = CellTest::Make(*condition, SchemaOf<Dashboard>());
  return test ? std::string() : test.error().message;
}

bool IsTrue(const std::string& comparison, const Dashboard& dashboard) {
  const auto condition = ParseCondition("car/panel/state.Dashboard" + comparison);
  EXPECT_TRUE(condition) << condition.error().message;
  if (!condition) return false;
  const auto test = CellTest::Make(*condition, SchemaOf<Dashboard>());
  EXPECT_TRUE(test) << test.error().message;
  return test && test->IsTrue(Encoded(dashboard));
}

TEST(ConditionTest, APathAloneIsAnEvent) {
  const auto condition = ParseCondition(" robot/arm/Control.GoalReached ");

  ASSERT_TRUE(condition) << condition.error().message;
  EXPECT_FALSE(condition->comparison);
  EXPECT_EQ(ToString(condition->path), "robot/arm/Control.GoalReached");
}

TEST(ConditionTest, AComparisonHasARelationAValueAndPerhapsAUnit) {
  const auto condition = ParseCondition("robot/arm/state.Joints.position[2]>=1.2 rad");

  ASSERT_TRUE(condition) << condition.error().message;
  EXPECT_EQ(condition->path.field, ".position[2]");
  ASSERT_TRUE(condition->comparison);
  EXPECT_EQ(condition->comparison->relation, Condition::Relation::kGreaterOrEqual);
  EXPECT_EQ(condition->comparison->value, "1.2");
  EXPECT_EQ(condition->comparison->unit, "rad");
}

TEST(ConditionTest, AMistakeIsToldWithItsColumn) {
  EXPECT_THAT(RefusalOf(""), HasSubstr("column 1: expected the path"));
  EXPECT_THAT(RefusalOf("a/b/state.X >"), HasSubstr("column 14: expected a number"));
  EXPECT_THAT(RefusalOf("a/b/state.X = 1"), HasSubstr("column 13: expected one of <"));
  EXPECT_THAT(RefusalOf("a/b/state.X > 1 rad s"), HasSubstr("column 20: expected the end"));
  EXPECT_THAT(RefusalOf("a/b/state"), HasSubstr("column 10: expected '.'"));
}

TEST(ConditionTest, NumbersAreComparedByEachRelation) {
  const Dashboard slow{.speed = {0.0, 0.0, 1.5}};

  EXPECT_TRUE(IsTrue(".speed[2] > 1.4 m/s", slow));
  EXPECT_FALSE(IsTrue(".speed[2] > 1.5", slow));
  EXPECT_TRUE(IsTrue(".speed[2] >= 1.5", slow));
  EXPECT_TRUE(IsTrue(".speed[2] < 2", slow));
  EXPECT_FALSE(IsTrue(".speed[2] <= 1", slow));
  EXPECT_TRUE(IsTrue(".speed[2] == 1.5e0", slow));
  EXPECT_TRUE(IsTrue(".speed[2] != -1.5", slow));
}

TEST(ConditionTest, IntegersBeyondADoubleAreComparedExactly) {
  const Dashboard old{.trips = std::numeric_limits<std::uint64_t>::max() - 1};

  EXPECT_TRUE(IsTrue(".trips < 18446744073709551615", old));
  EXPECT_TRUE(IsTrue(".trips == 18446744073709551614", old));
}

TEST(ConditionTest, ABoolAndAnEnumeratorAreComparedByName) {
  const Dashboard dashboard{.is_belted = true, .gear = Gear::kDrive};

  EXPECT_TRUE(IsTrue(".is_belted == true", dashboard));
  EXPECT_FALSE(IsTrue(".is_belted != true", dashboard));
  EXPECT_TRUE(IsTrue(".gear == drive", dashboard));
  EXPECT_TRUE(IsTrue(".gear != park", dashboard));
}

TEST(ConditionTest, NotANumberIsOnlyDifferent) {
  const Dashboard broken{.speed = {std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}};

  EXPECT_FALSE(IsTrue(".speed[0] > 0", broken));
  EXPECT_FALSE(IsTrue(".speed[0] <= 0", broken));
  EXPECT_TRUE(IsTrue(".speed[0] != 0", broken));
}

TEST(ConditionTest, AMissingValueMakesNoConditionTrue) {
  const auto condition = ParseCondition("car/panel/state.Dashboard.trips != 7");
  const auto test = CellTest::Make(*condition, SchemaOf<Dashboard>());
  ASSERT_TRUE(test);

  EXPECT_FALSE(test->IsTrue({}));
}

TEST(ConditionTest, AComparisonThatDoesNotFitItsColumnIsRefused) {
  const std::string column = "car/panel/state.Dashboard";

  EXPECT_THAT(RefusalOf(column + ".speed[0] > 3 km/h"),
              HasSubstr("in m/s, but the condition uses km/h"));
  EXPECT_THAT(RefusalOf(column + ".trips > 3 m"),
              HasSubstr("has no unit, but the condition has the unit 'm'"));
  EXPECT_THAT(RefusalOf(column + ".trips > many"), HasSubstr("expected a number, found 'many'"));
  EXPECT_THAT(RefusalOf(column + ".is_belted == 1"), HasSubstr("expected true or false"));
  EXPECT_THAT(RefusalOf(column + ".is_belted > true"), HasSubstr("expected == or !="));
  EXPECT_THAT(RefusalOf(column + ".gear == reverse"), HasSubstr("one of park, drive"));
  EXPECT_THAT(RefusalOf(column + ".colour == 1"), HasSubstr("colour"));
}

}  // namespace
}  // namespace tendon::recording
