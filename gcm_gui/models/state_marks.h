#pragma once

#include <gcm_gui/theme/state_mark.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/staleness.h>
#include <tendon/manager/unsatisfied_interface.h>

#include <QMetaType>
#include <QString>
#include <chrono>
#include <optional>
#include <vector>

namespace tendon::gui {

class ConnectionIndex;

[[nodiscard]] StateMark MarkOf(ProcessState state);
[[nodiscard]] StateMark MarkOf(ComponentState state);
[[nodiscard]] StateMark MarkOf(ConnectionState state);
/// Null means not connected.
[[nodiscard]] StateMark MarkOf(const ConnectionDescription* connection);

/// "suspended", "no answer", in the user's language; empty for none.
[[nodiscard]] QString WordOf(StaleReason why);
/// "suspended · 12 s old"; without the age if it is unknown.
[[nodiscard]] QString OldText(StaleReason why, std::optional<std::chrono::nanoseconds> age);
/// The connections that a component still waits for, by the same rules as in core. `connections`
/// must belong to the same catalogue as the component.
[[nodiscard]] std::vector<UnsatisfiedInterface> WaitsOf(const ConnectionIndex& connections,
                                                        const ProcessEntry& process,
                                                        const ComponentDescription& component);
/// The mark of a component; a warning if it runs but waits for a connection.
[[nodiscard]] StateMark MarkOf(ComponentState state,
                               const std::vector<UnsatisfiedInterface>& waits);
/// "waiting for Robot", in the user's language; the state if it waits for nothing.
[[nodiscard]] QString WordOf(ComponentState state, const std::vector<UnsatisfiedInterface>& waits);
/// "Robot: not connected", in the user's language; empty if it waits for nothing.
[[nodiscard]] QString ReasonsText(const std::vector<UnsatisfiedInterface>& waits);

/// "alive", "no answer", "lost", in the user's language.
[[nodiscard]] QString WordOf(ProcessState state);

/// True if the process is gone or only starting, so that its contents are shown grey.
[[nodiscard]] bool IsGone(ProcessState state);

}  // namespace tendon::gui

Q_DECLARE_METATYPE(tendon::gui::StateMark)
