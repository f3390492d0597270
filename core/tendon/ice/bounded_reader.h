#pragma once

#include <tendon/middleware/frame.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace tendon::ice {

/// Reads what Ice encodes, from bytes of any origin: no size is believed before it was compared
/// with what is left. Generated code of Ice 3.7.8 does not do so and dies; none of it runs here.
class BoundedReader {
 public:
  explicit BoundedReader(std::span<const std::byte> bytes) : rest_(bytes) {}

  std::optional<std::uint8_t> ReadByte();
  std::optional<std::int32_t> ReadInt();
  /// A byte, or 255 and an int; never more than what is left.
  std::optional<std::size_t> ReadSize();
  std::optional<std::span<const std::byte>> ReadBytes(std::size_t size);
  [[nodiscard]] bool AtEnd() const { return rest_.empty(); }

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
