#include <tendon/gcm/system/leaders.h>
#include <tendon/gcm/system/start_order.h>

#include <cstddef>
#include <map>
#include <set>

namespace tendon {
namespace {

using Servers = std::map<ComponentPath, std::vector<ComponentPath>>;

/// One that is put in order once all of its servers are.
struct Open {
  ComponentPath path;
  std::size_t next = 0;  // of its servers
};

class Sorter {
 public:
  explicit Sorter(const SystemFile& system) {
    for (const auto& process : system.processes) {
      for (const auto& component : process.components) servers_[{process.name, component.name}];
    }
    for (const auto& [required, provided, comment] : system.connections) {
      const auto client = servers_.find({required.process, required.component});
      const ComponentPath server(provided.process, provided.component);
      if (client == servers_.end() || !servers_.contains(server)) continue;
      client->second.push_back(server);
    }
  }

  void Add(const ComponentPath& path) {
    Begin(path);
    while (!open_.empty()) {
      Open& last = open_.back();
      const auto& servers = servers_.at(last.path);
      if (last.next < servers.size()) {
        Begin(servers[last.next++]);
      } else {
        order_.push_back(last.path);
        open_.pop_back();
      }
    }
  }

  std::vector<ComponentPath> Take() && { return std::move(order_); }

 private:
  void Begin(const ComponentPath& path) {
    if (begun_.insert(path).second) open_.push_back({path});
  }

  Servers servers_;
  std::set<ComponentPath> begun_;
  std::vector<Open> open_;  // a list, not recursion: a chain may be as long as the file
  std::vector<ComponentPath> order_;
};

}  // namespace

std::vector<ComponentPath> StartOrder(const SystemFile& system) {
  Sorter sorter(system);
  for (const auto& process : system.processes) {
    for (const auto& component : process.components) sorter.Add({process.name, component.name});
  }
  std::vector<ComponentPath> order = std::move(sorter).Take();
  const SystemIndex index(system);
  PutLeadersFirst(order, [&index](const ComponentPath& path) {
    return index.FindComponent(path.first, path.second)->runs_after;
  });
  return order;
}

}  // namespace tendon
