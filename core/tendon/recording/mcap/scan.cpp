#include <tendon/base/text.h>
#include <tendon/recording/mcap/compression.h>
#include <tendon/recording/mcap/contents.h>

#include <algorithm>
#include <bitset>
#include <limits>
#include <utility>

namespace tendon::mcap {
namespace {

/// Records outside of chunks are read in blocks of about this size.
constexpr std::uint64_t kLooseBlockSize = std::uint64_t{1} << 20U;  // bytes

std::string Place(std::uint64_t offset) { return " at " + std::to_string(offset); }

/// Reads the data section. If the length of a record is impossible, searches for the next chunk.
/// The search begins after the last trusted record, because the lengths after it may be wrong.
class DataScan {
 public:
  /// `known` is the content of the summary, if its checksum is correct.
  DataScan(BufferedFile& file, const ReaderLimits& limits, Problems& problems,
           std::optional<Contents> known)
      : file_(file), limits_(limits), problems_(problems), known_(std::move(known)) {
    // Limits the cost of a search: each false candidate for a chunk may be as long as the rest of
    // the file.
    search_budget_ = 8 * file.size() + limits.chunk;
  }

  Contents Run() {
    contents_.statistics.emplace();
    ReadHeader(file_, contents_, problems_);
    const auto head = file_.HeadAt(kMagicSize);
    const bool has_header = head && head->opcode == Opcode::kHeader;
    trusted_ = offset_ = kMagicSize;
    while (offset_ < file_.size() && !is_finished_) {
      if (offset_ == kMagicSize && has_header && LengthFits(*head)) {
        Accept(*head, ParseResult::kExact);
      } else {
        Step();
      }
    }
    EndBlock();
    TellUnknownSchemas();
    CountContents(contents_, *contents_.statistics);
    return std::move(contents_);
  }

 private:
  void Step();
  [[nodiscard]] bool LengthFits(const RecordHead& head) const {
    return head.opcode != Opcode::kNone && file_.size() - offset_ >= kRecordHeadSize &&
           head.length <= file_.size() - offset_ - kRecordHeadSize;
  }
  void Accept(const RecordHead& head, ParseResult fit);
  ParseResult ReadRecord(const RecordHead& head);
  ParseResult ReadSmallRecord(const RecordHead& head);
  ParseResult ReadDefinition(Opcode opcode, ByteView content, std::uint64_t offset);
  ParseResult ReadChunk(const RecordHead& head);
  void ReadChunkRecords(const LoadedChunk& chunk, MessageBlock& block);
  ParseResult ReadMessageIndex(ByteView content);
  ParseResult ReadAttachment(const RecordHead& head);
  ParseResult ReadMetadata(const RecordHead& head, ByteView content);
  ParseResult ReadLooseMessage(const RecordHead& head);
  bool FindChannel(ChannelId id);
  void Count(const Message& message, MessageBlock& block);
  void BeginBlock();
  void EndBlock();
  void Search();
  std::uint64_t FindPlausibleChunk(std::uint64_t from);
  bool IsPlausibleChunk(std::uint64_t offset);
  void TellUnknownSchemas();

