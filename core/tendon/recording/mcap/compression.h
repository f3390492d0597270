#pragma once

#include <tendon/base/result.h>
#include <tendon/recording/mcap/records.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

namespace tendon::mcap {

/// How the records of a chunk are compressed.
enum class Compression : std::int32_t {
  kNone,
  kLz4,   ///< LZ4 frame format
  kZstd,  ///< Zstandard frame format
};
inline constexpr std::array kCompressions{Compression::kNone, Compression::kLz4,
                                          Compression::kZstd};

/// Returns the name for people: "none", "lz4" or "zstd".
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
/// Reads a name for people. kInvalid, with the known names, for another one.
Result<Compression> ParseCompression(std::string_view name);

/// Returns the name in a file, which is empty for kNone.
[[nodiscard]] std::string_view FormatNameOf(Compression compression) noexcept;
/// Reads a name in a file. kInvalid, with the known names, for another one.
Result<Compression> ParseFormatName(std::string_view name);

/// The CRC32 of zlib, PNG and Ethernet: of `bytes`, or of them behind bytes whose checksum is
/// `before`. About 0.4 ns a byte.
[[nodiscard]] std::uint32_t Crc32(Bytes bytes, std::uint32_t before = 0) noexcept;
/// The checksum of two ranges in a row, of which the second has `size` bytes. About 1 us.
[[nodiscard]] std::uint32_t CombinedCrc32(std::uint32_t first, std::uint32_t second,
                                          std::uint64_t size) noexcept;

/// Compresses chunks; keeps the memory of the codec, a few MiB, from one to the next.
///
/// Thread safety: one thread at a time.
class Compressor {
 public:
  /// `level` 0 is the default of the method: 1 of zstd, the fast mode of LZ4.
  explicit Compressor(Compression compression, int level = 0);
  Compressor(const Compressor&) = delete;
  Compressor& operator=(const Compressor&) = delete;
  ~Compressor();

  /// The compressed bytes, valid until the next call. `used` becomes kNone, and the result is
  /// `bytes` itself, if they cannot be made smaller. kFailed if memory is exhausted.
  Result<Bytes> Compress(Bytes bytes, Compression& used);

 private:
  struct State;

  const std::unique_ptr<State> state_;
};

/// The most bytes that `size` compressed bytes can become: a claim above it is a lie, whatever the
/// memory.
[[nodiscard]] std::uint64_t LargestDecompressed(Compression compression,
                                                std::uint64_t size) noexcept;

/// Fills `out`, to the byte. kInvalid if the input is malformed or has another size when
/// decompressed; kFailed if memory is exhausted. Allocates up to 8 MiB.
Result<void> Decompress(Compression compression, Bytes bytes, std::span<std::byte> out);

}  // namespace tendon::mcap
