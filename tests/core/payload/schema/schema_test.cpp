#include <gtest/gtest.h>
#include <tendon/payload/schema.h>
#include <tests/core/payload/sample_types.h>

namespace tendon {
namespace {

using Kind = Schema::Kind;

const Schema kDouble(Kind::kFloat64);

TEST(Schema, OfAStructureNamesFieldsAndUnits) {
  const Schema& schema = SchemaOf<sample::JointState>();

  EXPECT_EQ(schema.kind(), Kind::kStructure);
  EXPECT_EQ(schema.name(), "sample.JointState");
  ASSERT_EQ(schema.fields().size(), 2U);
  EXPECT_EQ(schema.fields()[1].name, "velocity");
  EXPECT_EQ(schema.fields()[1].unit, "rad/s");
  EXPECT_EQ(schema.fields()[1].schema.kind(), Kind::kArray);
  EXPECT_EQ(schema.fields()[1].schema.length(), 7U);
  EXPECT_EQ(schema.fields()[1].schema.element(), kDouble);
}

TEST(Schema, KnowsEveryKind) {
  EXPECT_EQ(SchemaOf<bool>().kind(), Kind::kBool);
  EXPECT_EQ(SchemaOf<std::byte>().kind(), Kind::kUint8);
  EXPECT_EQ(SchemaOf<std::int8_t>().kind(), Kind::kInt8);
  EXPECT_EQ(SchemaOf<std::uint16_t>().kind(), Kind::kUint16);
  EXPECT_EQ(SchemaOf<std::int64_t>().kind(), Kind::kInt64);
  EXPECT_EQ(SchemaOf<float>().kind(), Kind::kFloat32);
  EXPECT_EQ(SchemaOf<std::string>().kind(), Kind::kString);
  EXPECT_EQ(SchemaOf<std::chrono::minutes>().kind(), Kind::kDuration);
  EXPECT_EQ(SchemaOf<std::vector<bool>>().kind(), Kind::kSequence);
  EXPECT_EQ(SchemaOf<sample::Mode>().kind(), Kind::kEnum);
  EXPECT_EQ(SchemaOf<sample::Plain>().kind(), Kind::kInt32);
}

TEST(Schema, DefaultsToThatOfNone) {
  EXPECT_EQ(Schema(), SchemaOf<None>());
  EXPECT_TRUE(Schema().is_none());
}

TEST(Schema, HasAShortNameForTables) {
  EXPECT_EQ(SchemaOf<sample::Point>().TypeName(), "sample.Point");
  EXPECT_EQ((SchemaOf<std::vector<std::array<double, 3>>>().TypeName()), "float64[3][]");
  EXPECT_EQ(SchemaOf<std::vector<sample::Mode>>().TypeName(), "sample.Mode[]");
  EXPECT_EQ(SchemaOf<double>().TypeName(), "float64");
  EXPECT_EQ((SchemaOf<std::array<double, 7>>().TypeName()), "float64[7]");
  EXPECT_EQ(SchemaOf<std::vector<bool>>().TypeName(), "bool[]");
  EXPECT_EQ(SchemaOf<std::string>().TypeName(), "string");
  EXPECT_EQ(SchemaOf<None>().TypeName(), "tendon.None");
}

TEST(Schema, PrintsEveryRelevantPart) {
  EXPECT_EQ(SchemaOf<sample::Fixed>().Text(),
            R"(struct sample.Fixed {
  flag: bool
  ragged: struct sample.Ragged {
    first: bool
    wide: float64 in mm
    small: uint8
    middle: int16
    second: bool
    real: float32
    last: uint8
  }[3] in m
  mode: enum sample.Mode {
    off = 0
    tracking = 5
    fault = -1
  }
  odd: uint8
  period: duration
  grid: float32[2][3] in K
  nothing: struct tendon.None {
  }
  flags: bool[3]
  plain: int32
  modes: enum sample.Mode {
    off = 0
    tracking = 5
    fault = -1
  }[2]
})");
}

TEST(Schema, HasTheMinimumSizeOfAValue) {
  EXPECT_EQ(SchemaOf<sample::JointState>().minimum_size(), 112U);
  EXPECT_EQ(SchemaOf<None>().minimum_size(), 1U);
  EXPECT_EQ((SchemaOf<std::array<std::string, 3>>().minimum_size()), 15U);
  EXPECT_EQ(SchemaOf<sample::Dynamic>().minimum_size(), payload::MinimumSize<sample::Dynamic>());
}

std::optional<std::string> DifferenceOfFields(const Schema::Field& needed,
                                              const Schema::Field& offered) {
  return FirstDifference(Schema::Structure("arm.JointState", {needed}),
                         Schema::Structure("arm.JointState", {offered}));
}

TEST(FirstDifference, IsEmptyForEqualTypes) {
  const auto copy = Schema::Parse(SchemaOf<sample::Dynamic>().Text());
  ASSERT_TRUE(copy);
  EXPECT_EQ(FirstDifference(SchemaOf<sample::Dynamic>(), *copy), std::nullopt);
}

TEST(FirstDifference, NamesADifferentUnit) {
  const Schema joints = Schema::Array(kDouble, 7);
  EXPECT_EQ(DifferenceOfFields({"position", "rad", joints}, {"position", "deg", joints}),
            "position of arm.JointState: float64[7] in rad needed, float64[7] in deg offered");
  EXPECT_EQ(DifferenceOfFields({"position", "rad", joints}, {"position", "", joints}),
            "position of arm.JointState: float64[7] in rad needed, float64[7] without unit "
            "offered");
}

TEST(FirstDifference, NamesADifferentShape) {
  EXPECT_EQ(DifferenceOfFields({"position", "rad", Schema::Array(kDouble, 7)},
                               {"position", "rad", Schema::Array(kDouble, 6)}),
            "position of arm.JointState: float64[7] needed, float64[6] offered");
  EXPECT_EQ(DifferenceOfFields({"p", "", Schema::Array(kDouble, 7)},
                               {"p", "", Schema::Sequence(kDouble)}),
            "p of arm.JointState: float64[7] needed, float64[] offered");
  EXPECT_EQ(DifferenceOfFields({"p", "", Schema::Sequence(Schema::Array(kDouble, 3))},
                               {"p", "", Schema::Sequence(Schema::Array(kDouble, 4))}),
            "p of arm.JointState: float64[3][] needed, float64[4][] offered");
}

TEST(FirstDifference, NamesADifferentType) {
  EXPECT_EQ(FirstDifference(SchemaOf<sample::JointState>(), SchemaOf<sample::Point>()),
            "sample.JointState needed, sample.Point offered");
  EXPECT_EQ(FirstDifference(kDouble, SchemaOf<None>()), "float64 needed, tendon.None offered");
}

TEST(FirstDifference, NamesAMissingField) {
  const Schema both = Schema::Structure("arm.A", {{"a", "", kDouble}, {"b", "", kDouble}});
  const Schema one = Schema::Structure("arm.A", {{"a", "", kDouble}});
  const Schema other = Schema::Structure("arm.A", {{"a", "", kDouble}, {"c", "", kDouble}});
  EXPECT_EQ(FirstDifference(both, one), "arm.A: field b needed, no further field offered");
  EXPECT_EQ(FirstDifference(one, both), "arm.A: no further field needed, field b offered");
  EXPECT_EQ(FirstDifference(both, other), "arm.A: field b needed, field c offered");
}

TEST(FirstDifference, NamesADifferentEnumValue) {
  const auto mode = [](std::vector<Schema::Enumerator> values) {
    return Schema::Array(Schema::Enum("arm.Mode", std::move(values)), 2);
  };
  EXPECT_EQ(FirstDifference(mode({{"off", 0}, {"on", 1}}), mode({{"off", 0}, {"on", 2}})),
            "arm.Mode: on = 1 needed, on = 2 offered");
  EXPECT_EQ(FirstDifference(mode({{"off", 0}}), mode({{"off", 0}, {"on", 2}})),
            "arm.Mode: no further value needed, on = 2 offered");
}

TEST(FirstDifference, IsFoundInsideNestedTypes) {
  const auto make = [](const char* unit) {
    const Schema inner = Schema::Structure("arm.Inner", {{"x", unit, kDouble}});
    return Schema::Structure("arm.Outer", {{"list", "", Schema::Sequence(inner)}});
  };
  EXPECT_EQ(FirstDifference(make("m"), make("mm")),
            "x of arm.Inner: float64 in m needed, float64 in mm offered");
}

}  // namespace
}  // namespace tendon
