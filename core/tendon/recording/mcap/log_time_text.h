#pragma once

#include <tendon/recording/mcap/records.h>

#include <string>

namespace tendon::mcap {

/// Returns a log time for people: as a date if possible, such as "2025-11-21 15:40:03.250";
/// otherwise in seconds, such as "12.250 s".
[[nodiscard]] std::string LogTimeText(Timestamp time);

}  // namespace tendon::mcap
