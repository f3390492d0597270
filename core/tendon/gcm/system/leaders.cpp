#include <tendon/gcm/system/leaders.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

namespace tendon {
namespace {

using Leaders = std::map<std::string, std::string>;  // leaders of one process, by follower

Leaders LeadersOf(const std::vector<SystemFile::Component>& components) {
  Leaders leaders;
  for (const auto& one : components) {
    if (!one.runs_after.empty()) leaders.emplace(one.name, one.runs_after);
  }
  return leaders;
}

/// Describes a cycle: the part of `chain` from `first` to the end. The last component of the chain
/// runs after `first`.
std::string RingText(const std::vector<std::string>& chain, const std::string& first) {
  constexpr std::ptrdiff_t kMaxNames = 20;
  const auto begin = std::find(chain.begin(), chain.end(), first);
  std::string text = "'" + first + "' runs after ";
  for (auto one = begin + 1; one < chain.end(); ++one) {
    if (one - begin == kMaxNames) {
      text += "... (" + std::to_string(chain.end() - one) + " more), which runs after ";
      break;
    }
    text += "'" + *one + "', which runs after ";
  }
  return text + "'" + first + "'";
}

}  // namespace

void PutLeadersFirst(std::vector<ComponentPath>& order,
                     const std::function<std::string(const ComponentPath& component)>& leader_of) {
  std::set<ComponentPath> behind(order.begin(), order.end());  // components not placed yet
  std::map<ComponentPath, std::vector<ComponentPath>> followers;
  std::vector<ComponentPath> ordered;
  for (const ComponentPath& path : order) {
    const ComponentPath leader(path.first, leader_of(path));
    if (behind.contains(leader)) {
      followers[leader].push_back(path);
      continue;
    }
    std::vector<ComponentPath> next = {path};
    while (!next.empty()) {  // no recursion, because the chain of followers may be very long
      const ComponentPath one = std::move(next.back());
      next.pop_back();
      ordered.push_back(one);
      behind.erase(one);
      const auto& waiting = followers[one];
      next.insert(next.end(), waiting.rbegin(), waiting.rend());
    }
  }
  for (ComponentPath& path : order) {
    if (behind.contains(path)) ordered.push_back(std::move(path));
  }
  order = std::move(ordered);
}

void PutLeadersFirst(std::vector<SystemFile::Component>& components) {
  const Leaders leaders = LeadersOf(components);
  if (leaders.empty()) return;
  std::map<std::string, SystemFile::Component*> by_name;
  std::vector<ComponentPath> order;
  for (auto& one : components) {
    by_name.emplace(one.name, &one);
    order.emplace_back("", one.name);
  }
  PutLeadersFirst(order, [&leaders](const ComponentPath& path) {
    const auto leader = leaders.find(path.second);
    return leader == leaders.end() ? std::string() : leader->second;
  });
  std::vector<SystemFile::Component> ordered;
  ordered.reserve(order.size());
  for (const auto& [process, name] : order) ordered.push_back(std::move(*by_name.at(name)));
  components = std::move(ordered);
}

std::string FindCycle(const std::vector<SystemFile::Component>& components) {
  const Leaders leaders = LeadersOf(components);
  std::set<std::string> fine;  // components that do not lead to a cycle
  for (const auto& [follower, leader] : leaders) {
    std::vector<std::string> chain;
    std::set<std::string> in_chain;
    std::string one = follower;
    while (!fine.contains(one)) {
      if (!in_chain.insert(one).second) return RingText(chain, one);
      chain.push_back(one);
      const auto next = leaders.find(one);
      if (next == leaders.end()) break;
      one = next->second;
    }
    fine.insert(chain.begin(), chain.end());
  }
  return {};
}

}  // namespace tendon
