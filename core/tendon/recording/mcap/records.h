#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// The file format of recordings: MCAP, version 0, by its public specification, "MCAP Format
/// Specification" (mcap.dev/spec). A file is
///
///     magic, header, data section, data end, summary, summary offsets, footer, magic
///
/// Each part is a sequence of records: an opcode (1 byte), the length of the content (8 bytes), the
/// content. Numbers are little-endian. Messages are in chunks, which are compressed and have a
/// checksum. The summary, at the end of the file, lists the place, the times and the channels of
/// each chunk.
///
/// This header has a struct for each kind of record, with two functions: Append() writes it,
/// Parse() reads it. These functions do not use files; mcap/writer.h and mcap/reader.h do.
namespace tendon::mcap {

using ByteView = std::span<const std::byte>;
using Buffer = std::vector<std::byte>;
/// Nanoseconds since an epoch of the writer's choice, usually 1970.
using Timestamp = std::uint64_t;
using ChannelId = std::uint16_t;
using SchemaId = std::uint16_t;

inline constexpr Timestamp kFirstTime = 0;
inline constexpr Timestamp kLastTime = std::numeric_limits<Timestamp>::max();

/// The first and the last bytes of a file.
inline constexpr std::size_t kMagicSize = 8;
[[nodiscard]] ByteView Magic() noexcept;

/// Opcode and length.
inline constexpr std::size_t kRecordHeadSize = 9;
/// Channel, sequence and two times.
inline constexpr std::size_t kMessageHeadSize = 22;
/// With the head of the record.
inline constexpr std::size_t kDataEndSize = kRecordHeadSize + 4;
inline constexpr std::size_t kFooterSize = kRecordHeadSize + 20;

/// The values 0x10 to 0x7f are reserved for later versions of the format. The values 0x80 to 0xff
/// are free for all programs. Readers skip both.
enum class Opcode : std::uint8_t {
  kNone = 0x00,  // occurs in no file
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kAttachment = 0x09,
  kAttachmentIndex = 0x0a,
  kStatistics = 0x0b,
  kMetadata = 0x0c,
  kMetadataIndex = 0x0d,
  kSummaryOffset = 0x0e,
  kDataEnd = 0x0f,
};

struct Header {
  std::string profile;  ///< for example "ros2", or empty
  std::string library;  ///< the program that wrote the file

  bool operator==(const Header&) const = default;
};

struct Footer {
  std::uint64_t summary_start = 0;         ///< offset in the file; 0: no summary
  std::uint64_t summary_offset_start = 0;  ///< offset in the file; 0: no summary offsets
  std::uint32_t summary_crc = 0;           ///< from summary_start to this field; 0: unknown

  bool operator==(const Footer&) const = default;
};

struct Schema {
  SchemaId id = 0;  ///< never 0 in a file
  std::string name;
  std::string encoding;  ///< for example "ros2msg"
  std::string data;      ///< any bytes

  bool operator==(const Schema&) const = default;
};

struct Channel {
  ChannelId id = 0;
  SchemaId schema_id = 0;  ///< 0: without a schema
  std::string topic;
  std::string message_encoding;  ///< for example "cdr"
  std::map<std::string, std::string> metadata;

  bool operator==(const Channel&) const = default;
};

struct Message {
  ChannelId channel_id = 0;
  std::uint32_t sequence = 0;
  Timestamp log_time = 0;
  Timestamp publish_time = 0;
  ByteView data;  ///< not owned
};

/// The fields of a chunk except the last one, its records.
struct ChunkHead {
  Timestamp message_start_time = 0;
  Timestamp message_end_time = 0;
  std::uint64_t uncompressed_size = 0;  ///< bytes
  std::uint32_t uncompressed_crc = 0;   ///< 0: unknown
  std::string compression;
  std::uint64_t records_size = 0;  ///< of the records in the file, bytes

  bool operator==(const ChunkHead&) const = default;
};

struct MessageIndexEntry {
  Timestamp log_time = 0;
  std::uint64_t offset = 0;  ///< in the uncompressed records of the chunk

