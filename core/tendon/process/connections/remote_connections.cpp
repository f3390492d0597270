#include <tendon/process/connections/remote_connections.h>

#include <tendon/base/log.h>
#include <tendon/base/name.h>
#include <tendon/process/ask.h>

#include <algorithm>
#include <utility>

namespace tendon {
namespace {

constexpr std::chrono::milliseconds kOpenTimeout(1000);

void LogConnection(LogLevel level, const ConnectionDescription& connection,
                   const std::string& what) {
  Log(level, "connection",
      ToString(connection.required) + " to " + ToString(connection.provided) + " " + what);
}

}  // namespace

void RemoteConnections::Connect(const message::ConnectionEnds& ends, Done done) {
  const auto id = Enter(ends, done);
  if (!id) return done(id.error());
  Try(*id);
}

Result<ConnectionId> RemoteConnections::Enter(const message::ConnectionEnds& ends,
                                              const Done& done) {
  const auto lock = context_.process.LockStructure();
  const auto required = context_.process.LookUpRequired(ends.required);
  if (!required) return required.error();
  const auto known = FindEntry(ends.required);
  if (known != entries_.end() && known->second.connection == nullptr) {
    return Error{ErrorCode::kExists, ToString(ends.required) + " waits to be connected to " +
                                         ToString(known->second.description.provided) +
                                         " already; end that connection first"};
  }
  if ((*required)->is_connected() || known != entries_.end()) {
    return AlreadyConnected(ToString(ends.required));
  }
  const ConnectionId id = context_.process.NewConnectionId();
  Entry& entry = entries_[id];
  entry.description = {.id = id,
                       .required = ends.required,
                       .provided = ends.provided,
                       .state = ConnectionState::kPending,
                       .reason = "process '" + ends.provided.process + "' has not answered yet"};
  entry.since = SteadyClock().Now();
  entry.done = done;
  return id;
}

void RemoteConnections::UpdatePeers(const std::vector<ProcessDescription>& processes) {
  peers_.Update(processes);
  peers_.CloseOutdated();
  TryPossible();
}

void RemoteConnections::LearnPeer(const std::string& process, const std::string& address,
                                  std::uint64_t instance) {
  peers_.Learn(process, address, instance);
}

void RemoteConnections::TryPossible() {
  std::vector<ConnectionId> possible;
  {
    const auto lock = context_.process.LockStructure();
    for (auto& [id, entry] : entries_) {
      const auto instance = peers_.InstanceOf(entry.description.provided.process);
      if (!instance || entry.is_opening) continue;
      const ConnectionState state = entry.description.state;
      const bool is_news = state == ConnectionState::kFailed && entry.refused_by != *instance;
      if (state != ConnectionState::kPending && !is_news) continue;
      entry.backoff.Reset();
      possible.push_back(id);
    }
  }
  for (const ConnectionId id : possible) Try(id);
}

void RemoteConnections::Try(ConnectionId id) {
  std::string process;
  std::uint64_t attempt = 0;
  bool is_first = false;
  bool is_there = false;
  {
    const auto lock = context_.process.LockStructure();
    const auto found = entries_.find(id);
    if (found == entries_.end() || found->second.connection || found->second.is_opening) return;
    Entry& entry = found->second;
    attempt = ++entry.attempt;
    process = entry.description.provided.process;
    is_first = entry.done != nullptr;
    is_there = entry.is_opening = peers_.InstanceOf(process).has_value();
  }
  if (!is_there) {  // UpdatePeers() tries again
    if (is_first) {
      Postpone(id, "process '" + process +
                       "' is not available; the connection is made when this process joins" +
                       DidYouMean(process, peers_.names()));
    }
    return;
  }
  peers_.LinkTo(process, [this, id, attempt](const auto& link) {
    if (!IsNewest(id, attempt)) return;
    link ? Request(id, *link) : Postpone(id, link.error().message);
  });
  if (!is_first) return;
  context_.worker->PostAfter(kOpenTimeout, [this, id, attempt] { ReportPending(id, attempt); });
}

/// Reports that the connection is pending, because the attempt may have to wait for links to
/// hanging processes.
void RemoteConnections::ReportPending(ConnectionId id, std::uint64_t attempt) {
  Done done;
  ConnectionDescription description;
  {
    const auto lock = context_.process.LockStructure();
    const auto found = entries_.find(id);
    if (found == entries_.end() || found->second.attempt != attempt || found->second.link) return;
    done = std::exchange(found->second.done, nullptr);
    description = found->second.description;
  }
  if (done) done(description);
}

void RemoteConnections::Request(ConnectionId id, const std::shared_ptr<PeerLink>& link) {
  // The limits of the executor's queue: the events of a few messages.
  constexpr std::size_t kMaxEvents = 4096;
  constexpr std::size_t kMaxEventBytes = std::size_t{64} << 20U;
  InterfaceRequest wanted;
  Attempt attempt{.id = id, .number = 0, .link = link, .handle = 0};
  {
    const auto lock = context_.process.LockStructure();
    const auto found = entries_.find(id);
    if (found == entries_.end()) return;
    Entry& entry = found->second;
    const auto required = context_.process.LookUpRequired(entry.description.required);
    entry.is_opening = required.ok();
    if (!required) return;
    wanted = {.open = {.required = entry.description.required,
                       .provided = entry.description.provided,
                       .description = (*required)->description(),
                       .handle = 0,
                       .capacity = static_cast<std::uint32_t>((*required)->mailbox_capacity()),
                       .latest_only = (*required)->latest_only()},
              .read_deadline = (*required)->read_deadline(),
              .mirrored = (*required)->mirrored(),
              .executor = (*required)->handles_in_raiser()
                              ? context_.calls->events.MakeExecutor(kMaxEvents, kMaxEventBytes)
                              : nullptr};
    wanted.open.handle = link->handles().Reserve(wanted.open.description.event_handlers.size());
    entry.link = link;
    entry.handle = attempt.handle = wanted.open.handle;
    attempt.number = entry.attempt;
  }
  // The reply is needed even after GiveUp(), because it contains the handle with which
  // CloseThere() closes the interface at the peer.
  OpenProvided(context_.network, link, wanted,
               [this, worker = context_.worker, attempt](const OpenedInterface& opened) {
                 worker->Post([this, attempt, opened] { Finish(attempt, opened); });
               });
  context_.worker->PostAfter(
      kOpenTimeout, [this, id, number = attempt.number, peer = link->channel()->peer().name] {
        GiveUp(id, number, NoReply(peer, kOpenTimeout));
      });
}

void RemoteConnections::GiveUp(ConnectionId id, std::uint64_t attempt, const Error& reason) {
  {
    const auto lock = context_.process.LockStructure();
    const auto found = entries_.find(id);
    if (found == entries_.end() || found->second.attempt != attempt) return;
    if (!found->second.is_opening) return;
  }
  Postpone(id, reason.message);
}

void RemoteConnections::Finish(const Attempt& attempt, const OpenedInterface& opened) {
  Result<void> outcome;
  Done done;
  ConnectionDescription description;
  {
    const auto lock = context_.process.LockStructure();
    const auto found = entries_.find(attempt.id);
    const bool is_void = found == entries_.end() || found->second.attempt != attempt.number;
    if (is_void) {
      attempt.link->handles().Remove(attempt.handle);
      if (opened) CloseThere(attempt.link->channel(), (*opened)->handle(), (*opened)->lane());
      return;
    }
    Entry& entry = found->second;
    entry.is_opening = false;
    outcome = opened ? Bind(entry, *opened) : opened.error();
    if (outcome) {
      done = std::exchange(entry.done, nullptr);
      description = entry.description;
    }
  }
  if (!outcome) {
    return IsFinal(outcome.error().code) ? Refuse(attempt.id, outcome.error())
                                         : Postpone(attempt.id, outcome.error().message);
  }
  context_.process.StructureChanged();
  if (done) done(description);
}

Result<void> RemoteConnections::Bind(Entry& entry,
                                     const std::shared_ptr<ProvidedInterfaceProxy>& proxy) {
  ConnectionDescription& description = entry.description;
  const auto required = context_.process.LookUpRequired(description.required);
  // The proxy is added before Make(), because a component may make a call at once, and Make() waits
  // until the call is executed.
  context_.proxies.Add(description.provided, proxy);
  auto connection =
      required ? Connection::Make(**required, proxy->interface(), ToString(description.required),
                                  ToString(description.provided))
               : required.error();
  if (!connection) {
    context_.proxies.Remove(description.provided, *proxy);
    CloseThere(entry.link->channel(), proxy->handle(), proxy->lane());
    return connection.error();
  }
  entry.connection = *std::move(connection);
  entry.proxy = proxy;
  description.state = ConnectionState::kActive;
  description.reason.clear();
  entry.backoff.Reset();
  LogConnection(LogLevel::kInfo, description, "is active");
  return {};
}

void RemoteConnections::Postpone(ConnectionId id, const std::string& reason) {
  Done done;
  ConnectionDescription description;
  {
    const auto lock = context_.process.LockStructure();
    const auto found = entries_.find(id);
    if (found == entries_.end()) return;
    Suspend(found->second, reason);
    done = std::exchange(found->second.done, nullptr);
    description = found->second.description;
  }
  context_.process.StructureChanged();
  if (done) done(description);
}

void RemoteConnections::Refuse(ConnectionId id, const Error& error) {
  Done done;
  {
    const auto lock = context_.process.LockStructure();
    const auto found = entries_.find(id);
    if (found == entries_.end()) return;
    Entry& entry = found->second;
    done = std::exchange(entry.done, nullptr);
    entry.refused_by = entry.link->instance();
    entry.since = SteadyClock().Now();
    entry.description.state = ConnectionState::kFailed;
    entry.description.reason = error.message;
    TakeDown(entry, {});
    if (done) {
      entries_.erase(found);
    } else {
      LogConnection(LogLevel::kWarning, entry.description, "is refused: " + error.message);
    }
  }
  context_.process.StructureChanged();
  if (done) done(error);
}

void RemoteConnections::OnLinkClosed(const PeerLink& link, const Error& reason) {
  {
    const auto lock = context_.process.LockStructure();
    for (auto& [id, entry] : entries_) {
      if (entry.link.get() != &link || !entry.connection) continue;
      Suspend(entry,
              "process '" + entry.description.provided.process + "' was lost: " + reason.message);
    }
  }
  context_.process.StructureChanged();
}

void RemoteConnections::OnInterfaceClosed(const PeerLink& link, std::uint32_t handle,
                                          const Error& reason) {
  {
    const auto lock = context_.process.LockStructure();
    for (auto& [id, entry] : entries_) {
      if (entry.link.get() != &link || entry.handle != handle) continue;
      Suspend(entry, reason.message);
    }
  }
  context_.process.StructureChanged();
}

/// Makes the connection pending. Another attempt follows later.
void RemoteConnections::Suspend(Entry& entry, const std::string& reason) {
  if (entry.connection) {
    LogConnection(LogLevel::kWarning, entry.description,
                  "is lost, and will be restored: " + reason);
  }
  TakeDown(entry, {});
  if (entry.description.state != ConnectionState::kPending) entry.since = SteadyClock().Now();
  entry.description.state = ConnectionState::kPending;
  entry.description.reason = reason;
  context_.worker->PostAfter(entry.backoff.Next(),
                             [this, id = entry.description.id, number = entry.attempt] {
                               if (IsNewest(id, number)) Try(id);
                             });
}

bool RemoteConnections::IsNewest(ConnectionId id, std::uint64_t attempt) const {
  const auto lock = context_.process.LockStructure();
  const auto found = entries_.find(id);
  return found != entries_.end() && found->second.attempt == attempt;
}

/// Closes the connection. Outcomes of earlier attempts are ignored from now on.
void RemoteConnections::TakeDown(Entry& entry, SteadyTime deadline) {
  ++entry.attempt;
  entry.is_opening = false;
  if (entry.proxy) entry.proxy->DrainEvents(deadline);
  if (entry.connection) entry.connection->Close(TimeUntil(deadline));
  entry.connection.reset();
  if (entry.proxy) {
    context_.proxies.Remove(entry.description.provided, *entry.proxy);
    entry.proxy->SendRest(TimeUntil(deadline));
    CloseThere(entry.link->channel(), entry.proxy->handle(), entry.proxy->lane());
  }
  if (entry.link) entry.link->handles().Remove(entry.handle);
  entry.proxy.reset();
  entry.link.reset();
}

/// Asks the peer to close its end of the connection. The notice is sent on the lane of the calls,
/// so it arrives after all earlier calls. The peer keeps the connection until then.
void RemoteConnections::CloseThere(const std::shared_ptr<Channel>& channel, std::uint32_t handle,
                                   Lane lane) {
  NotifyUntilSent(context_.worker, channel, message::kCloseInterface, handle, lane);
}

bool RemoteConnections::Has(const InterfaceName& required) const {
  const auto lock = context_.process.LockStructure();
  return FindEntry(required) != entries_.end();
}

Result<void> RemoteConnections::Disconnect(const InterfaceName& required) {
  Done done;
  {
    const auto lock = context_.process.LockStructure();
    const auto found = FindEntry(required);
    if (found == entries_.end()) {
      return Error{ErrorCode::kNotFound,
                   ToString(required) + " is not connected: there is nothing to disconnect"};
    }
    auto ended = entries_.extract(found);
    done = std::move(ended.mapped().done);
    TakeDown(ended.mapped(), SteadyClock().Now() + LocalManager::kDrainTimeout);
  }
  context_.process.StructureChanged();
  if (done) {  // called on the worker, because this thread may hold the lock
    context_.worker->Post([done, required] {
      done(Error{ErrorCode::kFailed,
                 ToString(required) + " was disconnected before the connection was made"});
    });
  }
  return {};
}

void RemoteConnections::RemoveComponent(const std::string& component) {
  std::vector<InterfaceName> concerned;
  const auto lock = context_.process.LockStructure();
  for (const auto& [id, entry] : entries_) {
    const InterfaceName& required = entry.description.required;
    if (required.component == component) concerned.push_back(required);
  }
  for (const InterfaceName& required : concerned) (void)Disconnect(required);
}

Result<ConnectionCounts> RemoteConnections::Counts(const InterfaceName& required) const {
  const auto lock = context_.process.LockStructure();
  const auto found = FindEntry(required);
  if (found == entries_.end()) {
    return Error{ErrorCode::kNotFound, ToString(required) + " is not connected"};
  }
  const Entry& entry = found->second;
  if (!entry.connection) {
    const ConnectionDescription& one = entry.description;
    const std::chrono::duration<double> age = SteadyClock().Now() - entry.since;
    return Error{ErrorCode::kFailed, "the connection of " + ToString(required) + " is " +
                                         std::string(ToString(one.state)) + " for " +
                                         std::to_string(static_cast<std::int64_t>(age.count())) +
                                         " s: " + one.reason};
  }
  ConnectionCounts counts = CountsOf(*entry.connection);
  counts.round_trip = entry.link->round_trip();
  return counts;
}

std::vector<ConnectionDescription> RemoteConnections::descriptions() const {
  const auto lock = context_.process.LockStructure();
  std::vector<ConnectionDescription> all;
  for (const auto& [id, entry] : entries_) {
    ConnectionDescription& one = all.emplace_back(entry.description);
    if (!entry.connection) continue;
    const Component* const client = context_.process.LookUpComponent(one.required.component);
    const std::string fault = entry.proxy->fault();
    if (client != nullptr && client->state() == ComponentState::kFaulted) {
      SetEndFaulted(one, one.required.component, client->fault());
    } else if (!fault.empty()) {
      SetEndFaulted(one, one.provided.component, fault);
    }
  }
  return all;
}

bool RemoteConnections::HasCallsUnderWay(const std::string& component) const {
  const auto lock = context_.process.LockStructure();
  return std::ranges::any_of(entries_, [&component](const auto& one) {
    const Entry& entry = one.second;
    if (!entry.connection || entry.description.required.component != component) return false;
    return entry.proxy->HasCallsUnderWay(*entry.connection);
  });
}

void RemoteConnections::Close(SteadyTime deadline) {
  const auto lock = context_.process.LockStructure();
  for (auto& [id, entry] : entries_) TakeDown(entry, deadline);
  entries_.clear();
  peers_.CloseAll();
}

RemoteConnections::Entries::const_iterator RemoteConnections::FindEntry(
    const InterfaceName& required) const {
  return std::find_if(entries_.begin(), entries_.end(), [&required](const auto& one) {
    return one.second.description.required == required;
  });
}

}  // namespace tendon
