#pragma once

#include <tendon/gcm/system/system_index.h>

#include <vector>

namespace tendon {

/// The components of a system, each behind the one after which it runs, and behind those that its
/// connections lead to, as far as these do not lead around in a circle: servers begin before their
/// clients, and end after them. Else in the order of the file.
[[nodiscard]] std::vector<ComponentPath> StartOrder(const SystemFile& system);

}  // namespace tendon
