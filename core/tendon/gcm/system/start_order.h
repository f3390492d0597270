#pragma once

#include <tendon/gcm/system/system_index.h>

#include <string>
#include <vector>

namespace tendon {

/// The components of a system, each behind the one after which it runs, and behind those that its
/// connections lead to, as far as these do not lead around in a circle: servers begin before their
/// clients, and end after them. Else in the order of the file.
[[nodiscard]] std::vector<ComponentPath> StartOrder(const SystemFile& system);

/// The other way round, for the end: each behind its clients, and behind those that run after it,
/// as far as these do not lead around in a circle. Else in the order of the file.
[[nodiscard]] std::vector<ComponentPath> EndOrder(const SystemFile& system);
/// The same for whole processes.
[[nodiscard]] std::vector<std::string> ProcessEndOrder(const SystemFile& system);

}  // namespace tendon
