#pragma once

#include <tendon/base/os/random_access_file.h>
#include <tendon/base/result.h>
#include <tendon/recording/mcap/records.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

/// Access to single records and chunks of a file, for the reader, the scan and the verification.
/// Programs use mcap/reader.h. Thread safety: one thread at a time.
namespace tendon::mcap {

/// How much memory a reader takes for what a file claims, in bytes. Each length is also compared
/// with the size of the file before memory is taken.
struct ReaderLimits {
  std::uint64_t chunk = std::uint64_t{256} << 20U;     ///< of a chunk, decompressed
  std::uint64_t text = std::uint64_t{64} << 20U;       ///< of a schema, channel, metadata, index
  std::uint64_t attachment = std::uint64_t{1} << 30U;  ///< of an attachment
  std::uint64_t summary = std::uint64_t{256} << 20U;   ///< of the summary section
  std::uint64_t cache = std::uint64_t{64} << 20U;      ///< of the decompressed chunks that are kept
  std::uint64_t overlap = std::uint64_t{256} << 20U;   ///< of the positions of crossed chunks
};

/// A damaged or missing part of a file. The sentence says where it is, and what is lost with it.
struct Problem {
  std::uint64_t offset = 0;  ///< in the file
  std::string sentence;
};

/// The first 100 problems, and how many there were.
class Problems {
 public:
  void Add(std::uint64_t offset, std::string sentence);
  void Add(const Problems& others);
  [[nodiscard]] const std::vector<Problem>& first() const { return first_; }
  [[nodiscard]] std::uint64_t count() const { return count_; }

 private:
  std::vector<Problem> first_;
  std::uint64_t count_ = 0;
};

/// Reads small records, one after the other, with few system calls: reads up to `ahead` bytes more
/// than it is asked for, unless these cannot be read.
class BufferedFile {
 public:
  explicit BufferedFile(os::RandomAccessFile& file, std::size_t ahead = std::size_t{64} << 10U)
      : file_(file), ahead_(ahead) {}

  /// `size` bytes at `offset`, both within the file. Valid until the next call.
  Result<Bytes> At(std::uint64_t offset, std::size_t size);
  /// As many as there are, up to `size`.
  Result<Bytes> UpTo(std::uint64_t offset, std::size_t size);
  /// The record head at `offset`; length 0 and kNone if the file ends within it.
  Result<RecordHead> HeadAt(std::uint64_t offset);

  [[nodiscard]] std::uint64_t size() const { return file_.size(); }
  [[nodiscard]] os::RandomAccessFile& file() { return file_; }

 private:
  Result<void> Fill(std::uint64_t offset, std::uint64_t size);

  os::RandomAccessFile& file_;
  const std::size_t ahead_;
  Buffer buffer_;
  std::uint64_t begin_ = 0;  // of the buffer, in the file
};

/// Bytes that are not filled with zeros first, which takes as long as to read them.
class RawBuffer {
 public:
  RawBuffer() = default;
  explicit RawBuffer(std::size_t size)
      : bytes_(std::make_unique_for_overwrite<std::byte[]>(size)), size_(size) {}

  [[nodiscard]] std::span<std::byte> bytes() { return {bytes_.get(), size_}; }
  [[nodiscard]] Bytes bytes() const { return {bytes_.get(), size_}; }

 private:
  std::unique_ptr<std::byte[]> bytes_;
  std::size_t size_ = 0;
};

/// A chunk, decompressed, whose checksum is right.
struct LoadedChunk {
  ChunkHead head;
  RawBuffer records;
};

/// The place of a chunk, read from its own first fields.
struct ChunkPlace {
  ChunkHead head;
  std::uint64_t length = 0;         ///< of the record, with its head
  std::uint64_t records_begin = 0;  ///< in the file
  bool is_exact = false;            ///< the record ends where its records do
};

/// Reads the first fields of the chunk at `offset`. kInvalid if there is none.
Result<ChunkPlace> FindChunk(BufferedFile& file, std::uint64_t offset);

/// Reads and decompresses its records. kInvalid, with the reason, if the checksum is wrong, the
/// compression is unknown, or a size is impossible or above the limit; kFailed if the disk reports
/// an error.
Result<LoadedChunk> LoadChunk(BufferedFile& file, const ChunkPlace& place,
                              const ReaderLimits& limits);

/// "0x1a2b3c4d"
[[nodiscard]] std::string HexText(std::uint32_t number);

}  // namespace tendon::mcap
