#include <tendon/recording/mcap/records.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <string_view>

namespace tendon::mcap {
namespace {

constexpr std::array<std::byte, kMagicSize> kMagic{std::byte{0x89}, std::byte{'M'}, std::byte{'C'},
                                                   std::byte{'A'},  std::byte{'P'}, std::byte{'0'},
                                                   std::byte{'\r'}, std::byte{'\n'}};

void AppendString(Buffer& out, std::string_view text) {
  AppendNumber(out, text.size(), 4);
  const ByteView bytes = std::as_bytes(std::span(text));
  out.insert(out.end(), bytes.begin(), bytes.end());
}

void SetNumber(Buffer& out, std::size_t place, std::uint64_t number, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) out[place + i] = static_cast<std::byte>(number >> (8 * i));
}

/// Writes the length of a record, or of a list in it, when it is known.
class LengthPrefix {
 public:
  LengthPrefix(Buffer& out, std::size_t size) : out_(out), place_(out.size()), size_(size) {
    AppendNumber(out, 0, size);
  }
  LengthPrefix(const LengthPrefix&) = delete;
  LengthPrefix& operator=(const LengthPrefix&) = delete;
  ~LengthPrefix() { SetNumber(out_, place_, out_.size() - place_ - size_, size_); }

 private:
  Buffer& out_;
  const std::size_t place_;
  const std::size_t size_;
};

LengthPrefix BeginRecord(Buffer& out, Opcode opcode) {
  out.push_back(static_cast<std::byte>(opcode));
  return {out, 8};
}

void AppendMap(Buffer& out, const std::map<std::string, std::string>& map) {
  const LengthPrefix length(out, 4);
  for (const auto& [key, value] : map) {
    AppendString(out, key);
    AppendString(out, value);
  }
}

/// Reads fields one after the other. After a field that does not fit, all further fields are 0 or
/// empty.
class FieldReader {
 public:
  explicit FieldReader(ByteView content) : rest_(content) {}

  template <typename Number>
  Number Get() {
    const ByteView bytes = GetBytes(sizeof(Number));
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      number |= std::to_integer<std::uint64_t>(bytes[i]) << (8 * i);
    }
    return static_cast<Number>(number);
  }
  ByteView GetBytes(std::uint64_t size) {
    if (size > rest_.size()) {
      is_malformed_ = true;
      rest_ = {};
      return {};
    }
    const ByteView bytes = rest_.first(static_cast<std::size_t>(size));
    rest_ = rest_.subspan(bytes.size());
    return bytes;
  }
  std::string GetString() {
    const ByteView bytes = GetBytes(Get<std::uint32_t>());
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  FieldReader GetList() { return FieldReader(GetBytes(Get<std::uint32_t>())); }
  std::map<std::string, std::string> GetMap() {
    std::map<std::string, std::string> map;
    FieldReader list = GetList();
    while (list.has_more()) {
      std::string key = list.GetString();
      std::string value = list.GetString();
      if (!list.is_malformed_) map.emplace(std::move(key), std::move(value));
    }
    is_malformed_ = is_malformed_ || list.is_malformed_;
    return map;
  }
  /// Marks this record as malformed if `list` is malformed. Call it after reading a list from
  /// GetList() with Get().
  void Check(const FieldReader& list) { is_malformed_ = is_malformed_ || list.is_malformed_; }

  [[nodiscard]] bool has_more() const { return !rest_.empty(); }
  [[nodiscard]] std::size_t rest_size() const { return rest_.size(); }
  [[nodiscard]] bool is_malformed() const { return is_malformed_; }
  [[nodiscard]] ParseResult fit() const {
    if (is_malformed_) return ParseResult::kMalformed;
    return rest_.empty() ? ParseResult::kExact : ParseResult::kLonger;
  }

 private:
  ByteView rest_;
  bool is_malformed_ = false;
};

}  // namespace

ByteView Magic() noexcept { return kMagic; }

