#pragma once

#include <tendon/interface/description.h>
#include <tendon/task/component_state.h>

namespace tendon::gui {

/// Whether a call of `command` is made only on purpose, by holding a button or pressing a key
/// twice: it can set something in motion, and its component, in that state, would do it at once.
[[nodiscard]] inline bool NeedsCare(const MemberDescription& command, ComponentState state) {
  return !command.hazard.empty() && state == ComponentState::kActive;
}

}  // namespace tendon::gui
