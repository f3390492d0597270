#pragma once

#include <cstdint>
#include <string>

namespace tendon {

/// Nanoseconds since 1970, for display only; may jump. For decisions use a Clock.
[[nodiscard]] std::int64_t WallTime();

/// "2025-11-21 15:40:03", in local time.
[[nodiscard]] std::string WallTimeText(std::int64_t nanoseconds);

/// The same with milliseconds: "2025-11-21 15:40:03.250".
[[nodiscard]] std::string FineWallTimeText(std::int64_t nanoseconds);

}  // namespace tendon
