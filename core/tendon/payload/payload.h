#pragma once

#include <tendon/payload/describe.h>
#include <tendon/payload/traits.h>

#include <concepts>
#include <string_view>
#include <type_traits>

namespace tendon {

/// Any type that can be sent through a command, an event or a state table: bool, integers, float,
/// double, enums, std::string, std::array, std::vector, std::chrono::duration and structures with a
/// description, in any nesting. It has a default value and can be copied.
template <typename T>
concept Payload = std::same_as<T, std::remove_cvref_t<T>> &&
    payload::IsPayload<T>() && std::semiregular<T>;

/// A structure or an enum with its own kPayload.
template <typename T>
concept Described = !std::same_as<payload::DescriptionOf<T>, NotDescribed>;

/// A payload whose values all take the same number of bytes on the wire.
template <typename T>
concept FixedPayload = Payload<T> && payload::IsFixed<T>();

/// `static_assert(RequirePayload<T>())` belongs at the start of a template that takes a payload
/// type: a wrong type then gives one clear message instead of a failed constraint.
template <typename T>
consteval bool RequirePayload() {
  if constexpr (!payload::IsPayload<T>() || !std::same_as<T, std::remove_cvref_t<T>>) {
    payload::ExplainPayload<T>();
  } else {
    static_assert(Payload<T>, "T has no default value, or it cannot be copied or assigned");
  }
  return true;
}

/// Means no argument or no result. On the wire it is one zero byte, as in ROS 2.
struct None {
  bool operator==(const None&) const = default;
};
template <>
inline constexpr auto kPayload<None> = Describe("tendon.None");

/// Returns the name of a value of a described enum; "?" if the value has no name.
template <payload::NamedEnum T>
[[nodiscard]] constexpr std::string_view NameOf(T value) {
  for (const auto& enumerator : kPayload<T>.enumerators) {
    if (enumerator.value == value) return enumerator.name;
  }
  return "?";
}

}  // namespace tendon
