#include <tendon/gcm/catalogue.h>

#include <tendon/base/text.h>
#include <tendon/payload/codec.h>

#include <algorithm>
#include <string_view>
#include <tuple>

namespace tendon {
namespace {

bool ApplyProcess(std::map<std::string, ProcessEntry>& processes, const CatalogueChange& change) {
  if (change.processes.size() != 1 || change.processes.front().name != change.process) return false;
  const ProcessDescription& process = change.processes.front();
  ProcessEntry& entry = processes[change.process];
  if (entry.process.instance != process.instance) entry = {};
  entry.process = process;
  return true;
}

bool ApplyToEntry(ProcessEntry& entry, const CatalogueChange& change) {
  using Kind = CatalogueChange::Kind;
  switch (change.kind) {
    case Kind::kComponent:
      if (change.components.size() != 1) return false;
      entry.components[change.components.front().name] = change.components.front();
      return true;
    case Kind::kComponentRemoved:
      return entry.components.erase(change.component) == 1;
    case Kind::kConnection:
      if (change.connections.size() != 1) return false;
      entry.connections[change.connections.front().id] = change.connections.front();
      return true;
    case Kind::kConnectionRemoved:
      return entry.connections.erase(change.connection) == 1;
    case Kind::kProcess:
    case Kind::kProcessRemoved:
      break;
  }
  return false;
}

/// Appends the encoded value.
template <Payload T>
void Append(const T& value, std::vector<std::byte>& bytes) {
  std::vector<std::byte> body;
  Encode(value, body);
  bytes.insert(bytes.end(), body.begin(), body.end());
}

}  // namespace

const ProcessEntry* Catalogue::FindProcess(const std::string& name) const {
  const auto found = processes_.find(name);
  return found == processes_.end() ? nullptr : &found->second;
}

const ComponentDescription* Catalogue::FindComponent(const std::string& process,
                                                     const std::string& component) const {
  const ProcessEntry* entry = FindProcess(process);
  if (entry == nullptr) return nullptr;
  const auto found = entry->components.find(component);
  return found == entry->components.end() ? nullptr : &found->second;
}

const ProvidedDescription* Catalogue::FindProvided(const InterfaceName& name) const {
  const ComponentDescription* component = FindComponent(name.process, name.component);
  return component == nullptr ? nullptr : FindNamed(component->provided, name.interface);
}

const RequiredDescription* Catalogue::FindRequired(const InterfaceName& name) const {
  const ComponentDescription* component = FindComponent(name.process, name.component);
  return component == nullptr ? nullptr : FindNamed(component->required, name.interface);
}

const ConnectionDescription* Catalogue::FindConnection(const InterfaceName& required) const {
  const ProcessEntry* entry = FindProcess(required.process);
  if (entry == nullptr) return nullptr;
  for (const auto& [id, connection] : entry->connections) {
    if (connection.required == required) return &connection;
  }
  return nullptr;
}

std::vector<ConnectionDescription> Catalogue::connections() const {
  std::vector<ConnectionDescription> all;
  for (const auto& [name, entry] : processes_) {
    for (const auto& [id, connection] : entry.connections) all.push_back(connection);
  }
  return all;
}

bool Catalogue::Apply(const CatalogueChange& change) {
  if (change.revision != revision_ + 1) return false;
  if (change.kind == CatalogueChange::Kind::kProcess) {
    if (!ApplyProcess(processes_, change)) return false;
  } else {
    const auto entry = processes_.find(change.process);
    if (entry == processes_.end()) return false;
    if (change.kind == CatalogueChange::Kind::kProcessRemoved) {
      processes_.erase(entry);
    } else if (!ApplyToEntry(entry->second, change)) {
      return false;
    }
  }
  ++revision_;
  return true;
}

std::vector<CatalogueChange> Catalogue::AsChanges() const {
  using Kind = CatalogueChange::Kind;
  std::vector<CatalogueChange> changes;
  for (const auto& [name, entry] : processes_) {
    changes.push_back({.kind = Kind::kProcess, .process = name, .processes = {entry.process}});
    for (const auto& [component_name, component] : entry.components) {
      changes.push_back({.kind = Kind::kComponent, .process = name, .components = {component}});
    }
    for (const auto& [id, connection] : entry.connections) {
      changes.push_back({.kind = Kind::kConnection, .process = name, .connections = {connection}});
    }
  }
  // The result is not negative, because each element of the catalogue has needed at least one
  // revision.
  std::uint64_t revision = revision_ - changes.size();
  for (CatalogueChange& change : changes) change.revision = ++revision;
  return changes;
}

Catalogue Catalogue::At(std::uint64_t revision) {
  Catalogue catalogue;
  catalogue.revision_ = revision;
  return catalogue;
}

Fingerprint Catalogue::ContentHash() const {
  std::vector<std::byte> bytes;
  for (const auto& [name, entry] : processes_) {
    Append(
        ProcessDescription{.name = name, .host = entry.process.host, .state = entry.process.state},
        bytes);
    for (const auto& [component_name, component] : entry.components) {
      ComponentDescription content = component;
      content.fault_time = 0;
      content.warning.clear();  // the warnings depend on the load of the machine
      Append(content, bytes);
    }
    std::vector<ConnectionDescription> connections;
    for (const auto& [id, connection] : entry.connections) {
      connections.push_back({.required = connection.required,
                             .provided = connection.provided,
                             .state = connection.state});
    }
    std::sort(connections.begin(), connections.end(), [](const auto& a, const auto& b) {
      return std::tie(a.required, a.provided) < std::tie(b.required, b.provided);
    });
    for (const ConnectionDescription& connection : connections) Append(connection, bytes);
  }
  return FingerprintOf(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

}  // namespace tendon
