#pragma once

#include <string>

#include "support/sample_system.h"

namespace tendon::gui {

/// Components that are nearly all connected to the component before: `process_100/component_100`, …
/// Each also has this number of commands, ten in an interface.
SystemBuilder LargeSystem(int processes, int of_each, int commands = 0);

std::string LargeProcess(int i);
std::string LargeComponent(int i);

}  // namespace tendon::gui
