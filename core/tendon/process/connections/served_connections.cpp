#include <tendon/process/connections/served_connections.h>

#include <tendon/base/text.h>
#include <tendon/interface/compatibility.h>
#include <tendon/process/ask.h>
#include <tendon/process/schema_exchange.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace tendon {
namespace {

constexpr std::chrono::milliseconds kReplyTimeout(400);  // the opener waits this long
constexpr std::size_t kMaxTypes = 8;

/// Adds the types of incompatible `members` that this process does not know to `unknown`.
void AddUnknown(const std::vector<MemberDescription>& members, const Compatibility& compatibility,
                std::vector<Fingerprint>& unknown) {
  for (const Mismatch& mismatch : compatibility.mismatches) {
    if (mismatch.kind != Mismatch::Kind::kOtherType) continue;
    const auto member = std::find_if(members.begin(), members.end(),
                                     [&](const auto& one) { return one.name == mismatch.member; });
    if (member == members.end()) continue;
    for (const Fingerprint& type : {member->signature.in, member->signature.out}) {
      if (unknown.size() < kMaxTypes && !FindSchema(type)) unknown.push_back(type);
    }
  }
}

Error Misfit(const message::OpenInterface& open, const ProvidedDescription& provided,
             const std::map<Fingerprint, Schema>& schemas) {
  const auto find = [&](Fingerprint type) -> std::optional<Schema> {
    const auto found = schemas.find(type);
    return found != schemas.end() ? found->second : FindSchema(type);
  };
  return {ErrorCode::kIncompatible, Refusal(ToString(open.required), ToString(open.provided),
                                            Compare(open.description, provided, find))};
}

/// Refuses a connection to the incompatible interface `provided`, and names the first difference.
/// First asks the opener for the types that only the opener knows. If the opener does not answer in
/// time, refuses with `why`; `timer` provides the timeout.
void RefuseMisfit(Worker& timer, const std::shared_ptr<Channel>& channel,
                  const message::OpenInterface& open, const ProvidedDescription& provided,
                  const Error& why, const std::shared_ptr<Responder>& responder) {
  const Compatibility compatibility = Compare(open.description, provided);
  message::GetSchemas unknown;
  AddUnknown(open.description.functions, compatibility, unknown.fingerprints);
  AddUnknown(open.description.event_handlers, compatibility, unknown.fingerprints);
  if (unknown.fingerprints.empty()) return responder->Refuse(why);
  Ask<message::Schemas>(timer, channel, message::kGetSchemas, unknown, kReplyTimeout,
                        [open, provided, unknown, why, responder](const auto& known) {
                          if (!known) return responder->Refuse(why);
                          const auto schemas = ReadSchemas(unknown, *known);
                          responder->Refuse(Misfit(open, provided, schemas));
                        });
}

}  // namespace

std::string EndsOf(const message::OpenInterface& open) {
  return ToString(open.provided) + " for " + ToString(open.required);
}

void ServedConnections::Open(const std::shared_ptr<Client>& client,
                             const message::OpenInterface& open, Use use,
                             const std::shared_ptr<Responder>& responder) {
  const auto lock = context_.process.LockStructure();
  if (const auto may = CheckListeners(*client, use); !may) return responder->Refuse(may.error());
  const auto server = LookUp(open.provided);
  if (!server) return responder->Refuse(server.error());
  auto made = Make(client, open, use, **server);
  if (!made && made.error().code == ErrorCode::kIncompatible) {
    return RefuseMisfit(
        *context_.worker, client->channel, open,
        use == Use::kEventsOnly ? (*server)->description_for_observers() : (*server)->description(),
        made.error(), responder);
  }
  if (!made) return responder->Refuse(made.error());
  entries_.push_back(*std::move(made));
  Entry& entry = entries_.back();
  const Component* const component = context_.process.LookUpComponent(entry.component);
  const message::OpenInterfaceReply opened{
      .handle = client->handles.Reserve(open.description.functions.size()),
      .credit = entry.proxy->capacity(),
      .accepting = entry.proxy->BeginCredit(
          *entry.connection,
          {.interface = *server,
           .fault = [component] { return component != nullptr ? component->fault() : ""; }}),
      .description = (*server)->description(),
      .latest_only = (*server)->latest_only()};
  entry.handle = opened.handle;
  client->handles.Put(entry.handle, entry.proxy);
  LogChange(entry, "opened");
  responder->Reply(EncodeBody(opened), entry.proxy->lane());  // events must not overtake the reply
  context_.proxies.Add(entry.required, entry.proxy);          // the proxy starts to send
}

