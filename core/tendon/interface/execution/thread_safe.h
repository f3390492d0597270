#pragma once

#include <concepts>

namespace tendon {

/// Marks a function that may run in any thread, concurrently with its component. The function uses
/// only constant or synchronised data.
struct ThreadSafe {};
inline constexpr ThreadSafe kThreadSafe;

/// Stands for a forgotten tag, so that the compiler can say which one.
struct Untagged {};

template <typename Tag>
consteval bool RequireThreadSafe() {
  static_assert(std::same_as<Tag, ThreadSafe>,
                "given a read without the tag tendon::kThreadSafe; expected it as the last "
                "argument, because the function runs in the thread of its caller");
  return true;
}

}  // namespace tendon
