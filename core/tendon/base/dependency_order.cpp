#include <tendon/base/dependency_order.h>

namespace tendon {
namespace {

/// An element that waits until its dependencies are placed in the order.
struct OpenNode {
  std::size_t number;
  std::size_t next = 0;  // index of its next dependency to place
};

}  // namespace

std::vector<std::size_t> DependencyOrder(const Dependencies& dependencies) {
  std::vector<std::size_t> order;
  order.reserve(dependencies.size());
  std::vector<bool> is_begun(dependencies.size());
  std::vector<OpenNode> open;  // a stack instead of recursion, because a chain may be very long
  const auto begin = [&](std::size_t number) {
    if (is_begun[number]) return;
    is_begun[number] = true;
    open.push_back({number});
  };
  for (std::size_t first = 0; first < dependencies.size(); ++first) {
    begin(first);
    while (!open.empty()) {
      OpenNode& last = open.back();
      const std::vector<std::size_t>& needed = dependencies[last.number];
      if (last.next < needed.size()) {
        begin(needed[last.next++]);
      } else {
        order.push_back(last.number);
        open.pop_back();
      }
    }
  }
  return order;
}

}  // namespace tendon
