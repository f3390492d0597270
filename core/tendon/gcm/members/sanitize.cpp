#include <tendon/gcm/members/sanitize.h>

#include <tendon/base/text.h>
#include <tendon/process/lifecycle/lifecycle_messages.h>

#include <set>
#include <vector>

namespace tendon::server {
namespace {

using Kind = CatalogueChange::Kind;

constexpr std::size_t kLongestPath = 4096;  // bytes
constexpr std::size_t kLongestWord = 256;   // bytes of a type, a class, a file, a host

constexpr double kLongestExpiry = 3600.0;  // s

Error Invalid(const std::string& message) { return {ErrorCode::kInvalid, message}; }

Result<void> SanitizeMembers(const std::string& what, std::vector<MemberDescription>& members) {
  for (MemberDescription& member : members) {
    if (auto checked = CheckName(what, member.name); !checked) return checked;
    member.in_type = Printable(member.in_type, kLongestWord);
    member.out_type = Printable(member.out_type, kLongestWord);
    member.hazard = Printable(member.hazard, kLongestWord);
    const bool is_sensible = member.expires_after >= 0.0 && member.expires_after <= kLongestExpiry;
    if (!is_sensible) member.expires_after = 0.0;
  }
  return {};
}

Result<void> SanitizeTables(SharedList<TableDescription>& tables) {
  for (TableDescription& table : tables) {
    if (auto checked = CheckName("table", table.name); !checked) return checked;
    for (ColumnDescription& column : table.columns) {
      if (auto checked = CheckName("column", column.name); !checked) return checked;
      column.type = Printable(column.type, kLongestWord);
    }
  }
  return {};
}

Result<void> CheckEnd(InterfaceName& end, const std::string& process) {
  if (end.process.empty()) end.process = process;
  if (auto checked = CheckName("process", end.process); !checked) return checked;
  if (auto checked = CheckName("component", end.component); !checked) return checked;
  return CheckName("interface", end.interface);
}

void SanitizeTexts(ProcessDescription& process) {
  process.host = Printable(process.host, kLongestWord);
  process.address = Printable(process.address, kLongestWord);
  for (PluginDescription& plugin : process.plugins) {
    plugin.name = Printable(plugin.name, kLongestWord);
    plugin.file = Printable(plugin.file, kLongestPath);
  }
}

}  // namespace

Result<void> Sanitize(ComponentDescription& component) {
  if (auto checked = CheckName("component", component.name); !checked) return checked;
  component.class_name = Printable(component.class_name, kLongestWord);
  component.library = Printable(component.library, kLongestWord);
  if (component.configuration.size() > message::kLongestConfiguration ||
      component.configuration !=
          Printable(component.configuration, message::kLongestConfiguration)) {
    return Invalid("the configuration of component '" + component.name + "' is longer than " +
                   std::to_string(message::kLongestConfiguration) +
                   " bytes, or has characters that cannot be printed; expected JSON on one line");
  }
  component.fault = Printable(component.fault);
  for (ProvidedDescription& provided : component.provided) {
    if (auto checked = CheckName("interface", provided.name); !checked) return checked;
    if (auto sanitized = SanitizeMembers("command", provided.commands); !sanitized)
      return sanitized;
    if (auto sanitized = SanitizeMembers("event", provided.events); !sanitized) return sanitized;
  }
  for (RequiredDescription& required : component.required) {
    if (auto checked = CheckName("interface", required.name); !checked) return checked;
    if (auto sanitized = SanitizeMembers("function", required.functions); !sanitized)
      return sanitized;
    if (auto sanitized = SanitizeMembers("event handler", required.event_handlers); !sanitized)
      return sanitized;
  }
  return SanitizeTables(component.tables);
}

Result<void> Sanitize(ConnectionDescription& connection, const std::string& process) {
  if (auto checked = CheckEnd(connection.required, process); !checked) return checked;
  if (auto checked = CheckEnd(connection.provided, process); !checked) return checked;
  if (connection.required.process != process) {
    return Invalid("a connection of " + ToString(connection.required) +
                   " must be reported by the process of that interface, not by '" + process + "'");
  }
  connection.reason = Printable(connection.reason);
  return {};
}

Result<void> Sanitize(message::Join& join) {
  if (auto checked = CheckName("process", join.process.name); !checked) return checked;
  SanitizeTexts(join.process);
  std::set<std::string> components;
  for (ComponentDescription& component : join.components) {
    if (auto sanitized = Sanitize(component); !sanitized) return sanitized;
    if (!components.insert(component.name).second) {
      return Invalid("two components are named '" + component.name + "'");
    }
  }
  std::set<InterfaceName> required;
  std::set<std::uint64_t> ids;
  for (ConnectionDescription& connection : join.connections) {
    if (auto sanitized = Sanitize(connection, join.process.name); !sanitized) return sanitized;
    if (!required.insert(connection.required).second || !ids.insert(connection.id).second) {
      return Invalid("two connections of " + ToString(connection.required) +
                     ", or two connections with the same id");
    }
  }
  return {};
}

Result<void> Sanitize(CatalogueChange& change, const std::string& process) {
  if (change.process.empty()) change.process = process;
  if (change.process != process) return Invalid("a process can only report about itself");
  switch (change.kind) {
    case Kind::kProcess:
      if (change.processes.size() != 1) break;
      SanitizeTexts(change.processes.front());
      return {};
    case Kind::kComponent:
      if (change.components.size() != 1) break;
      return Sanitize(change.components.front());
    case Kind::kConnection:
      if (change.connections.size() != 1) break;
      return Sanitize(change.connections.front(), process);
    case Kind::kComponentRemoved:
    case Kind::kConnectionRemoved:
      return {};
    case Kind::kProcessRemoved:
      return Invalid("a process that leaves must send kLeave");
  }
  return Invalid("a change of this kind must contain exactly one object");
}

void Sanitize(message::LogRecords& batch) {
  for (message::LogRecord& record : batch.records) {
    record.source = Printable(record.source, kLongestWord);
    record.text = Printable(record.text);
  }
}

}  // namespace tendon::server
