#pragma once

#include <tendon/gcm/messages.h>

#include <string>

namespace tendon {

/// "step 7 (connect a/b/C d/e/F, by gcm connect at 2025-11-21 15:40:03)".
[[nodiscard]] std::string WholeText(const message::HistoryEntry& step);

}  // namespace tendon
