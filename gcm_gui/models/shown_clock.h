#pragma once

#include <tendon/base/clock.h>

namespace tendon::gui {

/// The steady clock of the system that this program shows; see ShownTime(). GUI thread.
[[nodiscard]] const Clock& ShownClock();

}  // namespace tendon::gui
