#pragma once

#include <gcm_gui/theme/state_mark.h>
#include <tendon/gcm/catalog.h>

#include <QMetaType>
#include <QString>

namespace tendon::gui {

[[nodiscard]] StateMark MarkOf(ProcessState state);
[[nodiscard]] StateMark MarkOf(ComponentState state);
[[nodiscard]] StateMark MarkOf(ConnectionState state);
/// Null: nothing is connected.
[[nodiscard]] StateMark MarkOf(const ConnectionDescription* connection);

/// "alive", "no answer", "lost", in the user's language.
[[nodiscard]] QString WordOf(ProcessState state);

/// Whether the process is gone, or only starting, so that what it had is shown grey.
[[nodiscard]] bool IsGone(ProcessState state);

}  // namespace tendon::gui

Q_DECLARE_METATYPE(tendon::gui::StateMark)