  BufferedFile& file_;
  const ReaderLimits& limits_;
  Problems& problems_;
  const std::optional<Contents> known_;
  Contents contents_;
  std::uint64_t offset_ = 0;
  std::uint64_t trusted_ = 0;  // the end of the last record whose length is certainly correct
  std::uint64_t search_budget_ = 0;
  bool is_finished_ = false;
  bool has_chunks_ = false;     // whose checksum is right
  bool follows_chunk_ = false;  // the previous record is a chunk, or a message index of a chunk
  std::bitset<std::numeric_limits<ChannelId>::max() + 1> seen_;  // channels of the present block
  std::optional<MessageBlock> loose_;  // the block of records without a chunk that is growing
};

void DataScan::Step() {
  const auto head = file_.HeadAt(offset_);
  if (!head) {
    problems_.Add(offset_, head.error().message + "; the rest of the file is not read");
    is_finished_ = true;
    return;
  }
  if (!LengthFits(*head)) {
    Search();
    return;
  }
  const ParseResult fit = ReadRecord(*head);
  if (is_finished_) return;
  if (fit != ParseResult::kExact) {
    // The length is trusted only if another record can follow.
    const std::uint64_t here = std::exchange(offset_, offset_ + kRecordHeadSize + head->length);
    const auto next = file_.HeadAt(offset_);
    const bool can_follow = offset_ == file_.size() || (next && LengthFits(*next));
    offset_ = here;
    if (!can_follow) {
      Search();
      return;
    }
  }
  Accept(*head, fit);
}

void DataScan::Accept(const RecordHead& head, ParseResult fit) {
  offset_ += kRecordHeadSize + head.length;
  if (fit == ParseResult::kExact) trusted_ = offset_;
}

ParseResult DataScan::ReadRecord(const RecordHead& head) {
  const bool followed_chunk = std::exchange(follows_chunk_, false);
  switch (head.opcode) {
    case Opcode::kChunk:
      EndBlock();
      return ReadChunk(head);
    case Opcode::kMessage:
      return ReadLooseMessage(head);
    case Opcode::kAttachment:
      EndBlock();
      return ReadAttachment(head);
    case Opcode::kMessageIndex:
      if (!followed_chunk) {
        problems_.Add(offset_,
                      "the message index" + Place(offset_) +
                          " does not follow a chunk, so a damaged chunk before this index is lost");
      }
      follows_chunk_ = true;
      return ReadSmallRecord(head);
    case Opcode::kSchema:
    case Opcode::kChannel:
    case Opcode::kMetadata:
    case Opcode::kDataEnd:
      return ReadSmallRecord(head);
    case Opcode::kFooter:
      // The end of a file without a summary; some have no data end either.
      is_finished_ = offset_ + kFooterSize + kMagicSize == file_.size();
      return ParseResult::kExact;
    default:
      // Records of a summary occur here only if the DataEnd record before them is damaged.
      ++contents_.unknown_records;
      return ParseResult::kLonger;
  }
}

ParseResult DataScan::ReadSmallRecord(const RecordHead& head) {
  if (head.length > limits_.text) {
    problems_.Add(offset_, "the record" + Place(offset_) + " has " + std::to_string(head.length) +
                               " bytes, more than " + std::to_string(limits_.text) +
                               "; it is skipped");
    return ParseResult::kLonger;
  }
  const auto content = file_.At(offset_ + kRecordHeadSize, static_cast<std::size_t>(head.length));
  ParseResult fit = ParseResult::kMalformed;
  if (!content) {
    problems_.Add(offset_, content.error().message);
    return fit;
  }
  if (head.opcode == Opcode::kDataEnd) {
    DataEnd end;
    fit = Parse(*content, end);
    is_finished_ = fit == ParseResult::kExact;
    if (is_finished_) {
      contents_.data_section_crc = end.data_section_crc;
      contents_.data_section_end = offset_;
    }
  } else if (head.opcode == Opcode::kMetadata) {
    fit = ReadMetadata(head, *content);
  } else if (head.opcode == Opcode::kMessageIndex) {
    fit = ReadMessageIndex(*content);
  } else {
    fit = ReadDefinition(head.opcode, *content, offset_);
  }
  if (fit == ParseResult::kMalformed) {
    problems_.Add(offset_, "the record" + Place(offset_) + " is malformed; it is skipped");
  }
  return fit;
}

ParseResult DataScan::ReadDefinition(Opcode opcode, ByteView content, std::uint64_t offset) {
  ParseResult fit = ParseResult::kMalformed;
  if (opcode == Opcode::kSchema) {
    Schema schema;
    fit = Parse(content, schema);
    if (fit != ParseResult::kMalformed) AddSchema(contents_, std::move(schema), offset, problems_);
  } else {
    Channel channel;
    fit = Parse(content, channel);
    if (fit != ParseResult::kMalformed)
      AddChannel(contents_, std::move(channel), offset, problems_);
  }
  return fit;
}

ParseResult DataScan::ReadChunk(const RecordHead& head) {
  const auto place = FindChunk(file_, offset_);
  if (!place) {
    problems_.Add(offset_, "the chunk" + Place(offset_) + " is lost: " + place.error().message);
    return ParseResult::kMalformed;
  }
  follows_chunk_ = true;
  MessageBlock block;
  seen_.reset();
  block.index.chunk_start_offset = offset_;
  block.index.chunk_length = kRecordHeadSize + head.length;
  block.index.compression = place->head.compression;
  block.index.compressed_size = place->head.records_size;
  block.index.uncompressed_size = place->head.uncompressed_size;
  const auto chunk = LoadChunk(file_, *place, limits_);
  if (chunk) {
    ReadChunkRecords(*chunk, block);
    contents_.blocks.push_back(std::move(block));
    has_chunks_ = true;
  } else {
    problems_.Add(offset_, "the chunk" + Place(offset_) + " is lost: " + chunk.error().message);
  }
  return place->is_exact ? ParseResult::kExact : ParseResult::kLonger;
}

void DataScan::ReadChunkRecords(const LoadedChunk& chunk, MessageBlock& block) {
  RecordSequence records(chunk.records.bytes());
  while (const auto record = records.Next()) {
    if (record->opcode == Opcode::kMessage) {
      Message message;
      if (Parse(record->content, message) != ParseResult::kMalformed) {
        Count(message, block);
        continue;
      }
    } else if (record->opcode != Opcode::kSchema && record->opcode != Opcode::kChannel) {
      ++contents_.unknown_records;
      continue;
    } else if (ReadDefinition(record->opcode, record->content, offset_) !=
               ParseResult::kMalformed) {
      continue;
    }
    problems_.Add(offset_, "the chunk" + Place(offset_) + " has a malformed record" +
                               Place(record->offset) + " of its content; this record is skipped");
  }
  if (records.is_malformed()) {
    problems_.Add(offset_, "the chunk" + Place(offset_) + " has no valid record" +
                               Place(records.offset()) +
                               " of its content; the rest of the chunk is skipped");
  }
  if (block.index.message_start_time != chunk.head.message_start_time ||
      block.index.message_end_time != chunk.head.message_end_time) {
    problems_.Add(offset_, "the chunk" + Place(offset_) +
                               " states times that differ from the times of its messages; the "
                               "times of the messages are used");
  }
  std::ranges::sort(block.index.message_index_offsets);
}

/// Returns true if the channel is defined. If its definition is damaged, uses the definition in the
/// summary.
bool DataScan::FindChannel(ChannelId id) {
  if (contents_.channels.contains(id)) return true;
  if (!known_ || !known_->channels.contains(id)) return false;
  const Channel& channel = known_->channels.at(id);
  const auto schema = known_->schemas.find(channel.schema_id);
  if (schema != known_->schemas.end()) contents_.schemas.insert(*schema);
  contents_.channels.emplace(id, channel);
  return true;
}

void DataScan::Count(const Message& message, MessageBlock& block) {
  if (!FindChannel(message.channel_id)) {
    if (contents_.lost_messages++ == 0) {
      problems_.Add(offset_, "the message" + Place(offset_) + " is on channel " +
                                 std::to_string(message.channel_id) +
                                 ", which the file does not define before this message; messages "
                                 "without a defined channel are lost");
    }
    return;
  }
  Statistics& statistics = *contents_.statistics;
  ChunkIndex& index = block.index;
  const auto widen = [&](bool is_first, Timestamp& start, Timestamp& end) {
    start = is_first ? message.log_time : std::min(start, message.log_time);
    end = is_first ? message.log_time : std::max(end, message.log_time);
  };
  auto& channels = index.message_index_offsets;
  widen(statistics.message_count == 0, statistics.message_start_time, statistics.message_end_time);
  widen(channels.empty(), index.message_start_time, index.message_end_time);
  ++statistics.message_count;
  ++statistics.channel_message_counts[message.channel_id];
  if (seen_.test(message.channel_id)) return;
  seen_.set(message.channel_id);
  // 0 for now: ReadMessageIndex() sets the offset when it reads the index after the chunk.
  channels.emplace_back(message.channel_id, 0);
}

ParseResult DataScan::ReadMessageIndex(ByteView content) {
  MessageIndex index;
  const ParseResult fit = Parse(content, index);
  if (fit == ParseResult::kMalformed || contents_.blocks.empty() ||
      !contents_.blocks.back().is_chunk) {
    return fit;
  }
  ChunkIndex& chunk = contents_.blocks.back().index;
  const std::uint64_t begin = chunk.chunk_start_offset + chunk.chunk_length;
  if (begin + chunk.message_index_length != offset_) return fit;  // that chunk was lost
  chunk.message_index_length += kRecordHeadSize + content.size();
  for (auto& [channel, offset] : chunk.message_index_offsets) {
    if (channel == index.channel_id) offset = offset_;
  }
  return fit;
}

ParseResult DataScan::ReadAttachment(const RecordHead& head) {
  constexpr std::size_t kCrcSize = 4;
  Attachment attachment;
  AttachmentIndex index{.offset = offset_, .length = kRecordHeadSize + head.length};
  const auto most = static_cast<std::size_t>(std::min(head.length, limits_.text));
  const auto begin = file_.At(offset_ + kRecordHeadSize, std::min<std::size_t>(most, 4096));
  auto used =
      begin ? ParseAttachmentHead(*begin, head.length, attachment, index.data_size) : std::nullopt;
  if (!used && most > 4096) {  // long names
    const auto more = file_.At(offset_ + kRecordHeadSize, most);
    if (more) used = ParseAttachmentHead(*more, head.length, attachment, index.data_size);
  }
  if (!used) {
    problems_.Add(offset_, "the attachment" + Place(offset_) + " is malformed; it is lost");
    return ParseResult::kMalformed;
  }
  index.log_time = attachment.log_time;
  index.create_time = attachment.create_time;
  index.name = std::move(attachment.name);
  index.media_type = std::move(attachment.media_type);
  const bool is_exact = *used + index.data_size + kCrcSize == head.length;
  contents_.attachments.push_back(std::move(index));
  return is_exact ? ParseResult::kExact : ParseResult::kLonger;
}

ParseResult DataScan::ReadMetadata(const RecordHead& head, ByteView content) {
  Metadata metadata;
  const ParseResult fit = Parse(content, metadata);
  if (fit == ParseResult::kMalformed) return fit;
  contents_.metadata.push_back({offset_, kRecordHeadSize + head.length, std::move(metadata.name)});
  return fit;
}

/// In a file with chunks, all messages are in chunks. A message outside of them may be another
/// record with a damaged opcode, and no checksum shows this. Therefore, such messages are skipped.
ParseResult DataScan::ReadLooseMessage(const RecordHead& head) {
  if (has_chunks_) {
    ++contents_.lost_messages;
    problems_.Add(offset_,
                  "the message" + Place(offset_) +
                      " is outside of the chunks, so no checksum protects it; it is skipped");
    return ParseResult::kLonger;
  }
  if (head.length > limits_.chunk) {
    problems_.Add(offset_, "the message" + Place(offset_) + " has " + std::to_string(head.length) +
                               " bytes, more than " + std::to_string(limits_.chunk) +
                               "; it is skipped");
    EndBlock();
    return ParseResult::kLonger;
  }
  const auto content =
      file_.At(offset_ + kRecordHeadSize,
               static_cast<std::size_t>(std::min<std::uint64_t>(head.length, kMessageHeadSize)));
  Message message;
  if (!content || Parse(*content, message) == ParseResult::kMalformed) {
    problems_.Add(offset_, "the message" + Place(offset_) + " is malformed; it is skipped");
    EndBlock();
    return ParseResult::kMalformed;
  }
  const std::uint64_t size = kRecordHeadSize + head.length;
  if (loose_ && offset_ + size - loose_->index.chunk_start_offset > kLooseBlockSize) EndBlock();
  if (!loose_) BeginBlock();
  Count(message, *loose_);
  loose_->index.chunk_length = offset_ + size - loose_->index.chunk_start_offset;
  return contents_.channels.contains(message.channel_id) ? ParseResult::kExact
                                                         : ParseResult::kLonger;
}

void DataScan::BeginBlock() {
  loose_.emplace();
  seen_.reset();
  loose_->is_chunk = false;
  loose_->index.chunk_start_offset = offset_;
}

void DataScan::EndBlock() {
  if (!loose_) return;
  std::ranges::sort(loose_->index.message_index_offsets);
  if (!loose_->index.message_index_offsets.empty()) contents_.blocks.push_back(*std::move(loose_));
  loose_.reset();
}

/// Continues at the next chunk, or ends the scan.
void DataScan::Search() {
  EndBlock();
  const std::uint64_t broken = offset_;
  // The record at the end of the trusted records was already read; it is not a chunk.
  const std::uint64_t found = FindPlausibleChunk(trusted_ + 1);
  if (found == file_.size()) {
    is_finished_ = true;
    problems_.Add(broken, "the file ends within the record" + Place(broken) + ": the last " +
                              std::to_string(file_.size() - broken) + " bytes are incomplete");
    return;
  }
  problems_.Add(trusted_, "the bytes from " + std::to_string(trusted_) + " to " +
                              std::to_string(found) +
                              " are damaged and skipped; the next chunk begins after them");
  offset_ = trusted_ = found;
}

std::uint64_t DataScan::FindPlausibleChunk(std::uint64_t from) {
  constexpr std::size_t kPiece = std::size_t{64} << 10U;
  BufferedFile pieces(file_.file());  // IsPlausibleChunk() reads with the other reader
  while (from < file_.size()) {
    const auto piece = pieces.UpTo(from, kPiece);
    if (!piece) return file_.size();
    const ByteView bytes = *piece;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      if (bytes[i] != static_cast<std::byte>(Opcode::kChunk)) continue;
      // A length of 2^40 bytes or more is not plausible.
      if (i + kRecordHeadSize <= bytes.size() && bytes[i + 8] != std::byte{0}) continue;
      if (IsPlausibleChunk(from + i)) return from + i;
      if (search_budget_ == 0) return file_.size();
    }
    from += bytes.size();
  }
  return file_.size();
}

/// Returns true if there is a chunk with a correct checksum. Returns false for a chunk without a
/// checksum or above the size limit.
bool DataScan::IsPlausibleChunk(std::uint64_t offset) {
  const auto place = FindChunk(file_, offset);
  if (!place || !place->is_exact || place->head.uncompressed_crc == 0) return false;
  if (!ParseFormatName(place->head.compression)) return false;
  const std::uint64_t cost = place->head.records_size + place->head.uncompressed_size;
  if (cost > search_budget_) {
    search_budget_ = 0;
    problems_.Add(offset, "so much of the file is damaged that the search for further chunks ends" +
                              Place(offset));
    return false;
  }
  search_budget_ -= cost;
  return LoadChunk(file_, *place, limits_).ok();
}

void DataScan::TellUnknownSchemas() {
  for (const auto& [id, channel] : contents_.channels) {
    if (channel.schema_id == 0 || contents_.schemas.contains(channel.schema_id)) continue;
    problems_.Add(
        file_.size(),
        "channel " + std::to_string(id) + " (" + Quoted(channel.topic, 200) +
            ") has the schema id " + std::to_string(channel.schema_id) +
            ", but this schema is not defined; the messages of the channel have no schema");
  }
}

}  // namespace

Contents Scan(BufferedFile& file, const ReaderLimits& limits, Problems& problems) {
  Problems ignored;  // only the definitions are used, and only if their checksum is correct
  auto known = ReadSummary(file, limits, ignored);
  return DataScan(file, limits, problems, std::move(known)).Run();
}

}  // namespace tendon::mcap
