#pragma once

#include <tendon/base/status.h>
#include <tendon/payload/payload.h>

#include <type_traits>

namespace tendon {

/// Says that a method may run in any thread at the same time as its component: it touches only what
/// is constant or synchronised.
struct ThreadSafe {};
inline constexpr ThreadSafe kThreadSafe;

/// What a direct void or write command, or a direct event handler, runs.
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
