#include <gtest/gtest.h>
#include <tendon/recording/mcap/compression.h>

#include <random>
#include <string>

namespace tendon::mcap {
namespace {

Buffer Sawtooth(std::size_t size) {
  Buffer bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::byte>(i % 200 * (i / 5000));
  return bytes;
}

class CompressionTest : public testing::TestWithParam<Compression> {};

INSTANTIATE_TEST_SUITE_P(, CompressionTest,
                         testing::Values(Compression::kNone, Compression::kLz4, Compression::kZstd),
                         [](const auto& compression) {
                           return std::string(NameOf(compression.param));
                         });

TEST_P(CompressionTest, ReturnsTheBytesThatWereCompressed) {
  Compressor compressor(GetParam());
  for (const std::size_t size : {100'000U, 1'000U, 3'000'000U}) {
    const Buffer bytes = Sawtooth(size);
    Compression used = Compression::kNone;
    const auto compressed = compressor.Compress(bytes, used);
    ASSERT_TRUE(compressed);
    EXPECT_EQ(used, GetParam());
    EXPECT_GE(LargestDecompressed(used, compressed->size()), bytes.size());

    Buffer out(bytes.size());
    ASSERT_TRUE(Decompress(used, *compressed, out));
    EXPECT_EQ(out, bytes);
  }
}

TEST_P(CompressionTest, LeavesBytesAloneThatCannotBeMadeSmaller) {
  std::mt19937 random(3);
  Buffer bytes(5000);
  for (std::byte& byte : bytes) byte = static_cast<std::byte>(random());
  Compressor compressor(GetParam());
  Compression used = Compression::kZstd;

  const auto compressed = compressor.Compress(bytes, used);

  ASSERT_TRUE(compressed);
  EXPECT_EQ(used, Compression::kNone);
  EXPECT_EQ(compressed->data(), bytes.data());
}

TEST_P(CompressionTest, AnotherSizeThanTheStatedOneIsAnError) {
  const Buffer bytes = Sawtooth(10'000);
  Compressor compressor(GetParam());
  Compression used = Compression::kNone;
  const auto compressed = compressor.Compress(bytes, used);
  ASSERT_TRUE(compressed);

  for (const std::size_t size : {std::size_t{0}, bytes.size() - 1, bytes.size() + 1}) {
    Buffer out(size);
    const auto done = Decompress(used, *compressed, out);
    ASSERT_FALSE(done) << size;
    EXPECT_EQ(done.error().code, ErrorCode::kInvalid);
  }
}

TEST_P(CompressionTest, BytesThatAreCutOffAreAnError) {
  const Buffer bytes = Sawtooth(10'000);
  Compressor compressor(GetParam());
  Compression used = Compression::kNone;
  const auto compressed = compressor.Compress(bytes, used);
  ASSERT_TRUE(compressed);

  for (std::size_t size = 0; size < compressed->size(); ++size) {
    Buffer out(bytes.size());
    EXPECT_FALSE(Decompress(used, compressed->first(size), out)) << size;
  }
}

TEST(CompressionNames, InAFileAreThoseOfTheFormat) {
  EXPECT_EQ(*ParseFormatName(""), Compression::kNone);
  EXPECT_EQ(*ParseFormatName("lz4"), Compression::kLz4);
  EXPECT_EQ(*ParseFormatName("zstd"), Compression::kZstd);
  EXPECT_FALSE(ParseFormatName("none"));
  EXPECT_FALSE(ParseFormatName("ZSTD"));
}

TEST(CompressionNames, EachNameIsReadAsItIsWritten) {
  for (const Compression compression : kCompressions) {
    EXPECT_EQ(*ParseCompression(NameOf(compression)), compression);
    EXPECT_EQ(*ParseFormatName(FormatNameOf(compression)), compression);
  }
}

TEST(CompressionNames, AnUnknownNameIsAnErrorWithTheKnownNames) {
  const auto refused = ParseCompression("bzip2");

  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kInvalid);
  EXPECT_EQ(refused.error().message, "there is no compression 'bzip2'; known: none, lz4, zstd");
}

TEST(Crc32Test, IsTheOneOfTheFormat) {
  const std::string digits = "123456789";
  const ByteView bytes = std::as_bytes(std::span(digits));

  EXPECT_EQ(Crc32(bytes), 0xcbf43926U);  // the check value of CRC-32/ISO-HDLC
  EXPECT_EQ(Crc32(bytes.subspan(4), Crc32(bytes.first(4))), 0xcbf43926U);
  EXPECT_EQ(CombinedCrc32(Crc32(bytes.first(4)), Crc32(bytes.subspan(4)), 5), 0xcbf43926U);
}

}  // namespace
}  // namespace tendon::mcap
