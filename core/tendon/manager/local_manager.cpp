#include <tendon/manager/local_manager.h>

#include <algorithm>

namespace tendon {
namespace {

template <typename List>
std::vector<std::string> Names(const List& descriptions) {
  std::vector<std::string> names;
  for (const auto& one : descriptions) names.push_back(one.name);
  return names;
}

Error NoInterface(const std::string& sort, const InterfaceName& name,
                  const std::vector<std::string>& known) {
  return Error{ErrorCode::kNotFound, "component '" + name.component + "' has no " + sort +
                                         " interface '" + name.interface + "'" +
                                         DidYouMean(name.interface, known)};
}

}  // namespace

LocalManager::~LocalManager() { Clear(); }

void LocalManager::Clear() {
  SetObserver(nullptr);
  const auto lock = Lock();
  connections_.clear();
  for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry) {
    (void)entry->component->Stop();
  }
  while (!entries_.empty()) entries_.pop_back();
}

Component& LocalManager::Add(std::unique_ptr<Component> component, ComponentOrigin origin) {
  Component& added = *component;
  {
    const auto lock = Lock();
    if (Find(added.name()) != nullptr) {
      throw ConfigurationError("component '" + added.name() +
                               "' already exists in this process; choose another name");
    }
    added.Seal();
    added.SetStateObserver([this] { NotifyChanged(); });
    entries_.push_back({std::move(component), std::move(origin)});
  }
  NotifyChanged();
  return added;
}

Result<void> LocalManager::Remove(const std::string& component) {
  {
    const auto lock = Lock();
    const auto found = Require(component);
    if (!found) return found.error();
    OnRemoving(**found);
    DisconnectAll(component);
    (*found)->SetStateObserver(nullptr);
    (void)(*found)->Stop();
    std::erase_if(entries_, [&](const Entry& one) { return one.component.get() == *found; });
  }
  NotifyChanged();
  return {};
}

Result<ConnectionId> LocalManager::Connect(const InterfaceName& required,
                                           const InterfaceName& provided) {
  ConnectionId id = 0;
  {
    const auto lock = Lock();
    const auto client = FindRequired(required);
    if (!client) return client.error();
    const auto server = FindProvided(provided);
    if (!server) return server.error();
    auto connection = Connection::Make(**client, **server, ToString(required), ToString(provided));
    if (!connection) return connection.error();
    id = NextConnectionId();
    connections_[id] = {.description = {.id = id,
                                        .required = required,
                                        .provided = provided,
                                        .state = ConnectionState::kActive,
                                        .reason = {}},
                        .connection = std::move(*connection)};
  }
  NotifyChanged();
  return id;
}

Result<void> LocalManager::Disconnect(const InterfaceName& required) {
  {
    const auto lock = Lock();
    const auto client = FindRequired(required);
    if (!client) return client.error();
    const auto found = std::find_if(connections_.begin(), connections_.end(), [&](const auto& one) {
      const InterfaceName& name = one.second.description.required;
      return name.component == required.component && name.interface == required.interface;
    });
    if (found == connections_.end()) {
      return Error{ErrorCode::kNotFound, ToString(required) + " is not connected"};
    }
    found->second.connection->Close(kDrainPatience);
    connections_.erase(found);
  }
  NotifyChanged();
  return {};
}

Result<void> LocalManager::Start(const std::string& component) {
  const auto lock = Lock();
  const auto found = Require(component);
  return found ? (*found)->Start() : found.error();
}

Result<void> LocalManager::Stop(const std::string& component) {
  const auto lock = Lock();
  const auto found = Require(component);
  return found ? (*found)->Stop() : found.error();
}

Result<void> LocalManager::StartAll() {
  const auto lock = Lock();
  Result<void> outcome;
  for (const Entry& entry : entries_) {
    if (entry.component->state() == ComponentState::kActive) continue;
    const auto started = entry.component->Start();
    if (!started && outcome) outcome = started;
  }
  return outcome;
}

Result<void> LocalManager::StopAll() {
  const auto lock = Lock();
  Result<void> outcome;
  for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry) {
    if (entry->component->state() != ComponentState::kActive) continue;
    const auto stopped = entry->component->Stop();
    if (!stopped && outcome) outcome = stopped;
  }
  return outcome;
}

Component* LocalManager::Find(const std::string& component) const {
  const auto lock = Lock();
  for (const Entry& entry : entries_) {
    if (entry.component->name() == component) return entry.component.get();
  }
  return nullptr;
}

std::vector<ComponentDescription> LocalManager::components() const {
  const auto lock = Lock();
  std::vector<ComponentDescription> all;
  for (const Entry& entry : entries_) all.push_back(Describe(entry));
  return all;
}

std::vector<ConnectionDescription> LocalManager::connections() const {
  const auto lock = Lock();
  std::vector<ConnectionDescription> all;
  for (const auto& [id, connection] : connections_) all.push_back(connection.description);
  return all;
}

void LocalManager::SetObserver(std::function<void()> observer) {
  const std::scoped_lock lock(observer_mutex_);
  observer_ = std::move(observer);
}

Result<RequiredInterface*> LocalManager::FindRequired(const InterfaceName& name) const {
  const auto component = Require(name.component);
  if (!component) return component.error();
  RequiredInterface* found = (*component)->FindRequired(name.interface);
  if (found != nullptr) return found;
  return NoInterface("required", name, Names((*component)->required()));
}

Result<ProvidedInterface*> LocalManager::FindProvided(const InterfaceName& name) const {
  const auto component = Require(name.component);
  if (!component) return component.error();
  ProvidedInterface* found = (*component)->FindProvided(name.interface);
  if (found != nullptr) return found;
  return NoInterface("provided", name, Names((*component)->provided()));
}

std::unique_lock<std::recursive_mutex> LocalManager::Lock() const {
  return std::unique_lock(mutex_);
}

void LocalManager::NotifyChanged() const {
  const std::scoped_lock lock(observer_mutex_);
  if (observer_) observer_();
}

ComponentDescription LocalManager::Describe(const Entry& entry) {
  const Component& component = *entry.component;
  ComponentDescription description{.name = component.name(),
                                   .class_name = entry.origin.class_name,
                                   .library = entry.origin.library,
                                   .state = component.state(),
                                   .fault = component.fault(),
                                   .period = component.period(),
                                   .provided = component.provided(),
                                   .required = component.required(),
                                   .tables = {}};
  for (const StateTable* table : component.tables()) {
    TableDescription described{.name = table->name(), .length = table->length(), .columns = {}};
    for (const auto& column : table->columns()) {
      described.columns.push_back({.name = column->name(),
                                   .type = column->schema().name(),
                                   .fingerprint = column->fingerprint()});
    }
    description.tables.push_back(std::move(described));
  }
  return description;
}

Result<Component*> LocalManager::Require(const std::string& component) const {
  Component* found = Find(component);
  if (found != nullptr) return found;
  return Error{ErrorCode::kNotFound,
               "no component '" + component + "'" + DidYouMean(component, component_names())};
}

std::vector<std::string> LocalManager::component_names() const {
  std::vector<std::string> names;
  for (const Entry& entry : entries_) names.push_back(entry.component->name());
  return names;
}

void LocalManager::DisconnectAll(const std::string& component) {
  std::erase_if(connections_, [&component](const auto& one) {
    const ConnectionDescription& description = one.second.description;
    return description.required.component == component ||
           description.provided.component == component;
  });
}

}  // namespace tendon