  bool operator==(const MessageIndexEntry&) const = default;
};

struct MessageIndex {
  ChannelId channel_id = 0;
  std::vector<MessageIndexEntry> records;

  bool operator==(const MessageIndex&) const = default;
};

struct ChunkIndex {
  Timestamp message_start_time = 0;
  Timestamp message_end_time = 0;
  std::uint64_t chunk_start_offset = 0;  ///< in the file
  std::uint64_t chunk_length = 0;        ///< of the record, with its head
  /// The channels in the chunk, and the offsets of their message indexes in the file. Empty if
  /// unknown.
  std::vector<std::pair<ChannelId, std::uint64_t>> message_index_offsets;
  std::uint64_t message_index_length = 0;  ///< of all message indexes after the chunk
  std::string compression;
  std::uint64_t compressed_size = 0;
  std::uint64_t uncompressed_size = 0;

  bool operator==(const ChunkIndex&) const = default;
};

struct Attachment {
  Timestamp log_time = 0;
  Timestamp create_time = 0;  ///< 0: unknown
  std::string name;
  std::string media_type;
  Buffer data;

  bool operator==(const Attachment&) const = default;
};

struct AttachmentIndex {
  std::uint64_t offset = 0;  ///< in the file
  std::uint64_t length = 0;  ///< of the record, with its head
  Timestamp log_time = 0;
  Timestamp create_time = 0;
  std::uint64_t data_size = 0;
  std::string name;
  std::string media_type;

  bool operator==(const AttachmentIndex&) const = default;
};

/// Metadata have no separate checksum. They are covered only by the checksum of the whole data
/// section, which Verify() checks. Therefore, important data belongs in an attachment.
struct Metadata {
  std::string name;
  std::map<std::string, std::string> metadata;

  bool operator==(const Metadata&) const = default;
};

struct MetadataIndex {
  std::uint64_t offset = 0;  ///< in the file
  std::uint64_t length = 0;  ///< of the record, with its head
  std::string name;

  bool operator==(const MetadataIndex&) const = default;
};

struct Statistics {
  std::uint64_t message_count = 0;
  std::uint16_t schema_count = 0;
  std::uint32_t channel_count = 0;
  std::uint32_t attachment_count = 0;
  std::uint32_t metadata_count = 0;
  std::uint32_t chunk_count = 0;
  Timestamp message_start_time = 0;  ///< 0 if there is no message
  Timestamp message_end_time = 0;
  std::map<ChannelId, std::uint64_t> channel_message_counts;  ///< empty: unknown

  bool operator==(const Statistics&) const = default;
};

struct SummaryOffset {
  std::uint8_t group_opcode = 0;
  std::uint64_t group_start = 0;  ///< in the file
  std::uint64_t group_length = 0;

  bool operator==(const SummaryOffset&) const = default;
};

struct DataEnd {
  std::uint32_t data_section_crc = 0;  ///< from the start of the file to this record; 0: unknown

