#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/catalog.h>
#include <tendon/gcm/messages.h>

#include <string>

namespace tendon {

/// Whether the objects of a step are still as it left them, and can be as before, as far as the
/// catalogue and the history, to which it belongs, know: what the GCM looks at before it takes a
/// step back, and whoever only wants to see. Of a process that was started, only the GCM knows
/// more.
Result<void> CheckUndoOf(const Catalog& catalog, const message::History& history,
                         const message::HistoryEntry& step);

/// Whether a disconnect was from a component that a step before it had removed, and that is gone
/// still, or a replacement of a connection to such a one: taken back, that is pending, as it was.
[[nodiscard]] bool WasPending(const Catalog& catalog, const message::History& history,
                              const message::HistoryEntry& step);

/// "cannot undo step 7 (...): why".
[[nodiscard]] Error CannotUndo(const message::HistoryEntry& step, const Error& why);

/// The same, where it could only be passed over; says how.
[[nodiscard]] Error CannotUndoNow(const message::HistoryEntry& step, const std::string& why);

}  // namespace tendon
