#pragma once

#include <tendon/base/os/random_access_file.h>
#include <tendon/base/result.h>
#include <tendon/recording/mcap/records.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

/// Access to single records and chunks of a file, for the reader, the scan and the verification.
/// Programs use mcap/reader.h. Thread safety: one thread at a time.
namespace tendon::mcap {

/// The maximum memory that a reader allocates for parts of a file, in bytes. Before it allocates
/// memory, it also compares each length with the size of the file.
struct ReaderLimits {
  std::uint64_t chunk = std::uint64_t{256} << 20U;  ///< of a chunk, decompressed
  std::uint64_t text = std::uint64_t{64} << 20U;    ///< of one schema, channel, metadata or index
  std::uint64_t attachment = std::uint64_t{1} << 30U;  ///< of an attachment
  std::uint64_t summary = std::uint64_t{256} << 20U;   ///< of the summary section
  std::uint64_t cache = std::uint64_t{64} << 20U;      ///< of the decompressed chunks that are kept
  std::uint64_t overlap = std::uint64_t{256} << 20U;   ///< of the positions of crossed chunks
};

/// A damaged or missing part of a file. The sentence says where it is, and what is lost.
struct Problem {
  std::uint64_t offset = 0;  ///< in the file
  std::string sentence;
};

/// The first 100 problems, and the number of all problems.
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

/// Reads small records, one after the other, with few system calls: it reads up to `ahead` bytes
/// more than requested, if it can.
class BufferedFile {
 public:
  explicit BufferedFile(os::RandomAccessFile& file, std::size_t ahead = std::size_t{64} << 10U)
      : file_(file), ahead_(ahead) {}

  /// Returns `size` bytes at `offset`, which must be within the file. They are valid until the next
  /// call.
  Result<ByteView> At(std::uint64_t offset, std::size_t size);
  /// Like At(), but returns fewer bytes if the file ends too early.
  Result<ByteView> UpTo(std::uint64_t offset, std::size_t size);
  /// Returns the record head at `offset`. If the file ends within the head, returns length 0 and
  /// kNone.
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

/// A buffer that is not filled with zeros first, because this would take as long as reading the
/// bytes.
class RawBuffer {
 public:
  RawBuffer() = default;
  explicit RawBuffer(std::size_t size)
      : bytes_(std::make_unique_for_overwrite<std::byte[]>(size)), size_(size) {}

  [[nodiscard]] std::span<std::byte> bytes() { return {bytes_.get(), size_}; }
  [[nodiscard]] ByteView bytes() const { return {bytes_.get(), size_}; }

 private:
  std::unique_ptr<std::byte[]> bytes_;
  std::size_t size_ = 0;
};

/// A decompressed chunk with a correct checksum.
struct LoadedChunk {
  ChunkHead head;
  RawBuffer records;
};

/// The place of a chunk, according to its first fields.
struct ChunkPlace {
  ChunkHead head;
  std::uint64_t length = 0;         ///< length of the record with its head
  std::uint64_t records_begin = 0;  ///< in the file
  bool is_exact = false;            ///< true if no bytes follow the chunk's records in the record
};

/// Reads the first fields of the chunk at `offset`. Fails with kInvalid if there is no chunk.
Result<ChunkPlace> FindChunk(BufferedFile& file, std::uint64_t offset);

/// Reads and decompresses the records of a chunk. Fails with kInvalid if the checksum is wrong, the
/// compression is unknown, or a size is impossible or above the limit. Fails with kFailed if the
/// disk reports an error.
Result<LoadedChunk> LoadChunk(BufferedFile& file, const ChunkPlace& place,
                              const ReaderLimits& limits);

/// Returns a number as text: "0x1a2b3c4d".
[[nodiscard]] std::string HexText(std::uint32_t number);

}  // namespace tendon::mcap
