#pragma once

#include <cstddef>
#include <vector>

namespace tendon::graph {

/// From a provider to its client, by index.
struct LayerEdge {
  std::size_t from = 0;
  std::size_t to = 0;

  bool operator==(const LayerEdge&) const = default;
};

/// The layer of each of `count` nodes, so that edges lead to higher layers: the length of the
/// longest path from a node without providers. Ignores the edge that closes a cycle, in the order
/// of visits.
[[nodiscard]] std::vector<int> LayersOf(std::size_t count, const std::vector<LayerEdge>& edges);

}  // namespace tendon::graph
