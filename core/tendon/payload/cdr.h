#pragma once

#include <tendon/payload/traits.h>

#include <bit>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

/// Writes and reads the primitives of CDR (XCDR1, little-endian). A number is aligned to its size,
/// relative to the start of the body. Padding is zero.
namespace tendon::payload {

static_assert(std::endian::native == std::endian::little, "the codec copies numbers as they are");

constexpr std::size_t kMaxAlignment = 8;

/// Rounds `position` up to a multiple of `alignment`, which is a power of two.
constexpr std::size_t AlignUp(std::size_t position, std::size_t alignment) {
  return (position + alignment - 1) & ~(alignment - 1);
}

/// Writes into memory that the caller has made large enough.
class CdrWriter {
 public:
  explicit CdrWriter(std::byte* body) : body_(body) {}

  template <Number T>
  void Write(T value) {
    WritePlain(&value, sizeof(T), sizeof(T));
  }

  /// Copies numbers that are aligned to `alignment` bytes. `size`, at least 1, is the number of
  /// bytes of all numbers together.
  void WritePlain(const void* numbers, std::size_t size, std::size_t alignment) {
    const std::size_t start = AlignUp(position_, alignment);
    // Clears the padding with one store of a constant size. The store may also clear bytes after
    // the padding, but the numbers overwrite these bytes below.
    if (start != position_) std::memset(body_ + position_, 0, alignment);
    std::memcpy(body_ + start, numbers, size);
    position_ = start + size;
  }

  void WriteString(const std::string& text) {
    Write(static_cast<std::uint32_t>(text.size() + 1));
    WritePlain(text.c_str(), text.size() + 1, 1);
  }

  /// Skips `size` bytes and returns a separate writer for them. The new writer treats this position
  /// as the start of the body. Requires is_aligned().
  CdrWriter Fork(std::size_t size) {
    position_ += size;
    return CdrWriter(body_ + position_ - size);
  }

  /// True if the next byte is aligned like the start of the body.
  [[nodiscard]] bool is_aligned() const { return position_ % kMaxAlignment == 0; }
  [[nodiscard]] std::size_t position() const { return position_; }

 private:
  std::byte* body_;
  std::size_t position_ = 0;
};

/// Reads from untrusted bytes. Functions return false, and read nothing, if too few bytes are left.
class CdrReader {
 public:
  explicit CdrReader(std::span<const std::byte> body) : body_(body.data()), size_(body.size()) {}

  template <Number T>
  [[nodiscard]] bool Read(T& value) {
    if constexpr (std::same_as<T, bool>) {
      std::uint8_t byte = 0;
      if (!Read(byte) || byte > 1) return false;
      value = byte == 1;
      return true;
    } else {
      return ReadPlain(&value, sizeof(T), sizeof(T));
    }
  }

  /// Reads numbers that WritePlain() has written.
  [[nodiscard]] bool ReadPlain(void* numbers, std::size_t size, std::size_t alignment) {
    if (!Skip(size, alignment)) return false;
    if (size > 0) std::memcpy(numbers, body_ + position_ - size, size);
    return true;
  }

  /// Skips `size` bytes of numbers that are `alignment` bytes each.
  [[nodiscard]] bool Skip(std::size_t size, std::size_t alignment) {
    const std::size_t start = AlignUp(position_, alignment);
    if (start > size_ || size_ - start < size) return false;
    position_ = start + size;
    return true;
  }

  /// Reads a string without copying it: `text` refers to the bytes of the body.
  [[nodiscard]] bool ReadString(std::string_view& text) {
    std::uint32_t size = 0;
    if (!Read(size) || size == 0 || !Skip(size, 1)) return false;
    if (body_[position_ - 1] != std::byte{0}) return false;
    text = {reinterpret_cast<const char*>(body_ + position_ - size), size - 1};
    return true;
  }

  /// Reads the length of a sequence. Returns false if the remaining bytes are too few for this
  /// number of elements, which have at least `minimum_size` bytes each.
  [[nodiscard]] bool ReadLength(std::uint32_t& length, std::size_t minimum_size) {
    return Read(length) && length <= remaining() / minimum_size;
  }

  /// True if everything was read, apart from padding up to the next multiple of eight.
  [[nodiscard]] bool AtEnd() const { return size_ <= AlignUp(position_, kMaxAlignment); }

  [[nodiscard]] std::size_t remaining() const { return size_ - position_; }

 private:
  const std::byte* body_;
  std::size_t size_;
  std::size_t position_ = 0;
};

/// A duration on the wire: builtin_interfaces/Duration of ROS 2.
struct CdrDuration {
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;  // below one billion
};

/// Converts a duration, rounded to nanoseconds. A duration above 68 years becomes 68 years, and
/// not-a-number becomes zero.
template <TimeSpan T>
CdrDuration ToCdr(T value) {
  using std::chrono::nanoseconds;
  using std::chrono::seconds;
  constexpr double kLimit = 2147483648.0;  // s
  const double approximate = std::chrono::duration<double>(value).count();
  if (approximate >= kLimit) return {std::numeric_limits<std::int32_t>::max(), 999'999'999};
  if (approximate <= -kLimit) return {std::numeric_limits<std::int32_t>::min(), 0};
  if (std::isnan(approximate)) return {};
  nanoseconds exact{};
  if constexpr (std::is_floating_point_v<typename T::rep>) {
    exact = nanoseconds(std::llround(approximate * 1e9));
  } else {
    exact = value;
  }
  const auto whole = std::chrono::floor<seconds>(exact);
  return {static_cast<std::int32_t>(whole.count()),
          static_cast<std::uint32_t>((exact - whole).count())};
}

/// Converts a duration, rounded towards zero to the resolution of T. Returns false if `wire` has a
/// billion nanoseconds or more, or if T cannot hold the duration.
template <TimeSpan T>
bool FromCdr(CdrDuration wire, T& value) {
  if (wire.nanosec >= 1'000'000'000) return false;
  const std::chrono::nanoseconds exact =
      std::chrono::seconds(wire.sec) + std::chrono::nanoseconds(wire.nanosec);
  using Count = typename T::rep;
  if constexpr (std::is_integral_v<Count>) {
    using Wide = std::chrono::duration<std::int64_t, typename T::period>;
    const auto wide = std::chrono::duration_cast<Wide>(exact);
    if (!std::in_range<Count>(wide.count())) return false;
    value = T(static_cast<Count>(wide.count()));
  } else {
    value = std::chrono::duration_cast<T>(exact);
  }
  return true;
}

}  // namespace tendon::payload
