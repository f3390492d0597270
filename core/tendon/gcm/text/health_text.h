#pragma once

#include <tendon/gcm/messages.h>

#include <chrono>
#include <string>

namespace tendon {

/// How old a figure may be to be shown as that of now: members tell each second.
inline constexpr std::chrono::seconds kFreshHealth(3);

/// What a process as the catalogue has it has told last, however long ago; null where it has not.
[[nodiscard]] const message::ProcessHealth* LastHealth(const message::SystemHealth& health,
                                                       const ProcessDescription& process);

/// The same as what holds now; null where it is not alive, has not told, or not lately.
[[nodiscard]] const message::ProcessHealth* FindHealth(const message::SystemHealth& health,
                                                       const ProcessDescription& process);

// Each "-" of null, and where it is not known yet.

/// "12.5 %" of one core.
[[nodiscard]] std::string CpuText(const message::ProcessHealth* health);
/// "34.1 MiB".
[[nodiscard]] std::string MemoryText(const message::ProcessHealth* health);
/// "0.0 ms off (+-0.1 ms)".
[[nodiscard]] std::string ClockText(const message::ProcessHealth* health);

}  // namespace tendon
