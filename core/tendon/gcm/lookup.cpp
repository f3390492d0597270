#include <tendon/gcm/lookup.h>

#include <tendon/base/text.h>
#include <tendon/interface/compatibility.h>
#include <tendon/interface/observed_call.h>

#include <charconv>
#include <vector>

namespace tendon {
namespace {

constexpr std::size_t kMaxListed = 8;

/// Returns "; did you mean 'arm'?" if a name is similar. Otherwise lists the names, unless there
/// are many.
std::string Hint(const std::string& name, const std::vector<std::string>& candidates) {
  if (candidates.empty()) return "; there is none";
  if (std::string near = DidYouMean(name, candidates); !near.empty()) return near;
  if (candidates.size() > kMaxListed) return {};
  std::string list = "; there is ";
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    list += (i == 0 ? "'" : ", '") + candidates[i] + "'";
  }
  return list;
}

Error NotFound(const std::string& what, const std::string& full, const std::string& name,
               const std::vector<std::string>& candidates) {
  return {ErrorCode::kNotFound, "no " + what + " '" + full + "'" + Hint(name, candidates)};
}

/// Returns the error for an interface of the wrong kind: required instead of provided, or the
/// reverse. Lists the interfaces of the right kind, if the component has any.
Error OtherSide(const InterfaceName& name, const std::string& what, const std::string& needed,
                const std::vector<std::string>& candidates) {
  const std::string hint = candidates.empty()
                               ? "; " + name.process + "/" + name.component + " has none"
                               : Hint(name.interface, candidates);
  return {ErrorCode::kNotFound, ToString(name) + " is a " + what + " interface; a " + needed +
                                    " interface is needed" + hint};
}

Error RequiredInstead(const InterfaceName& name, const std::vector<std::string>& provided) {
  return OtherSide(name, "required", "provided", provided);
}

template <typename Map>
std::vector<std::string> KeysOf(const Map& map) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : map) keys.push_back(key);
  return keys;
}

template <typename List>
std::vector<std::string> NamesIn(const List& elements) {
  std::vector<std::string> names;
  for (const auto& element : elements) names.push_back(element.name);
  return names;
}

/// Checks the names before they are used in an error message, because they are untrusted.
Result<void> CheckFullName(const InterfaceName& name) {
  if (auto checked = CheckName("process", name.process); !checked) return checked;
  if (auto checked = CheckName("component", name.component); !checked) return checked;
  return CheckName("interface", name.interface);
}

/// Returns the component of an interface. Does not check that the component has the interface.
Result<const ComponentDescription*> LookUpOwner(const Catalogue& catalogue,
                                                const InterfaceName& name) {
  const auto component = LookUpComponent(catalogue, name.process, name.component);
  if (!component) return component.error();
  if (auto checked = CheckName("interface", name.interface); !checked) return checked.error();
  return component;
}

/// Returns the words between the names of the required and the provided interface in a sentence.
std::string StandOf(ConnectionState state) {
  switch (state) {
    case ConnectionState::kPending:
      return " waits to be connected to ";
    case ConnectionState::kFailed:
      return " was refused by ";
    default:
      return " is connected to ";
  }
}

std::string Connected(const ConnectionDescription& connection, const InterfaceName& wanted) {
  const std::string required = ToString(connection.required);
  const std::string stand = required + StandOf(connection.state) + ToString(connection.provided);
  if (connection.provided == wanted && connection.state == ConnectionState::kActive) {
    return stand + " already";
  }
  if (connection.provided == wanted) {
    return stand + " already: " + connection.reason + "; to see why: gcm explain " + required +
           "; to cancel the connection: gcm disconnect " + required;
  }
  return stand + "; to replace this connection: gcm connect " + required + " " + ToString(wanted) +
         " --replace";
}

/// Returns an error if an active connection would be replaced by a pending one.
Result<void> CheckReplacement(const Catalogue& catalogue, const ConnectionDescription& connection,
                              const std::string& provider) {
  if (connection.state != ConnectionState::kActive) return {};
  const auto entry = LookUpProcess(catalogue, provider);
  const auto present = entry ? RequirePresent((*entry)->process) : entry.error();
  if (present) return {};
  return Error{present.error().code,
               ToString(connection.required) + " stays connected to " +
                   ToString(connection.provided) +
                   ", because the new provided interface must be available first: " +
                   present.error().message};
}

/// The commands of an interface, including the columns of a table.
std::vector<MemberDescription> CommandsOf(const ComponentDescription& component,
                                          const std::string& interface) {
  if (const auto* provided = FindNamed(component.provided, interface)) return provided->commands;
  std::vector<MemberDescription> commands;
  if (const auto* table = FindNamed(component.tables, interface)) {
    for (const ColumnDescription& column : table->columns) {
      commands.push_back(
          {.name = column.name,
           .signature = {CommandKind::kRead, FingerprintOf<None>(), column.fingerprint},
           .out_type = column.type});
    }
  }
  return commands;
}

}  // namespace

