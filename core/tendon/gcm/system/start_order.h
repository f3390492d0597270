#pragma once

#include <tendon/gcm/system/system_index.h>

#include <string>
#include <vector>

namespace tendon {

/// The components of a system in the order of starts: each after its leader and after its servers.
/// Within cycles, and otherwise, keeps the order of the file.
[[nodiscard]] std::vector<ComponentPath> StartOrder(const SystemFile& system);

/// The order in which components end: each after its clients and its followers. Within cycles, and
/// otherwise, keeps the order of the file.
[[nodiscard]] std::vector<ComponentPath> EndOrder(const SystemFile& system);
/// The same for whole processes.
[[nodiscard]] std::vector<std::string> ProcessEndOrder(const SystemFile& system);

}  // namespace tendon
