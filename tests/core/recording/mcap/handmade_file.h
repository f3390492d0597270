#pragma once

#include <tendon/recording/mcap/compression.h>
#include <tendon/recording/mcap/records.h>

#include <cstdint>
#include <optional>
#include <string_view>

namespace tendon::mcap {

/// Builds files record by record, including files that Tendon never writes.
class HandmadeFile {
 public:
  HandmadeFile() {
    const ByteView magic = Magic();
    bytes.insert(bytes.end(), magic.begin(), magic.end());
    Append(bytes, Header{"", "hand"});
  }

  template <typename Record>
  HandmadeFile& Add(const Record& record) {
    Append(bytes, record);
    return *this;
  }
  HandmadeFile& Add(std::uint8_t opcode, std::string_view content) {
    bytes.push_back(static_cast<std::byte>(opcode));
    AppendNumber(bytes, content.size(), 8);
    const ByteView text = std::as_bytes(std::span(content));
    bytes.insert(bytes.end(), text.begin(), text.end());
    return *this;
  }
  /// Adds a chunk. Returns its index, without message indexes.
  ChunkIndex AddChunk(const Buffer& records, Timestamp start, Timestamp end,
                      Compression compression = Compression::kNone) {
    Compressor compressor(compression);
    Compression used = Compression::kNone;
    const auto compressed = compressor.Compress(records, used);
    const ChunkHead head{start,
                         end,
                         records.size(),
                         Crc32(records),
                         std::string(FormatNameOf(used)),
                         compressed->size()};
    const std::uint64_t begin = bytes.size();
    AppendChunkHead(bytes, head);
    bytes.insert(bytes.end(), compressed->begin(), compressed->end());
    return {.message_start_time = start,
            .message_end_time = end,
            .chunk_start_offset = begin,
            .chunk_length = bytes.size() - begin,
            .compression = head.compression,
            .compressed_size = head.records_size,
            .uncompressed_size = head.uncompressed_size};
  }
  /// Ends the data section. Then adds the records of `summary` and the footer.
  Buffer End(const Buffer& summary = {}, std::optional<std::uint64_t> start = std::nullopt) {
    Append(bytes, DataEnd{});
    const std::uint64_t begin = summary.empty() ? 0 : bytes.size();
    bytes.insert(bytes.end(), summary.begin(), summary.end());
    Append(bytes, Footer{start.value_or(begin), 0, 0});
    const ByteView magic = Magic();
    bytes.insert(bytes.end(), magic.begin(), magic.end());
    return bytes;
  }

  Buffer bytes;
};

}  // namespace tendon::mcap
