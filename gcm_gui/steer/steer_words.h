#pragma once

#include <tendon/process/life/messages.h>

#include <QString>
#include <array>

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
/// What may come of it, and so how it is asked for: "It can set something in motion: hold …".
[[nodiscard]] QString ButtonAdviceOf(LifeVerb verb);
[[nodiscard]] QString CardAdviceOf(LifeVerb verb);

}  // namespace tendon::gui
