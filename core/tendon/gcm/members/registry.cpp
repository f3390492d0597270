#include <tendon/gcm/members/registry.h>

#include <tendon/base/os/process.h>
#include <tendon/base/text.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/members/sanitize.h>
#include <tendon/gcm/text.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/membership/advertised_address.h>

#include <algorithm>

namespace tendon::server {
namespace {

using Kind = CatalogueChange::Kind;

/// Returns how many cores a process has used on average between two reports. The time is measured
/// with the clock of the process. Negative if the reports are inconsistent.
double CoresBetween(const message::Health& before, const message::Health& after) {
  const double passed = static_cast<double>(after.time) - static_cast<double>(before.time);
  const double used = static_cast<double>(after.cpu_time) - static_cast<double>(before.cpu_time);
  return passed > 0.0 && used >= 0.0 ? used / passed : -1.0;
}

/// Returns true if the catalogue already contains the result of the change. This change is dropped
/// and makes no new revision.
bool ChangesNothing(const CatalogueChange& change, const ProcessEntry* entry) {
  if (entry == nullptr) return false;
  switch (change.kind) {
    case Kind::kProcess:
      return entry->process == change.processes.front();
    case Kind::kComponent: {
      const auto found = entry->components.find(change.components.front().name);
      return found != entry->components.end() && found->second == change.components.front();
    }
    case Kind::kConnection: {
      const auto found = entry->connections.find(change.connections.front().id);
      return found != entry->connections.end() && found->second == change.connections.front();
    }
    case Kind::kComponentRemoved:
      return !entry->components.contains(change.component);
    case Kind::kConnectionRemoved:
      return !entry->connections.contains(change.connection);
    case Kind::kProcessRemoved:
      return false;
  }
  return false;
}

/// Returns the changes that remove the connections and components that are in the catalogue but not
/// in `join`.
std::vector<CatalogueChange> Removals(const ProcessEntry& before, const message::Join& join) {
  std::vector<CatalogueChange> changes;
  for (const auto& [id, connection] : before.connections) {
    const bool stays = std::any_of(join.connections.begin(), join.connections.end(),
                                   [&id = id](const auto& one) { return one.id == id; });
    if (stays) continue;
    changes.push_back(
        {.kind = Kind::kConnectionRemoved, .process = join.process.name, .connection = id});
  }
  for (const auto& [name, component] : before.components) {
    const bool stays = std::any_of(join.components.begin(), join.components.end(),
                                   [&name = name](const auto& one) { return one.name == name; });
    if (stays) continue;
    changes.push_back(
        {.kind = Kind::kComponentRemoved, .process = join.process.name, .component = name});
  }
  return changes;
}

}  // namespace

Result<Registry::Admission> Registry::Join(message::Join join, SessionToken held,
                                           std::shared_ptr<Channel> channel) {
  if (auto taken = Sanitize(join); !taken) return taken.error();
  for (ComponentDescription& component : join.components) pool_.Share(component);
  Admission admission;
  if (const Member* holder = FindByName(join.process.name)) {
    if (holder->session != held || holder->instance != join.process.instance) {
      return NameInUse(*holder);
    }
    admission.replaced = holder->channel;
    members_.erase(held);
  }
  do {
    admission.session = os::RandomNumber();
  } while (admission.session == 0 || members_.contains(admission.session));
  const std::int64_t now = WallTime();
  const std::string link = channel ? channel->peer_address() : std::string();
  members_[admission.session] = {.name = join.process.name,
                                 .instance = join.process.instance,
                                 .session = admission.session,
                                 .channel = std::move(channel),
                                 .link = link,
                                 .renewed = clock_.Now(),
                                 .joined = now,
                                 .health = {},
                                 .reported = {}};
  tombstones_.erase(join.process.name);
  expected_.erase(join.process.name);
  Enter(join, link, now);
  return admission;
}

/// Replaces the entry of a process in the catalogue by the data with which it joins.
void Registry::Enter(const message::Join& join, const std::string& link, std::int64_t now) {
  const std::string& name = join.process.name;
  ProcessDescription process = join.process;
  process.state = ProcessState::kAlive;
  process.reason = WhyOutOfReach(process.address, link);
  process.since = now;
  // A process that kept running still has its connections, so nothing is restored. For a new
  // instance, the connections of the old instance are restored.
  const ProcessEntry* before = catalogue_.FindProcess(name);
  if (before != nullptr && before->process.instance == process.instance) restorer_.Drop(name);
  Apply({.kind = Kind::kProcess, .process = name, .processes = {process}});
  for (CatalogueChange& change : Removals(*catalogue_.FindProcess(name), join)) {
    Apply(std::move(change));
  }
  for (const auto& component : join.components) {
    Apply({.kind = Kind::kComponent, .process = name, .components = {component}});
  }
  for (const auto& connection : join.connections) {
    Apply({.kind = Kind::kConnection, .process = name, .connections = {connection}});
  }
}

Result<void> Registry::Report(SessionToken session, message::Report report) {
  const Member* member = Find(session);
  if (member == nullptr)
    return Error{ErrorCode::kDenied, "the report belongs to a membership that has ended"};
  Result<void> result;
  for (CatalogueChange& change : report.changes) {
    if (auto taken = Sanitize(change, member->name); !taken) {
      if (result) result = taken;
      continue;
    }
    for (ComponentDescription& component : change.components) pool_.Share(component);
    if (change.kind == Kind::kProcess) {
      ProcessDescription process = catalogue_.FindProcess(member->name)->process;
      process.address = change.processes.front().address;
      process.host = change.processes.front().host;
      process.pid = change.processes.front().pid;
      if (process.state == ProcessState::kAlive) {
        process.reason = WhyOutOfReach(process.address, member->link);
      }
      process.plugins = std::move(change.processes.front().plugins);
      change.processes.front() = process;
    }
    Apply(std::move(change));
  }
  return result;
}

Result<void> Registry::Renew(SessionToken session) {
  Member* member = Find(session);
  if (member == nullptr) {
    return Error{ErrorCode::kDenied, "this membership has ended: join the GCM again"};
  }
  member->renewed = clock_.Now();
  const ProcessDescription& process = catalogue_.FindProcess(member->name)->process;
  if (process.state == ProcessState::kSuspect) {
    SetState(member->name, ProcessState::kAlive, WhyOutOfReach(process.address, member->link));
  }
  return {};
}

Result<void> Registry::UpdateHealth(SessionToken session, const message::Health& health) {
  Member* member = Find(session);
  if (member == nullptr) return Error{ErrorCode::kDenied, "this membership has ended"};
  if (member->health) member->cpu = CoresBetween(*member->health, health);
  member->health = health;
  member->reported = clock_.Now();
  return {};
}

message::SystemHealth Registry::health() const {
  message::SystemHealth health;
  for (const auto& [session, member] : members_) {
    if (!member.health) continue;
    health.processes.push_back({.process = member.name,
                                .instance = member.instance,
                                .cpu = member.cpu,
                                .memory = member.health->memory,
                                .clock_offset = member.health->clock_offset,
                                .clock_uncertainty = member.health->clock_uncertainty,
                                .age = clock_.Now() - member.reported});
  }
  std::ranges::sort(health.processes, {}, &message::ProcessHealth::process);
  return health;
}

void Registry::End(SessionToken session, ProcessState state, const std::string& reason) {
  const auto found = members_.find(session);
  if (found == members_.end()) return;
  const std::string name = found->second.name;
  const auto silence = clock_.Now() - found->second.renewed;
  members_.erase(found);
  restorer_.Keep(catalogue_, name);
  tombstones_[name] = clock_.Now();
  // The middleware may close the link of a hanging process before its lease ends. Even then, the
  // reason must say that the process was silent.
  const bool was_silent = state == ProcessState::kLost && silence >= leases_.suspect_after &&
                          !reason.starts_with(kNoRenewal);
  const std::string before =
      was_silent ? std::string(kNoRenewal) + Milliseconds(silence) + ", then " : std::string();
  SetState(name, state, before + reason);
  SuspendConnections(name);
}

void Registry::Expect(const std::string& process, std::int64_t pid) {
  if (FindByName(process) != nullptr) return;
  const auto* const before = catalogue_.FindProcess(process);
  ProcessDescription starting{.name = process};
  if (before != nullptr) starting.instance = before->process.instance;
  if (!expected_.contains(process)) {
    expected_[process] = before == nullptr ? std::nullopt : std::optional(before->process);
  }
  starting.host = os::HostName();
  starting.pid = pid;
  starting.state = ProcessState::kStarting;
  starting.since = WallTime();
  Apply({.kind = Kind::kProcess, .process = process, .processes = {starting}});
}

void Registry::GiveUp(const std::string& process) {
  const auto found = expected_.find(process);
  if (found == expected_.end()) return;
  const std::optional<ProcessDescription> before = std::move(found->second);
  expected_.erase(found);
  if (!before) return Remove(process);
  Apply({.kind = Kind::kProcess, .process = process, .processes = {*before}});
}

bool Registry::SetReason(const std::string& process, const std::string& reason) {
  const auto* const entry = catalogue_.FindProcess(process);
  if (entry == nullptr || IsPresent(entry->process)) return false;
  ProcessDescription description = entry->process;
  description.reason = reason;
  Apply({.kind = Kind::kProcess, .process = process, .processes = {description}});
  return true;
}

Result<void> Registry::Forget(const std::string& process) {
  const auto entry = LookUpProcess(catalogue_, process);
  if (!entry) return entry.error();
  if (FindByName(process) != nullptr) {
    return Error{
        ErrorCode::kFailed,
        "process '" + process + "' is not gone; only a process that is gone can be forgotten"};
  }
  if (expected_.contains(process)) {
    return Error{
        ErrorCode::kFailed,
        "process '" + process + "' is starting; only a process that is gone can be forgotten"};
  }
  Remove(process);
  return {};
}

std::vector<std::shared_ptr<Channel>> Registry::Tick() {
  const SteadyTime now = clock_.Now();
  ExtendLeases(now);
  std::vector<std::pair<SessionToken, std::chrono::nanoseconds>> given_up;
  for (const auto& [session, member] : members_) {
    // The parts of a large message also count as signs of life, because they may delay the renewal.
    const SteadyTime last_part = member.channel ? member.channel->last_part() : SteadyTime();
    const auto silence = now - std::max(member.renewed, last_part);
    if (silence >= leases_.lost_after) {
      given_up.emplace_back(session, silence);
    } else if (silence >= leases_.suspect_after) {
      SetState(member.name, ProcessState::kSuspect, "has not renewed its lease");
    }
  }
  std::vector<std::shared_ptr<Channel>> channels;
  for (const auto& [session, silence] : given_up) {
    channels.push_back(members_.at(session).channel);
    End(session, ProcessState::kLost, std::string(kNoRenewal) + Milliseconds(silence));
  }
  ClearTombstones(now);
  are_connections_due_ = are_connections_due_ || restorer_.IsPauseOver(now);
  return channels;
}

/// If this program was suspended, extends the leases by the length of the pause. Renewals may have
/// arrived that this program has not read yet.
void Registry::ExtendLeases(SteadyTime now) {
  constexpr std::chrono::milliseconds kUsual(250);
  const auto pause = now - std::exchange(last_tick_, now);
  if (pause < 2 * kUsual) return;
  for (auto& [session, member] : members_) {
    member.renewed = std::min(now, member.renewed + (pause - kUsual));
  }
}

void Registry::ClearTombstones(SteadyTime now) {
  std::vector<std::string> old;
  for (const auto& [name, since] : tombstones_) {
    if (now - since >= leases_.tombstone_for) old.push_back(name);
  }
  for (const std::string& name : old) {
    if (!expected_.contains(name)) Remove(name);
  }
}

const ProcessDescription* Registry::FindMember(SessionToken session) const {
  const auto found = members_.find(session);
  return found == members_.end() ? nullptr : &catalogue_.FindProcess(found->second.name)->process;
}

std::shared_ptr<Channel> Registry::ChannelOf(const std::string& process) const {
  const Member* member = FindByName(process);
  return member == nullptr ? nullptr : member->channel;
}

std::vector<std::shared_ptr<Channel>> Registry::channels() const {
  std::vector<std::shared_ptr<Channel>> channels;
  for (const auto& [session, member] : members_) channels.push_back(member.channel);
  return channels;
}

message::PeerList Registry::peers() const {
  message::PeerList peers;
  for (const auto& [name, entry] : catalogue_.processes()) {
    if (!IsPresent(entry.process)) continue;
    peers.processes.push_back(entry.process);
    peers.processes.back().plugins.clear();  // not needed to connect
  }
  return peers;
}

std::vector<message::ConnectionEnds> Registry::TakeDueConnections() {
  if (!std::exchange(are_connections_due_, false)) return {};
  return restorer_.TakeDue(catalogue_, clock_.Now());
}

ConnectionRestorer::Verdict Registry::OnRestored(const message::ConnectionEnds& ends,
                                                 const Result<void>& outcome) {
  return restorer_.Settle(ends, outcome, clock_.Now());
}

Registry::Member* Registry::Find(SessionToken session) {
  const auto found = members_.find(session);
  return found == members_.end() ? nullptr : &found->second;
}

const Registry::Member* Registry::FindByName(const std::string& name) const {
  for (const auto& [session, member] : members_) {
    if (member.name == name) return &member;
  }
  return nullptr;
}

Error Registry::NameInUse(const Member& member) const {
  const ProcessDescription& process = catalogue_.FindProcess(member.name)->process;
  return {ErrorCode::kExists, "process name '" + member.name + "' is in use by host " +
                                  process.host + " pid " + std::to_string(process.pid) + " since " +
                                  WallTimeText(member.joined) + " (last renewal " +
                                  Milliseconds(clock_.Now() - member.renewed) +
                                  " ago); choose another name, or stop that process first"};
}

void Registry::Apply(CatalogueChange change) {
  if (ChangesNothing(change, catalogue_.FindProcess(change.process))) return;
  change.revision = catalogue_.revision() + 1;
  if (!catalogue_.Apply(change)) return;
  are_connections_due_ = are_connections_due_ || change.kind == Kind::kProcess ||
                         change.kind == Kind::kComponent || change.kind == Kind::kConnection;
  changes_.push_back(std::move(change));
}

void Registry::SetState(const std::string& process, ProcessState state, const std::string& reason) {
  ProcessDescription description = catalogue_.FindProcess(process)->process;
  if (description.state == state) return;
  description.state = state;
  description.reason = reason;
  description.since = WallTime();
  Apply({.kind = Kind::kProcess, .process = process, .processes = {description}});
}

/// Sets the connections of an absent process to pending.
void Registry::SuspendConnections(const std::string& process) {
  const auto connections = catalogue_.FindProcess(process)->connections;
  for (auto [id, connection] : connections) {
    connection.state = ConnectionState::kPending;
    connection.reason = "process '" + process + "' is gone";
    Apply({.kind = Kind::kConnection, .process = process, .connections = {connection}});
  }
}

void Registry::Remove(const std::string& process) {
  tombstones_.erase(process);
  restorer_.Drop(process);
  Apply({.kind = Kind::kProcessRemoved, .process = process});
}

}  // namespace tendon::server
