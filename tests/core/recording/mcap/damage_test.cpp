#include <core/recording/recordings.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/folder.h>
#include <support/machine/sanitized.h>
#include <tendon/recording/mcap/copy.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <future>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
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

/// Returns true at full size: if TENDON_FULL_FAULTS is set. The tests then take minutes.
bool IsFullSize() { return std::getenv("TENDON_FULL_FAULTS") != nullptr; }

/// The distance between the bytes at which a test cuts or changes a file. A sanitizer makes reading
/// ten times slower.
std::size_t ByteDistance() { return !IsFullSize() && test::IsSanitized() ? 31 : 1; }

/// A small file with all features of a large one: several chunks, and records between them. It is
/// so small that every byte can be tried.
Sample SmallSample(Compression compression) {
  return {compression, {.messages = 48, .messages_in_chunk = 12}};
}

/// A file of a megabyte.
Sample LargeSample(Compression compression) {
  const bool is_compressed = compression != Compression::kNone;
  return {compression,
          {.messages = is_compressed ? 2'000 : 1'050,
           .message_size = 1'000,
           .chunk_size = std::size_t{32} << 10U}};
}

/// Calls `check` with each number below `count`, on all processors. Returns the first text that is
/// not empty, or an empty text.
template <typename Check>
std::string FirstMistake(std::size_t count, const Check& check) {
  const std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::future<std::string>> parts;
  for (std::size_t part = 0; part < threads; ++part) {
    parts.push_back(std::async(std::launch::async, [&check, count, threads, part] {
      std::string mistake;
      for (std::size_t i = part; i < count && mistake.empty(); i += threads) mistake = check(i);
      return mistake;
    }));
  }
  std::string first;
  for (auto& part : parts) {
    const std::string mistake = part.get();
    if (first.empty()) first = mistake;
  }
  return first;
}

/// The messages that are read from a damaged file.
struct Found {
  std::size_t messages = 0;
  bool are_the_first = true;  ///< true if they follow each other, beginning with message `first`
  std::string mistake;        ///< set if a message was never written or was read twice
};

/// Reads the messages from message `first` on, by log time.
Found FindIn(Reader& reader, const Sample& sample, std::size_t first = 0) {
  Found found;
  std::vector<bool> seen(sample.messages.size());  // by sequence number
  MessageStream messages =
      reader.Messages({.from = first == 0 ? kFirstTime : sample.messages[first].log_time});
  while (const auto message = messages.Next()) {
    const Channel* channel = reader.FindChannel(message->channel_id);
    const std::size_t number = message->sequence;
    const StoredMessage* written = number < seen.size() ? &sample.messages[number] : nullptr;
    const std::string_view data(reinterpret_cast<const char*>(message->data.data()),
                                message->data.size());
    if (written == nullptr || seen[number] || channel == nullptr ||
        channel->topic != written->topic || message->log_time != written->log_time ||
        message->publish_time != written->publish_time || data != written->data) {
      found.mistake = "message " + std::to_string(number) + " is there twice or was never written";
      return found;
    }
    seen[number] = true;
    found.are_the_first = found.are_the_first && number == first + found.messages;
    ++found.messages;
  }
  return found;
}

/// A chunk of a whole file.
struct WrittenChunk {
  std::uint64_t end = 0;          // in the file
  std::size_t first_message = 0;  // number of its first message
  std::size_t end_message = 0;    // number of the first message after it
};

/// The chunks of the sample, which must be compressed.
std::vector<WrittenChunk> ChunksOf(const Sample& sample, Compression compression) {
  std::vector<WrittenChunk> chunks;
  const auto whole = Open(sample.bytes);
  std::size_t messages = 0;
  for (const MessageBlock& block : whole->blocks()) {
    const ChunkIndex& index = block.index;
    EXPECT_EQ(index.compression, FormatNameOf(compression));
    if (compression != Compression::kNone) {
      EXPECT_LT(index.compressed_size, index.uncompressed_size * 3 / 4);
    }
    const std::size_t first = messages;
    messages +=
        ReadAll(*whole, {.from = index.message_start_time, .to = index.message_end_time}).size();
    chunks.push_back({index.chunk_start_offset + index.chunk_length, first, messages});
  }
  EXPECT_GE(chunks.size(), 3U);
  return chunks;
}

/// Checks the file that ends after `size` bytes. Opening it reads all of its chunks. All messages
/// are compared if the file that is `step` bytes shorter has a chunk less. Otherwise, only those of
/// the last complete chunk are compared, and the others are counted.
std::string MistakeInCut(const Sample& sample, const std::vector<WrittenChunk>& chunks,
                         std::size_t size, std::size_t step) {
  const auto reader = Reader::Open(std::make_unique<test::MemoryFile>(
      Buffer(sample.bytes.begin(), sample.bytes.begin() + static_cast<std::ptrdiff_t>(size))));
  if (size < kMagicSize) return reader ? "it is read" : "";
  if (!reader) return reader.error().message;
  const auto next = std::ranges::upper_bound(chunks, size, {}, &WrittenChunk::end);
  const WrittenChunk last = next == chunks.begin() ? WrittenChunk{} : *std::prev(next);
  const std::size_t first = size - last.end < step ? 0 : last.first_message;
  const Found found = FindIn(**reader, sample, first);
  if (!found.mistake.empty()) return found.mistake;
  if (!found.are_the_first) return "messages are missing before others";
  if (first + found.messages != last.end_message ||
      (*reader)->statistics()->message_count != last.end_message) {
    return std::to_string(first + found.messages) + " messages instead of " +
           std::to_string(last.end_message);
  }
  return (*reader)->problems().count() > 0 ? "" : "it reads like a whole file";
}

