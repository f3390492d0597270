#include <gtest/gtest.h>
#include <tendon/payload/schema.h>
#include <tests/core/payload/sample_types.h>

#include <random>

namespace tendon {
namespace {

std::string SchemaErrorOf(std::string_view text) {
  const auto schema = Schema::Parse(text);
  return schema ? "accepted" : schema.error().message;
}

TEST(SchemaParse, ReadsItsOwnText) {
  for (const Schema& schema :
       {SchemaOf<sample::Dynamic>(), SchemaOf<sample::Fixed>(), SchemaOf<sample::Numbers>(),
        SchemaOf<None>(), SchemaOf<std::vector<std::vector<std::string>>>(),
        SchemaOf<sample::Mode>(), SchemaOf<std::array<std::chrono::seconds, 4>>()}) {
    const auto parsed = Schema::Parse(schema.Text());
    ASSERT_TRUE(parsed) << parsed.error().message;
    EXPECT_EQ(parsed->Text(), schema.Text());
    EXPECT_EQ(parsed->minimum_size(), schema.minimum_size());
  }
}

TEST(SchemaParse, KeepsUnitsWithSpacesAndSymbols) {
  const std::string text = "struct a.B {\n  torque: float64 in N m\n  heat: float32 in °C/s\n}";

  const auto schema = Schema::Parse(text);

  ASSERT_TRUE(schema) << schema.error().message;
  EXPECT_EQ(schema->fields()[0].unit, "N m");
  EXPECT_EQ(schema->Text(), text);
}

TEST(SchemaParse, ErrorsNamePositionAndExpectation) {
  EXPECT_EQ(SchemaErrorOf(""), "schema line 1 column 1: expected a type");
  EXPECT_EQ(SchemaErrorOf("float65"), "schema line 1 column 1: expected a type");
  EXPECT_EQ(SchemaErrorOf("float64 x"), "schema line 1 column 9: expected the end");
  EXPECT_EQ(SchemaErrorOf("struct 9 {\n}"),
            "schema line 1 column 8: expected a type's name, like arm.JointState");
  EXPECT_EQ(SchemaErrorOf("struct a.B {\n  x float64\n}"), "schema line 2 column 5: expected ':'");
  EXPECT_EQ(SchemaErrorOf("struct a.B {\n  x: flt\n}"), "schema line 2 column 6: expected a type");
  EXPECT_EQ(SchemaErrorOf("struct a.B {\n  x: bool\n"),
            "schema line 3 column 1: expected a field's name or '}'");
  EXPECT_EQ(SchemaErrorOf("struct a.B {\n  x: bool\n  x: bool\n}"),
            "schema line 3 column 4: two fields have this name");
  EXPECT_EQ(SchemaErrorOf("struct a.B {\n  x: bool in \x01\n}"),
            "schema line 2 column 10: expected a unit");
  EXPECT_EQ(SchemaErrorOf("enum a.B {\n}"),
            "schema line 2 column 2: an enum has at least one enumerator");
  EXPECT_EQ(SchemaErrorOf("enum a.B {\n  x = 1\n  y = 1\n}"),
            "schema line 3 column 8: two enumerators have this value");
  EXPECT_EQ(SchemaErrorOf("enum a.B {\n  x = 2147483648\n}"),
            "schema line 2 column 7: expected a number of 32 bits");
  EXPECT_EQ(SchemaErrorOf("float64[0]"),
            "schema line 1 column 11: an array has at least one element");
  EXPECT_EQ(SchemaErrorOf("float64[-1]"), "schema line 1 column 9: expected a number of 32 bits");
  EXPECT_EQ(SchemaErrorOf("float64[7"), "schema line 1 column 10: expected ']'");
}

TEST(SchemaParse, RefusesATextTruncatedAtAnyByte) {
  const std::string text = "struct a.B {\n  # Help.\n  @ 0 to 1\n  x: float64[2][] in rad\n}";
  ASSERT_EQ(SchemaErrorOf(text), "accepted");
  for (std::size_t size = 0; size < text.size(); ++size) {
    EXPECT_NE(SchemaErrorOf(text.substr(0, size)), "accepted") << size;
  }
}

TEST(SchemaParse, RefusesValuesOfGigabytes) {
  EXPECT_EQ(SchemaErrorOf("float64[4294967295]"),
            "schema line 1 column 20: a value of this type would exceed 2 GiB");
  EXPECT_EQ(SchemaErrorOf("bool[65536][65536][65536][65536]"),
            "schema line 1 column 19: a value of this type would exceed 2 GiB");
  EXPECT_EQ(SchemaErrorOf("struct a.B {\n x: bool[2147483648]\n y: bool\n}"),
            "schema line 3 column 9: a value of this type would exceed 2 GiB");
}

TEST(SchemaParse, IsBoundedInDepth) {
  const auto nested = [](int depth) {
    std::string text;
    for (int i = 0; i < depth; ++i) text += "struct a.B { x: ";
    text += "bool";
    for (int i = 0; i < depth; ++i) text += "\n}";
    return text;
  };
  const auto brackets = [](int depth) {
    std::string text = "bool";
    for (int i = 0; i < depth; ++i) text += "[]";
    return text;
  };

  EXPECT_EQ(SchemaErrorOf(nested(63)), "accepted");
  EXPECT_NE(SchemaErrorOf(nested(64)).find("more than 64 levels"), std::string::npos);
  EXPECT_NE(SchemaErrorOf(nested(50'000)).find("more than 64 levels"), std::string::npos);
  EXPECT_EQ(SchemaErrorOf(brackets(63)), "accepted");
  EXPECT_NE(SchemaErrorOf(brackets(64)).find("more than 64 levels"), std::string::npos);
  EXPECT_NE(SchemaErrorOf(brackets(50'000)).find("more than 64 levels"), std::string::npos);
}

TEST(SchemaParse, RefusesATextOfOverAMebibyte) {
  EXPECT_EQ(SchemaErrorOf(std::string((1U << 20) + 1, ' ')),
            "schema: 1048577 bytes of text; at most 1048576 are read");
}

TEST(SchemaParse, AnAcceptedMutatedTextRoundTrips) {
  std::mt19937 random(7);
  const std::string original = SchemaOf<sample::Dynamic>().Text();
  constexpr std::string_view kAlphabet = "ab19._ \n[]{}:=-in\xff";
  int accepted = 0;
  for (int round = 0; round < 5000; ++round) {
    std::string text = original;
    for (auto changes = 1 + random() % 3; changes > 0; --changes) {
      const std::size_t place = random() % text.size();
      if (random() % 3 == 0) {
        text.erase(place, 1 + random() % 20);
      } else {
        text[place] = kAlphabet[random() % kAlphabet.size()];
      }
    }
    const auto schema = Schema::Parse(text);
    if (!schema) continue;
    ++accepted;
    const auto again = Schema::Parse(schema->Text());
    ASSERT_TRUE(again) << again.error().message << "\n" << text;
    ASSERT_EQ(again->Text(), schema->Text());
  }
  EXPECT_GT(accepted, 0);
}

}  // namespace
}  // namespace tendon