Result<void> ServedConnections::CheckListeners(const Client& client, Use use) const {
  if (use != Use::kEventsOnly) return {};
  std::ptrdiff_t all = 0;
  std::ptrdiff_t own = 0;
  for (const Entry& entry : entries_) {
    if (entry.use != use) continue;
    ++all;
    if (entry.client.get() == &client) ++own;
  }
  if (own < kMaxListenersOfOne && all < kMaxListeners) return {};
  const bool is_own = own >= kMaxListenersOfOne;
  return Error{ErrorCode::kFailed,
               "process '" + context_.name + "' has " + std::to_string(is_own ? own : all) +
                   " listeners to its events and commands" + (is_own ? " from this client" : "") +
                   " already, which is the limit: end some of these listeners"};
}

Result<ProvidedInterface*> ServedConnections::LookUp(const InterfaceName& provided) const {
  if (provided.process != context_.name) {
    return Error{ErrorCode::kNotFound,
                 "this is process '" + context_.name + "', not '" + provided.process + "'"};
  }
  const auto found = context_.process.LookUpProvided(provided);
  if (found) return found;
  return Error{found.error().code, "process '" + context_.name + "': " + found.error().message};
}

Result<ServedConnections::Entry> ServedConnections::Make(const std::shared_ptr<Client>& client,
                                                         const message::OpenInterface& open,
                                                         Use use, ProvidedInterface& provided) {
  using Events = RequiredInterfaceProxy::Events;
  const Events events = use == Use::kEventsOnly ? Events::kTimed : Events::kPlain;
  try {
    auto proxy =
        std::make_shared<RequiredInterfaceProxy>(context_.network, client->channel, open, events);
    proxy->MakeExecutors(provided, *context_.calls);
    proxy->PrepareObservers(provided);
    const auto bytes = Connection::MailboxBytes(proxy->interface(), provided);
    if (const auto fits = CheckSize(open, use, bytes); !fits) return fits.error();
    auto connection = Connection::Make(proxy->interface(), provided, ToString(open.required),
                                       ToString(open.provided));
    if (!connection) return connection.error();
    return Entry{.client = client,
                 .required = open.required,
                 .component = open.provided.component,
                 .ends = EndsOf(open),
                 .use = use,
                 .handle = 0,
                 .proxy = std::move(proxy),
                 .connection = *std::move(connection)};
  } catch (const ConfigurationError& error) {
    return Error{ErrorCode::kInvalid, error.what()};
  } catch (const std::exception& failure) {  // for example, no memory
    return Error{ErrorCode::kFailed, "process '" + context_.name + "' cannot serve " +
                                         ToString(open.required) + ": " + failure.what()};
  }
}

/// Limits the memory that another process can request from this process.
Result<void> ServedConnections::CheckSize(const message::OpenInterface& open, Use use,
                                          std::size_t bytes) {
  constexpr std::size_t kMaxCalls = 65536;
  // There may be many listeners. Each may have the largest mailbox for events.
  const std::size_t most_mib = use == Use::kEventsOnly ? 8 : 64;
  if (open.capacity <= kMaxCalls && bytes <= most_mib << 20U) return {};
  return Error{ErrorCode::kInvalid,
               ToString(open.required) + " requests a mailbox for " +
                   std::to_string(open.capacity) + " calls at " + ToString(open.provided) +
                   ", but a client in another process is allowed at most " +
                   std::to_string(kMaxCalls) + " calls and " + std::to_string(most_mib) +
                   " MiB: set a smaller mailbox capacity"};
}

void ServedConnections::Close(const std::shared_ptr<Client>& client, std::uint32_t handle) {
  CloseWhere([&](const Entry& entry) { return entry.client == client && entry.handle == handle; });
}

void ServedConnections::CloseAll(const std::shared_ptr<Client>& client) {
  CloseWhere([&](const Entry& entry) { return entry.client == client; });
}

