#pragma once

#include <cstdint>
#include <string>

namespace tendon {

/// "1 row", "0 rows", "12 rows".
[[nodiscard]] inline std::string Counted(std::uint64_t count, const std::string& one,
                                         const std::string& several) {
  return std::to_string(count) + " " + (count == 1 ? one : several);
}

}  // namespace tendon
