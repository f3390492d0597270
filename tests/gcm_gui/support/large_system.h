#pragma once

#include <string>

#include "support/sample_system.h"

namespace tendon::gui {

/// Returns a system with components `process_100/component_100`, … Nearly every component is
/// connected to the previous one. Each component has `commands` commands, ten per interface.
SystemBuilder LargeSystem(int processes, int of_each, int commands = 0);

std::string LargeProcess(int i);
std::string LargeComponent(int i);

}  // namespace tendon::gui