Result<const ProcessEntry*> LookUpProcess(const Catalogue& catalogue, const std::string& process) {
  if (auto checked = CheckName("process", process); !checked) return checked.error();
  if (const ProcessEntry* entry = catalogue.FindProcess(process)) return entry;
  return NotFound("process", process, process, KeysOf(catalogue.processes()));
}

Result<const ComponentDescription*> LookUpComponent(const Catalogue& catalogue,
                                                    const std::string& process,
                                                    const std::string& component) {
  const auto entry = LookUpProcess(catalogue, process);
  if (!entry) return entry.error();
  if (auto checked = CheckName("component", component); !checked) return checked.error();
  const auto found = (*entry)->components.find(component);
  if (found != (*entry)->components.end()) return &found->second;
  return NotFound("component", process + "/" + component, component, KeysOf((*entry)->components));
}

Result<const ProvidedDescription*> LookUpProvided(const Catalogue& catalogue,
                                                  const InterfaceName& name) {
  const auto component = LookUpOwner(catalogue, name);
  if (!component) return component.error();
  const ComponentDescription& owner = **component;
  if (const auto* provided = FindNamed(owner.provided, name.interface)) return provided;
  if (FindNamed(owner.required, name.interface) != nullptr) {
    return RequiredInstead(name, NamesIn(owner.provided));
  }
  return NotFound("provided interface", ToString(name), name.interface, NamesIn(owner.provided));
}

Result<const RequiredDescription*> LookUpRequired(const Catalogue& catalogue,
                                                  const InterfaceName& name) {
  const auto component = LookUpOwner(catalogue, name);
  if (!component) return component.error();
  const ComponentDescription& owner = **component;
  if (const auto* required = FindNamed(owner.required, name.interface)) return required;
  if (FindNamed(owner.provided, name.interface) != nullptr) {
    return OtherSide(name, "provided", "required", NamesIn(owner.required));
  }
  return NotFound("required interface", ToString(name), name.interface, NamesIn(owner.required));
}

Result<MemberDescription> LookUpCommand(const Catalogue& catalogue, const Path& path) {
  const auto component = LookUpComponent(catalogue, path.process, path.component);
  if (!component) return component.error();
  const ComponentDescription& owner = **component;
  if (FindNamed(owner.provided, path.interface) == nullptr &&
      FindNamed(owner.tables, path.interface) == nullptr) {
    std::vector<std::string> names = NamesIn(owner.provided);
    for (const TableDescription& table : owner.tables) {
      if (FindNamed(owner.provided, table.name) == nullptr) names.push_back(table.name);
    }
    if (FindNamed(owner.required, path.interface) != nullptr) {
      return RequiredInstead(path.interface_name(), names);
    }
    return NotFound("provided interface", ToString(path.interface_name()), path.interface, names);
  }
  const auto commands = CommandsOf(owner, path.interface);
  if (const auto* command = FindNamed(commands, path.member)) return *command;
  const bool is_table = FindNamed(owner.tables, path.interface) != nullptr;
  return NotFound(is_table ? "column" : "command",
                  ToString(path.interface_name()) + "." + path.member, path.member,
                  NamesIn(commands));
}

Result<std::vector<MemberDescription>> LookUpEvents(const Catalogue& catalogue,
                                                    const EventSubscription& wanted) {
  const auto provided = LookUpProvided(catalogue, wanted.provided);
  if (!provided) return provided.error();
  std::vector<MemberDescription> events;
  for (const std::string& name : wanted.events) {
    const auto& known = (*provided)->events;
    const auto event =
        std::find_if(known.begin(), known.end(), [&](const auto& one) { return one.name == name; });
    if (event == known.end()) {
      return Error{ErrorCode::kNotFound,
                   "there is no event " + ToString(wanted.provided) + "." + name};
    }
    events.push_back(*event);
  }
  for (const std::string& name : wanted.commands) {
    const MemberDescription* command = FindNamed((*provided)->commands, name);
    const std::string path = ToString(wanted.provided) + "." + name;
    if (command == nullptr) return Error{ErrorCode::kNotFound, "there is no command " + path};
    if (!CanBeObserved(command->signature)) {
      return Error{ErrorCode::kInvalid, path + " is a " +
                                            std::string(ToString(command->signature.kind)) +
                                            " command: only calls that can change something are "
                                            "observed"};
    }
    events.push_back(DescribeCalls(*command));
  }
  return events;
}

bool TakesArgument(const Signature& signature) {
  const CommandKind kind = signature.kind;
  return kind == CommandKind::kWrite || kind == CommandKind::kQualifiedRead ||
         kind == CommandKind::kWriteReturn;
}

