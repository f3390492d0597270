#pragma once

#include <cstdint>
#include <string>

namespace tendon {

/// The time in nanoseconds since 1970. It may jump, so use it for display only; for decisions, use
/// a Clock.
[[nodiscard]] std::int64_t WallTime();

/// "2025-11-21 15:40:03", in local time.
[[nodiscard]] std::string WallTimeText(std::int64_t nanoseconds);

/// The same with milliseconds: "2025-11-21 15:40:03.250".
[[nodiscard]] std::string FineWallTimeText(std::int64_t nanoseconds);

}  // namespace tendon
