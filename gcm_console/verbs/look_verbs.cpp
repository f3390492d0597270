#include <gcm_console/catalogue_json.h>
#include <gcm_console/place.h>
#include <gcm_console/report.h>
#include <gcm_console/verb.h>
#include <tendon/gcm/text/wall_time.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

namespace console {
namespace {

using nlohmann::ordered_json;
using program::ExitCode;
using tendon::Catalog;
using tendon::InterfaceName;
using tendon::Result;

/// What a required interface is connected to.
std::string Provider(const Catalog& catalog, const InterfaceName& required) {
  const auto* connection = catalog.FindConnection(required);
  if (connection == nullptr) return "not connected";
  const std::string provider = "-> " + ToString(connection->provided);
  if (connection->state == tendon::ConnectionState::kActive) return provider;
  return provider + " (" + std::string(ToString(connection->state)) + ": " + connection->reason +
         ")";
}

/// Who is connected to a provided interface: "<- desk/supervisor/Robot and 2 more".
std::string Users(const Catalog& catalog, const InterfaceName& provided) {
  std::string first;
  std::size_t more = 0;
  for (const auto& connection : catalog.connections()) {
    if (connection.provided != provided) continue;
    if (first.empty()) {
      first = "<- " + ToString(connection.required);
    } else {
      ++more;
    }
  }
  return first + (more == 0 ? "" : " and " + std::to_string(more) + " more");
}

void ListProcesses(const Catalog& catalog, Table& table) {
  for (const auto& [name, entry] : catalog.processes()) {
    const auto& process = entry.process;
    table.Add({name, std::string(ToString(process.state)), process.host,
               std::to_string(process.pid), std::to_string(entry.components.size()),
               process.address});
  }
}

void ListComponents(const tendon::ProcessEntry& entry, Table& table) {
  for (const auto& [name, component] : entry.components) {
    table.Add({name, std::string(ToString(component.state)), component.class_name,
               component.period > 0.0 ? ordered_json(component.period).dump() : "-"});
  }
}

void ListInterfaces(const Catalog& catalog, const Place& place, Table& table) {
  const auto name_of = [&](const std::string& interface) {
    return InterfaceName(place.process->process.name, place.component->name, interface);
  };
  for (const auto& one : place.component->provided) {
    table.Add({one.name, "provided", std::to_string(one.commands.size() + one.events.size()),
               Users(catalog, name_of(one.name))});
  }
  for (const auto& one : place.component->required) {
    table.Add({one.name, "required",
               std::to_string(one.functions.size() + one.event_handlers.size()),
               Provider(catalog, name_of(one.name))});
  }
}

void AddMember(const std::string& noun, const tendon::MemberDescription& member, Table& table) {
  table.Add(
      {member.name, std::string(ToString(member.signature.kind)) + " " + noun, TypesOf(member)});
}

void ListMembers(const Place& place, Table& table) {
  if (place.member != nullptr) return AddMember(place.noun, *place.member, table);
  const auto add = [&table](const std::string& noun, const auto& members) {
    for (const auto& one : members) AddMember(noun, one, table);
  };
  if (place.provided != nullptr) {
    add("command", place.provided->commands);
    add("event", place.provided->events);
  } else {
    add("function", place.required->functions);
    add("handler", place.required->event_handlers);
  }
}

Table ListingOf(const Catalog& catalog, const Place& place) {
  if (place.process == nullptr) {
    Table table({"PROCESS", "STATE", "HOST", "PID", "COMPONENTS", "ADDRESS"});
    ListProcesses(catalog, table);
    return table;
  }
  if (place.component == nullptr) {
    Table table({"COMPONENT", "STATE", "CLASS", "PERIOD/s"});
    ListComponents(*place.process, table);
    return table;
  }
  if (place.provided == nullptr && place.required == nullptr) {
    Table table({"INTERFACE", "SIDE", "MEMBERS", "CONNECTED"});
    ListInterfaces(catalog, place, table);
    return table;
  }
  Table table({"MEMBER", "KIND", "TYPE"});
  ListMembers(place, table);
  return table;
}

ordered_json JsonOf(const Catalog& catalog, const Place& place) {
  if (place.member != nullptr) return {{"member", ToJson(*place.member)}};
  if (place.provided != nullptr) return {{"interface", ToJson(*place.provided)}};
  if (place.required != nullptr) return {{"interface", ToJson(*place.required)}};
  if (place.component != nullptr) return {{"component", ToJson(*place.component)}};
  if (place.process != nullptr) return {{"process", ToJson(*place.process)}};
  ordered_json processes = ordered_json::array();
  for (const auto& [name, entry] : catalog.processes()) processes.push_back(ToJson(entry));
  return {{"processes", std::move(processes)}};
}

Result<ExitCode> List(Context& context, const std::string& path) {
  const auto client = context.Client();
  if (!client) return client.error();
  const Catalog catalog = (*client)->catalog();
  const auto place = path.empty() ? Result<Place>(Place{}) : FindPlace(catalog, path);
  if (!place) return place.error();
  if (context.settings().json) {
    context.PrintJson(JsonOf(catalog, *place));
  } else {
    ListingOf(catalog, *place).Print(context.out(), context.columns());
  }
  return program::kOk;
}

void PrintTree(const Catalog& catalog, std::ostream& out) {
  for (const auto& [process_name, entry] : catalog.processes()) {
    out << Plain(process_name) << "  " << ToString(entry.process.state) << '\n';
    for (const auto& [name, component] : entry.components) {
      out << "  " << Plain(name) << "  " << ToString(component.state) << '\n';
      for (const auto& one : component.provided) {
        const std::string users = Users(catalog, {process_name, name, one.name});
        out << "    " << Plain(one.name) << "  provided" << (users.empty() ? "" : "  ")
            << Plain(users) << '\n';
      }
      for (const auto& one : component.required) {
        out << "    " << Plain(one.name) << "  required  "
            << Plain(Provider(catalog, {process_name, name, one.name})) << '\n';
      }
    }
  }
}

Result<ExitCode> Tree(Context& context) {
  if (context.settings().json) return List(context, "");
  const auto client = context.Client();
  if (!client) return client.error();
  PrintTree((*client)->catalog(), context.out());
  return program::kOk;
}

/// What there is to say of one thing, a line each.
Table Facts(const Catalog& catalog, const Place& place) {
  Table table({"WHAT", "VALUE"});
  const auto& process = place.process->process;
  table.Add({"process", process.name});
  if (place.component == nullptr) {
    table.Add({"state", std::string(ToString(process.state))});
    if (!process.reason.empty()) table.Add({"reason", process.reason});
    table.Add({"since", tendon::WallTimeText(process.since)});
    table.Add({"host", process.host});
    table.Add({"pid", std::to_string(process.pid)});
    table.Add({"address", process.address});
    return table;
  }
  const auto& component = *place.component;
  table.Add({"component", component.name});
  table.Add({"class", component.class_name});
  if (!component.library.empty()) table.Add({"library", component.library});
  table.Add({"state", std::string(ToString(component.state))});
  if (!component.fault.empty()) {
    table.Add({"fault", component.fault});
    table.Add({"faulted at", tendon::WallTimeText(component.fault_time)});
  }
  if (component.period > 0.0) {
    table.Add({"period", ordered_json(component.period).dump() + " s"});
  }
  const auto name_of = [&](const std::string& interface) {
    return InterfaceName(process.name, component.name, interface);
  };
  if (place.provided != nullptr) {
    table.Add({"provided", place.provided->name});
    const std::string users = Users(catalog, name_of(place.provided->name));
    if (!users.empty()) table.Add({"connection", users});
  }
  if (place.required != nullptr) {
    table.Add({"required", place.required->name});
    table.Add({"connection", Provider(catalog, name_of(place.required->name))});
  }
  if (place.member != nullptr && !place.member->hazard.empty()) {
    table.Add({"hazard", place.member->hazard});
  }
  return table;
}

Result<ExitCode> Show(Context& context, const std::string& path) {
  if (context.settings().json) return List(context, path);
  const auto client = context.Client();
  if (!client) return client.error();
  const Catalog catalog = (*client)->catalog();
  const auto place = FindPlace(catalog, path);
  if (!place) return place.error();
  Facts(catalog, *place).Print(context.out(), context.columns());
  context.out() << '\n';
  ListingOf(catalog, *place).Print(context.out(), context.columns());
  return program::kOk;
}

}  // namespace

std::vector<Verb> LookVerbs() {
  return {
      {"ls", "list processes, or what is in one thing",
       [](CLI::App& app) -> Verb::Run {
         auto path = std::make_shared<std::string>();
         app.add_option("path", *path,
                        "process/component/interface.member, or the beginning of it");
         return [path](Context& context) { return List(context, *path); };
       }},
      {"tree", "show the whole catalogue", [](CLI::App&) -> Verb::Run { return &Tree; }},
      {"show", "tell all about one process, component or interface",
       [](CLI::App& app) -> Verb::Run {
         auto path = std::make_shared<std::string>();
         app.add_option("path", *path, "what to show")->required();
         return [path](Context& context) { return Show(context, *path); };
       }},
  };
}

}  // namespace console
