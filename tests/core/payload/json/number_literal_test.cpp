#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/payload/json/number_literal.h>
#include <tests/support/locales.h>
#include <tests/support/written_number.h>

namespace tendon {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Kind = Schema::Kind;

NumberLiteral Real(std::string_view text) { return ReadNumberLiteral(Kind::kFloat64, text); }
NumberLiteral Integer(std::string_view text) { return ReadNumberLiteral(Kind::kInt64, text); }

TEST(NumberLiteral, IsReadOnlyIfUnambiguous) {
  struct Case {
    const char* typed;
    const char* json;
  };
  for (const auto& [typed, json] : std::vector<Case>{{"0.5", "0.5"},
                                                     {"-.5", "-0.5"},
                                                     {".5", "0.5"},
                                                     {"5.", "5"},
                                                     {"+1", "1"},
                                                     {" 1e3 ", "1e3"},
                                                     {"1.E+3", "1e3"},
                                                     {"-0", "-0.0"},
                                                     {"inf", "\"inf\""},
                                                     {"+inf", "\"inf\""},
                                                     {"-inf", "\"-inf\""},
                                                     {"nan", "\"nan\""},
                                                     {"4.9e-324", "4.9e-324"},
                                                     {"0e9999999999", "0e9999999999"}}) {
    EXPECT_EQ(Real(typed).json, json) << typed;
    EXPECT_EQ(Real(typed).flaw, NumberFlaw::kNone) << typed;
  }
}

TEST(NumberLiteral, AnIntegerIsExactInAnyNotation) {
  EXPECT_EQ(Integer("9223372036854775807").json, "9223372036854775807");
  EXPECT_EQ(Integer("1e3").json, "1000");
  EXPECT_EQ(Integer("12.50e1").json, "125");
  EXPECT_EQ(Integer("-0").json, "0");
  EXPECT_EQ(ReadNumberLiteral(Kind::kUint64, "18446744073709551615").json, "18446744073709551615");
  for (const char* fraction :
       {"0.5", "1.00000000000000000001", "1e-1", "125e-1", "1e-99999999999"}) {
    EXPECT_EQ(Integer(fraction).flaw, NumberFlaw::kFraction) << fraction;
  }
  for (const char* large : {"9223372036854775808", "1e40", "1e99999999999", "inf", "nan"}) {
    EXPECT_EQ(Integer(large).flaw, NumberFlaw::kLimits) << large;
  }
  EXPECT_EQ(ReadNumberLiteral(Kind::kUint8, "-1").flaw, NumberFlaw::kLimits);
  EXPECT_EQ(ReadNumberLiteral(Kind::kInt8, "128").flaw, NumberFlaw::kLimits);
}

TEST(NumberLiteral, RefusesValuesOutsideTheType) {
  for (const char* word : {"1e999", "-1e999", "1e-400", "2e-324"}) {
    EXPECT_EQ(Real(word).flaw, NumberFlaw::kLimits) << word;
  }
  EXPECT_EQ(ReadNumberLiteral(Kind::kFloat32, "1e39").flaw, NumberFlaw::kLimits);
  EXPECT_EQ(ReadNumberLiteral(Kind::kFloat32, "1e-50").flaw, NumberFlaw::kLimits);
  EXPECT_EQ(ReadNumberLiteral(Kind::kDuration, "3e9").flaw, NumberFlaw::kLimits);
  EXPECT_EQ(ReadNumberLiteral(Kind::kDuration, "1e-10").flaw, NumberFlaw::kLimits);
  EXPECT_EQ(ReadNumberLiteral(Kind::kDuration, "1e-9").json, "1e-9");
  EXPECT_EQ(ReadNumberLiteral(Kind::kDuration, "inf").flaw, NumberFlaw::kLimits);
}

TEST(NumberLiteral, ARefusalSuggestsACorrection) {
  struct Case {
    const char* typed;
    const char* text;
  };
  for (const auto& [typed, text] :
       std::vector<Case>{{"", "a number is missing"},
                         {"0,123", "write 0.123: use a point as the decimal sign"},
                         {"-12,5e3", "write -12.5e3: use a point as the decimal sign"},
                         {"1.234,5", "write 1234.5: use a point as the decimal sign"},
                         {"1 234,5", "write 1234.5: use a point as the decimal sign"},
                         {"1\u202f234,5", "write 1234.5: use a point as the decimal sign"},
                         {"1,234",
                          "write 1.234 or 1234: use a point as the decimal sign, and no separator "
                          "between thousands"},
                         {"1,234.5", "write 1234.5: use no separator between thousands"},
                         {"1'000", "write 1000: use no separator between thousands"},
                         {"1_000", "write 1000: use no separator between thousands"},
                         {"1.234.567", "write 1234567: use no separator between thousands"},
                         {"007", "write 7"},
                         {"-01.5", "write -1.5"},
                         {"0x10", "write 16"},
                         {"Infinity", "write inf"},
                         {"NaN", "write nan"},
                         {"\uff11\uff12", "write 12"},
                         {"\u0661\u066b\u0665", "write 1.5: use a point as the decimal sign"},
                         {"\u22125", "write -5"},
                         {"5deg", "write the number alone, without 'deg'"},
                         {"0,5 rad", "write the number alone, without 'rad'"},
                         {"12 %", "write the number alone, without '%'"},
                         {"fast", "write a number in digits"},
                         {"1,2,3", "write a number in digits"},
                         {"1e999", "the number is too large or too small for the type"}}) {
    EXPECT_EQ(FlawText(Real(typed)), text) << typed;
  }
  EXPECT_EQ(FlawText(Integer("1.5")), "write a whole number");
  EXPECT_THAT(Real("1,234").meant, ElementsAre("1.234", "1234"));
  EXPECT_THAT(Real("1 2").meant, IsEmpty()) << "two numbers";
}

class NumberWordIn : public testing::TestWithParam<std::string> {
 protected:
  test::Locales locales_;
};

INSTANTIATE_TEST_SUITE_P(Locale, NumberWordIn, testing::ValuesIn(test::Locales::Names()),
                         [](const auto& locale) { return locale.param; });

TEST_P(NumberWordIn, IsNeverReadAsAnotherNumber) {
  ASSERT_TRUE(locales_.Use(GetParam())) << "localedef did not make " << GetParam();
  test::RandomWords words(20);
  int read = 0;
  for (int i = 0; i < 50'000; ++i) {
    const std::string word = words.Next();
    for (const Kind kind : {Kind::kFloat64, Kind::kInt64, Kind::kDuration}) {
      const NumberLiteral found = ReadNumberLiteral(kind, word);
      ASSERT_EQ(found.json.empty(), found.flaw != NumberFlaw::kNone) << word;
      ASSERT_EQ(FlawText(found).empty(), found.flaw == NumberFlaw::kNone) << word;
      for (const std::string& meant : found.meant) {
        ASSERT_TRUE(test::WrittenNumberOf(meant) || meant == "inf" || meant == "-inf" ||
                    meant == "nan")
            << word << " -> " << meant;
      }
      if (found.flaw != NumberFlaw::kNone || found.json.starts_with('"')) continue;
      ++read;
      const std::size_t begin = word.find_first_not_of(" \t");
      const std::string bare = word.substr(begin, word.find_last_not_of(" \t") + 1 - begin);
      ASSERT_TRUE(test::WrittenNumberOf(bare)) << word;
      ASSERT_EQ(test::WrittenNumberOf(found.json), test::WrittenNumberOf(bare)) << word;
    }
  }
  EXPECT_GT(read, 1000);
}

}  // namespace
}  // namespace tendon
