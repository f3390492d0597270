#include <gcm_console/catalogue_json.h>
#include <gcm_console/report.h>
#include <gcm_console/verb.h>
#include <tendon/base/path.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

namespace console {
namespace {

using nlohmann::ordered_json;
using program::ExitCode;
using tendon::Catalog;
using tendon::Error;
using tendon::ErrorCode;
using tendon::Path;
using tendon::Result;

/// What a path names in the catalogue: as deep as the path goes, the rest null.
struct Place {
  const tendon::ProcessEntry* process = nullptr;
  const tendon::ComponentDescription* component = nullptr;
  const tendon::ProvidedDescription* provided = nullptr;
  const tendon::RequiredDescription* required = nullptr;
};

Error Missing(const std::string& what, const std::string& name,
              const std::vector<std::string>& known) {
  return {ErrorCode::kNotFound, "no " + what + " '" + name + "'" + tendon::DidYouMean(name, known)};
}

template <typename Map>
std::vector<std::string> Keys(const Map& map) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : map) keys.push_back(key);
  return keys;
}

Result<Place> FindInterface(const tendon::ComponentDescription& component, Place place,
                            const std::string& name) {
  std::vector<std::string> known;
  for (const auto& one : component.provided) {
    known.push_back(one.name);
    if (one.name == name) place.provided = &one;
  }
  for (const auto& one : component.required) {
    known.push_back(one.name);
    if (one.name == name) place.required = &one;
  }
  if (place.provided == nullptr && place.required == nullptr) {
    return Missing("interface", name, known);
  }
  return place;
}

Result<Place> Find(const Catalog& catalog, const std::string& text) {
  const auto path = tendon::ParsePath(text);
  if (!path) return path.error();
  Place place;
  place.process = catalog.FindProcess(path->process);
  if (place.process == nullptr) return Missing("process", path->process, Keys(catalog.processes()));
  if (path->component.empty()) return place;
  const auto component = place.process->components.find(path->component);
  if (component == place.process->components.end()) {
    return Missing("component", path->component, Keys(place.process->components));
  }
  place.component = &component->second;
  if (path->interface.empty()) return place;
  return FindInterface(*place.component, place, path->interface);
}

std::string Types(const tendon::MemberDescription& member) {
  const bool has_in = member.in_type != "tendon.None";
  const bool has_out = member.out_type != "tendon.None";
  if (has_in && has_out) return member.in_type + " -> " + member.out_type;
  return has_in ? member.in_type : has_out ? member.out_type : "";
}

std::string Peer(const Catalog& catalog, const tendon::InterfaceName& required) {
  const auto* connection = catalog.FindConnection(required);
  if (connection == nullptr) return "not connected";
  const std::string peer = "-> " + ToString(connection->provided);
  if (connection->state == tendon::ConnectionState::kActive) return peer;
  return peer + " (" + std::string(ToString(connection->state)) + ": " + connection->reason + ")";
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
  for (const auto& one : place.component->provided) {
    table.Add({one.name, "provided", std::to_string(one.commands.size() + one.events.size()), ""});
  }
  for (const auto& one : place.component->required) {
    table.Add({one.name, "required",
               std::to_string(one.functions.size() + one.event_handlers.size()),
               Peer(catalog, {place.process->process.name, place.component->name, one.name})});
  }
}

void ListMembers(const Place& place, Table& table) {
  const auto add = [&table](const std::string& noun, const auto& members) {
    for (const auto& one : members) {
      table.Add({one.name, std::string(ToString(one.signature.kind)) + " " + noun, Types(one)});
    }
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
  const auto place = path.empty() ? Result<Place>(Place{}) : Find(catalog, path);
  if (!place) return place.error();
  if (context.settings().json) {
    context.PrintJson(JsonOf(catalog, *place));
  } else {
    ListingOf(catalog, *place).Print(context.out(), context.on_terminal());
  }
  return program::kOk;
}

void PrintTree(const Catalog& catalog, std::ostream& out) {
  for (const auto& [process_name, entry] : catalog.processes()) {
    out << Plain(process_name) << "  " << ToString(entry.process.state) << '\n';
    for (const auto& [name, component] : entry.components) {
      out << "  " << Plain(name) << "  " << ToString(component.state) << '\n';
      for (const auto& one : component.provided) out << "    " << Plain(one.name) << "  provided\n";
      for (const auto& one : component.required) {
        out << "    " << Plain(one.name) << "  required  "
            << Plain(Peer(catalog, {process_name, name, one.name})) << '\n';
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
Table Facts(const Place& place) {
  Table table({"WHAT", "VALUE"});
  const auto& process = place.process->process;
  table.Add({"process", process.name});
  if (place.component == nullptr) {
    table.Add({"state", std::string(ToString(process.state))});
    if (!process.reason.empty()) table.Add({"reason", process.reason});
    table.Add({"host", process.host});
    table.Add({"pid", std::to_string(process.pid)});
    table.Add({"address", process.address});
    return table;
  }
  const auto& component = *place.component;
  table.Add({"component", component.name});
  table.Add({"class", component.class_name});
  table.Add({"library", component.library});
  table.Add({"state", std::string(ToString(component.state))});
  if (!component.fault.empty()) table.Add({"fault", component.fault});
  if (component.period > 0.0) {
    table.Add({"period", ordered_json(component.period).dump() + " s"});
  }
  return table;
}

Result<ExitCode> Show(Context& context, const std::string& path) {
  if (context.settings().json) return List(context, path);
  const auto client = context.Client();
  if (!client) return client.error();
  const Catalog catalog = (*client)->catalog();
  const auto place = Find(catalog, path);
  if (!place) return place.error();
  Facts(*place).Print(context.out(), context.on_terminal());
  context.out() << '\n';
  ListingOf(catalog, *place).Print(context.out(), context.on_terminal());
  return program::kOk;
}

}  // namespace

std::vector<Verb> LookVerbs() {
  return {
      {"ls", "list processes, or what is in one thing",
       [](CLI::App& app) -> Verb::Run {
         auto path = std::make_shared<std::string>();
         app.add_option("path", *path, "process, process/component or process/component/interface");
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
