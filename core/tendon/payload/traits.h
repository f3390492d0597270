#pragma once

#include <tendon/payload/describe.h>

#include <array>
#include <chrono>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <ratio>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// Classifies the types that can be payloads. Every type is at most one of: Number, Enum, Text,
/// TimeSpan, Array, Sequence, Structure, Substituted.
namespace tendon::payload {

template <typename T>
concept Character = std::same_as<T, char> || std::same_as<T, wchar_t> || std::same_as<T, char8_t> ||
    std::same_as<T, char16_t> || std::same_as<T, char32_t>;

/// A bool, a std::byte, an integer of 8 to 64 bits, a float or a double. Characters are not numbers
/// here: a `char` is signed on some machines and unsigned on others.
template <typename T>
concept Number = (std::integral<T> && !Character<T> && sizeof(T) <= sizeof(std::uint64_t)) ||
                 std::same_as<T, float> || std::same_as<T, double> || std::same_as<T, std::byte>;

/// An enum of at most the size of an int. On the wire it is always an int32.
template <typename T>
concept Enum = std::is_enum_v<T> && !std::same_as<T, std::byte> && sizeof(T) <= sizeof(int);

template <typename T>
concept Text = std::same_as<T, std::string>;

template <typename T>
struct IsTimeSpan : std::false_type {};
template <typename Count, typename Period>
struct IsTimeSpan<std::chrono::duration<Count, Period>>
    : std::bool_constant<std::is_floating_point_v<Count> ||
                         std::ratio_greater_equal_v<Period, std::nano>> {};

/// A std::chrono::duration. If it counts in integers, its resolution is nanoseconds or coarser.
template <typename T>
concept TimeSpan = IsTimeSpan<T>::value;

/// Describes a type that stores a fixed number of elements of one type contiguously. Specialise it
/// for a container with data().
template <typename T>
struct ArrayTraits {
  static constexpr std::size_t kLength = 0;
};
template <typename T, std::size_t kCount>
struct ArrayTraits<std::array<T, kCount>> {
  using Element = T;
  static constexpr std::size_t kLength = kCount;
};
template <typename T>
concept Array = (ArrayTraits<T>::kLength > 0);

/// Describes a type that stores a varying number of elements of one type contiguously. Specialise
/// it for a container with data(), size() and resize().
template <typename T>
struct SequenceTraits {};
template <typename T, typename Allocator>
struct SequenceTraits<std::vector<T, Allocator>> {
  using Element = T;
};
template <typename T>
concept Sequence = requires {
  typename SequenceTraits<T>::Element;
};

/// Describes a type T that is sent as another payload, `Type`. A specialisation has `static Type
/// From(const T&)` and `static bool Into(const Type&, T&)`, which returns false for an invalid
/// value. If `Type` would have to allocate, the specialisation has Write, Read and EndOf instead,
/// as in codec.h.
template <typename T>
struct SubstituteFor {};
template <typename T>
concept Substituted = requires {
  typename SubstituteFor<T>::Type;
};
template <typename T>
concept SelfWritten = Substituted<T> && requires(const T& value, std::size_t start) {
  SubstituteFor<T>::EndOf(value, start);
};

template <typename T>
struct IsStructureDescription : std::false_type {};
template <typename... Fields>
struct IsStructureDescription<Description<Fields...>> : std::true_type {};

template <typename T>
using DescriptionOf = std::remove_cvref_t<decltype(kPayload<T>)>;

template <typename T>
concept Structure = std::is_class_v<T> && IsStructureDescription<DescriptionOf<T>>::value;

template <typename T>
concept NamedEnum = Enum<T> && !std::same_as<DescriptionOf<T>, NotDescribed>;

template <Array T>
using ElementOf = typename ArrayTraits<T>::Element;
template <Sequence T>
using ItemOf = typename SequenceTraits<T>::Element;
template <Substituted T>
using SubstituteOf = typename SubstituteFor<T>::Type;
template <typename AField>
using TypeOf = typename std::remove_cvref_t<AField>::Type;

/// Calls `visit(field...)` with all fields of a structure at once. Needs no value.
template <Structure T, typename Visitor>
constexpr decltype(auto) WithFields(Visitor&& visit) {
  return kPayload<T>.fields.Visit(std::forward<Visitor>(visit));
}

/// True if a field of type T can have a range: a number (not bool), a time span, or a list of
/// these.
template <typename T>
consteval bool HoldsNumbers() {
  if constexpr (Array<T>) {
    return HoldsNumbers<ElementOf<T>>();
  } else if constexpr (Sequence<T>) {
    return HoldsNumbers<ItemOf<T>>();
  } else if constexpr (Substituted<T>) {
    return HoldsNumbers<SubstituteOf<T>>();
  } else {
    return TimeSpan<T> || (Number<T> && !std::same_as<T, bool>);
  }
}

template <typename T>
consteval bool IsPayload();

/// Points to a value: `T*`, std::unique_ptr, std::shared_ptr.
template <typename T>
concept Pointer = std::is_pointer_v<T> || std::is_member_pointer_v<T> ||
    std::is_null_pointer_v<T> || requires(const T& pointer) {
  typename T::element_type;
  pointer.get();
};
/// Refers to memory that it does not own: std::string_view, std::span.
template <typename T>
concept View = std::is_class_v<T> && std::is_trivially_copyable_v<T> && requires(const T& view) {
  view.data();
  view.size();
};

/// Does not compile, and says why T, which is not a payload, cannot be one. Gives no sentence for a
/// structure, because its fields have given theirs.
template <typename T>
consteval void ExplainPayload() {
  if constexpr (std::is_array_v<T>) {
    static_assert(!std::is_array_v<T>, "T is a C array, which cannot be a payload: use std::array");
  } else if constexpr (!std::same_as<T, std::remove_cvref_t<T>>) {
    static_assert(std::same_as<T, std::remove_cvref_t<T>>,
                  "T is const or a reference, which cannot be a payload: name the plain type");
  } else if constexpr (Array<T>) {
    ExplainPayload<ElementOf<T>>();
  } else if constexpr (Sequence<T>) {
    ExplainPayload<ItemOf<T>>();
  } else if constexpr (Substituted<T>) {
    ExplainPayload<SubstituteOf<T>>();
  } else if constexpr (Character<T>) {
    static_assert(!Character<T>,
                  "T is a character, which cannot be a payload because its sign and size differ "
                  "between machines: use std::string for text, and std::int8_t or std::uint8_t for "
                  "a number");
  } else if constexpr (Pointer<T>) {
    static_assert(!Pointer<T>,
                  "T is a pointer, which cannot be a payload because it has no meaning in another "
                  "process: send the value, std::string for text, or std::vector for a list");
  } else if constexpr (View<T>) {
    static_assert(!View<T>,
                  "T is a view, which cannot be a payload because it does not own its memory: use "
                  "std::string, std::vector or std::array");
  } else if constexpr (std::same_as<T, long double>) {
    static_assert(!std::same_as<T, long double>,
                  "T is a long double, which cannot be a payload because its size differs between "
                  "machines: use double");
  } else if constexpr (std::is_enum_v<T>) {
    static_assert(Enum<T>, "T is an enum of more than 32 bits, which cannot be a payload");
  } else if constexpr (!Structure<T>) {
    static_assert(IsPayload<T>(), "T is not described: write kPayload<T> beside it");
  }
}

template <typename T>
constexpr bool FieldIsPayload(bool has_range) {
  if constexpr (IsPayload<T>()) {
    if (has_range && !HoldsNumbers<T>()) throw ConfigurationError("only a number can have a range");
    return true;
  } else {
    ExplainPayload<T>();
    return false;
  }
}

/// True if T is a payload. Does not compile for a structure with a field that is not a payload.
template <typename T>
consteval bool IsPayload() {
  if constexpr (Array<T>) {
    return IsPayload<ElementOf<T>>();
  } else if constexpr (Sequence<T>) {
    return IsPayload<ItemOf<T>>();
  } else if constexpr (Substituted<T>) {
    return IsPayload<SubstituteOf<T>>();
  } else if constexpr (Structure<T>) {
    return WithFields<T>([](const auto&... field) {
      return (FieldIsPayload<TypeOf<decltype(field)>>(field.range.has_value()) && ...);
    });
  } else {
    return Number<T> || Enum<T> || Text<T> || TimeSpan<T>;
  }
}

/// True if every value of T takes the same number of bytes.
template <typename T>
consteval bool IsFixed() {
  if constexpr (Array<T>) {
    return IsFixed<ElementOf<T>>();
  } else if constexpr (Substituted<T>) {
    return IsFixed<SubstituteOf<T>>();
  } else if constexpr (Structure<T>) {
    return WithFields<T>(
        [](const auto&... field) { return (IsFixed<TypeOf<decltype(field)>>() && ...); });
  } else {
    return Number<T> || Enum<T> || TimeSpan<T>;
  }
}

/// True if T has the same bytes in memory as on the wire, so that one memcpy copies many values.
/// False for bool, because each bool must be checked when it is read.
template <typename T>
consteval bool IsPlain() {
  if constexpr (Array<T>) {
    return IsPlain<ElementOf<T>>() && sizeof(T) == ArrayTraits<T>::kLength * sizeof(ElementOf<T>);
  } else {
    return Number<T> && !std::same_as<T, bool>;
  }
}

/// The alignment of a plain type: the size of the numbers in it.
template <typename T>
consteval std::size_t PlainAlignment() {
  if constexpr (Array<T>) {
    return PlainAlignment<ElementOf<T>>();
  } else {
    return sizeof(T);
  }
}

}  // namespace tendon::payload
