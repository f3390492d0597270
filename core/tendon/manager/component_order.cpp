#include <tendon/manager/component_order.h>

#include <tendon/task/task.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace tendon {

ComponentOrder::ComponentOrder(Components components)
    : components_(std::move(components)), needed_(components_.size()) {
  for (std::size_t i = 0; i < components_.size(); ++i) {
    numbers_.emplace(components_[i]->name(), i);
    const auto* task = dynamic_cast<const Task*>(components_[i].get());
    const Task* const leader = task == nullptr ? nullptr : task->leader();
    const auto own = std::ranges::find_if(
        components_, [&](const auto& component) { return component.get() == leader; });
    // The leader may belong to another manager, or may have been removed.
    if (own != components_.end()) {
      needed_[i].push_back(static_cast<std::size_t>(own - components_.begin()));
    }
    int leaders = 0;
    while (task != nullptr && (task = task->leader()) != nullptr) ++leaders;
    leader_counts_.push_back(leaders);
  }
}

void ComponentOrder::AddConnection(const std::string& client, const std::string& server) {
  const std::size_t caller = numbers_.at(client);
  const std::size_t called = numbers_.at(server);
  // A server that runs after its own client ends together with the client, so it cannot end after
  // the client.
  if (!RunsAfter(*components_[called], *components_[caller])) needed_[caller].push_back(called);
}

ComponentOrder::Components ComponentOrder::StartOrder() const {
  std::vector<std::size_t> order(components_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return leader_counts_[a] < leader_counts_[b];
  });
  Components all;
  for (const std::size_t number : order) all.push_back(components_[number]);
  return all;
}

std::vector<OrderlyShutdown::Member> ComponentOrder::EndOrder(
    const std::function<bool(const Component&)>& is_meant) const {
  std::vector<OrderlyShutdown::Member> members;
  std::map<std::size_t, std::size_t> places;  // position in the end order, by number
  std::vector<std::size_t> order = DependencyOrder(needed_);
  std::reverse(order.begin(), order.end());
  for (const std::size_t number : order) {
    if (!is_meant(*components_[number])) continue;
    places.emplace(number, members.size());
    members.push_back({.component = components_[number], .before = {}});
  }
  for (const auto& [number, place] : places) {
    for (const std::size_t server : needed_[number]) {
      const auto later = places.find(server);
      if (later != places.end() && later->second > place) {
        members[later->second].before.push_back(place);
      }
    }
  }
  return members;
}

}  // namespace tendon
