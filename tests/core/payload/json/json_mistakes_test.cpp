#include <gtest/gtest.h>
#include <tendon/payload/json.h>
#include <tendon/payload/json/strict_json.h>
#include <tests/core/payload/json/json_error.h>
#include <tests/core/payload/sample_types.h>
#include <tests/support/locales.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

/// Common mistakes of people and scripts in JSON. Each mistake has its own message.
namespace tendon {
namespace {

TEST(FromJson, ReportsThePositionOfInvalidJson) {
  const auto error = ErrorOf<sample::Point>;
  EXPECT_EQ(
      error("{"),
      "this is not valid JSON: line 1, column 2: unexpected end of input; expected string literal");
  EXPECT_EQ(error("{\"x\": 1,\n \"y\": 2,,\n"),
            "this is not valid JSON: line 2, column 9: unexpected ','; expected string literal");
  EXPECT_EQ(error("{\"x\": 1,\n}"),
            "this is not valid JSON: line 2, column 1: unexpected '}'; expected string literal");
  EXPECT_EQ(error("{} // done").substr(0, 41), "this is not valid JSON: line 1, column 4:");
  EXPECT_EQ(error("{'x': 1}").substr(0, 41), "this is not valid JSON: line 1, column 2:");
  EXPECT_EQ(error("\xef\xbb\xbf{}"),
            "this is not valid JSON: begins with a byte-order mark; save the text as UTF-8 without "
            "this mark");
}

TEST(FromJson, AcceptsEmptyTextOnlyForNone) {
  EXPECT_EQ(ErrorOf<sample::Point>(""), "expected sample.Point, got nothing");
  EXPECT_EQ(ErrorOf<double>(" \n"), "expected float64, got nothing");
}

TEST(FromJson, NamesADuplicateKeyWithItsPosition) {
  EXPECT_EQ(ErrorOf<sample::Point>(R"({"x":1,"y":2,"z":3,"y":4})"),
            "this is not valid JSON: line 1, column 20: key 'y' occurs twice");
  EXPECT_EQ(ErrorOf<std::vector<sample::Point>>(R"([{},{"x":1,"x":1}])"),
            "this is not valid JSON: line 1, column 12: [1]: key 'x' occurs twice");
}

TEST(FromJson, NestsNoDeeperThan64) {
  const auto nested = [](std::size_t depth) {
    return std::string(depth, '[') + std::string(depth, ']');
  };
  EXPECT_EQ(ErrorOf<double>(nested(64)), "expected a number, got an array of 1");
  EXPECT_EQ(ErrorOf<double>(nested(65)), "this is not valid JSON: nesting deeper than 64");
  EXPECT_EQ(ErrorOf<double>(std::string(1'000'000, '[')),
            "this is not valid JSON: nesting deeper than 64");
}

TEST(JsonOfPrograms, KeepsItsOrderAndNestsNoDeeperThan64) {
  const auto nested = [](std::size_t depth) {
    return std::string(depth, '[') + std::string(depth, ']');
  };
  const auto error = [](const std::string& text) {
    const auto value = ParseOrderedJson(text);
    return value ? value->dump() : value.error().message;
  };

  EXPECT_EQ(error(R"({"b": 1, "a": [{}, {}]})"), R"({"b":1,"a":[{},{}]})");
  EXPECT_EQ(error(nested(64)), nested(64));
  EXPECT_EQ(error(nested(65)), "nesting deeper than 64");
  EXPECT_EQ(error(std::string(1'000'000, '{')), "nesting deeper than 64");
  // Brackets inside a text do not count as nesting.
  EXPECT_EQ(error("\"" + std::string(100, '[') + "\\\"[\""),
            "\"" + std::string(100, '[') + "\\\"[\"");
  EXPECT_EQ(error("[1,]"), "line 1, column 4: unexpected ']'; expected '[', '{', or a literal");
}

TEST(JsonOfPrograms, InvalidJsonBecomesAText) {
  EXPECT_EQ(JsonOrText("[1]"), (nlohmann::ordered_json{1}));
  EXPECT_EQ(JsonOrText("nan"), "nan");
  EXPECT_EQ(JsonOrText("a\xff"), "a\\xff");
  EXPECT_EQ(JsonOrText(std::string(70, '[')), std::string(70, '['));
}

TEST(FromJson, ReadsAtMostSixteenMebibytes) {
  std::string text = "1" + std::string((16U << 20U) - 1, ' ');
  EXPECT_EQ(ErrorOf<double>(text), "accepted");
  text += ' ';
  EXPECT_EQ(ErrorOf<double>(text), "this JSON has 16777217 bytes; at most 16777216 are read");
}

TEST(FromJson, IntegersAreExactBeyondTwoToThe53) {
  EXPECT_EQ(*FromJson<std::int64_t>("9007199254740993"), 9007199254740993);
  EXPECT_EQ(*FromJson<std::int64_t>("-9223372036854775808"),
            std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(*FromJson<std::uint64_t>("18446744073709551615"),
            std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(ErrorOf<std::int64_t>("9223372036854775808"),
            "expected an integer from -9223372036854775808 to 9223372036854775807, got number "
            "9223372036854775808");
  EXPECT_EQ(ErrorOf<std::uint64_t>("18446744073709551616").substr(0, 56),
            "expected an integer from 0 to 18446744073709551615, got ");
  EXPECT_EQ(*FromJson<std::uint64_t>("9007199254740993.0"), 9007199254740993U);
  EXPECT_EQ(*FromJson<std::int64_t>("-12.5e1"), -125);
  for (const char* fraction : {"0.5", "1.00000000000000000001", "4503599627370497.5"}) {
    EXPECT_EQ(ErrorOf<std::int64_t>(fraction).substr(0, 22), "expected an integer fr");
  }
}

TEST(FromJson, RefusesNumbersThatNoDoubleCanHold) {
  EXPECT_NE(ErrorOf<double>("1e999").find("1e999"), std::string::npos);
  EXPECT_EQ(ErrorOf<double>("1e-400"),
            "this is not valid JSON: no double can hold the number 1e-400");
  EXPECT_EQ(ErrorOf<float>("1e-50").substr(0, 40), "expected a number that float32 can hold,");
  EXPECT_EQ(ErrorOf<std::chrono::duration<double>>("1e-10"),
            "expected a number of seconds, in steps of 1e-9, got number 1e-10");
  EXPECT_EQ(*FromJson<float>(ToJson(std::numeric_limits<float>::max())),
            std::numeric_limits<float>::max());
  EXPECT_EQ(ErrorOf<float>("3.41e38").substr(0, 40), "expected a number that float32 can hold,");
  EXPECT_EQ(ErrorOf<double>("NaN").substr(0, 24), "this is not valid JSON: ");
  EXPECT_EQ(ErrorOf<double>("Infinity").substr(0, 24), "this is not valid JSON: ");
  EXPECT_EQ(ErrorOf<double>("\"NaN\""), "expected a number, got string 'NaN'");
  EXPECT_EQ(*FromJson<int>("-0"), 0);
  EXPECT_TRUE(std::signbit(*FromJson<double>("-0.0")));
  EXPECT_EQ(ErrorOf<int>("\"nan\"").substr(0, 27), "expected an integer from -2");
  EXPECT_EQ(ErrorOf<std::chrono::seconds>("\"inf\""),
            "expected a number of seconds, below 68 years, got string 'inf'");
}

TEST(FromJson, IsTheSameInEveryLocale) {
  test::Locales locales;
  for (const std::string& name : test::Locales::Names()) {
    ASSERT_TRUE(locales.Use(name)) << "localedef did not make " << name;
    EXPECT_EQ(*FromJson<double>("0.123"), 0.123) << name;
    EXPECT_EQ(*FromJson<double>("-1.5e-3"), -1.5e-3) << name;
    EXPECT_EQ(ErrorOf<double>("0,123").substr(0, 24), "this is not valid JSON: ") << name;
    EXPECT_EQ(ToJson(0.25), "0.25") << name;
    EXPECT_EQ(ParseOrderedJson("[0.5]")->dump(), "[0.5]") << name;
  }
}

TEST(FromJson, RefusesInvalidUtf8AndNul) {
  for (const char* bad : {"\"\xff\"", "\"\xc0\xaf\"", "\"\xed\xa0\x80\"", "\"\xe2\x82\"",
                          R"("\ud800")", "\"a\x01\""}) {
    EXPECT_EQ(ErrorOf<std::string>(bad).substr(0, 24), "this is not valid JSON: ") << bad;
  }
  EXPECT_EQ(ErrorOf<std::string>(std::string("\"a\0b\"", 5)).substr(0, 24),
            "this is not valid JSON: ");
  EXPECT_EQ(ErrorOf<std::string>(R"("a\u0000b")"),
            "expected a string without \\u0000, got string 'a\\x00b'");
  EXPECT_EQ(*FromJson<std::string>(R"("\ud83e\uddbe")"), "\xf0\x9f\xa6\xbe");
}

TEST(FromJson, QuotesPrintableText) {
  EXPECT_EQ(ErrorOf<double>(R"("\u001b[2J")"), "expected a number, got string '\\x1b[2J'");
  EXPECT_EQ(ErrorOf<sample::Point>(R"({"\u001b[2J":1})"), "unknown key '\\x1b[2J'");
  EXPECT_LT(ErrorOf<sample::Point>("{\"" + std::string(1'000'000, 'k') + "\":1}").size(), 200U);
}

TEST(FromJson, RefusesTruncatedText) {
  const std::string text = R"({"x":1.5,"y":-2e3,"z":0})";
  ASSERT_EQ(ErrorOf<sample::Point>(text), "accepted");
  for (std::size_t size = 0; size < text.size(); ++size) {
    EXPECT_NE(ErrorOf<sample::Point>(text.substr(0, size)), "accepted") << size;
  }
}

}  // namespace
}  // namespace tendon
