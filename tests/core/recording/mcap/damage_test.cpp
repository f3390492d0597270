#include <core/recording/recordings.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/folder.h>
#include <support/machine/sanitized.h>
#include <tendon/recording/mcap/copy.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

/// Files that are cut off or damaged. Every complete chunk must be read, nothing must be read
/// wrong, and missing parts must be reported.
namespace tendon::mcap {
namespace {

using testing::HasSubstr;

std::string NameOfParameter(const testing::TestParamInfo<Compression>& compression) {
  return std::string(NameOf(compression.param));
}

class DamageTest : public testing::TestWithParam<Compression> {};

INSTANTIATE_TEST_SUITE_P(, DamageTest,
                         testing::Values(Compression::kNone, Compression::kLz4, Compression::kZstd),
                         NameOfParameter);

/// Returns the number of messages in the chunks that end at or before `size`.
std::uint64_t CompleteMessages(const std::vector<MessageBlock>& blocks,
                               const std::vector<std::size_t>& counts, std::size_t size) {
  std::uint64_t messages = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const ChunkIndex& index = blocks[i].index;
    if (index.chunk_start_offset + index.chunk_length <= size) messages += counts[i];
  }
  return messages;
}

/// A small file with all features of a large one: several chunks, and records between them. It is
/// so small that every byte can be tried.
Sample SmallSample(Compression compression) {
  return {compression, {.messages = 48, .messages_in_chunk = 12}};
}

/// Returns true at full size: if TENDON_FULL_FAULTS is set. The tests then take many minutes.
bool IsFullSize() { return std::getenv("TENDON_FULL_FAULTS") != nullptr; }

/// The messages that are read from a damaged file.
struct Found {
  std::size_t messages = 0;
  bool are_the_first = true;  ///< true if they are the first written messages, in order
  std::string mistake;        ///< set if a message was never written or was read twice
};

Found FindIn(Reader& reader, const Sample& sample) {
  Found found;
  std::vector<bool> seen(sample.messages.size());  // by sequence number
  MessageStream messages = reader.Messages();
  while (const auto message = messages.Next()) {
    const Channel* channel = reader.FindChannel(message->channel_id);
    const std::size_t number = message->sequence;
    const StoredMessage* written = number < seen.size() ? &sample.messages[number] : nullptr;
    if (written == nullptr || seen[number] || channel == nullptr ||
        channel->topic != written->topic || message->log_time != written->log_time ||
        message->publish_time != written->publish_time ||
        !std::ranges::equal(BytesOf(written->data), message->data)) {
      found.mistake = "message " + std::to_string(number) + " is there twice or was never written";
      return found;
    }
    seen[number] = true;
    found.are_the_first = found.are_the_first && number == found.messages;
    ++found.messages;
  }
  return found;
}

/// The distance between the bytes at which a test cuts or changes a file. A sanitizer makes reading
/// ten times slower.
std::size_t ByteDistance() { return !IsFullSize() && test::IsSanitized() ? 31 : 1; }

void ExpectEveryCutReads(const Sample& sample, std::size_t step) {
  const auto whole = Open(sample.bytes);
  std::vector<std::size_t> counts;
  for (const MessageBlock& block : whole->blocks()) {
    counts.push_back(ReadAll(*whole, {.from = block.index.message_start_time,
                                      .to = block.index.message_end_time})
                         .size());
  }
  ASSERT_GE(counts.size(), 3U);
  for (std::size_t size = 0; size < sample.bytes.size(); size += step) {
    SCOPED_TRACE(size);
    const auto cut = static_cast<std::ptrdiff_t>(size);
    const auto reader = Reader::Open(std::make_unique<test::MemoryFile>(
        Buffer(sample.bytes.begin(), sample.bytes.begin() + cut)));
    if (size < kMagicSize) {
      ASSERT_FALSE(reader);
      continue;
    }
    ASSERT_TRUE(reader) << reader.error().message;
    const Found found = FindIn(**reader, sample);
    ASSERT_EQ(found.mistake, "");
    ASSERT_TRUE(found.are_the_first);
    ASSERT_EQ(found.messages, CompleteMessages(whole->blocks(), counts, size));
    ASSERT_GT((*reader)->problems().count(), 0U);
  }
}

TEST_P(DamageTest, AFileCutAtAnyByteGivesItsCompleteChunks) {
  ExpectEveryCutReads(SmallSample(GetParam()), ByteDistance());
}

/// At full size, the file is cut at each byte.
TEST_P(DamageTest, AFileOfAMegabyteCutAnywhereGivesItsCompleteChunks) {
  const Sample sample(GetParam(), {.messages = 1'000, .message_size = 1'000});
  ASSERT_GT(sample.bytes.size(), 1'000'000U);

  ExpectEveryCutReads(sample, IsFullSize() ? 1 : 49'999);
}

TEST(CutFile, SaysWhatIsMissing) {
  const Sample sample(Compression::kZstd, 150);
  Buffer bytes = sample.bytes;
  const auto whole = Open(bytes);
  const ChunkIndex last = whole->blocks().back().index;
  bytes.resize(last.chunk_start_offset + 100);

  const auto reader = Open(bytes);

  EXPECT_EQ(Sentences(*reader),
            "the index at the end of the file cannot be used: the end of the file is missing: the "
            "recording was cut off, or is still being written; the whole file is read instead\n"
            "the file ends within the record at " +
                std::to_string(last.chunk_start_offset) + ": the last 100 bytes are incomplete\n");
}

/// Succeeds if everything that was read is correct, and if missing messages are reported.
testing::AssertionResult IsRightOrTold(Reader& reader, const Sample& sample, const Found& found) {
  if (!found.mistake.empty()) return testing::AssertionFailure() << found.mistake;
  if (found.messages < sample.messages.size() && reader.problems().count() == 0 &&
      reader.unknown_records() == 0) {
    return testing::AssertionFailure() << "messages are missing in silence";
  }
  for (const AttachmentIndex& index : reader.attachments()) {
    const auto attachment = reader.ReadAttachment(index);
    if (attachment && *attachment != sample.attachment) {
      return testing::AssertionFailure() << "a wrong attachment";
    }
  }
  return testing::AssertionSuccess();
}

/// Calls `check(reader, place)` for files in which one byte is changed: each ByteDistance()-th byte
/// in turn. At full size, each byte gets every other value.
template <typename Check>
void ForEachFlip(const Sample& sample, const Check& check) {
  std::mt19937 random(36);
  const int flips = IsFullSize() ? 255 : 1;
  for (std::size_t place = 0; place < sample.bytes.size(); place += ByteDistance()) {
    for (int i = 0; i < flips && !testing::Test::HasFatalFailure(); ++i) {
      const auto flip = static_cast<std::byte>(IsFullSize() ? i + 1 : 1 + random() % 255);
      SCOPED_TRACE("byte " + std::to_string(place) + " ^ " +
                   std::to_string(std::to_integer<int>(flip)));
      Buffer bytes = sample.bytes;
      bytes[place] ^= flip;
      const auto reader = Reader::Open(std::make_unique<test::MemoryFile>(std::move(bytes)));
      if (place < kMagicSize) {
        ASSERT_FALSE(reader);
      } else {
        ASSERT_TRUE(reader) << reader.error().message;
        check(**reader, place);
      }
    }
  }
}

TEST_P(DamageTest, NoFlippedByteIsReadInSilence) {
  const Sample sample = SmallSample(GetParam());
  std::size_t complete = 0;

  ForEachFlip(sample, [&](Reader& reader, std::size_t /*place*/) {
    const Found found = FindIn(reader, sample);
    ASSERT_TRUE(IsRightOrTold(reader, sample, found));
    if (found.messages == sample.messages.size()) ++complete;
    ASSERT_GT(Verify(reader).problems.count(), 0U) << "Verify() sees every flipped byte";
  });

  EXPECT_GT(complete, sample.bytes.size() / ByteDistance() / 100)
      << "most are not in a chunk's records";
}

/// At full size: ten thousand flips.
TEST_P(DamageTest, NoFlippedByteOfAMegabyteIsReadInSilence) {
  const Sample sample(GetParam(), {.messages = 1'000, .message_size = 1'000});
  std::mt19937 random(37);
  const std::size_t flips = IsFullSize() ? 10'000 : 100 / ByteDistance() + 1;

  for (std::size_t i = 0; i < flips; ++i) {
    const std::size_t place = kMagicSize + random() % (sample.bytes.size() - kMagicSize);
    const auto flip = static_cast<std::byte>(1 + random() % 255);
    SCOPED_TRACE("byte " + std::to_string(place) + " ^ " +
                 std::to_string(std::to_integer<int>(flip)));
    Buffer bytes = sample.bytes;
    bytes[place] ^= flip;
    const auto reader = Reader::Open(std::make_unique<test::MemoryFile>(std::move(bytes)));
    ASSERT_TRUE(reader) << reader.error().message;
    ASSERT_TRUE(IsRightOrTold(**reader, sample, FindIn(**reader, sample)));
  }
}

/// Without a summary, everything is found by a scan. Then only the lengths of records detect
/// damage.
TEST_P(DamageTest, NoFlippedByteOfAFileWithoutSummaryIsReadInSilence) {
  Sample sample = SmallSample(GetParam());
  const auto whole = Open(sample.bytes);
  const ChunkIndex last = whole->blocks().back().index;
  sample.bytes.resize(last.chunk_start_offset + last.chunk_length + last.message_index_length);
  // A flip of the opcode or a length of one record costs at most the chunk that it belongs to.
  const std::size_t fewest = sample.messages.size() / 3;

  ForEachFlip(sample, [&](Reader& reader, std::size_t /*place*/) {
    const Found found = FindIn(reader, sample);
    ASSERT_TRUE(IsRightOrTold(reader, sample, found));
    ASSERT_GE(found.messages, fewest);
  });
}

/// The file without its summary, as a crash leaves it, and with a wrong byte in each of `chunks`.
Buffer CrashedFile(const Buffer& bytes, const std::vector<std::size_t>& chunks) {
  const auto whole = Open(bytes);
  const ChunkIndex last = whole->blocks().back().index;
  Buffer crashed = bytes;
  for (const std::size_t chunk : chunks) {
    const ChunkIndex& index = whole->blocks()[chunk].index;
    crashed[index.chunk_start_offset + index.chunk_length - 5] ^= std::byte{0x10};
  }
  crashed.resize(last.chunk_start_offset + last.chunk_length + last.message_index_length);
  return crashed;
}

TEST_P(DamageTest, ADamagedChunkOfAFileWithoutSummaryCostsOnlyItself) {
  const Sample sample(GetParam(), 400);
  const auto whole = Open(sample.bytes);
  for (std::size_t chunk = 0; chunk < whole->blocks().size(); ++chunk) {
    const ChunkIndex& index = whole->blocks()[chunk].index;
    auto expected = sample.messages;
    std::erase_if(expected, [&](const StoredMessage& message) {
      return message.log_time >= index.message_start_time &&
             message.log_time <= index.message_end_time;
    });

    const auto reader = Open(CrashedFile(sample.bytes, {chunk}));

    EXPECT_EQ(ReadAll(*reader), expected) << "chunk " << chunk;
  }
}

TEST(Damage, OfAllChunksWithTheFirstDefinitionsCostsOnlyThePartBeforeTheyAreRepeated) {
  MemoryRecording recording(
      {.compression = Compression::kNone, .chunk_size = std::size_t{4} << 10U});
  const ChannelId channel = *recording.writer->AddChannel(0, "a", "cdr");
  const std::string data(1000, 'x');
  constexpr Timestamp kMessages = 1000;
  for (Timestamp time = 1; time <= kMessages; ++time) {
    ASSERT_TRUE(
        recording.writer->Write({.channel_id = channel, .log_time = time, .data = BytesOf(data)}));
  }
  ASSERT_TRUE(recording.writer->Close());

  const auto reader = Open(CrashedFile(recording.disk->bytes, {0, 1, 2}));

  EXPECT_GT(ReadAll(*reader).size(), kMessages / 2);
}

TEST_P(DamageTest, ChunksBehindADamagedLengthAreFound) {
  Sample sample(GetParam(), 400);
  const auto whole = Open(sample.bytes);
  const ChunkIndex first = whole->blocks()[0].index;
  const ChunkIndex second = whole->blocks()[1].index;
  sample.bytes[second.chunk_start_offset + 6] = std::byte{0x77};  // a byte of its length
  sample.bytes.resize(sample.bytes.size() - 10);                  // removes the footer
  std::size_t lost = 0;
  for (const StoredMessage& message : sample.messages) {
    if (message.log_time > first.message_end_time && message.log_time <= second.message_end_time) {
      ++lost;
    }
  }

  const auto reader = Open(sample.bytes);

  EXPECT_EQ(ReadAll(*reader).size() + lost, sample.messages.size());
  EXPECT_THAT(Sentences(*reader),
              HasSubstr("are damaged and skipped; the next chunk begins after"));
}

TEST_P(DamageTest, AWrongChecksumNamesTheChunkAndTheRestIsRead) {
  Sample sample(GetParam(), 400);
  const auto whole = Open(sample.bytes);
  const ChunkIndex bad = whole->blocks()[2].index;
  sample.bytes[bad.chunk_start_offset + bad.chunk_length - 5] ^= std::byte{0x10};

  const auto reader = Open(sample.bytes);
  bool is_complete = true;
  const auto messages = ReadAll(*reader, {}, &is_complete);

  EXPECT_FALSE(is_complete);
  EXPECT_GT(messages.size(), sample.messages.size() / 2);
  EXPECT_THAT(Sentences(*reader),
              HasSubstr("the chunk at " + std::to_string(bad.chunk_start_offset) + " is skipped"));
}

/// Returns the number of messages after the first chunk.
std::size_t MessagesBehindTheFirstChunk(const Sample& sample) {
  const auto whole = Open(sample.bytes);
  const ChunkIndex& first = whole->blocks()[0].index;
  return static_cast<std::size_t>(std::ranges::count_if(
      sample.messages,
      [&](const StoredMessage& message) { return message.log_time > first.message_end_time; }));
}

TEST_P(DamageTest, ASummaryReplacesDamagedDefinitions) {
  Sample sample(GetParam(), 400);
  const std::size_t behind = MessagesBehindTheFirstChunk(sample);
  const ChunkIndex first = Open(sample.bytes)->blocks()[0].index;
  sample.bytes[first.chunk_start_offset + first.chunk_length - 5] ^= std::byte{0x10};

  const auto reader =
      Reader::OpenByScan(std::make_unique<test::MemoryFile>(std::move(sample.bytes)));

  ASSERT_TRUE(reader) << reader.error().message;
  EXPECT_EQ(ReadAll(**reader).size(), behind);
}

TEST(Recover, MakesAFileWithAnIndexOfACutOne) {
  const test::Folder folder;
  const Sample sample(Compression::kZstd, 400);
  folder.Write("cut.mcap", std::string(reinterpret_cast<const char*>(sample.bytes.data()),
                                       sample.bytes.size() * 3 / 4));

  const auto report = Recover(folder.path() / "cut.mcap", folder.path() / "whole.mcap");

  ASSERT_TRUE(report) << report.error().message;
  EXPECT_GT(report->messages, sample.messages.size() / 2);
  EXPECT_GT(report->problem_count, 0U);
  const auto reader = Reader::Open(folder.path() / "whole.mcap");
  ASSERT_TRUE(reader) << reader.error().message;
  EXPECT_FALSE((*reader)->was_scanned());
  EXPECT_EQ(FlawsOf(**reader), "");
  EXPECT_EQ((*reader)->header().profile, "ros2");
  const auto messages = ReadAll(**reader);
  EXPECT_EQ(messages.size(), report->messages);
  EXPECT_TRUE(std::equal(messages.begin(), messages.end(), sample.messages.begin()));
  EXPECT_EQ((*reader)->channels().at(1).metadata.at("unit"), "rad");
}

TEST(Recover, KeepsAllOfAWholeFile) {
  const test::Folder folder;
  const Sample sample(Compression::kLz4, 400);
  folder.Write("a.mcap", std::string(reinterpret_cast<const char*>(sample.bytes.data()),
                                     sample.bytes.size()));

  const auto report = Recover(folder.path() / "a.mcap", folder.path() / "b.mcap");

  ASSERT_TRUE(report) << report.error().message;
  EXPECT_EQ(report->problem_count, 0U);
  const auto reader = Reader::Open(folder.path() / "b.mcap");
  ASSERT_TRUE(reader);
  EXPECT_EQ(ReadAll(**reader), sample.messages);
  ASSERT_EQ((*reader)->attachments().size(), 1U);
  EXPECT_EQ(*(*reader)->ReadAttachment((*reader)->attachments()[0]), sample.attachment);
  ASSERT_EQ((*reader)->metadata().size(), 1U);
  EXPECT_EQ(*(*reader)->ReadMetadata((*reader)->metadata()[0]), sample.metadata);
}

TEST(Recover, RefusesAFileThatIsBeingWrittenAndANameThatIsTaken) {
  const test::Folder folder;
  auto writer = Writer::Create(folder.path() / "run.mcap");
  ASSERT_TRUE(writer);

  const auto early = Recover(folder.path() / "run.mcap", folder.path() / "b.mcap");
  ASSERT_TRUE((*writer)->Close());
  writer->reset();
  const auto taken = Recover(folder.path() / "run.mcap", folder.path() / "run.mcap");

  ASSERT_FALSE(early);
  EXPECT_THAT(early.error().message,
              HasSubstr("it is still being recorded; stop the recording first"));
  ASSERT_FALSE(taken);
  EXPECT_EQ(taken.error().code, ErrorCode::kExists);
}

TEST(Copy, ACopyThatIsStoppedLeavesNoFile) {
  const test::Folder folder;
  const auto reader = Open(Sample(Compression::kZstd, 3000).bytes);

  const auto report = Copy(*reader, {}, folder.path() / "b.mcap", {}, [] { return true; });

  ASSERT_FALSE(report);
  EXPECT_THAT(report.error().message, HasSubstr("no file was written"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Copy, TakesARangeOfTimeAndChannels) {
  const Sample sample(Compression::kZstd, 400);
  const auto reader = Open(sample.bytes);
  MemoryRecording cut;

  const auto report = Copy(
      *reader,
      {.from = sample.messages[50].log_time, .to = sample.messages[99].log_time, .channels = {1}},
      *cut.writer);

  ASSERT_TRUE(report) << report.error().message;
  EXPECT_EQ(report->messages, 40U);
  ASSERT_TRUE(cut.writer->Close());
  EXPECT_EQ(ReadAll(*Open(cut.disk->bytes)).size(), 40U);
}

}  // namespace
}  // namespace tendon::mcap
