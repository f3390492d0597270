#pragma once

#include <gcm_gui/theme/state_mark.h>
#include <tendon/gcm/catalog.h>
#include <tendon/gcm/standstill.h>
#include <tendon/manager/unmet_need.h>

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
/// Null: nothing is connected.
[[nodiscard]] StateMark MarkOf(const ConnectionDescription* connection);

/// "suspended", "no answer", in the user's language; empty for none.
[[nodiscard]] QString WordOf(Standstill why);
/// "suspended · 12 s old"; without the age where it is not known.
[[nodiscard]] QString OldText(Standstill why, std::optional<std::chrono::nanoseconds> age);
/// What a component waits for, as core judges it; the index is of the process' catalogue.
[[nodiscard]] std::vector<UnmetNeed> WaitsOf(const ConnectionIndex& connections,
                                             const ProcessEntry& process,
                                             const ComponentDescription& component);
/// Of one that runs but waits: a warning.
[[nodiscard]] StateMark MarkOf(ComponentState state, const std::vector<UnmetNeed>& waits);
/// "waiting for Robot", in the user's language; the word of its state where it waits for nothing.
[[nodiscard]] QString WordOf(ComponentState state, const std::vector<UnmetNeed>& waits);
/// "Robot: not connected", likewise; empty where it waits for nothing.
[[nodiscard]] QString ReasonsText(const std::vector<UnmetNeed>& waits);

/// "alive", "no answer", "lost", in the user's language.
[[nodiscard]] QString WordOf(ProcessState state);

/// Whether the process is gone, or only starting, so that what it had is shown grey.
[[nodiscard]] bool IsGone(ProcessState state);

}  // namespace tendon::gui

Q_DECLARE_METATYPE(tendon::gui::StateMark)
