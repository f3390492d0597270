#include <tendon/recording/mcap/chunk.h>

#include <tendon/base/text.h>
#include <tendon/recording/mcap/compression.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

namespace tendon::mcap {
namespace {

Error Damage(std::string message) { return {ErrorCode::kInvalid, std::move(message)}; }

}  // namespace

std::string HexText(std::uint32_t number) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "0x%08x", number);
  return text.data();
}

void Problems::Add(std::uint64_t offset, std::string sentence) {
  constexpr std::size_t kMax = 100;
  ++count_;
  if (first_.size() < kMax) first_.push_back({offset, std::move(sentence)});
}

void Problems::Add(const Problems& others) {
  const std::uint64_t count = count_ + others.count_;
  for (const Problem& problem : others.first_) Add(problem.offset, problem.sentence);
  count_ = count;
}

Result<ByteView> BufferedFile::At(std::uint64_t offset, std::size_t size) {
  if (offset > file_.size() || size > file_.size() - offset) {
    return Damage("the file ends before " + std::to_string(offset) + " + " + std::to_string(size));
  }
  if (offset < begin_ || offset - begin_ > buffer_.size() ||
      size > buffer_.size() - (offset - begin_)) {
    auto filled = Fill(offset, std::min<std::uint64_t>(size + ahead_, file_.size() - offset));
    // The disk may have a bad sector in the bytes that were read ahead.
    if (!filled) filled = Fill(offset, size);
    if (!filled) return filled.error();
  }
  return ByteView(buffer_).subspan(static_cast<std::size_t>(offset - begin_), size);
}

Result<void> BufferedFile::Fill(std::uint64_t offset, std::uint64_t size) {
  buffer_.resize(static_cast<std::size_t>(size));
  begin_ = offset;
  auto read = file_.ReadAt(offset, buffer_);
  if (!read) buffer_.clear();
  return read;
}

Result<ByteView> BufferedFile::UpTo(std::uint64_t offset, std::size_t size) {
  const std::uint64_t rest = file_.size() - std::min(offset, file_.size());
  return At(offset, static_cast<std::size_t>(std::min<std::uint64_t>(size, rest)));
}

Result<RecordHead> BufferedFile::HeadAt(std::uint64_t offset) {
  const auto bytes = UpTo(offset, kRecordHeadSize);
  if (!bytes) return bytes.error();
  if (bytes->size() < kRecordHeadSize) return RecordHead{};
  return ParseRecordHead(*bytes);
}

Result<ChunkPlace> FindChunk(BufferedFile& file, std::uint64_t offset) {
  constexpr std::size_t kMaxFields = 128;  // the names of compressions are short
  const auto bytes = file.UpTo(offset, kMaxFields);
  if (!bytes) return bytes.error();
  const RecordHead head = ParseRecordHead(*bytes);
  if (bytes->size() < kRecordHeadSize || head.opcode != Opcode::kChunk) {
    return Damage("there is no chunk");
  }
  const std::uint64_t rest = file.size() - offset - kRecordHeadSize;
  if (head.length > rest) {
    return Damage("the length of the chunk is " + std::to_string(head.length) +
                  ", but the file ends after " + std::to_string(rest) + " bytes");
  }
  ChunkPlace place;
  const auto begin = ParseChunkHead(bytes->subspan(kRecordHeadSize), head.length, place.head);
  if (!begin) return Damage("the fields of the chunk do not match the length of the chunk");
  place.length = kRecordHeadSize + head.length;
  place.records_begin = offset + kRecordHeadSize + *begin;
  place.is_exact = *begin + place.head.records_size == head.length;
  return place;
}

Result<LoadedChunk> LoadChunk(BufferedFile& file, const ChunkPlace& place,
                              const ReaderLimits& limits) {
  const ChunkHead& head = place.head;
  const auto compression = ParseFormatName(head.compression);
  if (!compression) return Damage(compression.error().message);
  const std::uint64_t most = std::min(LargestDecompressed(*compression, head.records_size),
                                      std::max(limits.chunk, std::uint64_t{1}));
  if (head.uncompressed_size > most || head.records_size > limits.chunk) {
    return Damage("the chunk states " + std::to_string(head.uncompressed_size) +
                  " bytes after decompression, but at most " + std::to_string(most) +
                  " are possible or allowed");
  }
  LoadedChunk chunk{head, RawBuffer(static_cast<std::size_t>(head.uncompressed_size))};
  if (*compression == Compression::kNone) {
    if (head.records_size != head.uncompressed_size)
      return Damage("the two sizes of the uncompressed chunk differ");
    if (auto read = file.file().ReadAt(place.records_begin, chunk.records.bytes()); !read) {
      return read.error();
    }
  } else {
    RawBuffer compressed(static_cast<std::size_t>(head.records_size));
    if (auto read = file.file().ReadAt(place.records_begin, compressed.bytes()); !read) {
      return read.error();
    }
    const ByteView bytes = std::as_const(compressed).bytes();
    if (auto done = Decompress(*compression, bytes, chunk.records.bytes()); !done) {
      return done.error();
    }
  }
  const std::uint32_t crc =
      head.uncompressed_crc == 0 ? 0 : Crc32(std::as_const(chunk.records).bytes());
  if (crc != head.uncompressed_crc) {
    return Damage("the checksum of the chunk is " + HexText(crc) + " instead of " +
                  HexText(head.uncompressed_crc));
  }
  return chunk;
}

}  // namespace tendon::mcap
