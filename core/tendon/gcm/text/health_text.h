#pragma once

#include <tendon/gcm/gcm_messages.h>

#include <chrono>
#include <string>

namespace tendon {

/// The largest age of a value that is shown as current; members report every second.
inline constexpr std::chrono::seconds kFreshHealth(3);

/// The last report of a process in the catalogue, of any age; null if there is none.
[[nodiscard]] const message::ProcessHealth* LastHealth(const message::SystemHealth& health,
                                                       const ProcessDescription& process);

/// The same if it is current; null if the process is not alive or has not reported recently.
[[nodiscard]] const message::ProcessHealth* FindHealth(const message::SystemHealth& health,
                                                       const ProcessDescription& process);

// These return "-" for null, or if the value is not known yet.

/// "12.5 %" of one core.
[[nodiscard]] std::string CpuText(const message::ProcessHealth* health);
/// "34.1 MiB".
[[nodiscard]] std::string MemoryText(const message::ProcessHealth* health);
/// "0.0 ms off (+-0.1 ms)".
[[nodiscard]] std::string ClockText(const message::ProcessHealth* health);

}  // namespace tendon
