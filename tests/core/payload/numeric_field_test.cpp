#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/encoded.h>
#include <tendon/payload/codec.h>
#include <tendon/payload/numeric_field.h>
#include <tests/core/payload/random_value.h>
#include <tests/core/payload/sample_types.h>

namespace tendon {
namespace {

using testing::ElementsAre;

using test::Encoded;

std::vector<std::string> Paths(const std::vector<NumericField>& fields) {
  std::vector<std::string> paths;
  for (const NumericField& field : fields) paths.push_back(field.path);
  return paths;
}

TEST(NumericField, ANumberIsItsOwnOnlyField) {
  const auto fields = NumericFields(SchemaOf<double>());

  ASSERT_EQ(fields.size(), 1U);
  EXPECT_EQ(fields[0].path, "");
  EXPECT_EQ(fields[0].offset, 0U);
  EXPECT_EQ(ReadAsDouble(fields[0], Encoded(2.5)), 2.5);
}

TEST(NumericField, ListsEveryNumberWithItsUnit) {
  const auto fields = NumericFields(SchemaOf<sample::JointState>());

  ASSERT_EQ(fields.size(), 14U);
  EXPECT_EQ(fields[3].path, ".position[3]");
  EXPECT_EQ(fields[3].unit, "rad");
  EXPECT_EQ(fields[3].offset, 24U);
  EXPECT_EQ(fields[7].path, ".velocity[0]");
  EXPECT_EQ(fields[7].unit, "rad/s");
}

TEST(NumericField, InheritsTheUnitOfTheFieldAround) {
  const auto fields = NumericFields(SchemaOf<sample::Fixed>());
  const auto unit = [&](const std::string& path) -> std::string {
    for (const NumericField& field : fields) {
      if (field.path == path) return field.unit;
    }
    return "no such field";
  };

  EXPECT_EQ(unit(".ragged[1].wide"), "mm");
  EXPECT_EQ(unit(".ragged[1].small"), "m");
  EXPECT_EQ(unit(".grid[2][1]"), "K");
  EXPECT_EQ(unit(".period"), "s");
  EXPECT_EQ(unit(".mode"), "");
}

TEST(NumericField, OffsetsOfAFixedTypeAgreeWithTheCodec) {
  std::mt19937 random(8);
  const auto fields = NumericFields(SchemaOf<sample::Fixed>());
  const auto read = [&](const std::string& path, std::span<const std::byte> body) {
    for (const NumericField& field : fields) {
      if (field.path == path) return ReadAsDouble(field, body);
    }
    return std::optional<double>();
  };
  for (int round = 0; round < 50; ++round) {
    sample::Fixed value;
    sample::Randomise(random, value);
    const auto body = Encoded(value);
    ASSERT_EQ(read(".flag", body), value.flag);
    ASSERT_EQ(read(".ragged[0].wide", body), value.ragged[0].wide);
    ASSERT_EQ(read(".ragged[2].middle", body), value.ragged[2].middle);
    ASSERT_EQ(read(".ragged[2].real", body), value.ragged[2].real);
    ASSERT_EQ(read(".mode", body), static_cast<int>(value.mode));
    ASSERT_EQ(read(".odd", body), value.odd);
    ASSERT_NEAR(*read(".period", body), 1e-3 * static_cast<double>(value.period.count()), 1e-6);
    ASSERT_EQ(read(".grid[2][1]", body), value.grid[2][1]);
    ASSERT_EQ(read(".flags[1]", body), value.flags[1]);
    ASSERT_EQ(read(".plain", body), static_cast<int>(value.plain));
    ASSERT_EQ(read(".modes[1]", body), static_cast<int>(value.modes[1]));
  }
}

TEST(NumericField, EveryOffsetMatchesASequentialWalk) {
  std::mt19937 random(9);
  sample::Fixed value;
  sample::Randomise(random, value);
  const auto body = Encoded(value);
  for (NumericField field : NumericFields(SchemaOf<sample::Fixed>())) {
    ASSERT_TRUE(field.offset) << field.path;
    const auto directly = ReadAsDouble(field, body);
    field.offset.reset();
    EXPECT_EQ(ReadAsDouble(field, body), directly) << field.path;
  }
}

struct Report {
  std::string name;
  double load = 0;
  std::vector<float> cores;
  std::vector<sample::Point> points;
  std::int32_t count = 0;
};

}  // namespace
}  // namespace tendon

template <>
inline constexpr auto tendon::kPayload<tendon::Report> =
    tendon::Describe("sample.Report", tendon::Field{"name", &tendon::Report::name},
                     tendon::Field{"load", &tendon::Report::load, "%"},
                     tendon::Field{"cores", &tendon::Report::cores, "MHz"},
                     tendon::Field{"points", &tendon::Report::points},
                     tendon::Field{"count", &tendon::Report::count});

