#pragma once

#include <tendon/payload/cdr.h>
#include <tendon/payload/encoded_size.h>
#include <tendon/payload/payload.h>

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

/// Converts values to bytes and back. The format is that of DDS and ROS 2: CDR (XCDR1,
/// little-endian), but without an encapsulation header. All functions are thread-safe; they throw
/// only std::bad_alloc.
namespace tendon {

namespace payload {

/// Writes one element of a list. If the element begins at an aligned position, the offsets of all
/// numbers in it are constants for the compiler.
template <typename T>
void WriteItem(CdrWriter& writer, const T& item);

template <typename T>
void Write(CdrWriter& writer, const T& value) {
  if constexpr (Number<T>) {
    writer.Write(value);
  } else if constexpr (Enum<T>) {
    writer.Write(static_cast<std::int32_t>(value));
  } else if constexpr (Text<T>) {
    writer.WriteString(value);
  } else if constexpr (TimeSpan<T>) {
    const CdrDuration duration = ToCdr(value);
    writer.Write(duration.sec);
    writer.Write(duration.nanosec);
  } else if constexpr (IsPlain<T>()) {
    writer.WritePlain(value.data(), sizeof(T), PlainAlignment<T>());
  } else if constexpr (Array<T>) {
    for (std::size_t i = 0; i < ArrayTraits<T>::kLength; ++i) WriteItem(writer, value.data()[i]);
  } else if constexpr (Sequence<T>) {
    WriteSequence(writer, value);
  } else if constexpr (SelfWritten<T>) {
    SubstituteFor<T>::Write(writer, value);
  } else if constexpr (Substituted<T>) {
    Write(writer, SubstituteFor<T>::From(value));
  } else {
    WithFields<T>([&](const auto&... field) {
      if constexpr (sizeof...(field) == 0) writer.Write(std::uint8_t{0});
      (Write(writer, field.Of(value)), ...);
    });
  }
}

template <typename T>
void WriteItem(CdrWriter& writer, const T& item) {
  if constexpr (Structure<T> && IsFixed<T>()) {
    if (writer.is_aligned()) {
      CdrWriter fork = writer.Fork(EndOf<T>(0));
      return Write(fork, item);
    }
  }
  Write(writer, item);
}

template <Sequence T>
void WriteSequence(CdrWriter& writer, const T& value) {
  using Item = ItemOf<T>;
  const auto length = static_cast<std::size_t>(value.size());
  assert(length <= std::numeric_limits<std::uint32_t>::max());
  writer.Write(static_cast<std::uint32_t>(length));
  if constexpr (IsPlain<Item>()) {
    if (length > 0) writer.WritePlain(value.data(), length * sizeof(Item), PlainAlignment<Item>());
  } else {
    for (const Item& item : value) WriteItem(writer, item);
  }
}

/// Reads an enum, which is an int32. Returns false if the enum has no such value.
template <Enum T>
bool ReadEnum(CdrReader& reader, T& value) {
  std::int32_t number = 0;
  if (!reader.Read(number)) return false;
  if constexpr (NamedEnum<T>) {
    for (const auto& enumerator : kPayload<T>.enumerators) {
      if (static_cast<std::int32_t>(enumerator.value) != number) continue;
      value = enumerator.value;
      return true;
    }
    return false;
  } else {
    using Underlying = std::underlying_type_t<T>;
    const auto narrow = static_cast<Underlying>(number);
    if (static_cast<std::int32_t>(narrow) != number) return false;
    value = static_cast<T>(narrow);
    return true;
  }
}

template <typename T>
bool Read(CdrReader& reader, T& value) {
  if constexpr (Number<T>) {
    return reader.Read(value);
  } else if constexpr (Enum<T>) {
    return ReadEnum(reader, value);
  } else if constexpr (Text<T>) {
    std::string_view text;
    if (!reader.ReadString(text)) return false;
    value.assign(text);
    return true;
  } else if constexpr (TimeSpan<T>) {
    CdrDuration duration;
    return reader.Read(duration.sec) && reader.Read(duration.nanosec) && FromCdr(duration, value);
  } else if constexpr (IsPlain<T>()) {
    return reader.ReadPlain(value.data(), sizeof(T), PlainAlignment<T>());
  } else if constexpr (Array<T>) {
    for (std::size_t i = 0; i < ArrayTraits<T>::kLength; ++i) {
      if (!Read(reader, value.data()[i])) return false;
    }
    return true;
  } else if constexpr (Sequence<T>) {
    return ReadSequence(reader, value);
  } else if constexpr (SelfWritten<T>) {
    return SubstituteFor<T>::Read(reader, value);
  } else if constexpr (Substituted<T>) {
    SubstituteOf<T> substitute;
    return Read(reader, substitute) && SubstituteFor<T>::Into(substitute, value);
  } else {
    return WithFields<T>([&](const auto&... field) {
      if constexpr (sizeof...(field) == 0) return reader.Skip(1, 1);
      return (Read(reader, field.Of(value)) && ...);
    });
  }
}

template <Sequence T>
bool ReadSequence(CdrReader& reader, T& value) {
  using Item = ItemOf<T>;
  std::uint32_t length = 0;
  if (!reader.ReadLength(length, MinimumSize<Item>())) return false;
  value.resize(length);
  if constexpr (IsPlain<Item>()) {
    return length == 0 ||
           reader.ReadPlain(value.data(), length * sizeof(Item), PlainAlignment<Item>());
  } else if constexpr (std::same_as<T, std::vector<bool>>) {
    for (std::size_t i = 0; i < length; ++i) {
      bool item = false;
      if (!reader.Read(item)) return false;
      value[i] = item;
    }
    return true;
  } else {
    for (Item& item : value) {
      if (!Read(reader, item)) return false;
    }
    return true;
  }
}

}  // namespace payload

/// Writes `value` into the front of `out` and returns the number of bytes used. Returns 0, and
/// leaves `out` unchanged, if `out` is too small. No allocation.
template <Payload T>
std::size_t EncodeTo(const T& value, std::span<std::byte> out) {
  const std::size_t size = EncodedSize(value);
  if (size > out.size()) return 0;
  payload::CdrWriter writer(out.data());
  payload::Write(writer, value);
  assert(writer.position() == size);
  return size;
}

/// Like EncodeTo(), but replaces the content of `out`. Allocates only if the capacity of `out` is
/// too small.
template <Payload T>
void Encode(const T& value, std::vector<std::byte>& out) {
  out.resize(EncodedSize(value));
  EncodeTo(value, std::span<std::byte>(out));
}

/// Reads an untrusted body. Returns false, and leaves `value` valid but unspecified, if the body is
/// wrong:
/// - It is too short, or continues after the value (apart from padding to a multiple of eight).
/// - It contains a bool other than 0 and 1, an enum value without a name, an unterminated string,
///   or a duration with a billion nanoseconds or more.
///
/// Never allocates more than a body of this size can fill, and allocates nothing if the strings and
/// vectors in `value` have enough capacity.
template <Payload T>
[[nodiscard]] bool Decode(std::span<const std::byte> body, T& value) {
  payload::CdrReader reader(body);
  return payload::Read(reader, value) && reader.AtEnd();
}

}  // namespace tendon
