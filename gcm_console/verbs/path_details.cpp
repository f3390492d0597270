#include <gcm_console/verbs/path_details.h>

#include <gcm_console/catalogue/system_items.h>
#include <gcm_console/output/catalogue_json.h>
#include <gcm_console/output/text.h>
#include <gcm_console/verbs/queries.h>
#include <tendon/gcm/waiting.h>

#include <cmath>
#include <string>
#include <utility>

namespace console {
namespace {

using nlohmann::ordered_json;
using tendon::Catalogue;
using tendon::InterfaceName;
using tendon::message::SystemHealth;

void ListProcesses(const Catalogue& catalogue, Table& table) {
  for (const auto& [name, entry] : catalogue.processes()) {
    const auto& process = entry.process;
    table.Add({name, std::string(ToString(process.state)), process.host,
               std::to_string(process.pid), std::to_string(entry.components.size()),
               process.address});
  }
}

void ListComponents(const tendon::ProcessEntry& entry, Table& table) {
  for (const auto& [name, component] : entry.components) {
    table.Add({name, std::string(ToString(component.state)), component.class_name,
               component.period > 0.0 ? ordered_json(component.period).dump() : "-",
               WaitingText(WaitsOf(entry, component))});
  }
}

void ListInterfaces(const Catalogue& catalogue, const PathTarget& target, Table& table) {
  const auto name_of = [&](const std::string& interface) {
    return InterfaceName(target.process->process.name, target.component->name, interface);
  };
  for (const auto& one : target.component->provided) {
    table.Add({one.name, "provided", std::to_string(one.commands.size() + one.events.size()),
               UsersOf(catalogue, name_of(one.name))});
  }
  for (const auto& one : target.component->required) {
    table.Add({one.name, "required",
               std::to_string(one.functions.size() + one.event_handlers.size()),
               ProviderOf(catalogue, name_of(one.name))});
  }
}

void AddMember(const std::string& noun, const tendon::MemberDescription& member, Table& table) {
  table.Add(
      {member.name, std::string(ToString(member.signature.kind)) + " " + noun, TypesOf(member)});
}

void ListMembers(const PathTarget& target, Table& table) {
  if (target.member != nullptr) return AddMember(target.noun, *target.member, table);
  const auto add = [&table](const std::string& noun, const auto& members) {
    for (const auto& one : members) AddMember(noun, one, table);
  };
  if (target.provided != nullptr) {
    add("command", target.provided->commands);
    add("event", target.provided->events);
  } else {
    add("function", target.required->functions);
    add("handler", target.required->event_handlers);
  }
}

ordered_json ProcessJson(const tendon::ProcessEntry& entry, const SystemHealth& health) {
  ordered_json json = ToJson(entry);
  json["health"] = HealthOf(health, entry.process);
  return json;
}

}  // namespace

Table ListingOf(const Catalogue& catalogue, const PathTarget& target) {
  if (target.process == nullptr) {
    Table table({"PROCESS", "STATE", "HOST", "PID", "COMPONENTS", "ADDRESS"});
    ListProcesses(catalogue, table);
    return table;
  }
  if (target.component == nullptr) {
    Table table({"COMPONENT", "STATE", "CLASS", "PERIOD/s", "DETAIL"});
    ListComponents(*target.process, table);
    return table;
  }
  if (target.provided == nullptr && target.required == nullptr) {
    Table table({"INTERFACE", "SIDE", "MEMBERS", "CONNECTED"});
    ListInterfaces(catalogue, target, table);
    return table;
  }
  Table table({"MEMBER", "KIND", "TYPE"});
  ListMembers(target, table);
  return table;
}

ordered_json JsonOf(Context& context, const Catalogue& catalogue, const PathTarget& target) {
  if (target.member != nullptr) return {{"member", ToJson(*target.member)}};
  if (target.provided != nullptr) return {{"interface", ToJson(*target.provided)}};
  if (target.required != nullptr) {
    ordered_json json = {{"interface", ToJson(*target.required)}};
    if (const auto counts = AskCounts(context, target)) json["counts"] = ToJson(*counts);
    return json;
  }
  if (target.component != nullptr) {
    ordered_json json = {{"component", ToJson(*target.component, *target.process)}};
    if (const auto fill = AskFill(context, target)) json["mailbox"] = ToJson(*fill);
    return json;
  }
  const SystemHealth health = AskHealth(context);
  if (target.process != nullptr) {
    ordered_json json = {{"process", ProcessJson(*target.process, health)}};
    if (const auto history = AskHistory(context, target.process->process.name)) {
      json["process"]["history"] = ToJson(*history);
    }
    return json;
  }
  ordered_json processes = ordered_json::array();
  for (const auto& [name, entry] : catalogue.processes())
    processes.push_back(ProcessJson(entry, health));
  return {{"processes", std::move(processes)}};
}

std::string ExpiryText(double seconds) {
  constexpr double kMilliseconds = 1e3;     // per second
  constexpr double kRoundsToOne = 0.99995;  // rounds to 1 with four digits
  constexpr double kManyDigits = 1e4;       // such a number would be written with an exponent
  if (seconds < kRoundsToOne) return Short(seconds * kMilliseconds) + " ms";
  return (seconds < kManyDigits ? Short(seconds) : std::to_string(std::llround(seconds))) + " s";
}

}  // namespace console
