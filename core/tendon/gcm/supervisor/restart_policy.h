#pragma once

#include <tendon/payload/payload.h>

#include <array>
#include <cstdint>
#include <string_view>

namespace tendon {

/// The condition under which a GCM restarts a process that it has started.
enum class RestartPolicy : std::int32_t {
  kNever,
  kOnFailure,  ///< after an exit code other than 0, or a signal
};

inline constexpr std::array kRestartPolicies = {RestartPolicy::kNever, RestartPolicy::kOnFailure};

template <>
inline constexpr auto kPayload<RestartPolicy> =
    DescribeEnum("tendon.RestartPolicy", Enumerator{"never", RestartPolicy::kNever},
                 Enumerator{"on_failure", RestartPolicy::kOnFailure});

/// Returns the word for the policy in a system file: "never", "on-failure".
[[nodiscard]] constexpr std::string_view ToString(RestartPolicy policy) noexcept {
  return policy == RestartPolicy::kNever ? "never" : "on-failure";
}

}  // namespace tendon
