#pragma once

#include <tendon/middleware/frame.h>

#include <cstdint>
#include <cstring>
#include <optional>
#include <span>

namespace tendon::ice {

/// Reads what Ice encodes, from bytes of any origin: no size is believed before it was compared
/// with what is left. Generated code of Ice 3.7.8 does not do so and dies; none of it runs here.
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
  /// A byte, or 255 and an int; never more than what is left.
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

  /// What the byte is where an int says the size.
  static constexpr std::uint8_t kLongSize = 255;

 private:
  std::span<const std::byte> rest_;
};

/// The parameters of an operation that takes one sequence of bytes or one string: what is in it, or
/// nothing where `encapsulation` is malformed or holds anything else.
std::optional<std::span<const std::byte>> ReadOnlyParameter(
    std::span<const std::byte> encapsulation);

/// The counterpart; replaces the content of `encapsulation`, keeps its capacity.
void WriteOnlyParameter(std::span<const std::byte> parameter, Bytes& encapsulation);

}  // namespace tendon::ice
