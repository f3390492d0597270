#pragma once

#include <tendon/base/result.h>
#include <tendon/recording/mcap/records.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

namespace tendon::mcap {

/// The compression of the records of a chunk.
enum class Compression : std::int32_t {
  kNone,
  kLz4,   ///< LZ4 frame format
  kZstd,  ///< Zstandard frame format
};
inline constexpr std::array kCompressions{Compression::kNone, Compression::kLz4,
                                          Compression::kZstd};

/// Returns the name that users see: "none", "lz4" or "zstd".
[[nodiscard]] constexpr std::string_view NameOf(Compression compression) noexcept {
  switch (compression) {
    case Compression::kLz4:
      return "lz4";
    case Compression::kZstd:
      return "zstd";
    case Compression::kNone:
      break;
  }
  return "none";
}
/// Parses a name that users type. For other names, fails with kInvalid; the error lists the known
/// names.
Result<Compression> ParseCompression(std::string_view name);

/// Returns the name in files, which is empty for kNone.
[[nodiscard]] std::string_view FormatNameOf(Compression compression) noexcept;
/// Parses a name in a file. For other names, fails with kInvalid; the error lists the known names.
Result<Compression> ParseFormatName(std::string_view name);

/// Returns the CRC32 (of zlib, PNG and Ethernet) of `bytes`. If other bytes precede them, `before`
/// is the checksum of the preceding bytes. Cost: about 0.4 ns for each byte.
[[nodiscard]] std::uint32_t Crc32(ByteView bytes, std::uint32_t before = 0) noexcept;
/// Returns the checksum of two consecutive ranges; the second one has `size` bytes. Cost: about 1
/// us.
[[nodiscard]] std::uint32_t CombinedCrc32(std::uint32_t first, std::uint32_t second,
                                          std::uint64_t size) noexcept;

/// Compresses chunks. Keeps the memory of the codec, a few MiB, between chunks.
///
/// Thread safety: one thread at a time.
class Compressor {
 public:
  /// `level` 0 means the default: level 1 of zstd, or the fast mode of LZ4.
  explicit Compressor(Compression compression, int level = 0);
  Compressor(const Compressor&) = delete;
  Compressor& operator=(const Compressor&) = delete;
  ~Compressor();

  /// Returns the compressed bytes, which are valid until the next call. If the bytes cannot be made
  /// smaller, sets `used` to kNone and returns `bytes`. Fails with kFailed if memory is exhausted.
  Result<ByteView> Compress(ByteView bytes, Compression& used);

 private:
  struct State;

  const std::unique_ptr<State> state_;
};

/// Returns the maximum size of `size` compressed bytes after decompression. If a file states a
/// larger size, the file is wrong.
[[nodiscard]] std::uint64_t LargestDecompressed(Compression compression,
                                                std::uint64_t size) noexcept;

/// Decompresses `bytes` into `out`. Fails with kInvalid if the input is malformed or does not fill
/// `out` exactly, and with kFailed if memory is exhausted. Allocates up to 8 MiB.
Result<void> Decompress(Compression compression, ByteView bytes, std::span<std::byte> out);

}  // namespace tendon::mcap
