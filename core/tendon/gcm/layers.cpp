#include <tendon/gcm/layers.h>

#include <algorithm>

namespace tendon::graph {
namespace {

enum class Visit { kNew, kOpen, kDone };

/// A depth-first search without recursion, which visits the providers of a node before the node.
class LongestPaths {
 public:
  LongestPaths(std::size_t count, const std::vector<LayerEdge>& edges)
      : providers_(count), visits_(count, Visit::kNew), layers_(count, 0) {
    for (const auto& edge : edges) providers_[edge.to].push_back(edge.from);
  }

  std::vector<int> Compute() && {
    for (std::size_t start = 0; start < providers_.size(); ++start) {
      if (visits_[start] == Visit::kNew) Descend(start);
    }
    return std::move(layers_);
  }

 private:
  void Descend(std::size_t start) {
    std::vector<std::size_t> stack{start};
    while (!stack.empty()) {
      const std::size_t here = stack.back();
      if (visits_[here] == Visit::kNew) {
        visits_[here] = Visit::kOpen;
        for (const std::size_t provider : providers_[here]) {
          if (visits_[provider] == Visit::kNew) stack.push_back(provider);
        }
        continue;
      }
      stack.pop_back();
      if (visits_[here] == Visit::kDone) continue;
      visits_[here] = Visit::kDone;
      for (const std::size_t provider : providers_[here]) {
        // A provider that is not finished closes a cycle; its edge is ignored.
        if (visits_[provider] != Visit::kDone || provider == here) continue;
        layers_[here] = std::max(layers_[here], layers_[provider] + 1);
      }
    }
  }

  std::vector<std::vector<std::size_t>> providers_;
  std::vector<Visit> visits_;
  std::vector<int> layers_;
};

}  // namespace

std::vector<int> LayersOf(std::size_t count, const std::vector<LayerEdge>& edges) {
  return LongestPaths(count, edges).Compute();
}

}  // namespace tendon::graph