  bool operator==(const DataEnd&) const = default;
};

/// Appends a whole record, with its head. AppendChunkHead() and AppendAttachmentHead() write only
/// the part before the records or the data. Then the caller writes the records or the data and, for
/// an attachment, the checksum.
void Append(Buffer& out, const Header& header);
void Append(Buffer& out, const Footer& footer);
void Append(Buffer& out, const Schema& schema);
void Append(Buffer& out, const Channel& channel);
void Append(Buffer& out, const Message& message);
void Append(Buffer& out, const MessageIndex& index);
void Append(Buffer& out, const ChunkIndex& index);
void Append(Buffer& out, const AttachmentIndex& index);
void Append(Buffer& out, const Metadata& metadata);
void Append(Buffer& out, const MetadataIndex& index);
void Append(Buffer& out, const Statistics& statistics);
void Append(Buffer& out, const SummaryOffset& offset);
void Append(Buffer& out, const DataEnd& end);
void AppendChunkHead(Buffer& out, const ChunkHead& chunk);
void AppendAttachmentHead(Buffer& out, const Attachment& attachment);
void AppendNumber(Buffer& out, std::uint64_t number, std::size_t size);

/// Writes a number in the byte order of the format.
template <typename Number>
void PutNumber(std::byte* place, Number number) noexcept {
  if constexpr (std::endian::native == std::endian::little) {
    std::memcpy(place, &number, sizeof(number));
  } else {
    for (std::size_t i = 0; i < sizeof(number); ++i) {
      place[i] = static_cast<std::byte>(number >> (8 * i));
    }
  }
}

/// Whether the content of a record fits its kind.
enum class ParseResult : std::uint8_t {
  kMalformed,  ///< too short, or a length in it is wrong
  kLonger,     ///< a later version of the format may append fields
  kExact,
};

/// Reads the content of a record, which follows its head. Allocates at most a small multiple of the
/// content's size, even if a length in it is wrong. If a key occurs twice in a map, its first value
/// is used. After kMalformed, the content of the struct is undefined.
[[nodiscard]] ParseResult Parse(ByteView content, Header& header);
[[nodiscard]] ParseResult Parse(ByteView content, Footer& footer);
[[nodiscard]] ParseResult Parse(ByteView content, Schema& schema);
[[nodiscard]] ParseResult Parse(ByteView content, Channel& channel);
[[nodiscard]] ParseResult Parse(ByteView content, Message& message);  ///< data refers to `content`
[[nodiscard]] ParseResult Parse(ByteView content, MessageIndex& index);
[[nodiscard]] ParseResult Parse(ByteView content, ChunkIndex& index);
[[nodiscard]] ParseResult Parse(ByteView content, AttachmentIndex& index);
[[nodiscard]] ParseResult Parse(ByteView content, Metadata& metadata);
[[nodiscard]] ParseResult Parse(ByteView content, MetadataIndex& index);
[[nodiscard]] ParseResult Parse(ByteView content, Statistics& statistics);
[[nodiscard]] ParseResult Parse(ByteView content, SummaryOffset& offset);
[[nodiscard]] ParseResult Parse(ByteView content, DataEnd& end);

/// Reads the first fields of a chunk or an attachment. `begin` has the first bytes of its content,
/// and `size` is the size of its content. Returns the place of the records or the data in the
/// content. Returns nothing if they do not fit the size, or if `begin` is too short. Does not read
/// the data.
[[nodiscard]] std::optional<std::size_t> ParseChunkHead(ByteView begin, std::uint64_t size,
                                                        ChunkHead& chunk);
[[nodiscard]] std::optional<std::size_t> ParseAttachmentHead(ByteView begin, std::uint64_t size,
                                                             Attachment& attachment,
                                                             std::uint64_t& data_size);

/// One record of a sequence in memory.
struct RecordView {
  Opcode opcode = Opcode::kNone;
  std::uint64_t offset = 0;  ///< place of the head in the sequence
  ByteView content;
};

/// Iterates over a sequence of records in memory.
class RecordSequence {
 public:
  explicit RecordSequence(ByteView records) : records_(records) {}

  /// Returns the next record. Returns nothing at the end, or if the next bytes are not a record.
  std::optional<RecordView> Next();
  /// True if the next bytes are not a record.
  [[nodiscard]] bool is_malformed() const { return is_malformed_; }
  /// The place of the next record.
  [[nodiscard]] std::size_t offset() const { return offset_; }

 private:
  const ByteView records_;
  std::size_t offset_ = 0;
  bool is_malformed_ = false;
};

struct RecordHead {
  Opcode opcode = Opcode::kNone;
  std::uint64_t length = 0;  ///< length of the content, as the file states it
};

/// Reads the first kRecordHeadSize bytes.
[[nodiscard]] RecordHead ParseRecordHead(ByteView bytes);

}  // namespace tendon::mcap
