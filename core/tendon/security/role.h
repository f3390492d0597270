#pragma once

#include <tendon/base/result.h>

#include <cstdint>
#include <string_view>

namespace tendon {

/// The role of the holder of a certificate. Each role includes the rights of the roles before it.
enum class Role : std::uint8_t {
  kViewer,    ///< read the catalogue, values, rows and logs
  kOperator,  ///< make changes: connect, call commands, join as a process
};

/// "viewer", "operator".
[[nodiscard]] std::string_view ToString(Role role) noexcept;

/// Reads a role as ToString() writes it. Fails with kInvalid; the error lists the roles.
Result<Role> ParseRole(std::string_view text);

}  // namespace tendon
