#pragma once

#include <tendon/process/life/messages.h>
#include <tendon/task/component_state.h>

#include <QString>
#include <array>
#include <cstdint>
#include <optional>

namespace tendon::gui {

/// What the window orders of a component that is there, in the order of its buttons and menus.
inline constexpr std::array kSteerVerbs{LifeVerb::kStart, LifeVerb::kSuspend, LifeVerb::kStop,
                                        LifeVerb::kRestart};

/// "Start".
[[nodiscard]] QString WordOf(LifeVerb verb);
/// "Hold to start".
[[nodiscard]] QString HoldWordOf(LifeVerb verb);
/// "Stop the component", "Stop 2 components".
[[nodiscard]] QString TitleOf(LifeVerb verb, std::size_t components);
/// What a verb does to a component in this state, as far as it is so of any component: that one
/// that was suspended is told so. Empty where the verb says it all.
[[nodiscard]] QString EffectOf(LifeVerb verb, ComponentState state);
/// "robot/arm · suspended for 4 min", with the state and how long it has been in it where `since`,
/// ns since 1970, is known.
[[nodiscard]] QString SteeredText(const QString& path, ComponentState state,
                                  std::optional<std::int64_t> since, std::int64_t now);
/// What may come of it, and so how it is asked for: "It can set something in motion: hold …".
[[nodiscard]] QString ButtonAdviceOf(LifeVerb verb);
[[nodiscard]] QString CardAdviceOf(LifeVerb verb);

}  // namespace tendon::gui
