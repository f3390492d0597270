#include <tendon/recording/mcap/contents.h>

#include <tendon/recording/mcap/compression.h>

#include <algorithm>
#include <set>
#include <utility>

namespace tendon::mcap {
namespace {

/// Reads one summary. The functions that return a reason return an empty text on success.
class SummaryReader {
 public:
  SummaryReader(BufferedFile& file, const ReaderLimits& limits, Problems& problems)
      : file_(file), limits_(limits), problems_(problems) {}

  std::optional<Contents> Read() {
    std::string reason = ReadFooter();
    if (reason.empty() && footer_.summary_start == 0) return std::nullopt;
    if (reason.empty()) reason = ReadRecords();
    if (reason.empty()) {
      ReadDataEnd();
      reason = Check();
    }
    if (reason.empty() && !is_sufficient_) return std::nullopt;
    if (reason.empty()) return std::move(contents_);
    problems_.Add(footer_.summary_start, "the index at the end of the file cannot be used: " +
                                             reason + "; the whole file is read instead");
    return std::nullopt;
  }

 private:
  std::string ReadFooter();
  std::string ReadRecords();
  std::string ReadRecord(const RecordView& record);
  template <typename Record>
  std::string Add(const RecordView& record, std::vector<Record>& list);
  void ReadDataEnd();
  std::string Check();
  std::string CheckChunks();
  void CheckSufficiency();

