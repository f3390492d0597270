#pragma once

#include <tendon/base/result.h>
#include <tendon/recording/mcap/chunk.h>
#include <tendon/recording/mcap/records.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tendon::mcap {

/// Messages that are read together: the messages of a chunk or, in a file without chunks,
/// consecutive records without a checksum.
struct MessageBlock {
  ChunkIndex index;  ///< for records without a chunk, only the place and the times are set
  bool is_chunk = true;
};

/// The content of a file, with the places of the messages instead of the messages. Made by
/// ReadSummary() or Scan().
struct Contents {
  Header header;
  std::map<SchemaId, Schema> schemas;
  std::map<ChannelId, Channel> channels;
  std::vector<MessageBlock> blocks;  ///< sorted by offset
  std::vector<AttachmentIndex> attachments;
  std::vector<MetadataIndex> metadata;
  std::optional<Statistics> statistics;  ///< missing only if the summary has none
  std::uint32_t data_section_crc = 0;    ///< 0: unknown
  std::uint64_t data_section_end = 0;    ///< offset of the DataEnd record; 0: not found
  std::uint64_t unknown_records = 0;     ///< number of skipped records
  std::uint64_t lost_messages = 0;  ///< number of messages that a scan found without their channel
};

/// Adds a schema or a channel, unless its id is known. Adds a Problem if the id already has another
/// content or is not allowed.
void AddSchema(Contents& contents, Schema schema, std::uint64_t offset, Problems& problems);
void AddChannel(Contents& contents, Channel channel, std::uint64_t offset, Problems& problems);

/// Sets the counts of schemas, channels, attachments, metadata and chunks.
void CountContents(const Contents& contents, Statistics& statistics);

/// Reads the header. Adds a Problem if the header is missing.
void ReadHeader(BufferedFile& file, Contents& contents, Problems& problems);

/// Reads the summary. Cost and memory depend on the number of chunks, not on their size. Returns
/// nothing if there is no summary, or if the summary does not suffice to read the file. Adds a
/// Problem if the summary is damaged, or missing because the file was cut off.
std::optional<Contents> ReadSummary(BufferedFile& file, const ReaderLimits& limits,
                                    Problems& problems);

/// Reads the whole data section, and makes the contents from its records. After damaged records,
/// finds the next chunk. Reads messages outside of chunks only if the file has no chunks, or before
/// the first chunk. Decompresses each chunk once, and does not keep it.
Contents Scan(BufferedFile& file, const ReaderLimits& limits, Problems& problems);

}  // namespace tendon::mcap
