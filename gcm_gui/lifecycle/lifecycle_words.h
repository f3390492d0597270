#pragma once

#include <tendon/process/lifecycle/lifecycle_messages.h>
#include <tendon/task/component_state.h>

#include <QString>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace tendon::gui {

/// The verbs for an existing component, in the order of buttons and menus.
inline constexpr std::array kLifecycleVerbs{LifecycleVerb::kStart, LifecycleVerb::kSuspend,
                                            LifecycleVerb::kStop, LifecycleVerb::kRestart};

/// The word for a button: "Start".
[[nodiscard]] QString WordOf(LifecycleVerb verb);
/// The text of a button that must be held down: "Hold to start".
[[nodiscard]] QString HoldWordOf(LifecycleVerb verb);
/// The title of a confirmation: "Stop the component", "Stop 2 components".
[[nodiscard]] QString TitleOf(LifecycleVerb verb, std::size_t components);
/// The effect of a verb on a component in this state, in words that are true for every component.
/// Empty if the verb needs no explanation.
[[nodiscard]] QString EffectOf(LifecycleVerb verb, ComponentState state);
/// The state and its duration: "robot/arm · suspended for 4 min". Without the duration if `since`
/// (ns since 1970) is unknown.
[[nodiscard]] QString StateWithDuration(const QString& path, ComponentState state,
                                        std::optional<std::int64_t> since, std::int64_t now);
/// The risk of a verb, and how to confirm it: "This can move something: hold …".
[[nodiscard]] QString ButtonAdviceOf(LifecycleVerb verb);
[[nodiscard]] QString CardAdviceOf(LifecycleVerb verb);

}  // namespace tendon::gui
