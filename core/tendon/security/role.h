#pragma once

#include <tendon/base/result.h>

#include <cstdint>
#include <string_view>

namespace tendon {

/// What the holder of a certificate may do; each role includes those before it.
enum class Role : std::uint8_t {
  kViewer,    ///< look: catalogue, values, rows, logs
  kOperator,  ///< change: connect, call commands, join as a process
};

/// "viewer", "operator".
[[nodiscard]] std::string_view ToString(Role role) noexcept;

/// Reads what ToString() writes; kInvalid names the roles there are.
Result<Role> ParseRole(std::string_view text);

}  // namespace tendon
