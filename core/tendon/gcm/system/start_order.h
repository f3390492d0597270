#pragma once

#include <tendon/gcm/system/system_index.h>

#include <string>
#include <vector>

namespace tendon {

/// The components of a system, each behind the one after which it runs and behind its servers, so
/// that servers start before their clients and stop after them. Ignores order within rings.
/// Otherwise keeps the order of the file.
[[nodiscard]] std::vector<ComponentPath> StartOrder(const SystemFile& system);

/// The order in which components end: each behind its clients and its followers. Ignores order
/// within rings. Otherwise keeps the order of the file.
[[nodiscard]] std::vector<ComponentPath> EndOrder(const SystemFile& system);
/// The same for whole processes.
[[nodiscard]] std::vector<std::string> ProcessEndOrder(const SystemFile& system);

}  // namespace tendon
