#pragma once

#include <tendon/payload/cdr.h>
#include <tendon/payload/payload.h>

#include <cstddef>
#include <cstdint>

namespace tendon {

namespace payload {

/// Returns the offset after a value of a fixed type. `start` is the offset before the value,
/// without the padding that aligns the value.
template <typename T>
constexpr std::size_t EndOf(std::size_t start) {
  if constexpr (IsPlain<T>()) {
    return AlignUp(start, PlainAlignment<T>()) + sizeof(T);
  } else if constexpr (Number<T>) {
    return start + sizeof(T);  // bool
  } else if constexpr (Enum<T>) {
    return AlignUp(start, 4) + 4;
  } else if constexpr (TimeSpan<T>) {
    return AlignUp(start, 4) + 8;
  } else if constexpr (Array<T>) {
    for (std::size_t i = 0; i < ArrayTraits<T>::kLength; ++i) start = EndOf<ElementOf<T>>(start);
    return start;
  } else if constexpr (Substituted<T>) {
    return EndOf<SubstituteOf<T>>(start);
  } else {
    return WithFields<T>([&](const auto&... field) {
      if constexpr (sizeof...(field) == 0) return start + 1;
      ((start = EndOf<TypeOf<decltype(field)>>(start)), ...);
      return start;
    });
  }
}

/// Returns the offset after `value`, which may have any payload type.
template <typename T>
std::size_t EndOf(const T& value, std::size_t start) {
  if constexpr (IsFixed<T>()) {
    return EndOf<T>(start);
  } else if constexpr (Text<T>) {
    return AlignUp(start, 4) + 4 + value.size() + 1;
  } else if constexpr (Array<T>) {
    for (std::size_t i = 0; i < ArrayTraits<T>::kLength; ++i) start = EndOf(value.data()[i], start);
    return start;
  } else if constexpr (Sequence<T>) {
    using Item = ItemOf<T>;
    const auto length = static_cast<std::size_t>(value.size());
    start = AlignUp(start, 4) + 4;
    if (length == 0) return start;
    if constexpr (IsPlain<Item>()) {
      return AlignUp(start, PlainAlignment<Item>()) + length * sizeof(Item);
    } else {
      if constexpr (IsFixed<Item>()) {
        // Each item after the first begins at an offset that is aligned like the start of a body,
        // so all these items have the same size.
        if (EndOf<Item>(0) % kMaxAlignment == 0) {
          return EndOf<Item>(start) + (length - 1) * EndOf<Item>(0);
        }
      }
      for (const Item& item : value) start = EndOf(item, start);
      return start;
    }
  } else if constexpr (SelfWritten<T>) {
    return SubstituteFor<T>::EndOf(value, start);
  } else if constexpr (Substituted<T>) {
    return EndOf(SubstituteFor<T>::From(value), start);
  } else {
    return WithFields<T>([&](const auto&... field) {
      ((start = EndOf(field.Of(value), start)), ...);
      return start;
    });
  }
}

/// Returns the smallest number of bytes that a value can have; at least 1.
template <typename T>
consteval std::size_t MinimumSize() {
  if constexpr (Number<T>) {
    return sizeof(T);
  } else if constexpr (Array<T>) {
    return ArrayTraits<T>::kLength * MinimumSize<ElementOf<T>>();
  } else if constexpr (Substituted<T>) {
    return MinimumSize<SubstituteOf<T>>();
  } else if constexpr (Structure<T>) {
    return WithFields<T>([](const auto&... field) {
      const std::size_t sum = (std::size_t{0} + ... + MinimumSize<TypeOf<decltype(field)>>());
      return sum == 0 ? 1 : sum;
    });
  } else {
    return Enum<T> || Sequence<T> ? 4 : Text<T> ? 5 : 8;  // 8: a time span
  }
}

}  // namespace payload

/// Size in bytes of any value of a fixed type on the wire, without padding at the end.
template <FixedPayload T>
inline constexpr std::size_t kEncodedSize = payload::EndOf<T>(0);

/// Size of `value` in bytes on the wire. Visits all strings and sequences in `value`; for a fixed
/// type, the size is a constant.
template <Payload T>
[[nodiscard]] std::size_t EncodedSize(const T& value) {
  if constexpr (FixedPayload<T>) {
    return kEncodedSize<T>;
  } else {
    return payload::EndOf(value, 0);
  }
}

}  // namespace tendon