  BufferedFile& file_;
  const ReaderLimits& limits_;
  Problems& problems_;
  Contents contents_;
  Footer footer_;
  std::uint64_t footer_offset_ = 0;
  bool is_sufficient_ = true;
};

std::string SummaryReader::ReadFooter() {
  constexpr std::uint64_t kTail = kFooterSize + kMagicSize;
  if (file_.size() < kMagicSize + kTail) return "the file is cut off, or still being written";
  footer_offset_ = file_.size() - kTail;
  const auto tail = file_.At(footer_offset_, kTail);
  if (!tail) return tail.error().message;
  if (!std::ranges::equal(tail->subspan(kFooterSize), Magic())) {
    return "the end of the file is missing: the recording was cut off, or is still being written";
  }
  const RecordHead head = ParseRecordHead(*tail);
  if (head.opcode != Opcode::kFooter || head.length != kFooterSize - kRecordHeadSize ||
      Parse(tail->subspan(kRecordHeadSize, static_cast<std::size_t>(head.length)), footer_) !=
          ParseResult::kExact) {
    return "the footer is damaged";
  }
  const std::uint64_t start = footer_.summary_start;
  const std::uint64_t offsets = footer_.summary_offset_start;
  if (start != 0 && (start < kMagicSize || start > footer_offset_)) {
    return "the summary begins at " + std::to_string(start) + ", outside of the file";
  }
  if (offsets != 0 && (offsets < start || offsets > footer_offset_)) {
    return "the summary offsets begin at " + std::to_string(offsets) + ", outside of the summary";
  }
  return {};
}

std::string SummaryReader::ReadRecords() {
  const std::uint64_t size = footer_offset_ - footer_.summary_start;
  if (size > limits_.summary) {
    return "the summary has " + std::to_string(size) + " bytes, more than " +
           std::to_string(limits_.summary);
  }
  constexpr std::size_t kCrcSize = 4;
  RawBuffer buffer(static_cast<std::size_t>(size + kFooterSize - kCrcSize));
  if (auto read = file_.file().ReadAt(footer_.summary_start, buffer.bytes()); !read) {
    return read.error().message;
  }
  const ByteView bytes = std::as_const(buffer).bytes();
  const std::uint32_t crc = footer_.summary_crc == 0 ? 0 : Crc32(bytes);
  if (crc != footer_.summary_crc) {
    return "its checksum is " + HexText(crc) + " instead of " + HexText(footer_.summary_crc);
  }
  RecordSequence records(bytes.first(static_cast<std::size_t>(size)));
  while (const auto record = records.Next()) {
    if (std::string reason = ReadRecord(*record); !reason.empty()) return reason;
  }
  if (records.is_malformed()) {
    return "there is no record at " + std::to_string(footer_.summary_start + records.offset());
  }
  return {};
}

template <typename Record>
std::string SummaryReader::Add(const RecordView& record, std::vector<Record>& list) {
  Record read;
  if (Parse(record.content, read) == ParseResult::kMalformed) return "malformed";
  list.push_back(std::move(read));
  return {};
}

std::string SummaryReader::ReadRecord(const RecordView& record) {
  const std::uint64_t offset = footer_.summary_start + record.offset;
  std::string reason;
  bool is_read = true;
  switch (record.opcode) {
    case Opcode::kSchema: {
      Schema schema;
      is_read = Parse(record.content, schema) != ParseResult::kMalformed;
      if (is_read) AddSchema(contents_, std::move(schema), offset, problems_);
      break;
    }
    case Opcode::kChannel: {
      Channel channel;
      is_read = Parse(record.content, channel) != ParseResult::kMalformed;
      if (is_read) AddChannel(contents_, std::move(channel), offset, problems_);
      break;
    }
    case Opcode::kChunkIndex: {
      MessageBlock block;
      is_read = Parse(record.content, block.index) != ParseResult::kMalformed;
      contents_.blocks.push_back(std::move(block));
      break;
    }
    case Opcode::kAttachmentIndex:
      is_read = Add(record, contents_.attachments).empty();
      break;
    case Opcode::kMetadataIndex:
      is_read = Add(record, contents_.metadata).empty();
      break;
    case Opcode::kStatistics:
      contents_.statistics.emplace();
      is_read = Parse(record.content, *contents_.statistics) != ParseResult::kMalformed;
      break;
    case Opcode::kSummaryOffset: {
      SummaryOffset unused;
      is_read = Parse(record.content, unused) != ParseResult::kMalformed;
      break;
    }
    default:
      ++contents_.unknown_records;
  }
  if (!is_read) reason = "the record at " + std::to_string(offset) + " is malformed";
  return reason;
}

/// Reads the record before the summary. If it is missing, only the checksum of the data section is
/// unknown.
void SummaryReader::ReadDataEnd() {
  const std::uint64_t offset =
      footer_.summary_start - std::min<std::uint64_t>(footer_.summary_start, kDataEndSize);
  const auto bytes = file_.At(offset, kDataEndSize);
  DataEnd end;
  const RecordHead head = bytes ? ParseRecordHead(*bytes) : RecordHead{};
  if (head.opcode != Opcode::kDataEnd || head.length != kDataEndSize - kRecordHeadSize ||
      Parse(bytes->subspan(kRecordHeadSize), end) != ParseResult::kExact) {
    problems_.Add(offset,
                  "the end record of the data section is missing before the index, so the checksum "
                  "of the data section cannot be verified");
    return;
  }
  contents_.data_section_crc = end.data_section_crc;
  contents_.data_section_end = offset;
}

std::string SummaryReader::Check() {
  std::ranges::sort(contents_.blocks, {},
                    [](const MessageBlock& block) { return block.index.chunk_start_offset; });
  std::string reason = CheckChunks();
  const auto is_inside = [&](std::uint64_t offset, std::uint64_t length) {
    return offset >= kMagicSize && offset <= footer_.summary_start && length >= kRecordHeadSize &&
           length <= footer_.summary_start - offset;
  };
  for (const AttachmentIndex& index : contents_.attachments) {
    if (is_inside(index.offset, index.length) && index.data_size <= index.length) continue;
    reason = "according to the index, attachment '" + index.name + "' is outside of the file";
  }
  for (const MetadataIndex& index : contents_.metadata) {
    if (is_inside(index.offset, index.length)) continue;
    reason = "according to the index, metadata '" + index.name + "' is outside of the file";
  }
  if (reason.empty()) CheckSufficiency();
  return reason;
}

/// Each chunk must be in the data section, and chunks must not overlap, so that no byte is read
/// twice.
std::string SummaryReader::CheckChunks() {
  std::uint64_t end = kMagicSize;
  for (const MessageBlock& block : contents_.blocks) {
    const ChunkIndex& index = block.index;
    if (index.chunk_start_offset < end || index.chunk_start_offset > footer_.summary_start ||
        index.chunk_length > footer_.summary_start - index.chunk_start_offset) {
      return "according to the index, a chunk is at " + std::to_string(index.chunk_start_offset) +
             " + " + std::to_string(index.chunk_length) +
             ", so it overlaps another chunk or is outside of the file";
    }
    end = index.chunk_start_offset + std::max<std::uint64_t>(index.chunk_length, 1);
    if (index.message_start_time > index.message_end_time) {
      return "according to the index, the chunk at " + std::to_string(index.chunk_start_offset) +
             " ends before it begins";
    }
  }
  return {};
}

/// The format allows a summary without data that a reader needs. Then the whole file is read, which
/// is not a problem of the file.
void SummaryReader::CheckSufficiency() {
  std::set<ChannelId> used;
  for (const MessageBlock& block : contents_.blocks) {
    for (const auto& [channel, offset] : block.index.message_index_offsets) used.insert(channel);
  }
  const auto& statistics = contents_.statistics;
  if (statistics) {
    for (const auto& [channel, count] : statistics->channel_message_counts) {
      if (count > 0) used.insert(channel);
    }
    if (statistics->chunk_count != contents_.blocks.size() ||
        statistics->attachment_count != contents_.attachments.size() ||
        statistics->metadata_count != contents_.metadata.size() ||
        statistics->channel_count > contents_.channels.size() ||
        (statistics->message_count > 0 && contents_.blocks.empty())) {
      is_sufficient_ = false;
    }
  } else if (contents_.blocks.empty() || contents_.attachments.empty() ||
             contents_.metadata.empty()) {
    is_sufficient_ = false;  // nothing says that there are none
  }
  const bool may_have_channels =
      !statistics || statistics->channel_count > 0 || statistics->message_count > 0;
  if (contents_.channels.empty() && !contents_.blocks.empty() && may_have_channels) {
    is_sufficient_ = false;
  }
  for (const ChannelId id : used) {
    if (!contents_.channels.contains(id)) is_sufficient_ = false;
  }
  for (const auto& [id, channel] : contents_.channels) {
    if (channel.schema_id != 0 && !contents_.schemas.contains(channel.schema_id)) {
      is_sufficient_ = false;
    }
  }
}

}  // namespace

void AddSchema(Contents& contents, Schema schema, std::uint64_t offset, Problems& problems) {
  const SchemaId id = schema.id;
  if (id == 0) {
    problems.Add(offset, "the schema at " + std::to_string(offset) +
                             " has the id 0, which means no schema; it is skipped");
    return;
  }
  const auto [place, is_new] = contents.schemas.try_emplace(id, schema);
  if (!is_new && place->second != schema) {
    problems.Add(offset, "the schema at " + std::to_string(offset) + " has the id " +
                             std::to_string(id) +
                             " of another schema; the first of these schemas is used for both");
  }
}

void AddChannel(Contents& contents, Channel channel, std::uint64_t offset, Problems& problems) {
  const ChannelId id = channel.id;
  const auto [place, is_new] = contents.channels.try_emplace(id, channel);
  if (!is_new && place->second != channel) {
    problems.Add(offset, "the channel at " + std::to_string(offset) + " has the id " +
                             std::to_string(id) +
                             " of another channel; the first of these channels is used for both");
  }
}

void CountContents(const Contents& contents, Statistics& statistics) {
  statistics.schema_count = static_cast<std::uint16_t>(contents.schemas.size());
  statistics.channel_count = static_cast<std::uint32_t>(contents.channels.size());
  statistics.attachment_count = static_cast<std::uint32_t>(contents.attachments.size());
  statistics.metadata_count = static_cast<std::uint32_t>(contents.metadata.size());
  statistics.chunk_count =
      static_cast<std::uint32_t>(std::ranges::count_if(contents.blocks, &MessageBlock::is_chunk));
}

void ReadHeader(BufferedFile& file, Contents& contents, Problems& problems) {
  constexpr std::uint64_t kMaxHeader = std::uint64_t{1} << 20U;
  const auto head = file.HeadAt(kMagicSize);
  if (head && head->opcode == Opcode::kHeader && head->length <= kMaxHeader &&
      file.size() - kMagicSize - kRecordHeadSize >= head->length) {
    const auto content =
        file.At(kMagicSize + kRecordHeadSize, static_cast<std::size_t>(head->length));
    if (content && Parse(*content, contents.header) != ParseResult::kMalformed) return;
  }
  contents.header = {};
  problems.Add(kMagicSize, "the header is missing or damaged, so the profile is unknown");
}

std::optional<Contents> ReadSummary(BufferedFile& file, const ReaderLimits& limits,
                                    Problems& problems) {
  return SummaryReader(file, limits, problems).Read();
}

}  // namespace tendon::mcap
