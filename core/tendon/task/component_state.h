#pragma once

#include <tendon/payload/payload.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace tendon {

/// The lifecycle states of a component.
enum class ComponentState : std::int32_t {
  kConstructed,
  kReady,  ///< configured, but not started
  kActive,
  kSuspended,  ///< executes no cycles, but keeps its data; a start resumes it
  kFinished,
  kFaulted,  ///< one of its functions has thrown; a start configures it again
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

/// Returns true if the component is active or suspended, so a fault or a stop would interrupt it.
[[nodiscard]] constexpr bool IsRunning(ComponentState state) noexcept {
  return state == ComponentState::kActive || state == ComponentState::kSuspended;
}

/// The requests of a manager to a component.
enum class LifecycleRequest : std::uint16_t { kStart, kSuspend, kStop };

/// The effect of a request in one state.
struct Transition {
  ComponentState from;
  LifecycleRequest request;
  ComponentState to;  ///< equal to `from` if the request is refused
  /// The text after "component 'arm' is active"; empty if the request is allowed.
  std::string_view refusal{};
  bool configures_first = false;
};

/// The transitions for every request in every state. In addition, if one of the author's functions
/// throws, the component becomes faulted from any state.
inline constexpr std::array kTransitions = [] {
  using enum ComponentState;
  using enum LifecycleRequest;
  return std::array<Transition, 18>{{
      {kConstructed, kStart, kActive, "", true},
      {kConstructed, kSuspend, kConstructed, " and not active; start it first"},
      {kConstructed, kStop, kConstructed, " and not active; there is nothing to stop"},
      {kReady, kStart, kActive},
      {kReady, kSuspend, kReady, " and not active; start it first"},
      {kReady, kStop, kReady, " and not active; there is nothing to stop"},
      {kActive, kStart, kActive, " already; to start it again, stop it first"},
      {kActive, kSuspend, kSuspended},
      {kActive, kStop, kFinished},
      {kSuspended, kStart, kActive},
      {kSuspended, kSuspend, kSuspended, " already; to resume it, start it"},
      {kSuspended, kStop, kFinished},
      {kFinished, kStart, kActive},
      {kFinished, kSuspend, kFinished, " and not active; start it first"},
      {kFinished, kStop, kFinished, " already; there is nothing to stop"},
      {kFaulted, kStart, kActive, "", true},
      {kFaulted, kSuspend, kFaulted, " and not active; start it again first"},
      {kFaulted, kStop, kFaulted, " and has ended; there is nothing to stop"},
  }};
}();

[[nodiscard]] constexpr const Transition& TransitionOf(ComponentState from,
                                                       LifecycleRequest request) {
  constexpr std::size_t kRequests = 3;
  return kTransitions[static_cast<std::size_t>(from) * kRequests +
                      static_cast<std::size_t>(request)];
}

}  // namespace tendon
