#include <tendon/manager/local_manager.h>

#include <tendon/base/log.h>
#include <tendon/manager/component_order.h>
#include <tendon/manager/state_requests.h>
#include <tendon/task/threaded_task.h>

#include <algorithm>
#include <thread>
#include <utility>

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

/// The error for an interface of the wrong kind. A connection needs a required and a provided
/// interface.
Error OtherSide(const InterfaceName& name, const std::string& is, const std::string& wanted) {
  return Error{ErrorCode::kNotFound, "interface '" + name.interface + "' of component '" +
                                         name.component + "' is a " + is + " interface; give a " +
                                         wanted + " interface"};
}

ConfigurationError ExistsAlready(const std::string& name, const ComponentOrigin& first) {
  std::string origin;
  if (!first.class_name.empty()) origin = " (of class " + first.class_name + ")";
  if (!first.added_at.empty()) origin = " (added at " + first.added_at + ")";
  return ConfigurationError("component '" + name + "' already exists in this process" + origin +
                            "; choose another name");
}

Error NotReplaced(const std::string& component, const std::string& why) {
  return {ErrorCode::kFailed, "component '" + component + "' is not replaced: " + why};
}

}  // namespace

ManagerClient::~ManagerClient() = default;

ConnectionCounts CountsOf(const Connection& connection) {
  return {.age = SteadyClock().Now() - connection.made(),
          .taken = connection.taken(),
          .capacity = connection.capacity(),
          .waiting = connection.waiting(),
          .refused = connection.refused(),
          .replaced = connection.replaced(),
          .lost_events = connection.lost_events()};
}

LocalManager::LocalManager()
    : requests_(std::make_unique<StateRequests>(StateRequests::Manager{
          .lock = [this] { return Lock(); },
          .find = [this](const std::string& name) { return Require(name); },
          .order = [this] { return Order(); },
          .has_calls_under_way = [this](const Component& one) { return HasCallsUnderWay(one); }})) {
}

LocalManager::~LocalManager() {
  SetObserver(nullptr);
  EndAll(SteadyClock().Now() + kEndTimeout);
  Clear();
}

void LocalManager::Clear() {
  SetObserver(nullptr);
  const auto lock = Lock();
  connections_.clear();
  ComponentOrder::Components components = Order().StartOrder();
  for (auto one = components.rbegin(); one != components.rend(); ++one) (*one)->End();
  for (const auto& one : components) watchdog_.Forget(*one);
  entries_.clear();
  while (!components.empty()) components.pop_back();
}

Component& LocalManager::Add(std::unique_ptr<Component> component, ComponentOrigin origin) {
  if (!component) throw ConfigurationError("LocalManager::Add: null component");
  Component& added = *component;
  {
    const auto lock = Lock();
    for (const Entry& entry : entries_) {
      if (entry.component->name() == added.name()) throw ExistsAlready(added.name(), entry.origin);
    }
    entries_.push_back(MakeEntry(std::move(component), std::move(origin)));
    Attach(added);
  }
  NotifyChanged();
  return added;
}

LocalManager::Entry LocalManager::MakeEntry(std::unique_ptr<Component> component,
                                            ComponentOrigin origin) {
  component->Seal();
  if (auto* client = dynamic_cast<ManagerClient*>(component.get())) client->OnAdding(*this);
  // The last owner of a component may be a thread that waits for the component's state and does not
  // hold the lock. Then the destructor needs the lock, because it also changes the tasks that run
  // after this component.
  const auto destroy = [this](Component* one) {
    const auto destroyed = Lock();
    delete one;
  };
  return {{component.release(), destroy}, std::move(origin)};
}

