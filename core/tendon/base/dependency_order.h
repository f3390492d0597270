#pragma once

#include <cstddef>
#include <vector>

namespace tendon {

/// Entry i lists the numbers of the elements that element i depends on.
using Dependencies = std::vector<std::vector<std::size_t>>;

/// Returns the numbers of all elements. Each element comes after the elements that it depends on. A
/// dependency that closes a cycle is ignored. The same input gives the same order.
[[nodiscard]] std::vector<std::size_t> DependencyOrder(const Dependencies& dependencies);

}  // namespace tendon
