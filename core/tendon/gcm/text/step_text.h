#pragma once

#include <tendon/gcm/gcm_messages.h>

#include <string>

namespace tendon {

/// "step 7 (connect a/b/C d/e/F, by gcm connect at 2025-11-21 15:40:03)".
[[nodiscard]] std::string WholeText(const message::HistoryEntry& step);

/// "noise 0.001 -> 0.5, bandwidth default -> 80": the changes of a "configure" step; empty for
/// other steps.
[[nodiscard]] std::string ChangesText(const message::HistoryEntry& step);

/// True if the step concerns the life cycle of a component or of a started process.
[[nodiscard]] bool IsOfLife(const message::HistoryEntry& step);
[[nodiscard]] bool IsOfProcess(const message::HistoryEntry& step);

/// The process that executed the step, and would undo it. For the start of a process, that process
/// itself.
[[nodiscard]] const std::string& ProcessOf(const message::HistoryEntry& step);

}  // namespace tendon
