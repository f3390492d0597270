#include <tendon/recording/mcap/compression.h>

#include <lz4frame.h>
#include <tendon/base/text.h>
#include <zlib.h>
#include <zstd.h>

#include <cstring>
#include <limits>
#include <string>

namespace tendon::mcap {
namespace {

Error Damaged(std::string_view codec, std::string_view reason) {
  return {ErrorCode::kInvalid,
          std::string(codec) + " cannot decompress the data: " + std::string(reason)};
}

Error WrongSize(std::uint64_t size, std::uint64_t expected) {
  return {ErrorCode::kInvalid, "the data has " + std::to_string(size) +
                                   " bytes after decompression, instead of " +
                                   std::to_string(expected)};
}

Result<void> DecompressZstd(ByteView bytes, std::span<std::byte> out) {
  // Decompression in a single call allocates no window. With a stream, a frame could request a
  // window of any size.
  const std::size_t size = ZSTD_decompress(out.data(), out.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(size) != 0U) return Damaged("zstd", ZSTD_getErrorName(size));
  if (size != out.size()) return WrongSize(size, out.size());
  return {};
}

Result<void> DecompressLz4(ByteView bytes, std::span<std::byte> out) {
  LZ4F_dctx* made = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&made, LZ4F_VERSION)) != 0U) {
    return Error{ErrorCode::kFailed, "there is not enough memory"};
  }
  const std::unique_ptr<LZ4F_dctx, decltype(&LZ4F_freeDecompressionContext)> context(
      made, &LZ4F_freeDecompressionContext);
  std::size_t done = 0;
  std::size_t hint = 1;  // 0 at the end of a frame
  while (!bytes.empty()) {
    std::size_t taken = bytes.size();
    std::size_t given = out.size() - done;
    hint = LZ4F_decompress(context.get(), out.data() + done, &given, bytes.data(), &taken, nullptr);
    if (LZ4F_isError(hint) != 0U) return Damaged("LZ4", LZ4F_getErrorName(hint));
    done += given;
    bytes = bytes.subspan(taken);
    if (given == 0 && taken == 0) return WrongSize(out.size() + 1, out.size());
  }
  if (hint != 0) return Damaged("LZ4", "the end of the data is missing");
  if (done != out.size()) return WrongSize(done, out.size());
  return {};
}

}  // namespace

Result<Compression> ParseCompression(std::string_view name) {
  std::string known;
  for (const Compression compression : kCompressions) {
    if (NameOf(compression) == name) return compression;
    known += (known.empty() ? "" : ", ") + std::string(NameOf(compression));
  }
  return Error{ErrorCode::kInvalid,
               "there is no compression " + Quoted(name, 100) + "; known: " + known};
}

std::string_view FormatNameOf(Compression compression) noexcept {
  return compression == Compression::kNone ? "" : NameOf(compression);
}

Result<Compression> ParseFormatName(std::string_view name) {
  if (name.empty()) return Compression::kNone;
  if (name == NameOf(Compression::kNone)) {
    return Error{
        ErrorCode::kInvalid,
        "the compression is 'none'; a file without compression must leave this name empty"};
  }
  return ParseCompression(name);
}

std::uint32_t Crc32(ByteView bytes, std::uint32_t before) noexcept {
  // zlib treats a null pointer as a request for the initial value.
  if (bytes.empty()) return before;
  return static_cast<std::uint32_t>(
      crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::uint32_t CombinedCrc32(std::uint32_t first, std::uint32_t second,
                            std::uint64_t size) noexcept {
  return static_cast<std::uint32_t>(crc32_combine(first, second, static_cast<z_off_t>(size)));
}

struct Compressor::State {
  Compression compression = Compression::kNone;
  int level = 0;
  std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> zstd{nullptr, &ZSTD_freeCCtx};
  Buffer out;
};

Compressor::Compressor(Compression compression, int level) : state_(std::make_unique<State>()) {
  state_->compression = compression;
  state_->level = level;
  if (compression == Compression::kZstd) {
    if (level == 0) state_->level = 1;
    state_->zstd.reset(ZSTD_createCCtx());
  }
}

Compressor::~Compressor() = default;

Result<ByteView> Compressor::Compress(ByteView bytes, Compression& used) {
  used = Compression::kNone;
  Buffer& out = state_->out;
  std::size_t size = 0;
  if (state_->compression == Compression::kZstd) {
    if (state_->zstd == nullptr) return Error{ErrorCode::kFailed, "there is not enough memory"};
    const std::size_t bound = ZSTD_compressBound(bytes.size());
    if (out.size() < bound) out.resize(bound);
    size = ZSTD_compressCCtx(state_->zstd.get(), out.data(), out.size(), bytes.data(), bytes.size(),
                             state_->level);
    if (ZSTD_isError(size) != 0U) return Error{ErrorCode::kFailed, ZSTD_getErrorName(size)};
  } else if (state_->compression == Compression::kLz4) {
    LZ4F_preferences_t preferences{};
    preferences.frameInfo.contentSize = bytes.size();
    preferences.frameInfo.blockSizeID = LZ4F_max1MB;
    preferences.compressionLevel = state_->level;
    const std::size_t bound = LZ4F_compressFrameBound(bytes.size(), &preferences);
    if (out.size() < bound) out.resize(bound);
    size = LZ4F_compressFrame(out.data(), out.size(), bytes.data(), bytes.size(), &preferences);
    if (LZ4F_isError(size) != 0U) return Error{ErrorCode::kFailed, LZ4F_getErrorName(size)};
  } else {
    return bytes;
  }
  if (size >= bytes.size()) return bytes;
  used = state_->compression;
  return ByteView(out).first(size);
}

std::uint64_t LargestDecompressed(Compression compression, std::uint64_t size) noexcept {
  // A block of zstd has at most 128 KiB, and takes at least 4 bytes. A byte of LZ4 represents at
  // most 255 bytes.
  constexpr std::uint64_t kZstd = (std::uint64_t{128} << 10U) / 4;
  constexpr std::uint64_t kLz4 = 255;
  std::uint64_t factor = 1;
  if (compression == Compression::kZstd) factor = kZstd;
  if (compression == Compression::kLz4) factor = kLz4;
  if (size > std::numeric_limits<std::uint64_t>::max() / factor) {
    return std::numeric_limits<std::uint64_t>::max();
  }
  return size * factor;
}

Result<void> Decompress(Compression compression, ByteView bytes, std::span<std::byte> out) {
  switch (compression) {
    case Compression::kZstd:
      return DecompressZstd(bytes, out);
    case Compression::kLz4:
      return DecompressLz4(bytes, out);
    case Compression::kNone:
      break;
  }
  if (bytes.size() != out.size()) return WrongSize(bytes.size(), out.size());
  if (!bytes.empty()) std::memcpy(out.data(), bytes.data(), bytes.size());
  return {};
}

}  // namespace tendon::mcap
