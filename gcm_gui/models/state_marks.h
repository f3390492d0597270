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
/// Returns the mark of a connection; null means that the interface is not connected.
[[nodiscard]] StateMark MarkOf(const ConnectionDescription* connection);

/// Returns the reason in the user's language: "suspended", "no reply"; empty for kNone.
[[nodiscard]] QString WordOf(StaleReason why);
/// Returns reason and age: "suspended · 12 s old"; without the age if it is unknown.
[[nodiscard]] QString OldText(StaleReason why, std::optional<std::chrono::nanoseconds> age);
/// Returns the connections for which a component still waits, by the same rules as in core.
/// `connections` and the component must belong to the same catalogue.
[[nodiscard]] std::vector<UnsatisfiedInterface> WaitsOf(const ConnectionIndex& connections,
                                                        const ProcessEntry& process,
                                                        const ComponentDescription& component);
/// Returns the mark of a component: a warning if it runs but waits for a connection.
[[nodiscard]] StateMark MarkOf(ComponentState state,
                               const std::vector<UnsatisfiedInterface>& waits);
/// Returns "waiting for Robot" in the user's language; the state of the component if it waits for
/// nothing.
[[nodiscard]] QString WordOf(ComponentState state, const std::vector<UnsatisfiedInterface>& waits);
/// Returns what is missing, in the user's language: "Robot: not connected". Empty if the component
/// waits for nothing.
[[nodiscard]] QString ReasonsText(const std::vector<UnsatisfiedInterface>& waits);

/// Returns the state in the user's language: "alive", "no reply", "lost".
[[nodiscard]] QString WordOf(ProcessState state);

/// Returns true if the process does not run (any more) or is only starting. Its contents are then
/// shown grey.
[[nodiscard]] bool IsGone(ProcessState state);

}  // namespace tendon::gui

Q_DECLARE_METATYPE(tendon::gui::StateMark)
