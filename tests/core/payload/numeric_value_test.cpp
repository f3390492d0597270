#include <gtest/gtest.h>
#include <support/encoded.h>
#include <tendon/payload/codec.h>
#include <tendon/payload/numeric_field.h>
#include <tendon/payload/numeric_value.h>
#include <tests/core/payload/sample_types.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace tendon {
namespace {

using test::Encoded;

template <Payload T>
NumericValue ValueOf(const T& number) {
  return ReadExactly(NumericFields(SchemaOf<T>()).at(0), Encoded(number)).value();
}
template <Payload T>
std::string TextOf(const T& number) {
  return ToString(SchemaOf<T>(), ValueOf(number));
}

// Above this limit, doubles cannot represent every integer.
constexpr std::int64_t kExact = std::int64_t{1} << 53;

TEST(NumericValue, IntegersKeepAllDigits) {
  EXPECT_EQ(TextOf(kExact + 1), "9007199254740993");
  EXPECT_EQ(TextOf(std::numeric_limits<std::int64_t>::min()), "-9223372036854775808");
  EXPECT_EQ(TextOf(std::numeric_limits<std::uint64_t>::max()), "18446744073709551615");
  EXPECT_EQ(TextOf(std::int8_t{-128}), "-128");
  EXPECT_EQ(TextOf(std::uint8_t{255}), "255");
}

TEST(NumericValue, FloatsHaveTheirShortestExactText) {
  EXPECT_EQ(TextOf(0.1F), "0.1");
  EXPECT_EQ(TextOf(0.1), "0.1");
  EXPECT_EQ(TextOf(-0.0), "-0");
  EXPECT_EQ(TextOf(std::numeric_limits<double>::max()), "1.7976931348623157e+308");
  EXPECT_EQ(TextOf(std::numeric_limits<double>::denorm_min()), "5e-324");
  EXPECT_EQ(TextOf(-std::numeric_limits<double>::infinity()), "-inf");
  EXPECT_EQ(TextOf(std::copysign(std::numeric_limits<double>::quiet_NaN(), -1.0)), "nan");
}

TEST(NumericValue, BoolsAndEnumsHaveTheirNames) {
  EXPECT_EQ(TextOf(true), "true");
  EXPECT_EQ(TextOf(false), "false");
  const Schema mode = Schema::Enum("test.Mode", {{"off", -1}, {"on", 2}});

  EXPECT_EQ(ToString(mode, NumericValue(std::int32_t{-1})), "off");
  EXPECT_EQ(ToString(mode, NumericValue(std::int32_t{2})), "on");
  EXPECT_EQ(ToString(mode, NumericValue(std::int32_t{7})), "7");
}

TEST(NumericValue, DurationsKeepTheirNanoseconds) {
  using std::chrono::nanoseconds;
  using std::chrono::seconds;
  EXPECT_EQ(TextOf(nanoseconds(-1'000'000'001)), "-1.000000001");
  EXPECT_EQ(TextOf(nanoseconds(-500'000'000)), "-0.5");
  EXPECT_EQ(TextOf(seconds(2'147'483'647) + nanoseconds(123'456'789)), "2147483647.123456789");
  EXPECT_EQ(TextOf(nanoseconds(seconds(-2'147'483'648))), "-2147483648");
  EXPECT_EQ(ValueOf(nanoseconds(1'500'000'000)).real(), 1.5);
}

TEST(NumericValue, EqualityComparesBits) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(NumericValue(none), NumericValue(none));
  EXPECT_FALSE(NumericValue(0.0) == NumericValue(-0.0));
  EXPECT_FALSE(ValueOf(kExact + 1) == ValueOf(kExact));
}

TEST(NumericValue, StatesAndCountsAreDrawnAsSteps) {
  EXPECT_TRUE(IsStepped(SchemaOf<bool>()));
  EXPECT_TRUE(IsStepped(SchemaOf<std::uint64_t>()));
  EXPECT_TRUE(IsStepped(SchemaOf<std::int8_t>()));
  EXPECT_TRUE(IsStepped(Schema::Enum("test.Mode", {{"off", 0}})));
  EXPECT_FALSE(IsStepped(SchemaOf<float>()));
  EXPECT_FALSE(IsStepped(SchemaOf<double>()));
  EXPECT_FALSE(IsStepped(SchemaOf<std::chrono::nanoseconds>()));
}

}  // namespace
}  // namespace tendon
