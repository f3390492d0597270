#pragma once

#include <string>

#include "support/sample_system.h"

namespace tendon::gui {

/// Components of which nearly all drive the one before: `process_100/component_100`, …
SystemBuilder LargeSystem(int processes, int of_each);

std::string LargeProcess(int i);
std::string LargeComponent(int i);

}  // namespace tendon::gui