void ServedConnections::RemoveComponent(const std::string& component) {
  const Error reason{ErrorCode::kNotFound, "component '" + component + "' of process '" +
                                               context_.name + "' was removed"};
  const auto is_of_it = [&](const Entry& entry) { return entry.component == component; };
  const auto lock = context_.process.LockStructure();
  for (const Entry& entry : entries_) {
    if (!is_of_it(entry)) continue;
    Channel& channel = *entry.client->channel;
    const Status sent = channel.Notify(message::kInterfaceClosed, entry.proxy->handle(), reason,
                                       entry.proxy->lane());
    // The client must learn that its connection has ended. The link is too full for the notice, so
    // the channel is closed instead, and the client opens it again.
    if (sent == Status(Status::kQueueFull)) channel.Close();
  }
  const SteadyTime deadline = SteadyClock().Now() + LocalManager::kDrainTimeout;
  TakeDownWhere(entries_, is_of_it, deadline);
  TakeDownWhere(hanging_, is_of_it, deadline);
}

bool ServedConnections::HasSentAllEvents() const {
  const auto lock = context_.process.LockStructure();
  return std::ranges::none_of(entries_,
                              [](const Entry& entry) { return entry.proxy->has_unsent_events(); });
}

void ServedConnections::Close(SteadyTime deadline) {
  const auto any = [](const Entry& /*entry*/) { return true; };
  const auto lock = context_.process.LockStructure();
  TakeDownWhere(entries_, any, deadline);
  TakeDownWhere(hanging_, any, deadline);
}

template <typename Predicate>
void ServedConnections::CloseWhere(Predicate predicate) {
  const auto lock = context_.process.LockStructure();
  const SteadyTime deadline = SteadyClock().Now() + LocalManager::kDrainTimeout;
  const bool none_hung = hanging_.empty();
  for (auto entry = entries_.begin(); entry != entries_.end();) {
    const auto next = std::next(entry);
    if (predicate(*entry)) {
      Detach(*entry);
      if (!entry->proxy->Drain(deadline)) {
        entry->proxy->DropCommands();  // before the client's next connection sends commands
        hanging_.splice(hanging_.end(), entries_, entry);
      }
    }
    entry = next;
  }
  TakeDownWhere(entries_, predicate, deadline);
  if (none_hung && !hanging_.empty()) CheckHanging();
}

/// Closes hanging connections whose calls have returned. Runs on the worker, and repeats until no
/// connection hangs.
void ServedConnections::CheckHanging() {
  constexpr std::chrono::milliseconds kUntilNextLook(50);
  context_.worker->PostAfter(kUntilNextLook, [this] {
    const auto lock = context_.process.LockStructure();
    const SteadyTime now = SteadyClock().Now();
    TakeDownWhere(
        hanging_, [now](const Entry& entry) { return entry.proxy->Drain(now); }, now);
    if (!hanging_.empty()) CheckHanging();
  });
}

template <typename Predicate>
void ServedConnections::TakeDownWhere(std::list<Entry>& entries, Predicate predicate,
                                      SteadyTime deadline) {
  for (Entry& entry : entries) {  // for all entries, before any entry waits
    if (predicate(entry)) Detach(entry);
  }
  for (auto entry = entries.begin(); entry != entries.end();) {
    if (!predicate(*entry)) {
      ++entry;
      continue;
    }
    TakeDown(*entry, deadline);
    entry = entries.erase(entry);
  }
}

/// Removes the entry's handle, so that later messages for it are ignored.
void ServedConnections::Detach(Entry& entry) {
  entry.client->handles.Remove(entry.handle);
  entry.proxy->DropReads();
  if (entry.use == Use::kEventsOnly) entry.proxy->Sever();
}

void ServedConnections::TakeDown(Entry& entry, SteadyTime deadline) {
  (void)entry.proxy->Drain(deadline);
  entry.proxy->EndCredit();
  entry.connection->Close(TimeUntil(deadline));
  context_.proxies.Remove(entry.required, *entry.proxy);
  LogChange(entry, "closed, commands: " + std::to_string(entry.proxy->received()));
}

void ServedConnections::LogChange(const Entry& entry, const std::string& what) {
  if (entry.use == Use::kEventsOnly) return;
  const Channel& channel = *entry.client->channel;
  entry.client->audit.Write("one program", LogLevel::kInfo,
                            NameAndRole(channel, channel.peer().role) + ": interface " +
                                Printable(entry.ends, 256) + ": " + what);
}

}  // namespace tendon
