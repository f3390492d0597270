#include <tendon/recording/mcap/verify.h>

#include <tendon/recording/mcap/compression.h>

#include <algorithm>
#include <exception>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tendon::mcap {

/// Verifies one file, part by part.
class Verifier {
 public:
  explicit Verifier(Reader& reader) : reader_(reader), contents_(reader.contents_) {}

  Verification Run();

 private:
  using EntriesByChannel = std::map<ChannelId, std::vector<MessageIndexEntry>>;

  void VerifyAll(Statistics& found);
  void VerifyBlock(const MessageBlock& block, Statistics& found);
  void VerifyMessageIndexes(const MessageBlock& block, const EntriesByChannel& found);
  void VerifyAttachments();
  void VerifyMetadata();
  void VerifyDataSection();
  void VerifyStatistics(const Statistics& found);

  Reader& reader_;
  const Contents& contents_;
  Problems problems_;
};

Verification Verifier::Run() {
  Verification result;
  try {
    VerifyAll(result.found);
  } catch (const std::exception& thrown) {
    problems_.Add(0, std::string("the file cannot be verified: ") + thrown.what());
  }
  result.problems.Add(reader_.problems());  // includes the problems that this verification has
                                            // found while it read the chunks
  result.problems.Add(problems_);
  return result;
}

void Verifier::VerifyAll(Statistics& found) {
  CountContents(contents_, found);
  for (const MessageBlock& block : contents_.blocks) VerifyBlock(block, found);
  VerifyAttachments();
  VerifyMetadata();
  VerifyDataSection();
  VerifyStatistics(found);
}

void Verifier::VerifyAttachments() {
  for (const AttachmentIndex& index : contents_.attachments) {
    const auto read = reader_.ReadAttachment(index);
    if (!read) problems_.Add(index.offset, read.error().message);
    if (read && (read->name != index.name || read->media_type != index.media_type ||
                 read->log_time != index.log_time || read->create_time != index.create_time)) {
      problems_.Add(index.offset, "the attachment at " + std::to_string(index.offset) +
                                      " differs from the index at the end of the file");
    }
  }
}

void Verifier::VerifyMetadata() {
  for (const MetadataIndex& index : contents_.metadata) {
    const auto read = reader_.ReadMetadata(index);
    if (!read) problems_.Add(index.offset, read.error().message);
  }
}

void Verifier::VerifyBlock(const MessageBlock& block, Statistics& found) {
  const auto records = reader_.Load(block);
  if (records == nullptr) return;
  const std::uint64_t count_before = found.message_count;
  EntriesByChannel entries;
  std::optional<Timestamp> first;
  std::optional<Timestamp> last;
  RecordSequence sequence(records->bytes());
  while (const auto record = sequence.Next()) {
    Message message;
    if (record->opcode != Opcode::kMessage ||
        Parse(record->content, message) == ParseResult::kMalformed) {
      continue;
    }
    entries[message.channel_id].push_back({message.log_time, record->offset});
    first = std::min(first.value_or(message.log_time), message.log_time);
    last = std::max(last.value_or(message.log_time), message.log_time);
    ++found.message_count;
    ++found.channel_message_counts[message.channel_id];
  }
  const std::uint64_t offset = block.index.chunk_start_offset;
  if (sequence.is_malformed() || first.value_or(0) != block.index.message_start_time ||
      last.value_or(0) != block.index.message_end_time) {
    problems_.Add(offset,
                  "the chunk at " + std::to_string(offset) +
                      " has malformed records, or its times differ from those in the index");
  }
  if (!entries.empty()) {
    const auto widen = [&](bool is_first, Timestamp& start, Timestamp& end) {
      start = is_first ? *first : std::min(start, *first);
      end = is_first ? *last : std::max(end, *last);
    };
    const bool is_first = count_before == 0;
    widen(is_first, found.message_start_time, found.message_end_time);
  }
  if (block.is_chunk) VerifyMessageIndexes(block, entries);
}

/// Message indexes may be missing in the whole file or for single chunks.
void Verifier::VerifyMessageIndexes(const MessageBlock& block, const EntriesByChannel& found) {
  const std::uint64_t offset = block.index.chunk_start_offset;
  const auto indexes = reader_.ReadMessageIndexes(block);
  if (!indexes) {
    problems_.Add(offset, indexes.error().message);
    return;
  }
  if (indexes->empty() && (reader_.was_scanned() || block.index.message_index_offsets.empty()))
    return;
  EntriesByChannel stated;
  for (const MessageIndex& index : *indexes) {
    auto& list = stated[index.channel_id];
    list.insert(list.end(), index.records.begin(), index.records.end());
  }
  for (auto& [channel, list] : stated) std::ranges::sort(list, {}, &MessageIndexEntry::offset);
  std::erase_if(stated, [](const auto& entry) { return entry.second.empty(); });
  bool is_same = stated == found;
  if (!block.index.message_index_offsets.empty()) {
    for (const auto& entries : found) {
      const auto& offsets = block.index.message_index_offsets;
      is_same = is_same && std::ranges::any_of(offsets, [&](const auto& entry) {
                  return entry.first == entries.first;
                });
    }
  }
  if (!is_same) {
    problems_.Add(offset, "the message indexes of the chunk at " + std::to_string(offset) +
                              " differ from its messages");
  }
}

void Verifier::VerifyDataSection() {
  if (contents_.data_section_crc == 0) return;
  constexpr std::uint64_t kPiece = std::uint64_t{1} << 20U;
  Buffer piece(kPiece);
  std::uint32_t crc = 0;
  std::uint64_t offset = 0;
  while (offset < contents_.data_section_end) {
    const std::uint64_t size = std::min(kPiece, contents_.data_section_end - offset);
    const auto bytes = std::span(piece).first(static_cast<std::size_t>(size));
    if (auto read = reader_.file_->ReadAt(offset, bytes); !read) {
      problems_.Add(offset, read.error().message);
      return;
    }
    crc = Crc32(bytes, crc);
    offset += size;
  }
  if (crc == contents_.data_section_crc) return;
  problems_.Add(0, "the checksum of the data section is " + HexText(crc) + " instead of " +
                       HexText(contents_.data_section_crc) + ": a byte before " +
                       std::to_string(offset) + " is damaged");
}

void Verifier::VerifyStatistics(const Statistics& found) {
  if (!contents_.statistics) return;
  Statistics stated = *contents_.statistics;
  std::erase_if(stated.channel_message_counts, [](const auto& entry) { return entry.second == 0; });
  if (stated.channel_message_counts.empty()) {
    stated.channel_message_counts = found.channel_message_counts;
  }
  if (stated == found) return;
  problems_.Add(0, "the statistics state " + std::to_string(stated.message_count) +
                       " messages, and " + std::to_string(found.message_count) +
                       " were read; if these numbers are equal, other counts or times differ");
}

Verification Verify(Reader& reader) { return Verifier(reader).Run(); }

}  // namespace tendon::mcap