namespace tendon {
namespace {

const Report kReport{"robot", 12.5, {800, 1600}, {{1, 2, 3}}, 42};

TEST(NumericField, AfterAStringHasNoFixedOffset) {
  const auto fields = NumericFields(SchemaOf<Report>());

  EXPECT_THAT(Paths(fields), ElementsAre(".load", ".count"));
  EXPECT_FALSE(fields[0].offset);
  EXPECT_EQ(ReadAsDouble(fields[0], Encoded(kReport)), 12.5);
  EXPECT_EQ(ReadAsDouble(fields[1], Encoded(kReport)), 42);
}

TEST(NumericField, ElementsOfSequencesAreListedByValue) {
  const auto body = Encoded(kReport);

  const auto fields = NumericFields(SchemaOf<Report>(), body);

  EXPECT_THAT(Paths(fields), ElementsAre(".load", ".cores[0]", ".cores[1]", ".points[0].x",
                                         ".points[0].y", ".points[0].z", ".count"));
  EXPECT_EQ(fields[2].unit, "MHz");
  EXPECT_EQ(ReadAsDouble(fields[2], body), 1600);
  EXPECT_EQ(ReadAsDouble(fields[5], body), 3);
}

TEST(NumericField, AMissingElementReadsAsNothing) {
  const auto field = FindNumericField(SchemaOf<Report>(), ".cores[2]");

  ASSERT_TRUE(field);
  EXPECT_EQ(ReadAsDouble(*field, Encoded(kReport)), std::nullopt);
}

TEST(NumericField, ReadsATruncatedBodyWithinItsBounds) {
  const auto body = Encoded(kReport);
  const auto fields = NumericFields(SchemaOf<Report>(), body);
  for (std::size_t size = 0; size < body.size(); ++size) {
    const std::vector<std::byte> cut(body.begin(), body.begin() + static_cast<long>(size));
    EXPECT_TRUE(NumericFields(SchemaOf<Report>(), cut).empty()) << size;
    EXPECT_EQ(ReadAsDouble(fields.back(), cut), std::nullopt) << size;
  }
  const auto fixed = NumericFields(SchemaOf<sample::JointState>());
  EXPECT_EQ(ReadAsDouble(fixed.back(), std::vector<std::byte>(111)), std::nullopt);
  EXPECT_EQ(ReadAsDouble(fixed.back(), {}), std::nullopt);
}

TEST(NumericField, HugeArraysAreListedUpToALimit) {
  const auto numbers = Schema::Parse("float64[100000000]");
  const auto nothings =
      Schema::Parse("struct a.B {\n  many: struct tendon.None {\n  }[1000000000]\n  x: uint8\n}");
  ASSERT_TRUE(numbers && nothings);

  EXPECT_EQ(NumericFields(*numbers).size(), kMaxNumericFields);
  ASSERT_EQ(NumericFields(*nothings).size(), 1U);
  EXPECT_EQ(NumericFields(*nothings)[0].offset, 1'000'000'000U);
}

TEST(FindNumericField, ReturnsOffsetUnitAndType) {
  const auto field = FindNumericField(SchemaOf<sample::JointState>(), ".velocity[6]");

  ASSERT_TRUE(field);
  EXPECT_EQ(field->offset, 104U);
  EXPECT_EQ(field->unit, "rad/s");
  EXPECT_EQ(field->schema.kind(), Schema::Kind::kFloat64);
}

TEST(FindNumericField, TakesAPathWithoutTheFirstDot) {
  const auto field = FindNumericField(SchemaOf<sample::JointState>(), "velocity[6]");

  ASSERT_TRUE(field);
  EXPECT_EQ(field->path, ".velocity[6]");
}

TEST(FindNumericField, NamesTheUnknownPartOfAPath) {
  const auto error = [](std::string_view path) {
    const auto field = FindNumericField(SchemaOf<sample::JointState>(), path);
    return field ? "found" : field.error().message;
  };

  EXPECT_EQ(error(".positon[0]"),
            "sample.JointState has no field 'positon'; did you mean 'position'?");
  EXPECT_EQ(error(".position"), "'.position' is float64[7], not one number");
  EXPECT_EQ(error(".position[7]"), "[7] is not in float64[7]");
  EXPECT_EQ(error(".position[x]"), "'[x]' does not begin with an index, like [0]");
  EXPECT_EQ(error(".position[1"), "'[1' does not begin with an index, like [0]");
  EXPECT_EQ(error(".position[1].x"), "float64 has no field 'x'");
  EXPECT_EQ(error("[0]"), "sample.JointState has no elements");
  EXPECT_EQ(error(""), "'' is sample.JointState, not one number");
}

}  // namespace
}  // namespace tendon
