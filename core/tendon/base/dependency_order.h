#pragma once

#include <cstddef>
#include <vector>

namespace tendon {

/// For each element, by its number, the numbers of the elements that it depends on.
using Dependencies = std::vector<std::vector<std::size_t>>;

/// The numbers of all elements, each after the elements that it depends on. In a dependency cycle,
/// the elements keep the order of their numbers. The same input gives the same order.
[[nodiscard]] std::vector<std::size_t> DependencyOrder(const Dependencies& dependencies);

}  // namespace tendon
