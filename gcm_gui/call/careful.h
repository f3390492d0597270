#pragma once

#include <tendon/interface/interface_description.h>
#include <tendon/task/component_state.h>

namespace tendon::gui {

/// True if the user must hold a button or press a key twice to call `command`: it can set something
/// in motion, and its component executes it at once in this state.
[[nodiscard]] inline bool NeedsCare(const MemberDescription& command, ComponentState state) {
  return !command.hazard.empty() && state == ComponentState::kActive;
}

}  // namespace tendon::gui
