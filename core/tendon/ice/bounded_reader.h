#pragma once

#include <tendon/middleware/frame.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>

namespace tendon::ice {

/// Reads the encoding of Ice from untrusted bytes, and checks every size against the number of
/// remaining bytes. The generated code of Ice 3.7.8 is not used, because it does not check sizes
/// and crashes.
class BoundedReader {
 public:
  explicit BoundedReader(std::span<const std::byte> bytes) : rest_(bytes) {}

  std::optional<std::uint8_t> ReadByte() {
    const auto bytes = ReadBytes(1);
    if (!bytes) return std::nullopt;
    return std::to_integer<std::uint8_t>(bytes->front());
  }
  std::optional<std::int32_t> ReadInt() {
    std::int32_t value = 0;
    const auto bytes = ReadBytes(sizeof value);
    if (!bytes) return std::nullopt;
    std::memcpy(&value, bytes->data(), sizeof value);
    return value;
  }
  /// Reads a size: one byte, or the byte 255 and an int. Fails if the size is larger than the
  /// number of remaining bytes.
  std::optional<std::size_t> ReadSize() {
    const auto first = ReadByte();
    if (!first) return std::nullopt;
    const std::optional<std::int32_t> size = *first < kLongSize ? *first : ReadInt();
    if (!size || *size < 0 || static_cast<std::size_t>(*size) > rest_.size()) return std::nullopt;
    return static_cast<std::size_t>(*size);
  }
  std::optional<std::span<const std::byte>> ReadBytes(std::size_t size) {
    if (size > rest_.size()) return std::nullopt;
    const auto bytes = rest_.first(size);
    rest_ = rest_.subspan(size);
    return bytes;
  }
  [[nodiscard]] bool AtEnd() const { return rest_.empty(); }

  /// The byte before a size that is encoded as an int.
  static constexpr std::uint8_t kLongSize = 255;

 private:
  std::span<const std::byte> rest_;
};

/// Reads the parameters of an operation that has only one sequence of bytes or one string, and
/// returns the content. Returns no value if `encapsulation` is malformed or has other content.
std::optional<std::span<const std::byte>> ReadOnlyParameter(
    std::span<const std::byte> encapsulation);

/// Writes one sequence of bytes as the only parameter, for ReadOnlyParameter(). Replaces the
/// content of `encapsulation` and keeps its capacity.
void WriteOnlyParameter(std::span<const std::byte> parameter, Bytes& encapsulation);

}  // namespace tendon::ice
