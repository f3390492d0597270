#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/gcm_messages.h>

#include <string>

namespace tendon {

/// Whether the objects of a step of `history` are still as it left them, and can be restored, as
/// far as catalogue and history know. The GCM checks this before an undo; others use it as a
/// preview. For a process that was started, only the GCM knows more.
Result<void> CheckUndoOf(const Catalogue& catalogue, const message::History& history,
                         const message::HistoryEntry& step);

/// Whether undoing a disconnect or a replacement leads to a pending connection, as before: an
/// earlier step has removed the provider's component, which is still gone.
[[nodiscard]] bool WasPending(const Catalogue& catalogue, const message::History& history,
                              const message::HistoryEntry& step);

/// "cannot undo step 7 (...): why".
[[nodiscard]] Error CannotUndo(const message::HistoryEntry& step, const Error& why);

/// The same for a step that can only be passed over; says how.
[[nodiscard]] Error CannotUndoNow(const message::HistoryEntry& step, const std::string& why);

}  // namespace tendon