Result<void> LocalManager::Remove(const std::string& component, std::chrono::nanoseconds timeout) {
  std::shared_ptr<Component> removed;
  {
    const auto lock = Lock();
    const auto found = Require(component);
    if (!found) return found.error();
    removed = *found;
  }
  const SteadyTime deadline = DeadlineAfter(timeout);
  (void)requests_->StopInOrder(
      [&](const Component& one) { return &one == removed.get() || RunsAfter(one, *removed); },
      std::min<SteadyTime>(deadline, SteadyClock().Now() + kEndTimeout));
  {
    const auto lock = Lock();
    if (Find(component) != removed.get()) {
      return Error{ErrorCode::kNotFound,
                   "component '" + component + "' was removed by another request"};
    }
    OnRemoving(*removed);  // also removes pending connections
    DisconnectAll(component);
  }
  if (!removed->is_at_rest() && !removed->is_stopping()) {
    (void)requests_->RequestStop(removed, deadline);
  }
  Result<void> stopped;
  if (!removed->is_at_rest()) {
    stopped = removed->WaitFor(ComponentState::kFinished,
                               std::max(kNoWait, deadline - SteadyClock().Now()));
  }
  if (!removed->is_at_rest()) {
    return Error{ErrorCode::kTimeout,
                 "component '" + component + "' is not removed, because it runs" +
                     (stopped ? std::string(" again") : ": " + stopped.error().message)};
  }
  const auto taken = Retry(std::max(kNoWait, deadline - SteadyClock().Now()),
                           [&](SteadyTime last) { return TryTakeOut(removed, last); });
  if (!taken) return taken;
  removed.reset();
  NotifyChanged();
  return {};
}

Result<void> LocalManager::TryTakeOut(const std::shared_ptr<Component>& component,
                                      SteadyTime deadline) {
  if (const auto none = requests_->RequireNoRequest(*component); !none) return none;
  if (!component->is_at_rest()) {
    return Error{ErrorCode::kFailed,
                 "component '" + component->name() + "' is not removed, because it runs again"};
  }
  if (auto* task = dynamic_cast<Task*>(component.get())) {
    if (const auto left = task->LeaveLeader(deadline); !left) {
      return Error{left.error().code,
                   "component '" + component->name() + "' is not removed: " + left.error().message};
    }
  }
  Detach(*component);  // again, because other threads may have made connections
  std::erase_if(entries_, [&](const Entry& one) { return one.component == component; });
  return {};
}

void LocalManager::Attach(Component& component) {
  component.SetStateObserver([this] { NotifyChanged(); });
  if (const auto* task = dynamic_cast<const Task*>(&component)) watchdog_.Watch(*task);
  OnAttached(component);
}

void LocalManager::Detach(Component& component) {
  OnDetached(component);
  OnRemoving(component);
  DisconnectAll(component.name());
  component.SetStateObserver(nullptr);
  watchdog_.Forget(component);
}

