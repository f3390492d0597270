#include <tendon/security/role.h>

#include <tendon/base/text.h>

namespace tendon {

std::string_view ToString(Role role) noexcept {
  switch (role) {
    case Role::kViewer:
      return "viewer";
    case Role::kOperator:
      return "operator";
  }
  return "unknown role";
}

Result<Role> ParseRole(std::string_view text) {
  for (const Role role : {Role::kViewer, Role::kOperator}) {
    if (text == ToString(role)) return role;
  }
  return Error{ErrorCode::kInvalid, "role " + Quoted(text, 64) + ": expected viewer or operator"};
}

}  // namespace tendon
