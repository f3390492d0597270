#include <gtest/gtest.h>
#include <support/encoded.h>
#include <tendon/payload/codec.h>
#include <tests/core/payload/random_value.h>
#include <tests/core/payload/sample_types.h>

#include <random>
#include <vector>

namespace tendon {
namespace {

using test::Encoded;

/// Decodes from a buffer that is exactly as long as the body, so that a sanitizer detects reads
/// beyond the end.
template <typename T>
bool DecodeExactly(std::span<const std::byte> body, T& value) {
  const std::vector<std::byte> memory(body.begin(), body.end());
  return Decode(memory, value);
}

template <typename T>
T Sample(unsigned seed) {
  std::mt19937 random(seed);
  T value{};
  sample::Randomise(random, value);
  return value;
}

template <typename T>
class DecodeBounds : public testing::Test {};
using BoundedTypes =
    testing::Types<bool, double, std::string, sample::Mode, std::vector<std::string>,
                   std::vector<sample::Ragged>, None, sample::JointState, sample::Numbers,
                   sample::Fixed, sample::Dynamic>;
TYPED_TEST_SUITE(DecodeBounds, BoundedTypes);

TYPED_TEST(DecodeBounds, RefusesABodyTruncatedAtAnyByte) {
  const auto body = Encoded(Sample<TypeParam>(4));
  for (std::size_t size = 0; size < body.size(); ++size) {
    TypeParam value{};
    ASSERT_FALSE(DecodeExactly(std::span(body).first(size), value)) << "cut at " << size;
  }
}

TYPED_TEST(DecodeBounds, AcceptsPaddingOnlyToAMultipleOfEight) {
  const TypeParam sent = Sample<TypeParam>(5);
  auto body = Encoded(sent);
  const std::size_t padded = (body.size() + 7) / 8 * 8;
  for (; body.size() <= padded; body.emplace_back()) {
    TypeParam value{};
    ASSERT_TRUE(DecodeExactly(body, value)) << body.size();
    ASSERT_EQ(value, sent);
  }
  TypeParam value{};
  EXPECT_FALSE(DecodeExactly(body, value)) << body.size();
}

TYPED_TEST(DecodeBounds, AnAcceptedMutatedBodyReencodesToItsSize) {
  std::mt19937 random(6);
  TypeParam value{};
  std::size_t accepted = 0;
  for (int round = 0; round < 5000; ++round) {
    auto body = Encoded(Sample<TypeParam>(static_cast<unsigned>(round % 50)));
    for (auto changes = 1 + random() % 3; changes > 0; --changes) {
      body[random() % body.size()] = static_cast<std::byte>(random());
    }
    if (!DecodeExactly(body, value)) continue;
    ++accepted;
    const std::size_t again = EncodedSize(value);
    ASSERT_LE(again, body.size()) << "round " << round;
    ASSERT_LT(body.size() - again, 8U) << "round " << round;
  }
  EXPECT_GT(accepted, 0U);
}

TEST(Decode, RefusesAnEmptyBodyEvenForNone) {
  None none;
  EXPECT_FALSE(Decode({}, none));
}

TEST(Decode, RefusesABoolOtherThanZeroOrOne) {
  bool value = false;
  for (const int byte : {2, 128, 255}) {
    const std::array body{static_cast<std::byte>(byte)};
    EXPECT_FALSE(Decode(body, value)) << byte;
  }
}

TEST(Decode, RefusesAnUnnamedEnumValue) {
  sample::Mode mode{};
  EXPECT_TRUE(Decode(Encoded(std::int32_t{5}), mode));
  EXPECT_EQ(mode, sample::Mode::kTracking);
  EXPECT_FALSE(Decode(Encoded(std::int32_t{1}), mode));
}

TEST(Decode, AnEnumWithoutNamesFitsItsType) {
  sample::Plain plain{};
  EXPECT_TRUE(Decode(Encoded(std::int32_t{255}), plain));
  EXPECT_FALSE(Decode(Encoded(std::int32_t{256}), plain));
  EXPECT_FALSE(Decode(Encoded(std::int32_t{-1}), plain));
}

TEST(Decode, AStringEndsWithItsTerminator) {
  auto body = Encoded(std::string("abc"));
  std::string text;
  body.back() = std::byte{'d'};
  EXPECT_FALSE(Decode(body, text));
  EXPECT_FALSE(Decode(Encoded(std::uint32_t{0}), text));
}

TEST(Decode, ASecondHasLessThanABillionNanoseconds) {
  std::chrono::nanoseconds time{};
  EXPECT_TRUE(Decode(Encoded(std::array<std::uint32_t, 2>{1, 999'999'999}), time));
  EXPECT_FALSE(Decode(Encoded(std::array<std::uint32_t, 2>{1, 1'000'000'000}), time));
}

TEST(Decode, AnExcessiveLengthAllocatesNothing) {
  for (const std::uint32_t length : {2U, 0x7fffffffU, 0x80000000U, 0xffffffffU}) {
    auto body = Encoded(length);
    body.resize(4 + 8 + 4);  // padding and one double
    std::vector<double> doubles;
    EXPECT_FALSE(DecodeExactly(body, doubles)) << length;
    EXPECT_EQ(doubles.capacity(), 0U) << length;
    std::vector<std::string> strings;
    EXPECT_FALSE(DecodeExactly(body, strings)) << length;
    EXPECT_LE(strings.capacity(), 2U) << length;
    std::vector<sample::JointState> states;
    EXPECT_FALSE(DecodeExactly(body, states)) << length;
    EXPECT_EQ(states.capacity(), 0U) << length;
    std::string text;
    EXPECT_FALSE(DecodeExactly(body, text)) << length;
    std::vector<None> nothings;
    EXPECT_EQ(DecodeExactly(body, nothings), false) << length;
    EXPECT_LE(nothings.capacity(), body.size()) << length;
  }
}

}  // namespace
}  // namespace tendon
