#pragma once

#include <tendon/base/dependency_order.h>
#include <tendon/manager/orderly_shutdown.h>
#include <tendon/task/component.h>

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace tendon {

/// The order in which the components of a manager start and end. It holds the components and what
/// they depend on at the time of its construction; later changes have no effect. The leaders and
/// connections of the components must not change while it is made.
class ComponentOrder {
 public:
  using Components = std::vector<std::shared_ptr<Component>>;

  /// `components` are in the order in which they were added.
  explicit ComponentOrder(Components components);
  /// Adds a connection between two of the components, given by their names.
  void AddConnection(const std::string& client, const std::string& server);

  /// Returns all components in the order in which they start: as they were added, but leaders
  /// before the components that run after them.
  [[nodiscard]] Components StartOrder() const;
  /// Returns the components for which `is_meant` is true, in the order in which they end: each
  /// comes after its clients and after the components that run after it.
  [[nodiscard]] std::vector<OrderlyShutdown::Member> EndOrder(
      const std::function<bool(const Component&)>& is_meant) const;

 private:
  const Components components_;
  std::map<std::string, std::size_t> numbers_;  // index of each component, by name
  std::vector<int> leader_counts_;              // number of leaders above each component
  Dependencies needed_;  // the components that each component still needs while it ends
};

}  // namespace tendon
