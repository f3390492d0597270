#pragma once

#include <tendon/base/status.h>
#include <tendon/payload/payload.h>

#include <type_traits>

namespace tendon {

/// Marks a method that may run in any thread, concurrently with its component. The method uses only
/// constant or synchronised data.
struct ThreadSafe {};
inline constexpr ThreadSafe kThreadSafe;

/// Returns the body of a direct void or write command, or of a direct event handler.
template <typename In, typename Method, typename Object>
auto CallMethod(Method method, Object* object) {
  return [method, object](const In& in, None&) -> Status {
    if constexpr (std::is_same_v<In, None>) {
      (object->*method)();
    } else {
      (object->*method)(in);
    }
    return Status::kDone;
  };
}

}  // namespace tendon
