#pragma once

#include <tendon/gcm/gcm_messages.h>

#include <string>

namespace tendon {

/// "step 7 (connect a/b/C d/e/F, by gcm connect at 2025-11-21 15:40:03)".
[[nodiscard]] std::string WholeText(const message::HistoryEntry& step);

/// "noise 0.001 -> 0.5, bandwidth default -> 80": changes of a "configure"; empty for other steps.
[[nodiscard]] std::string ChangesText(const message::HistoryEntry& step);

/// Whether the step concerns the life of a component, or of a process that was started.
[[nodiscard]] bool IsOfLife(const message::HistoryEntry& step);
[[nodiscard]] bool IsOfProcess(const message::HistoryEntry& step);

/// The process that made the step, and would undo it; a started process counts as its own.
[[nodiscard]] const std::string& ProcessOf(const message::HistoryEntry& step);

}  // namespace tendon
