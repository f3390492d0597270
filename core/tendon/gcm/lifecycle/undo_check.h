#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/gcm_messages.h>

#include <string>

namespace tendon {

/// Checks that the objects of a step of `history` are still as the step left them, and can be
/// restored, as far as catalogue and history know. The GCM checks this before an undo; others use
/// it as a preview. For a started process, the GCM makes further checks.
Result<void> CheckUndoOf(const Catalogue& catalogue, const message::History& history,
                         const message::HistoryEntry& step);

/// True if undoing a disconnect or a replacement restores a connection that was pending: an earlier
/// step has removed the provider's component, which is still missing.
[[nodiscard]] bool WasPending(const Catalogue& catalogue, const message::History& history,
                              const message::HistoryEntry& step);

/// "cannot undo step 7 (...): why".
[[nodiscard]] Error CannotUndo(const message::HistoryEntry& step, const Error& why);

/// The same for a step that can only be skipped; says how.
[[nodiscard]] Error CannotUndoNow(const message::HistoryEntry& step, const std::string& why);

}  // namespace tendon