Result<void> LocalManager::Retry(std::chrono::nanoseconds timeout,
                                 const std::function<Result<void>(SteadyTime)>& attempt) {
  constexpr std::chrono::milliseconds kAtOnce(20);
  const SteadyTime deadline = DeadlineAfter(timeout);
  while (true) {
    Result<void> done;
    bool is_last = false;
    {
      const auto lock = Lock();
      const SteadyTime now = SteadyClock().Now();
      is_last = now >= deadline;
      done = attempt(std::min<SteadyTime>(deadline, now + kAtOnce));
    }
    if (done || done.error().code != ErrorCode::kTimeout || is_last) return done;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

Result<ConnectionId> LocalManager::Connect(const InterfaceName& required,
                                           const InterfaceName& provided) {
  const auto joined = [&] {
    const auto lock = Lock();
    return Join(required, provided);
  }();
  if (joined) NotifyChanged();
  return joined;
}

Result<ConnectionId> LocalManager::Join(const InterfaceName& required,
                                        const InterfaceName& provided) {
  const auto client = FindRequired(required);
  if (!client) return client.error();
  const auto server = FindProvided(provided);
  if (!server) return server.error();
  auto connection = Connection::Make(**client, **server, ToString(required), ToString(provided));
  if (!connection) return connection.error();
  const ConnectionId id = NextConnectionId();
  connections_[id] = {.description = {.id = id,
                                      .required = required,
                                      .provided = provided,
                                      .state = ConnectionState::kActive,
                                      .reason = {},
                                      .converted = (*connection)->converted()},
                      .connection = std::move(*connection)};
  return id;
}

Result<void> LocalManager::Disconnect(const InterfaceName& required) {
  {
    const auto lock = Lock();
    const auto client = FindRequired(required);
    if (!client) return client.error();
    const auto found = FindConnection(required);
    if (!found) {
      return Error{ErrorCode::kNotFound,
                   found.error().message + ": there is nothing to disconnect"};
    }
    Close(connections_.at(*found), kDrainTimeout);
    connections_.erase(*found);
  }
  NotifyChanged();
  return {};
}

Result<ConnectionCounts> LocalManager::Counts(const InterfaceName& required) const {
  const auto lock = Lock();
  const auto found = FindConnection(required);
  if (!found) return found.error();
  return CountsOf(*connections_.at(*found).connection);
}

Result<MailboxFill> LocalManager::FillOf(const std::string& component) const {
  const auto lock = Lock();
  const auto found = Require(component);
  if (!found) return found.error();
  const Inbox::Fill fill = (*found)->mailbox_fill();
  return MailboxFill{.waiting = fill.waiting, .capacity = fill.capacity};
}

Result<ConnectionId> LocalManager::FindConnection(const InterfaceName& required) const {
  const auto client = FindRequired(required);
  if (!client) return client.error();
  for (const auto& [id, connection] : connections_) {
    const InterfaceName& name = connection.description.required;
    if (name.component == required.component && name.interface == required.interface) return id;
  }
  return Error{ErrorCode::kNotFound, ToString(required) + " is not connected"};
}

void LocalManager::Close(const LocalConnection& connection, std::chrono::milliseconds timeout) {
  const std::size_t dropped = connection.connection->Close(timeout);
  if (dropped == 0) return;
  const ConnectionDescription& ends = connection.description;
  Log(LogLevel::kWarning, ends.required.component,
      "the disconnect of " + ToString(ends.required) + " from " + ToString(ends.provided) +
          " has dropped " + std::to_string(dropped) + " calls and events that were not executed");
}

Result<void> LocalManager::RunAfter(const std::string& component, const std::string& leader,
                                    std::chrono::nanoseconds timeout) {
  const auto done =
      Retry(timeout, [&](SteadyTime deadline) { return TryRunAfter(component, leader, deadline); });
  if (done) NotifyChanged();
  return done;
}

Result<void> LocalManager::TryRunAfter(const std::string& component, const std::string& leader,
                                       SteadyTime deadline) {
  const auto follower = Require(component);
  if (!follower) return follower.error();
  const auto first = Require(leader);
  if (!first) return first.error();
  auto* task = dynamic_cast<ThreadedTask*>(follower->get());
  auto* leading = dynamic_cast<Task*>(first->get());
  if (task == nullptr || leading == nullptr) {
    return Error{ErrorCode::kFailed, "component '" + component + "' cannot run after '" + leader +
                                         "': '" +
                                         (task == nullptr ? component + "' has no thread"
                                                          : leader + "' does not run in cycles")};
  }
  if (const auto none = requests_->RequireNoRequest(*task); !none) return none;
  return task->RunAfter(*leading, deadline);
}

Result<void> LocalManager::Start(const std::string& component, std::chrono::nanoseconds timeout) {
  return requests_->Start(component, timeout);
}

Result<void> LocalManager::Start(const std::string& component, std::chrono::nanoseconds timeout,
                                 std::function<bool()> proceed) {
  return requests_->Start(component, timeout, std::move(proceed));
}

Result<void> LocalManager::Suspend(const std::string& component, std::chrono::nanoseconds timeout) {
  return requests_->Suspend(component, timeout);
}

Result<void> LocalManager::Stop(const std::string& component, std::chrono::nanoseconds timeout) {
  return requests_->Stop(component, timeout);
}

Result<void> LocalManager::TransitionTo(const std::string& component, ComponentState wanted,
                                        std::chrono::nanoseconds timeout) {
  return requests_->TransitionTo(component, wanted, timeout);
}

Result<void> LocalManager::StartAll(std::chrono::nanoseconds timeout) {
  return requests_->StartAll(timeout);
}

Result<void> LocalManager::SuspendAll(std::chrono::nanoseconds timeout) {
  return requests_->SuspendAll(timeout);
}

Result<void> LocalManager::StopAll(std::chrono::nanoseconds timeout) {
  return requests_->StopAll(timeout);
}

Result<void> LocalManager::WaitFor(const std::string& component, ComponentState state,
                                   std::chrono::nanoseconds timeout) {
  return requests_->WaitFor(component, state, timeout);
}

Result<void> LocalManager::WaitForAll(ComponentState state, std::chrono::nanoseconds timeout) {
  return requests_->WaitForAll(state, timeout);
}

void LocalManager::EndAll(SteadyTime deadline) {
  const auto ended =
      requests_->StopInOrder([](const Component& /*one*/) { return true; }, deadline);
  if (ended) return;
  Log(LogLevel::kWarning, "manager", "the shutdown is not complete: " + ended.error().message);
}

/// Ignores servers whose calls this thread executes, because they execute nothing while this thread
/// waits.
bool LocalManager::HasCallsUnderWay(const Component& client) const {
  const auto lock = Lock();
  return std::ranges::any_of(connections_, [&](const auto& one) {
    const ConnectionDescription& ends = one.second.description;
    if (ends.required.component != client.name()) return false;
    if (one.second.connection->waiting() == 0) return false;
    const auto server = FindProvided(ends.provided);
    const Inbox* const inbox = server ? (*server)->inbox() : nullptr;
    return inbox != nullptr && inbox->accepting() && inbox->IsForeignThread();
  });
}

ComponentOrder LocalManager::Order() const {
  ComponentOrder::Components components;
  for (const Entry& entry : entries_) components.push_back(entry.component);
  ComponentOrder order(std::move(components));
  for (const auto& [id, connection] : connections_) {
    const ConnectionDescription& ends = connection.description;
    order.AddConnection(ends.required.component, ends.provided.component);
  }
  return order;
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
  for (const auto& [id, connection] : connections_) {
    all.push_back(connection.description);
    for (const InterfaceName& end : {all.back().required, all.back().provided}) {
      const Component* const component = Find(end.component);
      if (component == nullptr || component->state() != ComponentState::kFaulted) continue;
      SetEndFaulted(all.back(), end.component, component->fault());
    }
  }
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
  if ((*component)->FindProvided(name.interface) != nullptr) {
    return OtherSide(name, "provided", "required");
  }
  return NoInterface("required", name, Names((*component)->required()));
}

Result<ProvidedInterface*> LocalManager::FindProvided(const InterfaceName& name) const {
  const auto component = Require(name.component);
  if (!component) return component.error();
  ProvidedInterface* found = (*component)->FindProvided(name.interface);
  if (found != nullptr) return found;
  if ((*component)->FindRequired(name.interface) != nullptr) {
    return OtherSide(name, "required", "provided");
  }
  return NoInterface("provided", name, Names((*component)->provided()));
}

std::unique_lock<std::recursive_mutex> LocalManager::Lock() const {
  return std::unique_lock(mutex_);
}

std::unique_lock<std::recursive_mutex> LocalManager::TryLock() const {
  return std::unique_lock(mutex_, std::try_to_lock);
}

void LocalManager::NotifyChanged() const {
  const std::scoped_lock lock(observer_mutex_);
  if (observer_) observer_();
}

ComponentDescription LocalManager::Describe(const Entry& entry) const {
  const Component& component = *entry.component;
  ComponentDescription description{
      .name = component.name(),
      .class_name = entry.origin.class_name,
      .library = entry.origin.library,
      .configuration = entry.origin.configuration,
      .state = component.state(),
      .fault = component.fault(),
      .fault_time = std::chrono::nanoseconds(component.fault_time().time_since_epoch()).count(),
      .warning = watchdog_.WarningOf(component),
      .period = component.period(),
      .thread = {},
      .leader = {},
      .provided = component.provided(),
      .required = component.required(),
      .tables = {}};
  if (const auto* task = dynamic_cast<const ThreadedTask*>(&component)) {
    description.thread.push_back(task->thread_options());
  }
  if (const auto* task = dynamic_cast<const Task*>(&component); task && task->leader()) {
    description.leader = task->leader()->name();
  }
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

Result<std::shared_ptr<Component>> LocalManager::Require(const std::string& component) const {
  const auto lock = Lock();
  for (const Entry& entry : entries_) {
    if (entry.component->name() == component) return entry.component;
  }
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
    const ConnectionDescription& ends = one.second.description;
    const bool is_meant =
        ends.required.component == component || ends.provided.component == component;
    if (is_meant) Close(one.second, std::chrono::milliseconds(0));
    return is_meant;
  });
}

Result<RunSettings> LocalManager::SettingsOf(const std::string& component) const {
  const auto lock = Lock();
  const auto found = Require(component);
  if (!found) return found.error();
  RunSettings settings{.is_at_rest = (*found)->is_at_rest()};
  if (const auto* task = dynamic_cast<const ThreadedTask*>(found->get())) {
    settings.thread = task->thread_options();
  }
  for (const Entry& entry : entries_) {
    const auto* task = dynamic_cast<const Task*>(entry.component.get());
    const Task* const leader = task == nullptr ? nullptr : task->leader();
    if (leader == nullptr) continue;
    if (task == found->get()) settings.leader = leader->name();
    if (leader == found->get()) settings.followers.push_back(task->name());
  }
  return settings;
}

Result<void> LocalManager::Replace(std::unique_ptr<Component> component, ComponentOrigin origin,
                                   std::chrono::nanoseconds timeout) {
  if (!component) throw ConfigurationError("LocalManager::Replace: null component");
  Entry given = MakeEntry(std::move(component), std::move(origin));
  const auto replaced =
      Retry(timeout, [&](SteadyTime deadline) { return TryReplace(given, deadline); });
  if (replaced) NotifyChanged();
  return replaced;
}

/// Makes all checks that can fail before it changes anything.
Result<void> LocalManager::TryReplace(Entry& given, SteadyTime deadline) {
  Component& made = *given.component;
  const std::string& name = made.name();
  const auto present = Require(name);
  if (!present) return present.error();
  Component& former = **present;
  if (const auto none = requests_->RequireNoRequest(former); !none) return none;
  if (!former.is_at_rest()) return NotReplaced(name, "it runs; stop it first");
  const auto settings = SettingsOf(name);
  if (!settings->followers.empty()) {
    return NotReplaced(name, "'" + settings->followers.front() + "' runs after it");
  }
  if (const auto leader = Require(settings->leader)) {
    auto* const follower = dynamic_cast<ThreadedTask*>(&made);
    if (follower == nullptr) {
      return NotReplaced(name, "the new component has no thread, so it cannot run after '" +
                                   settings->leader + "'");
    }
    const auto left = dynamic_cast<Task&>(former).LeaveLeader(deadline);
    if (!left) return left;
    const auto joined = follower->RunAfter(dynamic_cast<Task&>(**leader));
    if (!joined) return joined;
  }
  ReplaceEntry(given, former);
  return {};
}

void LocalManager::ReplaceEntry(Entry& given, Component& former) {
  const std::string& name = former.name();
  std::vector<ConnectionDescription> own;
  for (const auto& [id, connection] : connections_) {
    const ConnectionDescription& ends = connection.description;
    if (ends.required.component == name || ends.provided.component == name) own.push_back(ends);
  }
  Detach(former);
  const auto place =
      std::ranges::find(entries_, &former, [](const Entry& one) { return one.component.get(); });
  std::swap(*place, given);
  Attach(*place->component);
  for (const ConnectionDescription& ends : own) (void)Join(ends.required, ends.provided);
}

}  // namespace tendon
