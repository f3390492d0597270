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

/// Messages that are read together: a chunk, or records of a file without chunks, which have no
/// checksum.
struct MessageBlock {
  ChunkIndex index;  ///< of records without a chunk, only place and times are set
  bool is_chunk = true;
};

/// The content of a file, without its messages: where they are. Made by ReadSummary() or Scan().
struct Contents {
  Header header;
  std::map<SchemaId, Schema> schemas;
  std::map<ChannelId, Channel> channels;
  std::vector<MessageBlock> blocks;  ///< by their offset
  std::vector<AttachmentIndex> attachments;
  std::vector<MetadataIndex> metadata;
  std::optional<Statistics> statistics;  ///< missing only if the summary has none
  std::uint32_t data_section_crc = 0;    ///< 0: unknown
  std::uint64_t data_section_end = 0;    ///< offset of the DataEnd record; 0: not found
  std::uint64_t unknown_records = 0;     ///< that were skipped
  std::uint64_t lost_messages = 0;       ///< that a scan found, but without their channel
};

/// Adds a schema or a channel unless its id is known; a Problem if it is known with other content,
/// or not allowed.
void AddSchema(Contents& contents, Schema schema, std::uint64_t offset, Problems& problems);
void AddChannel(Contents& contents, Channel channel, std::uint64_t offset, Problems& problems);

/// Reads the header. A Problem if it is missing.
void ReadHeader(BufferedFile& file, Contents& contents, Problems& problems);

/// Reads the summary: cost and memory grow with the number of chunks, not with their size. Empty if
/// the file has no summary, or it does not suffice to read the file; if it is damaged or missing
/// because the file was cut off, a Problem says so.
std::optional<Contents> ReadSummary(BufferedFile& file, const ReaderLimits& limits,
                                    Problems& problems);

/// Reads the whole data section, and makes the contents from the records themselves. Finds the next
/// chunk behind damaged records. Messages outside of chunks are read in files without chunks, or
/// before the first one. Decompresses each chunk once; keeps none.
Contents Scan(BufferedFile& file, const ReaderLimits& limits, Problems& problems);

}  // namespace tendon::mcap
