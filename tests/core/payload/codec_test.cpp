#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/encoded.h>
#include <tendon/payload/codec.h>
#include <tests/core/payload/random_value.h>
#include <tests/core/payload/sample_types.h>

#include <bit>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <vector>

namespace tendon {
namespace {

using std::chrono::hours;
using std::chrono::milliseconds;
using std::chrono::nanoseconds;
using testing::ElementsAre;

std::vector<std::byte> Bytes(std::initializer_list<int> values) {
  std::vector<std::byte> bytes;
  for (const int value : values) bytes.push_back(static_cast<std::byte>(value));
  return bytes;
}

using test::Encoded;

TEST(Codec, ANumberIsAlignedToItsSizeFromTheStartOfTheBody) {
  const sample::Ragged ragged{true, 0, 2, 3, true, 0, 9};

  const auto body = Encoded(ragged);

  ASSERT_EQ(body.size(), 29U);
  EXPECT_EQ(body[0], std::byte{1});
  EXPECT_EQ(body[16], std::byte{2});
  EXPECT_EQ(body[18], std::byte{3});
  EXPECT_EQ(body[20], std::byte{1});
  EXPECT_EQ(body[28], std::byte{9});
}

TEST(Codec, PaddingIsAlwaysZero) {
  std::vector<std::byte> body(64, std::byte{0xee});

  Encode(sample::Ragged{}, body);

  EXPECT_THAT(body, testing::Each(std::byte{0}));
}

TEST(Codec, AStringHasItsLengthAndATerminator) {
  EXPECT_EQ(Encoded(std::string("ab")), Bytes({3, 0, 0, 0, 'a', 'b', 0}));
}

TEST(Codec, AnEnumIsEncodedAsInt32) {
  EXPECT_EQ(Encoded(sample::Mode::kFault), Bytes({0xff, 0xff, 0xff, 0xff}));
  EXPECT_EQ(Encoded(sample::Plain::kLarge), Bytes({200, 0, 0, 0}));
}

TEST(Codec, NoneIsOneZeroByte) {
  EXPECT_EQ(Encoded(None{}), Bytes({0}));
  EXPECT_EQ(kEncodedSize<None>, 1U);
}

TEST(Codec, ANegativeDurationHasPositiveNanoseconds) {
  EXPECT_EQ(Encoded(milliseconds(-1500)), Bytes({0xfe, 0xff, 0xff, 0xff, 0, 0x65, 0xcd, 0x1d}));
}

TEST(Codec, ADurationOutOfRangeBecomesTheLongest) {
  hours decoded{};

  ASSERT_TRUE(Decode(Encoded(hours(100'000'000)), decoded));
  EXPECT_EQ(decoded, hours(596523));
  ASSERT_TRUE(Decode(Encoded(hours::min()), decoded));
  EXPECT_EQ(decoded, hours(-596523));
}

TEST(Codec, ADurationInFloatingPointIsRoundedToNanoseconds) {
  using Seconds = std::chrono::duration<double>;
  nanoseconds decoded{};

  ASSERT_TRUE(Decode(Encoded(Seconds(0.3)), decoded));
  EXPECT_EQ(decoded, milliseconds(300));
  ASSERT_TRUE(Decode(Encoded(Seconds(-1e-20)), decoded));
  EXPECT_EQ(decoded, nanoseconds(0));
  ASSERT_TRUE(Decode(Encoded(Seconds(std::numeric_limits<double>::quiet_NaN())), decoded));
  EXPECT_EQ(decoded, nanoseconds(0));
}

TEST(Codec, ADurationIsTruncatedToTheReceiversUnit) {
  std::chrono::duration<std::int16_t, std::milli> decoded{};

  ASSERT_TRUE(Decode(Encoded(nanoseconds(1'999'999)), decoded));
  EXPECT_EQ(decoded.count(), 1);
  EXPECT_FALSE(Decode(Encoded(std::chrono::seconds(33)), decoded));
}

/// Unusual numbers, such as NaN, must arrive with the same bits.
template <typename Number, typename Word>
void ExpectEveryBitKept() {
  using Limits = std::numeric_limits<Number>;
  const auto payload_of_nan = static_cast<Word>(std::bit_cast<Word>(Limits::quiet_NaN()) | 0x1234U);
  const std::vector<Number> odd{Limits::quiet_NaN(),
                                -Limits::quiet_NaN(),
                                Limits::signaling_NaN(),
                                Limits::infinity(),
                                -Limits::infinity(),
                                Limits::denorm_min(),
                                -Limits::denorm_min(),
                                Number(-0.0),
                                Limits::max(),
                                Limits::lowest(),
                                std::bit_cast<Number>(payload_of_nan)};
  std::vector<Number> decoded;

  ASSERT_TRUE(Decode(Encoded(odd), decoded));

  ASSERT_EQ(decoded.size(), odd.size());
  for (std::size_t i = 0; i < odd.size(); ++i) {
    EXPECT_EQ(std::bit_cast<Word>(decoded[i]), std::bit_cast<Word>(odd[i])) << i;
  }
}

TEST(Codec, ANumberKeepsEveryBitEvenForNan) {
  ExpectEveryBitKept<double, std::uint64_t>();
  ExpectEveryBitKept<float, std::uint32_t>();
}

TEST(Codec, TheSizeOfAFixedTypeIsAConstant) {
  static_assert(kEncodedSize<sample::JointState> == 112);
  static_assert(kEncodedSize<sample::Ragged> == 29);

  std::mt19937 random(3);
  for (int round = 0; round < 100; ++round) {
    sample::Fixed value;
    sample::Randomise(random, value);
    ASSERT_EQ(Encoded(value).size(), kEncodedSize<sample::Fixed>);
  }
}

TEST(Codec, EncodeToWritesNothingIfItDoesNotFit) {
  std::vector<std::byte> out(111, std::byte{7});

  EXPECT_EQ(EncodeTo(sample::JointState{}, std::span(out)), 0U);

  EXPECT_THAT(out, testing::Each(std::byte{7}));
}

TEST(Codec, EncodeToWritesAtTheFrontAndReturnsTheSize) {
  std::vector<std::byte> out(20, std::byte{7});

  EXPECT_EQ(EncodeTo(std::int64_t{1}, std::span(out)), 8U);

  EXPECT_EQ(out[0], std::byte{1});
  EXPECT_EQ(out[8], std::byte{7});
}

TEST(Codec, EncodeReplacesTheContentAndKeepsTheMemory) {
  std::vector<std::byte> body;
  Encode(std::string(100, 'x'), body);
  const auto* memory = body.data();

  Encode(std::string("ab"), body);

  EXPECT_EQ(body, Bytes({3, 0, 0, 0, 'a', 'b', 0}));
  EXPECT_EQ(body.data(), memory);
}

TEST(Codec, DecodeKeepsTheMemoryOfStringsAndVectors) {
  sample::Dynamic value;
  value.name.assign(100, 'n');
  value.samples.assign(50, 1.0);
  value.words.assign(3, std::string(64, 'w'));
  sample::Dynamic decoded = value;
  const auto* name = decoded.name.data();
  const auto* samples = decoded.samples.data();
  const auto* word = decoded.words[2].data();
  value.name = "short";

  ASSERT_TRUE(Decode(Encoded(value), decoded));

  EXPECT_EQ(decoded, value);
  EXPECT_EQ(decoded.name.data(), name);
  EXPECT_EQ(decoded.samples.data(), samples);
  EXPECT_EQ(decoded.words[2].data(), word);
}

TEST(Codec, AStringMayHoldZeros) {
  const std::string text("a\0b", 3);
  std::string decoded;

  ASSERT_TRUE(Decode(Encoded(text), decoded));

  EXPECT_EQ(decoded, text);
}

}  // namespace
}  // namespace tendon
