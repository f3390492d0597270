#include <tendon/gcm/lifecycle/followers.h>

#include <tendon/payload/json/strict_json.h>

#include <nlohmann/json.hpp>
#include <set>
#include <utility>

namespace tendon {
namespace {

using message::LifecycleOrder;
using message::LifecycleStep;
using nlohmann::ordered_json;

struct Follower {
  std::string component;
  std::string leader;
  bool was_suspended = false;
};

/// Returns the text of a key. Returns an empty text if the key is missing or has another type,
/// which is possible if a user has edited the history file.
std::string TextAt(const ordered_json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// Returns the followers, each after its leader.
std::vector<Follower> Read(const LifecycleStep& stop) {
  std::vector<Follower> all;
  const ordered_json list = JsonOrText(stop.former);
  if (!list.is_array()) return all;
  for (const ordered_json& one : list) {
    std::string component = TextAt(one, "component");
    if (component.empty()) continue;
    all.push_back({std::move(component), TextAt(one, "leader"),
                   TextAt(one, "state") == ToString(ComponentState::kSuspended)});
  }
  return all;
}

}  // namespace

std::string FollowersText(const Catalogue& catalogue, const std::string& process,
                          const std::string& component) {
  const auto* entry = catalogue.FindProcess(process);
  if (entry == nullptr) return {};
  std::vector<std::string> leaders = {component};
  std::set<std::string> seen = {component};
  ordered_json list = ordered_json::array();
  for (std::size_t next = 0; next < leaders.size(); ++next) {
    const std::string leader = leaders[next];
    for (const auto& [name, one] : entry->components) {
      if (one.leader != leader || !IsRunning(one.state) || !seen.insert(name).second) continue;
      list.push_back({{"component", name}, {"leader", leader}, {"state", ToString(one.state)}});
      leaders.push_back(name);
    }
  }
  return list.empty() ? std::string() : list.dump();
}

std::vector<std::string> FollowersOf(const LifecycleStep& stop) {
  std::vector<std::string> names;
  for (Follower& one : Read(stop)) names.push_back(std::move(one.component));
  return names;
}

Result<void> CheckFollowers(const Catalogue& catalogue, const LifecycleStep& stop) {
  for (const Follower& one : Read(stop)) {
    const std::string path = stop.process + "/" + one.component;
    const auto* now = catalogue.FindComponent(stop.process, one.component);
    if (now == nullptr) return Error{ErrorCode::kFailed, path + " no longer exists"};
    if (now->leader != one.leader) {
      return Error{ErrorCode::kFailed, path + " no longer runs after '" + one.leader + "'"};
    }
    if (IsRunning(now->state) || now->state == ComponentState::kFaulted) {
      return Error{ErrorCode::kFailed,
                   path + " is " + std::string(ToString(now->state)) + " since"};
    }
  }
  return {};
}

std::vector<LifecycleOrder> OrdersToRunAgain(const LifecycleStep& stop,
                                             const LifecycleOrder& order) {
  if (!IsRunning(stop.state)) return {};
  std::vector<Follower> all = Read(stop);
  all.insert(all.begin(), {.component = order.component,
                           .leader = {},
                           .was_suspended = stop.state == ComponentState::kSuspended});
  std::vector<LifecycleOrder> orders;
  const auto add = [&](LifecycleVerb verb, const std::string& component) {
    orders.push_back(order);
    orders.back().verb = verb;
    orders.back().component = component;
  };
  for (const Follower& one : all) add(LifecycleVerb::kStart, one.component);
  // Suspended components. Their followers do not run either.
  std::set<std::string> suspended;
  for (const Follower& one : all) {
    if (!one.was_suspended) continue;
    const bool is_suspended = suspended.contains(one.leader);
    suspended.insert(one.component);
    if (!is_suspended) add(LifecycleVerb::kSuspend, one.component);
  }
  return orders;
}

}  // namespace tendon
