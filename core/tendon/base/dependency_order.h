#pragma once

#include <cstddef>
#include <vector>

namespace tendon {

/// For each thing, by its number, the numbers of those that it depends on.
using Dependencies = std::vector<std::vector<std::size_t>>;

/// The numbers of all things, each behind those that it depends on, as far as these do not lead
/// around in a circle; else in the order of the numbers. The same input gives the same order.
[[nodiscard]] std::vector<std::size_t> DependencyOrder(const Dependencies& dependencies);

}  // namespace tendon
