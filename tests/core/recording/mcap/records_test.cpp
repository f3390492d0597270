#include <gtest/gtest.h>
#include <tendon/recording/mcap/records.h>

#include <limits>
#include <string_view>

namespace tendon::mcap {
namespace {

ByteView ContentOf(const Buffer& record) { return ByteView(record).subspan(kRecordHeadSize); }

/// Writes the record, and reads it complete, with additional bytes, and cut at each byte.
template <typename Record>
void ExpectRoundTrip(Opcode opcode, const Record& record) {
  Buffer bytes;
  Append(bytes, record);

  const RecordHead head = ParseRecordHead(bytes);
  EXPECT_EQ(head.opcode, opcode);
  EXPECT_EQ(head.length, bytes.size() - kRecordHeadSize);
  Record read;
  EXPECT_EQ(Parse(ContentOf(bytes), read), ParseResult::kExact);
  EXPECT_EQ(read, record);

  for (std::size_t size = 0; size < bytes.size() - kRecordHeadSize; ++size) {
    Record cut;
    EXPECT_EQ(Parse(ContentOf(bytes).first(size), cut), ParseResult::kMalformed) << size;
  }
  bytes.push_back(std::byte{1});  // a field of a later version
  Record longer;
  EXPECT_EQ(Parse(ContentOf(bytes), longer), ParseResult::kLonger);
  EXPECT_EQ(longer, record);
}

TEST(McapRecords, EveryKindReadsAsItWasWritten) {
  constexpr std::uint64_t kLarge = std::numeric_limits<std::uint64_t>::max();
  ExpectRoundTrip(Opcode::kHeader, Header{"ros2", "tendon 0.1"});
  ExpectRoundTrip(Opcode::kFooter, Footer{100, kLarge, 0x12345678});
  ExpectRoundTrip(Opcode::kSchema, Schema{65'535, "arm/msg/Pose", "ros2msg", "float64 x\n"});
  ExpectRoundTrip(Opcode::kChannel, Channel{7, 3, "a/b", "cdr", {{"", "x"}, {"key", ""}}});
  ExpectRoundTrip(Opcode::kMessageIndex, MessageIndex{9, {{1, 2}, {kLarge, 4}, {0, kLarge}}});
  ExpectRoundTrip(Opcode::kChunkIndex,
                  ChunkIndex{1, kLarge, 3, 4, {{1, 100}, {65'535, kLarge}}, 5, "zstd", 6, 7});
  ExpectRoundTrip(Opcode::kAttachmentIndex, AttachmentIndex{1, 2, 3, 4, 5, "name", "text/plain"});
  ExpectRoundTrip(Opcode::kMetadata, Metadata{"clock", {{"a", "b"}, {"c", "d"}}});
  ExpectRoundTrip(Opcode::kMetadataIndex, MetadataIndex{1, 2, "clock"});
  ExpectRoundTrip(Opcode::kStatistics,
                  Statistics{kLarge, 2, 3, 4, 5, 6, 7, 8, {{1, 9}, {65'535, kLarge}}});
  ExpectRoundTrip(Opcode::kSummaryOffset, SummaryOffset{8, 1, kLarge});
  ExpectRoundTrip(Opcode::kDataEnd, DataEnd{0x87654321});
}

TEST(McapRecords, AMessageReadsAsItWasWritten) {
  constexpr std::string_view kData = "seven bytes, and more";
  Buffer bytes;
  Append(bytes, Message{513, 70'000, 1, 2, std::as_bytes(std::span(kData))});

  Message read;
  ASSERT_EQ(Parse(ContentOf(bytes), read), ParseResult::kExact);
  EXPECT_EQ(read.channel_id, 513);
  EXPECT_EQ(read.sequence, 70'000U);
  EXPECT_EQ(read.log_time, 1U);
  EXPECT_EQ(read.publish_time, 2U);
  EXPECT_EQ(std::string_view(reinterpret_cast<const char*>(read.data.data()), read.data.size()),
            kData);
  for (std::size_t size = 0; size < kMessageHeadSize; ++size) {
    EXPECT_EQ(Parse(ContentOf(bytes).first(size), read), ParseResult::kMalformed);
  }
}

TEST(McapRecords, TheHeadsOfChunksAndAttachmentsReadAsTheyWereWritten) {
  const ChunkHead chunk{1, 2, 300, 4, "zstd", 5};
  Buffer bytes;
  AppendChunkHead(bytes, chunk);
  ChunkHead read;
  const auto begin = ParseChunkHead(ContentOf(bytes), ParseRecordHead(bytes).length, read);
  ASSERT_TRUE(begin);
  EXPECT_EQ(*begin, bytes.size() - kRecordHeadSize);
  EXPECT_EQ(read, chunk);
  EXPECT_FALSE(ParseChunkHead(ContentOf(bytes), ParseRecordHead(bytes).length - 1, read));

  const Attachment attachment{1, 2, "name", "text/plain", Buffer(3)};
  Buffer other;
  AppendAttachmentHead(other, attachment);
  Attachment read_attachment;
  std::uint64_t size = 0;
  const std::uint64_t length = ParseRecordHead(other).length;
  EXPECT_EQ(ParseAttachmentHead(ContentOf(other), length, read_attachment, size),
            other.size() - kRecordHeadSize);
  EXPECT_EQ(size, 3U);
  EXPECT_EQ(read_attachment.name, "name");
  EXPECT_FALSE(ParseAttachmentHead(ContentOf(other), length - 1, read_attachment, size));
}

TEST(McapRecords, TheBytesAreThoseOfTheSpecification) {
  Buffer bytes;
  Append(bytes, Channel{0x0201, 0x0403, "t", "cdr", {{"k", "vw"}}});

  const unsigned char expected[] = {0x04,                                // opcode
                                    31,   0,    0, 0, 0,   0,   0,   0,  // length
                                    0x01, 0x02,                          // id
                                    0x03, 0x04,                          // schema
                                    1,    0,    0, 0, 't',               // topic
                                    3,    0,    0, 0, 'c', 'd', 'r',     // encoding
                                    11,   0,    0, 0,                    // bytes of the map
                                    1,    0,    0, 0, 'k', 2,   0,   0, 0, 'v', 'w'};  // key, value
  ASSERT_EQ(bytes.size(), sizeof(expected));
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    EXPECT_EQ(std::to_integer<unsigned>(bytes[i]), expected[i]) << i;
  }
}

TEST(McapRecords, ALengthThatClaimsMoreThanThereIsIsMalformed) {
  for (const std::size_t place : {0U, 4U + 4U}) {  // the lengths of the two strings
    Buffer bytes;
    Append(bytes, Header{"ros2", "tendon"});
    for (std::size_t i = 0; i < 4; ++i) bytes[kRecordHeadSize + place + i] = std::byte{0xff};
    Header header;
    EXPECT_EQ(Parse(ContentOf(bytes), header), ParseResult::kMalformed);
  }
}

TEST(McapRecords, AKeyThatOccursTwiceKeepsItsFirstValue) {
  Buffer bytes;
  Append(bytes, Metadata{"m", {{"a", "1"}, {"b", "2"}}});
  bytes[bytes.size() - 6] = std::byte{'a'};  // changes the key "b"

  Metadata read;
  ASSERT_EQ(Parse(ContentOf(bytes), read), ParseResult::kExact);
  EXPECT_EQ(read, (Metadata{"m", {{"a", "1"}}}));
}

TEST(RecordSequence, EndsAtTheFirstThatIsNoRecord) {
  Buffer bytes;
  Append(bytes, DataEnd{1});
  const std::size_t end = bytes.size();
  Append(bytes, DataEnd{2});
  bytes.pop_back();

  RecordSequence records(bytes);
  ASSERT_TRUE(records.Next());
  EXPECT_FALSE(records.Next());
  EXPECT_TRUE(records.is_malformed());
  EXPECT_EQ(records.offset(), end);

  const Buffer zeros(20);
  RecordSequence none(zeros);
  EXPECT_FALSE(none.Next());
  EXPECT_TRUE(none.is_malformed());
  EXPECT_FALSE(RecordSequence(ByteView{}).Next());
}

}  // namespace
}  // namespace tendon::mcap
