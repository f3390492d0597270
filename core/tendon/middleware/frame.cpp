#include <tendon/middleware/frame.h>

#include <bit>
#include <cassert>
#include <cstring>
#include <type_traits>

namespace tendon {

static_assert(std::endian::native == std::endian::little, "the header is copied as it is");
static_assert(sizeof(FrameHeader) == FrameHeader::kSize);
static_assert(std::is_trivially_copyable_v<FrameHeader>);
static_assert(offsetof(FrameHeader, request) == 8 && offsetof(FrameHeader, handle) == 20);

void WriteFrame(const FrameHeader& header, std::span<const std::byte> body, Bytes& frame) {
  assert(header.size == body.size());
  frame.resize(FrameHeader::kSize + body.size());
  std::memcpy(frame.data(), &header, FrameHeader::kSize);
  if (!body.empty()) std::memcpy(frame.data() + FrameHeader::kSize, body.data(), body.size());
}

void WriteHeader(const FrameHeader& header, std::span<std::byte, FrameHeader::kSize> place) {
  std::memcpy(place.data(), &header, FrameHeader::kSize);
}

std::optional<FrameHeader> ReadFrameHeader(std::span<const std::byte> bytes, std::size_t limit) {
  if (bytes.size() < FrameHeader::kSize) return std::nullopt;
  FrameHeader header;
  std::memcpy(&header, bytes.data(), FrameHeader::kSize);
  if (header.magic != FrameHeader::kMagic) return std::nullopt;
  if (header.size > limit - FrameHeader::kSize) return std::nullopt;
  return header;
}

std::optional<FrameHeader> ReadWholeFrame(std::span<const std::byte> frame, std::size_t limit) {
  const auto header = ReadFrameHeader(frame, limit);
  if (!header || frame.size() != FrameHeader::kSize + header->size) return std::nullopt;
  return header;
}

}  // namespace tendon
