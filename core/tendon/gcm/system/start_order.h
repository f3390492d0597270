#pragma once

#include <tendon/gcm/system/system_index.h>

#include <string>
#include <vector>

namespace tendon {

/// Returns the components of a system in the order in which they should be started: each after its
/// leader and its servers. In all other cases, for example within a cycle, the order of the file is
/// kept.
[[nodiscard]] std::vector<ComponentPath> StartOrder(const SystemFile& system);

/// Returns the order in which components should end: each after its clients and its followers. In
/// all other cases, for example within a cycle, the order of the file is kept.
[[nodiscard]] std::vector<ComponentPath> EndOrder(const SystemFile& system);
/// Returns the order in which whole processes should end: each after its clients.
[[nodiscard]] std::vector<std::string> ProcessEndOrder(const SystemFile& system);

}  // namespace tendon
