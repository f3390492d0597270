#pragma once

#include <tendon/recording/mcap_records.h>

#include <string>

namespace tendon::mcap {

/// A log time for people: as a date if it can be one, else as seconds: "2025-11-21 15:40:03.250",
/// "12.250 s".
[[nodiscard]] std::string LogTimeText(Timestamp time);

}  // namespace tendon::mcap
