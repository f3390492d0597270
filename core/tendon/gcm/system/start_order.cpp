#include <tendon/gcm/system/start_order.h>

#include <tendon/base/dependency_order.h>
#include <tendon/gcm/system/leaders.h>

#include <cstddef>
#include <map>
#include <utility>

namespace tendon {
namespace {

/// Pairs of names. The first name of a pair must come after the second.
template <typename Name>
using Pairs = std::vector<std::pair<Name, Name>>;

/// Returns the names in an order that satisfies the pairs. Ignores pairs with names that are not in
/// `names`.
template <typename Name>
std::vector<Name> Ordered(const std::vector<Name>& names, const Pairs<Name>& pairs) {
  std::map<Name, std::size_t> numbers;
  for (std::size_t i = 0; i < names.size(); ++i) numbers.emplace(names[i], i);
  Dependencies dependencies(names.size());
  for (const auto& [later, earlier] : pairs) {
    const auto from = numbers.find(later);
    const auto to = numbers.find(earlier);
    if (from == numbers.end() || to == numbers.end()) continue;
    dependencies[from->second].push_back(to->second);
  }
  std::vector<Name> order;
  for (const std::size_t number : DependencyOrder(dependencies)) order.push_back(names[number]);
  return order;
}

std::vector<ComponentPath> PathsOf(const SystemFile& system) {
  std::vector<ComponentPath> paths;
  for (const auto& process : system.processes) {
    for (const auto& component : process.components) {
      paths.emplace_back(process.name, component.name);
    }
  }
  return paths;
}

}  // namespace

std::vector<ComponentPath> StartOrder(const SystemFile& system) {
  Pairs<ComponentPath> pairs;
  for (const auto& [required, provided, comment] : system.connections) {
    pairs.emplace_back(OwnerOf(required), OwnerOf(provided));
  }
  std::vector<ComponentPath> order = Ordered(PathsOf(system), pairs);
  const SystemIndex index(system);
  PutLeadersFirst(order, [&index](const ComponentPath& path) {
    return index.FindComponent(path.first, path.second)->runs_after;
  });
  return order;
}

std::vector<ComponentPath> EndOrder(const SystemFile& system) {
  Pairs<ComponentPath> pairs;
  for (const auto& process : system.processes) {
    for (const auto& component : process.components) {
      pairs.push_back({{process.name, component.runs_after}, {process.name, component.name}});
    }
  }
  for (const auto& [required, provided, comment] : system.connections) {
    pairs.emplace_back(OwnerOf(provided), OwnerOf(required));
  }
  return Ordered(PathsOf(system), pairs);
}

std::vector<std::string> ProcessEndOrder(const SystemFile& system) {
  std::vector<std::string> names;
  for (const auto& process : system.processes) names.push_back(process.name);
  Pairs<std::string> pairs;
  for (const auto& [required, provided, comment] : system.connections) {
    pairs.emplace_back(provided.process, required.process);
  }
  return Ordered(names, pairs);
}

}  // namespace tendon