void ExpectEveryCutReads(const Sample& sample, Compression compression, std::size_t step) {
  const auto chunks = ChunksOf(sample, compression);
  const std::size_t cuts = (sample.bytes.size() + step - 1) / step;

  EXPECT_EQ(FirstMistake(cuts,
                         [&](std::size_t cut) {
                           const std::size_t size = cut * step;
                           const std::string mistake = MistakeInCut(sample, chunks, size, step);
                           return mistake.empty()
                                      ? mistake
                                      : "cut at " + std::to_string(size) + ": " + mistake;
                         }),
            "");
}

TEST_P(DamageTest, AFileCutAtAnyByteGivesItsCompleteChunks) {
  ExpectEveryCutReads(SmallSample(GetParam()), GetParam(), ByteDistance());
}

/// At full size, the file is cut at each byte.
TEST_P(DamageTest, AFileOfAMegabyteCutAnywhereGivesItsCompleteChunks) {
  const Sample sample = LargeSample(GetParam());
  ASSERT_GT(sample.bytes.size(), 1'000'000U);

  ExpectEveryCutReads(sample, GetParam(), IsFullSize() ? 1 : 49'999);
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

/// Returns an empty text if everything that was read is correct, and if missing messages are
/// reported.
std::string MistakeIn(Reader& reader, const Sample& sample, const Found& found) {
  if (!found.mistake.empty()) return found.mistake;
  if (found.messages < sample.messages.size() && reader.problems().count() == 0 &&
      reader.unknown_records() == 0) {
    return "messages are missing in silence";
  }
  for (const AttachmentIndex& index : reader.attachments()) {
    const auto attachment = reader.ReadAttachment(index);
    if (attachment && *attachment != sample.attachment) return "a wrong attachment";
  }
  return "";
}

/// A byte of a file that is changed.
struct Flip {
  std::size_t place = 0;
  std::byte change{};
};

/// Changes each ByteDistance()-th byte. At full size, each byte gets every other value.
std::vector<Flip> FlipsOf(const Sample& sample) {
  std::mt19937 random(36);
  std::vector<Flip> flips;
  for (std::size_t place = 0; place < sample.bytes.size(); place += ByteDistance()) {
    const unsigned first = IsFullSize() ? 1 : 1 + static_cast<unsigned>(random() % 255);
    const unsigned last = IsFullSize() ? 255 : first;
    for (unsigned change = first; change <= last; ++change) {
      flips.push_back({place, static_cast<std::byte>(change)});
    }
  }
  return flips;
}

/// Calls `check(reader)` for the sample with each of the changes.
template <typename Check>
void ExpectNoMistake(const Sample& sample, const std::vector<Flip>& flips, const Check& check) {
  const auto mistake_of = [&](const Flip& flip) -> std::string {
    Buffer bytes = sample.bytes;
    bytes[flip.place] ^= flip.change;
    const auto reader = Reader::Open(std::make_unique<test::MemoryFile>(std::move(bytes)));
    if (flip.place < kMagicSize) return reader ? "it is read" : "";
    return reader ? check(**reader) : reader.error().message;
  };
  EXPECT_EQ(FirstMistake(flips.size(),
                         [&](std::size_t i) {
                           const std::string mistake = mistake_of(flips[i]);
                           return mistake.empty()
                                      ? mistake
                                      : "byte " + std::to_string(flips[i].place) + " ^ " +
                                            std::to_string(std::to_integer<int>(flips[i].change)) +
                                            ": " + mistake;
                         }),
            "");
}

TEST_P(DamageTest, NoFlippedByteIsReadInSilence) {
  const Sample sample = SmallSample(GetParam());
  std::atomic<std::size_t> complete = 0;

  ExpectNoMistake(sample, FlipsOf(sample), [&](Reader& reader) -> std::string {
    const Found found = FindIn(reader, sample);
    if (found.messages == sample.messages.size()) ++complete;
    if (std::string mistake = MistakeIn(reader, sample, found); !mistake.empty()) return mistake;
    return Verify(reader).problems.count() > 0 ? "" : "Verify() does not see it";
  });

  EXPECT_GT(complete, sample.bytes.size() / ByteDistance() / 100)
      << "most are not in a chunk's records";
}

/// At full size: ten thousand flips.
TEST_P(DamageTest, NoFlippedByteOfAMegabyteIsReadInSilence) {
  const Sample sample = LargeSample(GetParam());
  std::mt19937 random(37);
  std::vector<Flip> flips(IsFullSize() ? 10'000 : 100 / ByteDistance() + 1);
  for (Flip& flip : flips) {
    flip.place = kMagicSize + random() % (sample.bytes.size() - kMagicSize);
    flip.change = static_cast<std::byte>(1 + random() % 255);
  }

  ExpectNoMistake(sample, flips, [&](Reader& reader) {
    return MistakeIn(reader, sample, FindIn(reader, sample));
  });
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

  ExpectNoMistake(sample, FlipsOf(sample), [&](Reader& reader) -> std::string {
    const Found found = FindIn(reader, sample);
    if (std::string mistake = MistakeIn(reader, sample, found); !mistake.empty()) return mistake;
    return found.messages >= fewest
               ? ""
               : "only " + std::to_string(found.messages) + " messages are found";
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
