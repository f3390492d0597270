#include <gtest/gtest.h>
#include <support/property.h>
#include <tendon/payload/json.h>
#include <tendon/payload/numeric_field.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace tendon {
namespace {

/// Returns the digits of a number before its exponent, without zeros that only show its magnitude.
std::string SignificantDigits(const std::string& text) {
  std::string digits;
  for (const char letter : text.substr(0, text.find('e'))) {
    if (letter >= '0' && letter <= '9') digits += letter;
  }
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size()));
  digits.erase(digits.find_last_not_of('0') + 1);
  return digits;
}

/// Returns the fewest digits from which the C library reads the same bits, found by trying.
int FewestDigits(double value) {
  for (int digits = 1;; ++digits) {
    char text[64];
    std::snprintf(text, sizeof(text), "%.*e", digits - 1, value);
    if (digits == 17 || std::strtod(text, nullptr) == value) return digits;
  }
}

TEST(JsonNumbersProperty, DoublesReadBackAsTheSameBitsAndAreShort) {
  test::CheckProperty([] {
    const double value = *test::AnyFinite();
    const std::string text = ToJson(value);

    RC_ASSERT(std::bit_cast<std::uint64_t>(std::strtod(text.c_str(), nullptr)) ==
              std::bit_cast<std::uint64_t>(value));
    const auto back = FromJson<double>(text);
    RC_ASSERT(back.ok());
    RC_ASSERT(std::bit_cast<std::uint64_t>(*back) == std::bit_cast<std::uint64_t>(value));
    if (value == 0) return;
    const int fewest = FewestDigits(value);
    char with_exponent[64];
    const int size = std::snprintf(with_exponent, sizeof(with_exponent), "%.*e", fewest - 1, value);
    // An integer such as 18446744073709551616 may have all its digits, if this text is not longer.
    RC_ASSERT(SignificantDigits(text).size() <= static_cast<std::size_t>(fewest) ||
              text.size() <= static_cast<std::size_t>(size));
  });
}

TEST(JsonNumbersProperty, DurationsReadBackToTheNanosecond) {
  using std::chrono::nanoseconds;
  const nanoseconds since_1970(2'000'000'000'123'456'789);
  EXPECT_EQ(FromJson<nanoseconds>("2000000000.123456789").value(), since_1970);
  EXPECT_EQ(FromJson<nanoseconds>("\"2000000000.123456789\"").value(), since_1970)
      << "as text, where it comes through a program that keeps doubles";
  EXPECT_FALSE(FromJson<nanoseconds>("\"2\"").ok());
  EXPECT_FALSE(FromJson<nanoseconds>("2147483648.123456789").ok());
  test::CheckProperty([] {
    constexpr std::int64_t kLimit = std::int64_t{2147483647} * 1'000'000'000;
    const nanoseconds value(*rc::gen::inRange<std::int64_t>(-kLimit, kLimit));
    const std::vector both{value, value};
    const std::string text = ToJson(both);
    const auto back = FromJson<std::vector<nanoseconds>>(text);
    RC_LOG() << text << ' ' << (back ? "" : back.error().message);
    RC_ASSERT(back.ok());
    RC_ASSERT(*back == both);
  });
}

TEST(JsonNumbersProperty, NanAndInfinitiesHaveOneForm) {
  test::CheckProperty([] {
    const double value =
        *rc::gen::suchThat(test::AnyDouble(), [](double any) { return !std::isfinite(any); });
    RC_ASSERT(ToJson(value) == (std::isnan(value) ? "\"nan\""
                                : value > 0       ? "\"inf\""
                                                  : "\"-inf\""));
  });
}

template <typename Integer>
void CheckIntegers() {
  test::CheckProperty([] {
    const auto value = *test::AnyInteger<Integer>();
    const std::string text = ToJson(value);
    RC_ASSERT(text == std::to_string(value));
    RC_ASSERT(FromJson<Integer>(text).value() == value);
  });
}

TEST(JsonNumbersProperty, IntegersKeepEveryDigit) {
  CheckIntegers<std::int64_t>();
  CheckIntegers<std::uint64_t>();
  CheckIntegers<std::int32_t>();
  CheckIntegers<std::uint8_t>();
}

/// Checks that a single number and a whole body give the same text.
template <Payload T>
void CheckAlike(const T& value) {
  std::vector<std::byte> body;
  Encode(value, body);
  const auto field = NumericFields(SchemaOf<T>()).at(0);
  RC_ASSERT(ToJson(field.schema, ReadExactly(field, body).value()) == ToJson(value));
}

TEST(JsonNumbersProperty, ASingleNumberIsWrittenAsWithinAPayload) {
  test::CheckProperty([] {
    CheckAlike(*test::AnyDouble());
    CheckAlike(static_cast<float>(*rc::gen::arbitrary<double>()));
    CheckAlike(*test::AnyInteger<std::int64_t>());
    CheckAlike(*test::AnyInteger<std::uint64_t>());
    CheckAlike(*rc::gen::arbitrary<bool>());
    CheckAlike(std::chrono::nanoseconds(
        *rc::gen::inRange<std::int64_t>(-2'000'000'000'000'000'000, 2'000'000'000'000'000'000)));
  });
}

}  // namespace
}  // namespace tendon
