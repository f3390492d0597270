#include <core/recording/recordings.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/folder.h>
#include <tendon/recording/mcap/reader.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>

#include "handmade_file.h"

namespace tendon::mcap {
namespace {

using testing::HasSubstr;

constexpr std::uint64_t kHuge = std::uint64_t{1} << 60U;
constexpr std::uint64_t kNegative = std::uint64_t{1} << 63U;
constexpr std::uint64_t kLargest = std::numeric_limits<std::uint64_t>::max();

Channel ChannelWith(ChannelId id, std::string topic = "t") {
  return {id, 0, std::move(topic), "cdr", {}};
}

Message At(Timestamp time, ChannelId channel = 1, std::string_view data = "x") {
  return {channel, static_cast<std::uint32_t>(time), time, time, BytesOf(data)};
}

std::vector<Timestamp> TimesOf(const std::vector<StoredMessage>& messages) {
  std::vector<Timestamp> times;
  for (const StoredMessage& message : messages) times.push_back(message.log_time);
  return times;
}

std::string ErrorOf(std::string_view text) {
  const ByteView bytes = BytesOf(text);
  const auto reader =
      Reader::Open(std::make_unique<test::MemoryFile>(Buffer(bytes.begin(), bytes.end())));
  return reader ? "" : reader.error().message;
}

TEST(Reader, AFileThatIsNoRecordingIsNamedForWhatItIs) {
  EXPECT_EQ(ErrorOf(""), "memory.mcap is not a recording: it is empty");
  EXPECT_EQ(ErrorOf("\x89MCA"), "memory.mcap is not a recording: the file ends after 4 bytes");
  EXPECT_EQ(ErrorOf("PK\x03\x04 and so on"),
            "memory.mcap is not a recording: the file begins with 'PK\\x03\\x04 and', but an MCAP "
            "file begins with '\\x89MCAP0'; it may be a ZIP archive");
  EXPECT_EQ(ErrorOf("\x89MCAP1\r\n"),
            "memory.mcap is not a recording: the file has version '1' of MCAP, but this program "
            "reads version 0");
  EXPECT_THAT(ErrorOf("#ROSBAG V2.0\n"), HasSubstr("it may be a ROS 1 bag"));
}

TEST(Reader, AMissingFileIsNotFound) {
  const test::Folder folder;

  const auto reader = Reader::Open(folder.path() / "none.mcap");
  const auto directory = Reader::Open(folder.path());

  ASSERT_FALSE(reader);
  EXPECT_EQ(reader.error().code, ErrorCode::kNotFound);
  EXPECT_FALSE(directory);
}

TEST(Reader, ReadsTheSmallestFile) {
  Buffer bytes(Magic().begin(), Magic().end());
  Append(bytes, Header{});
  Append(bytes, Footer{});
  bytes.insert(bytes.end(), Magic().begin(), Magic().end());

  const auto reader = Open(bytes);

  EXPECT_TRUE(ReadAll(*reader).empty());
}

TEST(Reader, MessagesOfCrossedChunksAreInOrderOfTime) {
  MemoryRecording recording({.chunk_size = 4096});
  const ChannelId channel = *recording.writer->AddChannel(0, "t", "cdr");
  std::vector<Timestamp> times;
  const std::string data(100, 'x');
  for (Timestamp i = 0; i < 1000; ++i) {
    // The time span of each chunk contains those of the previous chunks.
    const Timestamp time = i % 2 == 0 ? i : 1'000 - i;
    times.push_back(time);
    ASSERT_TRUE(recording.writer->Write(
        {.channel_id = channel, .log_time = time, .publish_time = time, .data = BytesOf(data)}));
  }
  ASSERT_TRUE(recording.writer->Close());
  const auto reader = Open(recording.disk->bytes);
  ASSERT_GT(reader->blocks().size(), 10U);

  EXPECT_EQ(TimesOf(ReadAll(*reader, {.order = Query::Order::kFile})), times);
  std::sort(times.begin(), times.end());
  EXPECT_EQ(TimesOf(ReadAll(*reader)), times);
}

TEST(Reader, CrossedChunksAreReadInOrderWithACacheOfOneChunk) {
  MemoryRecording recording({.chunk_size = 4096});
  const ChannelId channel = *recording.writer->AddChannel(0, "t", "cdr");
  for (Timestamp i = 0; i < 400; ++i) {
    const Timestamp time = i * 7919 % 400;
    ASSERT_TRUE(recording.writer->Write(At(time, channel, std::string(100, 'x'))));
  }
  ASSERT_TRUE(recording.writer->Close());

  const auto reader = Open(recording.disk->bytes, {.cache = 1});

  const auto times = TimesOf(ReadAll(*reader));
  EXPECT_EQ(times.size(), 400U);
  EXPECT_TRUE(std::ranges::is_sorted(times));
}

TEST(Reader, SoManyCrossedChunksThatMemoryDoesNotSufficeAreTold) {
  MemoryRecording recording({.chunk_size = 4096});
  const ChannelId channel = *recording.writer->AddChannel(0, "t", "cdr");
  for (Timestamp i = 0; i < 400; ++i) {
    ASSERT_TRUE(recording.writer->Write(At(i * 7919 % 400, channel, std::string(100, 'x'))));
  }
  ASSERT_TRUE(recording.writer->Close());
  const auto reader = Open(recording.disk->bytes, {.overlap = 1000});
  bool is_complete = true;

  ReadAll(*reader, {}, &is_complete);

  EXPECT_FALSE(is_complete);
  EXPECT_THAT(Sentences(*reader), HasSubstr("read the messages in the order of the file"));
  EXPECT_EQ(ReadAll(*reader, {.order = Query::Order::kFile}).size(), 400U);
}

TEST(Reader, ReadsTheMessagesOfARangeOfTimeAndOfChannels) {
  const Sample sample(Compression::kZstd);
  const auto reader = Open(sample.bytes);
  const Timestamp from = sample.messages[100].log_time;
  const Timestamp to = sample.messages[220].log_time;
  std::vector<StoredMessage> expected;
  for (const StoredMessage& message : sample.messages) {
    if (message.log_time >= from && message.log_time <= to && message.topic == "robot/arm/log") {
      expected.push_back(message);
    }
  }

  EXPECT_EQ(ReadAll(*reader, {.from = from, .to = to, .channels = {2}}), expected);
  EXPECT_EQ(expected.size(), 24U);
  EXPECT_TRUE(ReadAll(*reader, {.from = to, .to = from}).empty());
  EXPECT_TRUE(ReadAll(*reader, {.channels = {77}}).empty());
}

TEST(Reader, OpeningReadsTheEndOfTheFileAndSeekingOneChunk) {
  MemoryRecording recording({.compression = Compression::kNone, .chunk_size = 64 << 10});
  const ChannelId channel = *recording.writer->AddChannel(0, "t", "cdr");
  const std::string data(1000, 'x');
  for (Timestamp i = 0; i < 10'000; ++i) {
    ASSERT_TRUE(recording.writer->Write(At(i, channel, data)));
  }
  ASSERT_TRUE(recording.writer->Close());
  const auto reads = std::make_shared<test::MemoryFile::Reads>();

  const auto reader =
      Reader::Open(std::make_unique<test::MemoryFile>(recording.disk->bytes, reads));
  ASSERT_TRUE(reader);
  const std::uint64_t opened = reads->bytes;
  const auto messages = ReadAll(**reader, {.from = 5000, .to = 5000});

  EXPECT_GT(recording.disk->bytes.size(), 10'000'000U);
  EXPECT_LT(opened, 250'000U);
  EXPECT_EQ(messages.size(), 1U);
  EXPECT_LT(reads->bytes - opened, 300'000U);
}

TEST(Reader, AFileWithoutASummaryIsReadWhole) {
  for (const Compression compression :
       {Compression::kNone, Compression::kLz4, Compression::kZstd}) {
    HandmadeFile file;
    Buffer records;
    Append(records, Schema{3, "s", "ros2msg", ""});
    Append(records, Channel{1, 3, "t", "cdr", {}});
    for (Timestamp time = 10; time < 90; ++time) Append(records, At(time));
    file.AddChunk(records, 10, 89, compression);

    const auto reader = Open(file.End());

    EXPECT_TRUE(reader->was_scanned());
    EXPECT_EQ(ReadAll(*reader).size(), 80U);
    EXPECT_EQ(reader->schemas().size(), 1U);
    EXPECT_EQ(reader->statistics()->message_count, 80U);
    EXPECT_EQ(FlawsOf(*reader), "");
  }
}

TEST(Reader, MessagesOutsideOfChunksAreRead) {
  HandmadeFile file;
  file.Add(ChannelWith(1, "a")).Add(At(30)).Add(At(10));
  file.Add(Metadata{"m", {}}).Add(ChannelWith(2, "b")).Add(At(20, 2));

  const auto reader = Open(file.End());

  EXPECT_EQ(TimesOf(ReadAll(*reader)), (std::vector<Timestamp>{10, 20, 30}));
  EXPECT_EQ(TimesOf(ReadAll(*reader, {.channels = {2}})), (std::vector<Timestamp>{20}));
  EXPECT_EQ(reader->metadata().size(), 1U);
  EXPECT_EQ(FlawsOf(*reader), "");
}

TEST(Reader, ASummaryWithoutMessageIndexesSuffices) {
  HandmadeFile file;
  Buffer records;
  Append(records, ChannelWith(1));
  Append(records, At(7));
  const ChunkIndex index = file.AddChunk(records, 7, 7);
  Buffer summary;
  Append(summary, ChannelWith(1));
  Append(summary, index);
  Append(summary, Statistics{.message_count = 1,
                             .channel_count = 1,
                             .chunk_count = 1,
                             .message_start_time = 7,
                             .message_end_time = 7});

  const auto reader = Open(file.End(summary));

  EXPECT_FALSE(reader->was_scanned());
  EXPECT_EQ(ReadAll(*reader).size(), 1U);
  EXPECT_EQ(FlawsOf(*reader), "");
}

TEST(Reader, WithoutStatisticsAttachmentsAndMetadataAreSearched) {
  HandmadeFile file;
  Buffer records;
  Append(records, ChannelWith(1));
  Append(records, At(7));
  const ChunkIndex index = file.AddChunk(records, 7, 7);
  file.Add(Metadata{"m", {{"key", "value"}}});
  Buffer summary;
  Append(summary, ChannelWith(1));
  Append(summary, index);

  const auto reader = Open(file.End(summary));

  EXPECT_TRUE(reader->was_scanned());
  EXPECT_EQ(reader->metadata().size(), 1U);
  EXPECT_EQ(reader->problems().count(), 0U) << Sentences(*reader);
}

TEST(Reader, ASummaryThatLeavesOutChannelsOrChunksDoesNot) {
  for (const bool leaves_out_channel : {false, true}) {
    HandmadeFile file;
    Buffer records;
    Append(records, ChannelWith(1));
    Append(records, At(7));
    const ChunkIndex index = file.AddChunk(records, 7, 7);
    Buffer summary;
    if (!leaves_out_channel) Append(summary, ChannelWith(1));
    Append(summary, Statistics{.message_count = 1, .channel_count = 1, .chunk_count = 1});
    if (leaves_out_channel) Append(summary, index);

    const auto reader = Open(file.End(summary));

    EXPECT_TRUE(reader->was_scanned());
    EXPECT_EQ(ReadAll(*reader).size(), 1U);
  }
}

TEST(Reader, RecordsOfUnknownKindsAreSkippedAndCounted) {
  HandmadeFile file;
  file.Add(0x42, "of a later version").Add(ChannelWith(1)).Add(0xff, "private").Add(At(1));
  Buffer records;
  Append(records, At(2));
  HandmadeFile inner;
  inner.bytes.clear();
  inner.Add(0x90, "in a chunk");
  records.insert(records.end(), inner.bytes.begin(), inner.bytes.end());
  Append(records, At(3));
  file.AddChunk(records, 2, 3);

  const auto reader = Open(file.End());

  EXPECT_EQ(reader->unknown_records(), 3U);
  EXPECT_EQ(TimesOf(ReadAll(*reader)), (std::vector<Timestamp>{1, 2, 3}));
  EXPECT_EQ(reader->problems().count(), 0U) << Sentences(*reader);
}

TEST(Reader, LengthsThatClaimTooMuchTakeNoMemory) {
  // If the reader allocated as much as each file claims, the allocator or a sanitizer would end the
  // test. The largest lengths are negative for a signed number, and overflow if one is added.
  for (int flaw = 0; flaw < 12; ++flaw) {
    const std::uint64_t huge = std::array{kHuge, kNegative, kLargest}[flaw / 4];
    const int place = flaw % 4;
    HandmadeFile file;
    file.Add(ChannelWith(1));
    const std::size_t begin = file.bytes.size();
    ChunkHead head{0, 0, place == 0 ? huge : 10, 1, "zstd", place == 1 ? huge : 10};
    AppendChunkHead(file.bytes, head);
    file.bytes.resize(file.bytes.size() + 10);
    if (place >= 1) {  // a valid length of the record; for place 2, a huge length
      for (std::size_t i = 0; i < 8; ++i) {
        const std::uint64_t length =
            place == 2 ? huge : file.bytes.size() - begin - kRecordHeadSize;
        file.bytes[begin + 1 + i] = static_cast<std::byte>(length >> (8 * i));
      }
    }
    if (place == 3) file.Add(0x09, std::string(24, '\xff'));

    const auto reader = Open(file.End());

    EXPECT_TRUE(ReadAll(*reader).empty());
    EXPECT_GT(reader->problems().count(), 0U) << flaw;
  }
}

TEST(Reader, AChunkThatInflatesToTooMuchIsRefused) {
  Buffer records;
  Append(records, ChannelWith(1));
  const std::string zeros(1'000'000, '\0');
  Append(records, At(1, 1, zeros));
  HandmadeFile file;
  file.AddChunk(records, 1, 1, Compression::kZstd);
  ASSERT_LT(file.bytes.size(), 1000U);

  const auto reader = Open(file.End(), {.chunk = 500'000});

  EXPECT_TRUE(ReadAll(*reader).empty());
  EXPECT_THAT(Sentences(*reader), HasSubstr("at most 500000 are possible or allowed"));
}

TEST(Reader, AnIndexThatPointsOutsideBackwardsOrTwiceToAChunkIsNotUsed) {
  for (int flaw = 0; flaw < 6; ++flaw) {
    HandmadeFile file;
    Buffer records;
    Append(records, ChannelWith(1));
    Append(records, At(7));
    ChunkIndex index = file.AddChunk(records, 7, 7);
    Buffer summary;
    Append(summary, ChannelWith(1));
    if (flaw == 0) index.chunk_start_offset = kHuge;
    if (flaw == 1) index.chunk_length = kHuge;
    if (flaw == 2) index.chunk_start_offset = 2;
    if (flaw == 4) index.chunk_length = kNegative;
    if (flaw == 5) index.chunk_length = kLargest;
    Append(summary, index);
    if (flaw == 3) Append(summary, index);

    const auto reader = Open(file.End(summary));

    EXPECT_TRUE(reader->was_scanned()) << flaw;
    EXPECT_EQ(ReadAll(*reader).size(), 1U) << flaw;
    EXPECT_THAT(Sentences(*reader), HasSubstr("cannot be used")) << flaw;
  }
}

TEST(Reader, AFooterThatPointsOutsideIsNotUsed) {
  for (const std::uint64_t start : {kHuge, std::uint64_t{3}, std::uint64_t{60}}) {
    HandmadeFile file;
    file.Add(ChannelWith(1)).Add(At(7)).Add(At(8));

    const auto reader = Open(file.End({}, start));

    EXPECT_TRUE(reader->was_scanned());
    EXPECT_EQ(ReadAll(*reader).size(), 2U);
    EXPECT_GT(reader->problems().count(), 0U);
  }
}

TEST(Reader, AChunkThatDiffersFromItsIndexIsSkipped) {
  HandmadeFile file;
  Buffer records;
  Append(records, ChannelWith(1));
  Append(records, At(7));
  ChunkIndex index = file.AddChunk(records, 7, 7);
  index.message_start_time = 6;
  Buffer summary;
  Append(summary, ChannelWith(1));
  Append(summary, index);
  Append(summary, Statistics{.message_count = 1, .channel_count = 1, .chunk_count = 1});
  const auto reader = Open(file.End(summary));
  bool is_complete = true;

  EXPECT_TRUE(ReadAll(*reader, {}, &is_complete).empty());
  EXPECT_FALSE(is_complete);
  EXPECT_THAT(Sentences(*reader), HasSubstr("the fields of the chunk differ from the index"));
}

TEST(Reader, AMessageBehindAChunkIsNotTakenFromARecordOfAnotherKind) {
  Sample sample(Compression::kNone, 150);
  const auto whole = Open(sample.bytes);
  const ChunkIndex chunk = whole->blocks()[1].index;
  const std::size_t index = chunk.chunk_start_offset + chunk.chunk_length;
  ASSERT_EQ(sample.bytes[index], static_cast<std::byte>(Opcode::kMessageIndex));
  sample.bytes[index] = static_cast<std::byte>(Opcode::kMessage);
  sample.bytes.resize(sample.bytes.size() - 10);  // removes the footer

  const auto reader = Open(sample.bytes);

  EXPECT_EQ(ReadAll(*reader), sample.messages);
  EXPECT_THAT(Sentences(*reader), HasSubstr("is outside of the chunks"));
}

TEST(Reader, AnEmptyChunkAndAChunkWithoutMessagesAreFine) {
  HandmadeFile file;
  file.AddChunk({}, 0, 0);
  Buffer records;
  Append(records, ChannelWith(1));
  file.AddChunk(records, 0, 0);
  Buffer more;
  Append(more, At(5));
  file.AddChunk(more, 5, 5);

  const auto reader = Open(file.End());

  EXPECT_EQ(ReadAll(*reader).size(), 1U);
  EXPECT_EQ(FlawsOf(*reader), "");
}

TEST(Reader, AnIdThatOccursTwiceWithOtherContentIsTold) {
  HandmadeFile file;
  file.Add(Schema{1, "first", "ros2msg", ""}).Add(Schema{1, "first", "ros2msg", ""});
  file.Add(Channel{1, 1, "first", "cdr", {}}).Add(At(1));
  EXPECT_EQ(Open(HandmadeFile(file).End())->problems().count(), 0U);
  file.Add(Schema{1, "second", "ros2msg", ""}).Add(Channel{1, 1, "second", "cdr", {}});

  const auto reader = Open(file.End());

  EXPECT_EQ(reader->problems().count(), 2U);
  EXPECT_THAT(Sentences(*reader), HasSubstr("has the id 1 of another"));
  EXPECT_EQ(reader->channels().at(1).topic, "first");
}

TEST(Reader, ASchemaWithIdZeroIsSkipped) {
  HandmadeFile file;
  file.Add(Schema{0, "none", "", ""});

  const auto reader = Open(file.End());

  EXPECT_TRUE(reader->schemas().empty());
  EXPECT_EQ(reader->problems().count(), 1U);
}

TEST(Reader, AChannelWithAnUnknownSchemaIsToldAndItsMessagesAreRead) {
  HandmadeFile file;
  file.Add(Channel{1, 7, "arm/state", "cdr", {}}).Add(At(1));

  const auto reader = Open(file.End());

  EXPECT_EQ(ReadAll(*reader).size(), 1U);
  EXPECT_THAT(Sentences(*reader),
              HasSubstr("channel 1 ('arm/state') has the schema id 7, but this schema is not "
                        "defined; the messages of the channel have no schema"));
}

TEST(Reader, MessagesWithoutAChannelAreToldAndSkipped) {
  HandmadeFile file;
  file.Add(At(1, 9)).Add(ChannelWith(1)).Add(At(2)).Add(At(3, 9));
  const auto reader = Open(file.End());
  bool is_complete = true;

  EXPECT_EQ(TimesOf(ReadAll(*reader, {}, &is_complete)), (std::vector<Timestamp>{2}));
  EXPECT_FALSE(is_complete);
  EXPECT_THAT(Sentences(*reader), HasSubstr("channel 9, which the file does not define"));
}

TEST(Reader, AnUnknownCompressionIsNamedAndTheRestRead) {
  HandmadeFile file;
  file.Add(ChannelWith(1));
  AppendChunkHead(file.bytes, {1, 1, 3, 0, "brotli", 3});
  file.bytes.resize(file.bytes.size() + 3);
  file.Add(At(2));

  const auto reader = Open(file.End());

  EXPECT_EQ(ReadAll(*reader).size(), 1U);
  EXPECT_THAT(Sentences(*reader),
              HasSubstr("there is no compression 'brotli'; known: none, lz4, zstd"));
}

TEST(Reader, TimesFromTheFirstToTheLastPossibleOneAreRead) {
  MemoryRecording recording;
  const ChannelId channel = *recording.writer->AddChannel(0, "t", "cdr");
  for (const Timestamp time : {kLastTime, kFirstTime, Timestamp{5}}) {
    ASSERT_TRUE(recording.writer->Write(At(time, channel)));
  }
  ASSERT_TRUE(recording.writer->Close());

  const auto reader = Open(recording.disk->bytes);

  EXPECT_EQ(TimesOf(ReadAll(*reader)), (std::vector<Timestamp>{kFirstTime, 5, kLastTime}));
  EXPECT_EQ(FlawsOf(*reader), "");
}

TEST(Reader, AMillionChannelRecordsTakeTheMemoryOf65536) {
  HandmadeFile file;
  Buffer channels;
  Append(channels, ChannelWith(0));
  for (std::uint32_t i = 0; i < 1'000'000; ++i) {
    channels[kRecordHeadSize] = static_cast<std::byte>(i);
    channels[kRecordHeadSize + 1] = static_cast<std::byte>(i >> 8U);
    file.bytes.insert(file.bytes.end(), channels.begin(), channels.end());
  }

  const auto reader = Open(file.End());

  EXPECT_EQ(reader->channels().size(), 65'536U);
  EXPECT_EQ(reader->problems().count(), 0U);
}

TEST(Reader, ABadPlaceOnTheDiskCostsItsChunkAlone) {
  const Sample sample(Compression::kNone);
  const auto reads = std::make_shared<test::MemoryFile::Reads>();
  const auto reader = Reader::Open(std::make_unique<test::MemoryFile>(sample.bytes, reads));
  ASSERT_TRUE(reader);
  const ChunkIndex& bad = (*reader)->blocks()[3].index;
  reads->bad_begin = bad.chunk_start_offset + 200;
  reads->bad_end = reads->bad_begin + 1;

  bool is_complete = true;
  const auto messages = ReadAll(**reader, {}, &is_complete);

  EXPECT_FALSE(is_complete);
  EXPECT_LT(messages.size(), sample.messages.size());
  EXPECT_GT(messages.size(), sample.messages.size() * 3 / 4);
  EXPECT_THAT(Sentences(**reader), HasSubstr("Input/output error"));
}

TEST(Reader, EachBadPlaceOnTheDiskIsToldAndNothingIsReadWrong) {
  constexpr std::size_t kSector = 64;  // bytes
  const Sample sample(Compression::kZstd, {.messages = 48, .messages_in_chunk = 12});
  for (std::size_t place = 0; place < sample.bytes.size(); place += kSector) {
    SCOPED_TRACE(place);
    const auto reads = std::make_shared<test::MemoryFile::Reads>();
    reads->bad_begin = place;
    reads->bad_end = place + kSector;

    const auto reader = Reader::Open(std::make_unique<test::MemoryFile>(sample.bytes, reads));

    if (!reader) {
      EXPECT_LT(place, kMagicSize);
      EXPECT_THAT(reader.error().message, HasSubstr("Input/output error"));
      continue;
    }
    const auto messages = ReadAll(**reader);
    for (const StoredMessage& message : messages) {
      ASSERT_EQ(message, sample.messages.at(message.sequence));
    }
    if (messages.size() < sample.messages.size()) {
      EXPECT_GT((*reader)->problems().count(), 0U);
    }
    EXPECT_NE(FlawsOf(**reader), "");
  }
}

TEST(ReaderOnDisk, AFileThatGrowsIsReadAsItWasWhenItWasOpened) {
  const test::Folder folder;
  const auto writer = *Writer::Create(folder.path() / "run.mcap");
  const ChannelId channel = *writer->AddChannel(0, "t", "cdr");
  ASSERT_TRUE(writer->Write(At(1, channel)));
  ASSERT_TRUE(writer->Sync());
  const auto early = Reader::Open(folder.path() / "run.mcap");
  ASSERT_TRUE(early) << early.error().message;

  ASSERT_TRUE(writer->Write(At(2, channel)));
  ASSERT_TRUE(writer->Close());

  EXPECT_EQ(TimesOf(ReadAll(**early)), (std::vector<Timestamp>{1}));
  EXPECT_THAT(Sentences(**early), HasSubstr("still being written"));
  const auto late = Reader::Open(folder.path() / "run.mcap");
  ASSERT_TRUE(late);
  EXPECT_EQ(TimesOf(ReadAll(**late)), (std::vector<Timestamp>{1, 2}));
}

TEST(ReaderOnDisk, AFileThatShrinksIsTold) {
  const test::Folder folder;
  const Sample sample(Compression::kNone);
  folder.Write("run.mcap", std::string(reinterpret_cast<const char*>(sample.bytes.data()),
                                       sample.bytes.size()));
  const auto reader = Reader::Open(folder.path() / "run.mcap");
  ASSERT_TRUE(reader);

  std::filesystem::resize_file(folder.path() / "run.mcap", sample.bytes.size() / 2);
  bool is_complete = true;
  const auto messages = ReadAll(**reader, {}, &is_complete);

  EXPECT_FALSE(is_complete);
  EXPECT_LT(messages.size(), sample.messages.size());
  EXPECT_GT((*reader)->problems().count(), 0U);
}

TEST(ReaderOnDisk, AFileThatCannotBeWrittenIsRead) {
  const test::Folder folder;
  const Sample sample(Compression::kZstd);
  folder.Write("run.mcap", std::string(reinterpret_cast<const char*>(sample.bytes.data()),
                                       sample.bytes.size()));
  std::filesystem::permissions(folder.path() / "run.mcap", std::filesystem::perms::owner_read);

  const auto reader = Reader::Open(folder.path() / "run.mcap");

  ASSERT_TRUE(reader) << reader.error().message;
  EXPECT_EQ(ReadAll(**reader), sample.messages);
}

}  // namespace
}  // namespace tendon::mcap
