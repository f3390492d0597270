#pragma once

#include <tendon/payload/payload.h>

#include <cstdint>
#include <string_view>

namespace tendon {

/// Where a component is in its life.
///
/// | from        | Start               | Stop     | a thrown exception |
/// |-------------|---------------------|----------|--------------------|
/// | constructed | configures, active  | refused  | faulted            |
/// | ready       | active              | refused  | faulted            |
/// | active      | refused             | finished | faulted            |
/// | finished    | active              | refused  |                    |
/// | faulted     | configures, active  | refused  | faulted            |
enum class ComponentState : std::int32_t {
  kConstructed,
  kReady,
  kActive,
  kSuspended,
  kFinished,
  kFaulted,
};

template <>
inline constexpr auto kPayload<ComponentState> = DescribeEnum(
    "tendon.ComponentState", Enumerator{"constructed", ComponentState::kConstructed},
    Enumerator{"ready", ComponentState::kReady}, Enumerator{"active", ComponentState::kActive},
    Enumerator{"suspended", ComponentState::kSuspended},
    Enumerator{"finished", ComponentState::kFinished},
    Enumerator{"faulted", ComponentState::kFaulted});

/// "active", "faulted", ...
[[nodiscard]] constexpr std::string_view ToString(ComponentState state) noexcept {
  return NameOf(state);
}

}  // namespace tendon