Result<message::ConnectionPlan> PlanConnect(const Catalogue& catalogue,
                                            const message::ConnectionEnds& ends,
                                            WhenConnected when_connected) {
  for (const InterfaceName& name : {ends.required, ends.provided}) {
    if (auto checked = CheckFullName(name); !checked) return checked.error();
  }
  const auto required = LookUpRequired(catalogue, ends.required);
  if (!required) return required.error();
  const ProcessDescription& owner = catalogue.FindProcess(ends.required.process)->process;
  if (auto present = RequirePresent(owner); !present) return present.error();
  const ProcessEntry* provider = catalogue.FindProcess(ends.provided.process);
  const bool is_there = provider != nullptr && IsPresent(provider->process);
  const auto provided = LookUpProvided(catalogue, ends.provided);
  if (!provided && is_there) return provided.error();
  const auto* connection = catalogue.FindConnection(ends.required);
  if (connection != nullptr && when_connected == WhenConnected::kRefuse) {
    return Error{ErrorCode::kExists, Connected(*connection, ends.provided)};
  }
  if (connection != nullptr) {
    const auto checked = CheckReplacement(catalogue, *connection, ends.provided.process);
    if (!checked) return checked.error();
  }
  if (provided) {
    if (const auto compatibility = Compare(**required, **provided); !compatibility.fits()) {
      return Error{ErrorCode::kIncompatible,
                   Refusal(ToString(ends.required), ToString(ends.provided), compatibility)};
    }
  }
  return ConnectionPlanOf(catalogue, ends);
}

message::ConnectionPlan ConnectionPlanOf(const Catalogue& catalogue,
                                         const message::ConnectionEnds& ends) {
  const ProcessEntry* provider = catalogue.FindProcess(ends.provided.process);
  if (provider == nullptr || !IsPresent(provider->process)) return {.ends = ends};
  return {
      .ends = ends, .address = provider->process.address, .instance = provider->process.instance};
}

Result<ConnectionDescription> PlanDisconnect(const Catalogue& catalogue,
                                             const InterfaceName& required) {
  if (auto checked = CheckFullName(required); !checked) return checked.error();
  if (const auto found = LookUpRequired(catalogue, required); !found) return found.error();
  const ProcessDescription& owner = catalogue.FindProcess(required.process)->process;
  if (auto present = RequirePresent(owner); !present) return present.error();
  if (const auto* connection = catalogue.FindConnection(required)) return *connection;
  return Error{ErrorCode::kFailed,
               ToString(required) + " is not connected: there is nothing to disconnect"};
}

Result<InterfaceName> LookUpConnected(const Catalogue& catalogue, const std::string& text) {
  const std::size_t slash = text.find('/');
  const std::string process = slash == std::string::npos ? "" : text.substr(0, slash);
  const std::string number = slash == std::string::npos ? text : text.substr(slash + 1);
  std::uint64_t id = 0;
  const auto [end, code] = std::from_chars(number.data(), number.data() + number.size(), id);
  const bool is_number = code == std::errc() && end == number.data() + number.size();
  if (!is_number) return ParseInterfaceName(text);
  std::vector<InterfaceName> found;
  for (const ConnectionDescription& one : catalogue.connections()) {
    const bool is_meant = process.empty() || one.required.process == process;
    if (is_meant && one.id == id) found.push_back(one.required);
  }
  if (found.size() == 1) return found.front();
  if (found.empty()) return Error{ErrorCode::kNotFound, "no connection has the number " + text};
  std::string all;
  for (const InterfaceName& one : found) {
    all += (all.empty() ? "" : ", ") + one.process + "/" + number + " belongs to " + ToString(one);
  }
  return Error{ErrorCode::kInvalid, "more than one connection has the number " + text + ": " + all};
}

std::uint64_t InstanceOf(const Catalogue& catalogue, const std::string& process) {
  const ProcessEntry* entry = catalogue.FindProcess(process);
  return entry == nullptr ? 0 : entry->process.instance;
}

bool IsPresent(const ProcessDescription& process) {
  return process.state == ProcessState::kAlive || process.state == ProcessState::kSuspect;
}

bool HasFallenSilent(const ProcessDescription& process) {
  return process.state == ProcessState::kLost && process.reason.starts_with(kNoRenewal);
}

std::string AdviceFor(const ProcessDescription& process) {
  if (!HasFallenSilent(process)) return "start it again";
  const std::string pid = std::to_string(process.pid);
  return "the process may be stopped, may hang, or may have lost its connection to the GCM; on "
         "host " +
         process.host + ", to resume a stopped process: kill -CONT " + pid +
         "; to end the process: kill -9 " + pid;
}

Result<void> RequirePresent(const ProcessDescription& process) {
  if (IsPresent(process)) return {};
  if (process.state == ProcessState::kStarting) {
    return Error{ErrorCode::kFailed,
                 "process '" + process.name + "' is starting; try again when it has joined"};
  }
  const std::string state = process.state == ProcessState::kLeft ? "has left" : "is lost";
  const std::string reason = process.reason.empty() ? "" : " (" + process.reason + ")";
  return Error{ErrorCode::kFailed,
               "process '" + process.name + "' " + state + reason + "; " +
                   (HasFallenSilent(process) ? AdviceFor(process) : "start it again first")};
}

}  // namespace tendon
