#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/gcm_messages.h>

#include <string>

namespace tendon {

/// Checks that a step of `history` can be undone: nothing that it changed has been changed again,
/// as far as catalogue and history show this. The GCM calls this before an undo; other programs use
/// it for a preview. For a step that started a process, the GCM makes further checks.
Result<void> CheckUndoOf(const Catalogue& catalogue, const message::History& history,
                         const message::HistoryEntry& step);

/// Returns true if undoing a disconnect or a replacement restores a connection that was pending.
/// This is the case if an earlier step removed the provider's component and the component is still
/// missing.
[[nodiscard]] bool WasPending(const Catalogue& catalogue, const message::History& history,
                              const message::HistoryEntry& step);

/// The error "cannot undo step 7 (...): why".
[[nodiscard]] Error CannotUndo(const message::HistoryEntry& step, const Error& why);

/// Like CannotUndo(), but for a step that can only be skipped. The error also says how to skip the
/// step.
[[nodiscard]] Error CannotUndoNow(const message::HistoryEntry& step, const std::string& why);

}  // namespace tendon
