#include <tendon/gcm/system/system_index.h>

namespace tendon {
namespace {

template <typename Map, typename Key>
typename Map::mapped_type FindIn(const Map& map, const Key& key) {
  const auto found = map.find(key);
  return found == map.end() ? nullptr : found->second;
}

}  // namespace

SystemIndex::SystemIndex(const SystemFile& system) {
  for (const auto& process : system.processes) {
    processes_.emplace(process.name, &process);
    for (const auto& component : process.components) {
      components_.emplace(ComponentPath(process.name, component.name), &component);
    }
  }
  for (const auto& connection : system.connections) {
    connections_.emplace(connection.required, &connection);
  }
}

const SystemFile::Process* SystemIndex::FindProcess(const std::string& process) const {
  return FindIn(processes_, process);
}

const SystemFile::Component* SystemIndex::FindComponent(const std::string& process,
                                                        const std::string& component) const {
  return FindIn(components_, ComponentPath(process, component));
}

const SystemFile::Connection* SystemIndex::FindConnection(const InterfaceName& required) const {
  return FindIn(connections_, required);
}

}  // namespace tendon
