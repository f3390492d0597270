#pragma once

#include <tendon/payload/json.h>

#include <string>
#include <string_view>

namespace tendon {

/// Returns the error of reading `json` as a T; "accepted" if there is none.
template <typename T>
std::string ErrorOf(std::string_view json) {
  const auto value = FromJson<T>(json);
  return value ? "accepted" : value.error().message;
}

}  // namespace tendon