void AppendNumber(Buffer& out, std::uint64_t number, std::size_t size) {
  assert(size <= sizeof(number));
  std::array<std::byte, sizeof(number)> bytes{};
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::byte>(number >> (8 * i));
  out.insert(out.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
}

void Append(Buffer& out, const Header& header) {
  const LengthPrefix length = BeginRecord(out, Opcode::kHeader);
  AppendString(out, header.profile);
  AppendString(out, header.library);
}

void Append(Buffer& out, const Footer& footer) {
  const LengthPrefix length = BeginRecord(out, Opcode::kFooter);
  AppendNumber(out, footer.summary_start, 8);
  AppendNumber(out, footer.summary_offset_start, 8);
  AppendNumber(out, footer.summary_crc, 4);
}

void Append(Buffer& out, const Schema& schema) {
  const LengthPrefix length = BeginRecord(out, Opcode::kSchema);
  AppendNumber(out, schema.id, 2);
  AppendString(out, schema.name);
  AppendString(out, schema.encoding);
  AppendString(out, schema.data);
}

void Append(Buffer& out, const Channel& channel) {
  const LengthPrefix length = BeginRecord(out, Opcode::kChannel);
  AppendNumber(out, channel.id, 2);
  AppendNumber(out, channel.schema_id, 2);
  AppendString(out, channel.topic);
  AppendString(out, channel.message_encoding);
  AppendMap(out, channel.metadata);
}

void Append(Buffer& out, const Message& message) {
  // The head is appended in one piece, because this function is called for every message.
  std::array<std::byte, kRecordHeadSize + kMessageHeadSize> head{};
  head[0] = static_cast<std::byte>(Opcode::kMessage);
  PutNumber(head.data() + 1, std::uint64_t{kMessageHeadSize + message.data.size()});
  PutNumber(head.data() + 9, message.channel_id);
  PutNumber(head.data() + 11, message.sequence);
  PutNumber(head.data() + 15, message.log_time);
  PutNumber(head.data() + 23, message.publish_time);
  out.insert(out.end(), head.begin(), head.end());
  out.insert(out.end(), message.data.begin(), message.data.end());
}

void Append(Buffer& out, const MessageIndex& index) {
  const LengthPrefix length = BeginRecord(out, Opcode::kMessageIndex);
  AppendNumber(out, index.channel_id, 2);
  const LengthPrefix list(out, 4);
  for (const MessageIndexEntry& entry : index.records) {
    AppendNumber(out, entry.log_time, 8);
    AppendNumber(out, entry.offset, 8);
  }
}

void Append(Buffer& out, const ChunkIndex& index) {
  const LengthPrefix length = BeginRecord(out, Opcode::kChunkIndex);
  AppendNumber(out, index.message_start_time, 8);
  AppendNumber(out, index.message_end_time, 8);
  AppendNumber(out, index.chunk_start_offset, 8);
  AppendNumber(out, index.chunk_length, 8);
  {
    const LengthPrefix list(out, 4);
    for (const auto& [channel, offset] : index.message_index_offsets) {
      AppendNumber(out, channel, 2);
      AppendNumber(out, offset, 8);
    }
  }
  AppendNumber(out, index.message_index_length, 8);
  AppendString(out, index.compression);
  AppendNumber(out, index.compressed_size, 8);
  AppendNumber(out, index.uncompressed_size, 8);
}

void Append(Buffer& out, const AttachmentIndex& index) {
  const LengthPrefix length = BeginRecord(out, Opcode::kAttachmentIndex);
  AppendNumber(out, index.offset, 8);
  AppendNumber(out, index.length, 8);
  AppendNumber(out, index.log_time, 8);
  AppendNumber(out, index.create_time, 8);
  AppendNumber(out, index.data_size, 8);
  AppendString(out, index.name);
  AppendString(out, index.media_type);
}

void Append(Buffer& out, const Metadata& metadata) {
  const LengthPrefix length = BeginRecord(out, Opcode::kMetadata);
  AppendString(out, metadata.name);
  AppendMap(out, metadata.metadata);
}

void Append(Buffer& out, const MetadataIndex& index) {
  const LengthPrefix length = BeginRecord(out, Opcode::kMetadataIndex);
  AppendNumber(out, index.offset, 8);
  AppendNumber(out, index.length, 8);
  AppendString(out, index.name);
}

void Append(Buffer& out, const Statistics& statistics) {
  const LengthPrefix length = BeginRecord(out, Opcode::kStatistics);
  AppendNumber(out, statistics.message_count, 8);
  AppendNumber(out, statistics.schema_count, 2);
  AppendNumber(out, statistics.channel_count, 4);
  AppendNumber(out, statistics.attachment_count, 4);
  AppendNumber(out, statistics.metadata_count, 4);
  AppendNumber(out, statistics.chunk_count, 4);
  AppendNumber(out, statistics.message_start_time, 8);
  AppendNumber(out, statistics.message_end_time, 8);
  const LengthPrefix list(out, 4);
  for (const auto& [channel, count] : statistics.channel_message_counts) {
    AppendNumber(out, channel, 2);
    AppendNumber(out, count, 8);
  }
}

void Append(Buffer& out, const SummaryOffset& offset) {
  const LengthPrefix length = BeginRecord(out, Opcode::kSummaryOffset);
  AppendNumber(out, offset.group_opcode, 1);
  AppendNumber(out, offset.group_start, 8);
  AppendNumber(out, offset.group_length, 8);
}

void Append(Buffer& out, const DataEnd& end) {
  const LengthPrefix length = BeginRecord(out, Opcode::kDataEnd);
  AppendNumber(out, end.data_section_crc, 4);
}

void AppendChunkHead(Buffer& out, const ChunkHead& chunk) {
  constexpr std::size_t kNumbers = 8 + 8 + 8 + 4 + 4 + 8;
  AppendNumber(out, static_cast<std::uint64_t>(Opcode::kChunk), 1);
  AppendNumber(out, kNumbers + chunk.compression.size() + chunk.records_size, 8);
  AppendNumber(out, chunk.message_start_time, 8);
  AppendNumber(out, chunk.message_end_time, 8);
  AppendNumber(out, chunk.uncompressed_size, 8);
  AppendNumber(out, chunk.uncompressed_crc, 4);
  AppendString(out, chunk.compression);
  AppendNumber(out, chunk.records_size, 8);
}

void AppendAttachmentHead(Buffer& out, const Attachment& attachment) {
  constexpr std::size_t kNumbers = 8 + 8 + 4 + 4 + 8 + 4;
  AppendNumber(out, static_cast<std::uint64_t>(Opcode::kAttachment), 1);
  AppendNumber(
      out,
      kNumbers + attachment.name.size() + attachment.media_type.size() + attachment.data.size(), 8);
  AppendNumber(out, attachment.log_time, 8);
  AppendNumber(out, attachment.create_time, 8);
  AppendString(out, attachment.name);
  AppendString(out, attachment.media_type);
  AppendNumber(out, attachment.data.size(), 8);
}

ParseResult Parse(ByteView content, Header& header) {
  FieldReader fields(content);
  header.profile = fields.GetString();
  header.library = fields.GetString();
  return fields.fit();
}

ParseResult Parse(ByteView content, Footer& footer) {
  FieldReader fields(content);
  footer.summary_start = fields.Get<std::uint64_t>();
  footer.summary_offset_start = fields.Get<std::uint64_t>();
  footer.summary_crc = fields.Get<std::uint32_t>();
  return fields.fit();
}

ParseResult Parse(ByteView content, Schema& schema) {
  FieldReader fields(content);
  schema.id = fields.Get<SchemaId>();
  schema.name = fields.GetString();
  schema.encoding = fields.GetString();
  schema.data = fields.GetString();
  return fields.fit();
}

ParseResult Parse(ByteView content, Channel& channel) {
  FieldReader fields(content);
  channel.id = fields.Get<ChannelId>();
  channel.schema_id = fields.Get<SchemaId>();
  channel.topic = fields.GetString();
  channel.message_encoding = fields.GetString();
  channel.metadata = fields.GetMap();
  return fields.fit();
}

ParseResult Parse(ByteView content, Message& message) {
  FieldReader fields(content);
  message.channel_id = fields.Get<ChannelId>();
  message.sequence = fields.Get<std::uint32_t>();
  message.log_time = fields.Get<Timestamp>();
  message.publish_time = fields.Get<Timestamp>();
  message.data = fields.GetBytes(fields.rest_size());
  return fields.fit();
}

ParseResult Parse(ByteView content, MessageIndex& index) {
  FieldReader fields(content);
  index.channel_id = fields.Get<ChannelId>();
  FieldReader list = fields.GetList();
  index.records.clear();
  index.records.reserve(list.rest_size() / sizeof(MessageIndexEntry));
  while (list.has_more()) {
    MessageIndexEntry entry;
    entry.log_time = list.Get<Timestamp>();
    entry.offset = list.Get<std::uint64_t>();
    index.records.push_back(entry);
  }
  fields.Check(list);
  return fields.fit();
}

ParseResult Parse(ByteView content, ChunkIndex& index) {
  constexpr std::size_t kEntrySize = 10;  // bytes in the file
  FieldReader fields(content);
  index.message_start_time = fields.Get<Timestamp>();
  index.message_end_time = fields.Get<Timestamp>();
  index.chunk_start_offset = fields.Get<std::uint64_t>();
  index.chunk_length = fields.Get<std::uint64_t>();
  FieldReader list = fields.GetList();
  index.message_index_offsets.clear();
  index.message_index_offsets.reserve(list.rest_size() / kEntrySize);
  while (list.has_more()) {
    const auto channel = list.Get<ChannelId>();
    index.message_index_offsets.emplace_back(channel, list.Get<std::uint64_t>());
  }
  fields.Check(list);
  index.message_index_length = fields.Get<std::uint64_t>();
  index.compression = fields.GetString();
  index.compressed_size = fields.Get<std::uint64_t>();
  index.uncompressed_size = fields.Get<std::uint64_t>();
  return fields.fit();
}

ParseResult Parse(ByteView content, AttachmentIndex& index) {
  FieldReader fields(content);
  index.offset = fields.Get<std::uint64_t>();
  index.length = fields.Get<std::uint64_t>();
  index.log_time = fields.Get<Timestamp>();
  index.create_time = fields.Get<Timestamp>();
  index.data_size = fields.Get<std::uint64_t>();
  index.name = fields.GetString();
  index.media_type = fields.GetString();
  return fields.fit();
}

ParseResult Parse(ByteView content, Metadata& metadata) {
  FieldReader fields(content);
  metadata.name = fields.GetString();
  metadata.metadata = fields.GetMap();
  return fields.fit();
}

ParseResult Parse(ByteView content, MetadataIndex& index) {
  FieldReader fields(content);
  index.offset = fields.Get<std::uint64_t>();
  index.length = fields.Get<std::uint64_t>();
  index.name = fields.GetString();
  return fields.fit();
}

ParseResult Parse(ByteView content, Statistics& statistics) {
  FieldReader fields(content);
  statistics.message_count = fields.Get<std::uint64_t>();
  statistics.schema_count = fields.Get<std::uint16_t>();
  statistics.channel_count = fields.Get<std::uint32_t>();
  statistics.attachment_count = fields.Get<std::uint32_t>();
  statistics.metadata_count = fields.Get<std::uint32_t>();
  statistics.chunk_count = fields.Get<std::uint32_t>();
  statistics.message_start_time = fields.Get<Timestamp>();
  statistics.message_end_time = fields.Get<Timestamp>();
  statistics.channel_message_counts.clear();
  FieldReader list = fields.GetList();
  while (list.has_more()) {
    const auto channel = list.Get<ChannelId>();
    statistics.channel_message_counts.emplace(channel, list.Get<std::uint64_t>());
  }
  fields.Check(list);
  return fields.fit();
}

ParseResult Parse(ByteView content, SummaryOffset& offset) {
  FieldReader fields(content);
  offset.group_opcode = fields.Get<std::uint8_t>();
  offset.group_start = fields.Get<std::uint64_t>();
  offset.group_length = fields.Get<std::uint64_t>();
  return fields.fit();
}

ParseResult Parse(ByteView content, DataEnd& end) {
  FieldReader fields(content);
  end.data_section_crc = fields.Get<std::uint32_t>();
  return fields.fit();
}

std::optional<std::size_t> ParseChunkHead(ByteView begin, std::uint64_t size, ChunkHead& chunk) {
  FieldReader fields(begin.first(std::min<std::uint64_t>(begin.size(), size)));
  chunk.message_start_time = fields.Get<Timestamp>();
  chunk.message_end_time = fields.Get<Timestamp>();
  chunk.uncompressed_size = fields.Get<std::uint64_t>();
  chunk.uncompressed_crc = fields.Get<std::uint32_t>();
  chunk.compression = fields.GetString();
  chunk.records_size = fields.Get<std::uint64_t>();
  if (fields.is_malformed()) return std::nullopt;
  const std::size_t used = std::min<std::uint64_t>(begin.size(), size) - fields.rest_size();
  if (chunk.records_size > size - used) return std::nullopt;
  return used;
}

std::optional<std::size_t> ParseAttachmentHead(ByteView begin, std::uint64_t size,
                                               Attachment& attachment, std::uint64_t& data_size) {
  constexpr std::uint64_t kCrcSize = 4;
  FieldReader fields(begin.first(std::min<std::uint64_t>(begin.size(), size)));
  attachment.log_time = fields.Get<Timestamp>();
  attachment.create_time = fields.Get<Timestamp>();
  attachment.name = fields.GetString();
  attachment.media_type = fields.GetString();
  data_size = fields.Get<std::uint64_t>();
  if (fields.is_malformed()) return std::nullopt;
  const std::size_t used = std::min<std::uint64_t>(begin.size(), size) - fields.rest_size();
  if (size - used < kCrcSize || data_size > size - used - kCrcSize) return std::nullopt;
  return used;
}

RecordHead ParseRecordHead(ByteView bytes) {
  FieldReader fields(bytes);
  RecordHead head;
  head.opcode = static_cast<Opcode>(fields.Get<std::uint8_t>());
  head.length = fields.Get<std::uint64_t>();
  return head;
}

std::optional<RecordView> RecordSequence::Next() {
  const ByteView rest = records_.subspan(offset_);
  if (rest.empty()) return std::nullopt;
  const RecordHead head = ParseRecordHead(rest);
  if (rest.size() < kRecordHeadSize || head.opcode == Opcode::kNone ||
      head.length > rest.size() - kRecordHeadSize) {
    is_malformed_ = true;
    return std::nullopt;
  }
  const auto length = static_cast<std::size_t>(head.length);
  const RecordView view{head.opcode, offset_, rest.subspan(kRecordHeadSize, length)};
  offset_ += kRecordHeadSize + length;
  return view;
}

}  // namespace tendon::mcap
