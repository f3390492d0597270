#include <gtest/gtest.h>
#include <tendon/payload/codec.h>
#include <tests/core/payload/random_value.h>
#include <tests/core/payload/sample_types.h>

#include <utility>

#include "core/payload/fast_cdr.h"

namespace tendon {
namespace {

using eprosima::fastcdr::Cdr;

/// Passes a value to Fast CDR like generated code of DDS: field by field, and lists of numbers at
/// once.
template <typename T>
void Serialize(Cdr& cdr, const T& value) {
  if constexpr (std::same_as<T, std::byte>) {
    cdr << static_cast<std::uint8_t>(value);
  } else if constexpr (payload::Number<T> || payload::Text<T>) {
    cdr << value;
  } else if constexpr (payload::Enum<T>) {
    cdr << static_cast<std::int32_t>(value);
  } else if constexpr (payload::TimeSpan<T>) {
    const auto seconds = std::chrono::floor<std::chrono::seconds>(value);
    const std::chrono::nanoseconds rest = value - seconds;
    cdr << static_cast<std::int32_t>(seconds.count()) << static_cast<std::uint32_t>(rest.count());
  } else if constexpr (std::same_as<T, std::vector<double>> || std::same_as<T, std::vector<bool>> ||
                       std::same_as<T, std::vector<std::string>> ||
                       std::same_as<T, std::array<double, 7>>) {
    cdr << value;
  } else if constexpr (payload::Array<T>) {
    for (const auto& element : value) Serialize(cdr, element);
  } else if constexpr (payload::Sequence<T>) {
    cdr << static_cast<std::uint32_t>(value.size());
    for (const auto& element : value) Serialize(cdr, element);
  } else {
    payload::WithFields<T>([&](const auto&... field) {
      if constexpr (sizeof...(field) == 0) cdr << std::uint8_t{0};
      (Serialize(cdr, value.*field.member), ...);
    });
  }
}

template <typename T>
std::vector<std::byte> EncodedByFastCdr(const T& value) {
  return test::WrittenByFastCdr([&](Cdr& cdr) { Serialize(cdr, value); });
}

template <typename T>
class FastCdr : public testing::Test {};

using CdrTypes =
    testing::Types<bool, std::int8_t, std::uint8_t, std::byte, std::int16_t, std::uint16_t,
                   std::int32_t, std::uint32_t, std::int64_t, std::uint64_t, float, double,
                   std::string, sample::Mode, sample::Plain, std::chrono::nanoseconds,
                   std::vector<double>, std::vector<std::uint8_t>, std::vector<std::string>,
                   std::vector<bool>, std::vector<sample::Point>, std::vector<sample::Ragged>,
                   std::array<double, 7>, std::array<bool, 3>, None, sample::JointState,
                   sample::Ragged, sample::Numbers, sample::Fixed, sample::Dynamic>;
TYPED_TEST_SUITE(FastCdr, CdrTypes);

TYPED_TEST(FastCdr, WritesTheSameBytes) {
  std::mt19937 random(1);
  std::vector<std::byte> body;
  for (int round = 0; round < 200; ++round) {
    TypeParam value{};
    sample::Randomise(random, value);

    Encode(value, body);

    ASSERT_EQ(body, EncodedByFastCdr(value)) << "round " << round;
  }
}

TYPED_TEST(FastCdr, IsReadBack) {
  std::mt19937 random(2);
  TypeParam decoded{};
  for (int round = 0; round < 200; ++round) {
    TypeParam value{};
    sample::Randomise(random, value);

    ASSERT_TRUE(Decode(EncodedByFastCdr(value), decoded)) << "round " << round;

    ASSERT_EQ(decoded, value) << "round " << round;
  }
}

TEST(FastCdrEmpty, AnEmptySequenceOfDoublesIsNotPaddedToEight) {
  const sample::Dynamic empty;
  std::vector<std::byte> body;

  Encode(empty, body);

  EXPECT_EQ(body, EncodedByFastCdr(empty));
}

}  // namespace
}  // namespace tendon
