#include <gcm_console/catalogue/payload_text.h>
#include <gcm_console/catalogue/things.h>
#include <gcm_console/catalogue_json.h>
#include <gcm_console/place.h>
#include <gcm_console/report.h>
#include <gcm_console/screen/screen.h>
#include <gcm_console/screen/task_feed.h>
#include <gcm_console/verb.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/text/health_text.h>
#include <tendon/gcm/text/wall_time.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>
#include <thread>

namespace console {
namespace {

using nlohmann::ordered_json;
using program::ExitCode;
using tendon::Catalog;
using tendon::InterfaceName;
using tendon::Result;
using tendon::message::SystemHealth;

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
               UsersOf(catalog, name_of(one.name))});
  }
  for (const auto& one : place.component->required) {
    table.Add({one.name, "required",
               std::to_string(one.functions.size() + one.event_handlers.size()),
               ProviderOf(catalog, name_of(one.name))});
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

/// As far as the GCM says: what is asked for is the catalogue.
SystemHealth AskHealth(Context& context) {
  auto health = context.Ask<SystemHealth>(
      [](tendon::GcmClient& client, auto handler) { client.GetHealth(handler); });
  return health ? *std::move(health) : SystemHealth{};
}

ordered_json JsonOf(const tendon::ProcessEntry& entry, const SystemHealth& health) {
  ordered_json json = ToJson(entry);
  json["health"] = HealthOf(health, entry.process);
  return json;
}

/// As its process knows; null where it is not connected, or the process does not tell.
std::optional<tendon::ConnectionCounts> AskCounts(Context& context, const Place& place) {
  const InterfaceName required(place.process->process.name, place.component->name,
                               place.required->name);
  const auto counts = context.Ask<tendon::ConnectionCounts>(
      [&](tendon::GcmClient& client, auto handler) { client.GetCounts(required, handler); });
  return counts ? std::optional(*counts) : std::nullopt;
}

std::optional<tendon::MailboxFill> AskFill(Context& context, const Place& place) {
  const auto fill = context.Ask<tendon::MailboxFill>([&](tendon::GcmClient& client, auto handler) {
    client.GetFill(place.process->process.name, place.component->name, handler);
  });
  return fill && fill->capacity > 0 ? std::optional(*fill) : std::nullopt;
}

ordered_json JsonOf(Context& context, const Catalog& catalog, const Place& place) {
  if (place.member != nullptr) return {{"member", ToJson(*place.member)}};
  if (place.provided != nullptr) return {{"interface", ToJson(*place.provided)}};
  if (place.required != nullptr) {
    ordered_json json = {{"interface", ToJson(*place.required)}};
    if (const auto counts = AskCounts(context, place)) json["counts"] = ToJson(*counts);
    return json;
  }
  if (place.component != nullptr) {
    ordered_json json = {{"component", ToJson(*place.component)}};
    if (const auto fill = AskFill(context, place)) json["mailbox"] = ToJson(*fill);
    return json;
  }
  const SystemHealth health = AskHealth(context);
  if (place.process != nullptr) return {{"process", JsonOf(*place.process, health)}};
  ordered_json processes = ordered_json::array();
  for (const auto& [name, entry] : catalog.processes()) processes.push_back(JsonOf(entry, health));
  return {{"processes", std::move(processes)}};
}

struct ListOptions {
  std::string path;
  bool is_recursive = false;
  bool is_long = false;
  std::vector<std::string> types;  ///< codes of nouns
};

/// What the processes among them take of their machines, where nothing else is said of them.
void AddHealth(Context& context, const Catalog& catalog, std::vector<Thing>& things) {
  const auto lacks_detail = [&](const Thing& thing) {
    return thing.noun == "process" && thing.detail.empty();
  };
  if (std::none_of(things.begin(), things.end(), lacks_detail)) return;
  const SystemHealth health = AskHealth(context);
  for (Thing& thing : things) {
    if (!lacks_detail(thing)) continue;
    const auto* of_process = FindHealth(health, catalog.FindProcess(thing.path)->process);
    thing.detail =
        "cpu " + tendon::CpuText(of_process) + ", memory " + tendon::MemoryText(of_process);
  }
}

/// What is to be listed by path instead of by name: everything below a path, or what is right in
/// it, of some kinds only.
Result<ExitCode> ListThings(Context& context, const Catalog& catalog, const ListOptions& options) {
  const bool is_deep = options.is_recursive || !options.types.empty();
  const int deepest = DepthOf(options.path) + 1;
  auto things = ThingsIn(catalog, options.path);
  std::erase_if(things, [&](const Thing& thing) {
    const auto noun = std::find_if(std::begin(kNouns), std::end(kNouns),
                                   [&](const Noun& one) { return one.name == thing.noun; });
    const bool is_wanted =
        options.types.empty() ||
        std::find(options.types.begin(), options.types.end(), noun->code) != options.types.end();
    return !is_wanted || (!is_deep && DepthOf(thing.path) > deepest);
  });
  if (options.is_long) AddHealth(context, catalog, things);
  PrintThings(context, things);
  return program::kOk;
}

Result<ExitCode> List(Context& context, const std::string& path) {
  const auto client = context.Client();
  if (!client) return client.error();
  const Catalog catalog = (*client)->catalog();
  const auto place = path.empty() ? Result<Place>(Place{}) : FindPlace(catalog, path);
  if (!place) return place.error();
  if (context.settings().json) {
    context.PrintJson(JsonOf(context, catalog, *place));
  } else {
    context.Print(ListingOf(catalog, *place));
  }
  return program::kOk;
}

void PrintTree(const Catalog& catalog, std::ostream& out) {
  for (const auto& [process_name, entry] : catalog.processes()) {
    out << Plain(process_name) << "  " << ToString(entry.process.state) << '\n';
    for (const auto& [name, component] : entry.components) {
      out << "  " << Plain(name) << "  " << ToString(component.state) << '\n';
      for (const auto& one : component.provided) {
        const std::string users = UsersOf(catalog, {process_name, name, one.name});
        out << "    " << Plain(one.name) << "  provided" << (users.empty() ? "" : "  ")
            << Plain(users) << '\n';
      }
      for (const auto& one : component.required) {
        out << "    " << Plain(one.name) << "  required  "
            << Plain(ProviderOf(catalog, {process_name, name, one.name})) << '\n';
      }
    }
  }
}

Result<ExitCode> List(Context& context, const ListOptions& options) {
  ListOptions wanted = options;
  if (wanted.path.empty()) wanted.path = context.settings().at;
  if (!wanted.is_recursive && !wanted.is_long && wanted.types.empty()) {
    return List(context, wanted.path);
  }
  const auto client = context.Client();
  if (!client) return client.error();
  const Catalog catalog = (*client)->catalog();
  const auto place = wanted.path.empty() ? Result<Place>(Place{}) : FindPlace(catalog, wanted.path);
  if (!place) return place.error();
  return ListThings(context, catalog, wanted);
}

Result<ExitCode> Tree(Context& context) {
  if (context.settings().json) return List(context, "");
  const auto client = context.Client();
  if (!client) return client.error();
  PrintTree((*client)->catalog(), context.out());
  return program::kOk;
}

/// What there is to say of one thing, a line each.
Table Facts(Context& context, const Catalog& catalog, const Place& place) {
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
    const SystemHealth system = AskHealth(context);
    const auto* health = FindHealth(system, process);
    table.Add({"cpu", tendon::CpuText(health)});
    table.Add({"memory", tendon::MemoryText(health)});
    table.Add({"clock", tendon::ClockText(health)});
    return table;
  }
  const auto& component = *place.component;
  table.Add({"component", component.name});
  table.Add({"class", component.class_name});
  if (!component.library.empty()) table.Add({"library", component.library});
  if (!component.configuration.empty()) table.Add({"configuration", component.configuration});
  table.Add({"state", std::string(ToString(component.state))});
  if (!component.fault.empty()) {
    table.Add({"fault", component.fault});
    table.Add({"faulted at", tendon::WallTimeText(component.fault_time)});
  }
  if (!component.warning.empty()) table.Add({"warning", component.warning});
  if (component.period > 0.0) {
    table.Add({"period", ordered_json(component.period).dump() + " s"});
  }
  const auto name_of = [&](const std::string& interface) {
    return InterfaceName(process.name, component.name, interface);
  };
  if (place.provided != nullptr) {
    table.Add({"provided", place.provided->name});
    const std::string users = UsersOf(catalog, name_of(place.provided->name));
    if (!users.empty()) table.Add({"connection", users});
  }
  if (place.required != nullptr) {
    table.Add({"required", place.required->name});
    const InterfaceName required = name_of(place.required->name);
    table.Add({"connection", ProviderOf(catalog, required)});
    const auto* connection = catalog.FindConnection(required);
    if (connection != nullptr) table.Add({"number", std::to_string(connection->id)});
  }
  if (place.member != nullptr && !place.member->hazard.empty()) {
    table.Add({"hazard", place.member->hazard});
  }
  return table;
}

/// How a task that runs has kept its time in the last second, which it tells at once.
void AddTask(tendon::GcmClient& client, const Place& place, Table& table) {
  using namespace std::chrono_literals;
  constexpr double kMicro = 1e6;
  constexpr double kPercent = 100.0;
  TaskFeed feed(client, place.process->process.name + "/" + place.component->name);
  const auto deadline = std::chrono::steady_clock::now() + 500ms;
  auto tasks = feed.Look();
  while (!tasks.empty() && !tasks[0].is_known && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(5ms);
    tasks = feed.Look();
  }
  if (tasks.empty() || !tasks[0].is_known) return;
  const TaskFigures& task = tasks[0];
  table.Add({"rate", Fixed(task.rate, 1) + " Hz"});
  table.Add({"late", Fixed(task.late * kMicro, 0) + " us, at most " +
                         Fixed(task.latest * kMicro, 0) + " us"});
  table.Add({"compute", Fixed(task.compute * kMicro, 1) + " us"});
  table.Add({"load", Fixed(task.load * kPercent, 1) + " %"});
  table.Add({"skipped", std::to_string(task.skipped)});
}

/// "3 of 64 wait".
std::string WaitingText(std::uint64_t waiting, std::uint64_t capacity) {
  return std::to_string(waiting) + " of " + std::to_string(capacity) + " wait";
}

/// How a connection that stands is doing.
void AddCounts(Context& context, const Place& place, Table& table) {
  const auto counts = AskCounts(context, place);
  if (!counts) return;
  using Seconds = std::chrono::duration<double>;
  using Microseconds = std::chrono::duration<double, std::micro>;
  const double age = Seconds(counts->age).count();
  table.Add({"stands for", Fixed(age, 1) + " s"});
  if (counts->round_trip.count() >= 0) {
    table.Add({"round trip", Fixed(Microseconds(counts->round_trip).count(), 0) + " us"});
  }
  const double rate = age > 0.0 ? static_cast<double>(counts->taken) / age : 0.0;
  table.Add({"calls, events",
             std::to_string(counts->taken) + ", " + Fixed(rate, 1) + " a second since it stands"});
  if (counts->capacity > 0) {
    table.Add({"mailbox", WaitingText(counts->waiting, counts->capacity)});
  }
  table.Add({"refused", std::to_string(counts->refused)});
  table.Add({"replaced", std::to_string(counts->replaced)});
  table.Add({"lost events", std::to_string(counts->lost_events)});
}

/// What goes into a member or comes out of it, field by field; best effort, for the process may be
/// gone.
void PrintPayload(Context& context, const std::string& process, const std::string& title,
                  const tendon::Fingerprint& fingerprint) {
  const auto schema = context.Ask<tendon::Schema>([&](tendon::GcmClient& client, auto handler) {
    client.GetSchema(process, fingerprint, handler);
  });
  if (!schema) {
    context.err() << "gcm: what is in the " << title
                  << " is unknown: " << Plain(schema.error().message) << '\n';
    return;
  }
  context.out() << '\n' << title << '\n';
  context.Print(FieldsOf(*schema));
}

/// How it is called, to be copied.
void PrintCall(Context& context, const Place& place, const std::string& path) {
  const auto& member = *place.member;
  std::string argument;
  if (TakesArgument(member.signature)) {
    const auto schema = context.Ask<tendon::Schema>([&](tendon::GcmClient& client, auto handler) {
      client.GetSchema(place.process->process.name, member.signature.in, handler);
    });
    if (!schema) return;
    argument = " '" + JsonSkeleton(*schema) + "'";
  }
  context.out() << "\ngcm call " << path << argument << '\n';
}

void PrintPayloads(Context& context, const Place& place, const std::string& path) {
  const auto& member = *place.member;
  const std::string& process = place.process->process.name;
  const auto& signature = member.signature;
  if (TakesArgument(signature)) PrintPayload(context, process, "argument", signature.in);
  if (GivesAnswer(member)) PrintPayload(context, process, "answer", member.signature.out);
  if (place.noun == "command") PrintCall(context, place, path);
}

Result<ExitCode> Show(Context& context, const std::string& path) {
  if (context.settings().json) return List(context, path);
  const auto client = context.Client();
  if (!client) return client.error();
  const Catalog catalog = (*client)->catalog();
  const auto place = FindPlace(catalog, path);
  if (!place) return place.error();
  Table facts = Facts(context, catalog, *place);
  const bool is_component =
      place->component != nullptr && place->provided == nullptr && place->required == nullptr;
  if (is_component && place->component->state == tendon::ComponentState::kActive) {
    AddTask(**client, *place, facts);
  }
  if (is_component) {
    const auto fill = AskFill(context, *place);
    if (fill) facts.Add({"mailbox", WaitingText(fill->waiting, fill->capacity)});
  }
  if (place->required != nullptr) AddCounts(context, *place, facts);
  context.Print(facts);
  context.out() << '\n';
  context.Print(ListingOf(catalog, *place));
  if (place->member != nullptr) PrintPayloads(context, *place, path);
  return program::kOk;
}

Verb::Run PrepareList(CLI::App& app) {
  auto options = std::make_shared<ListOptions>();
  Names(app.add_option("path", options->path,
                       "process/component/interface.member, or the beginning of it"),
        WordKind::kPath);
  app.add_flag("-R,--recursive", options->is_recursive, "and what is in that, by path");
  app.add_flag("-l,--long", options->is_long, "by path, with type, state and who is connected");
  std::vector<std::string> codes;
  for (const Noun& noun : kNouns) codes.emplace_back(noun.code);
  app.add_option("--type", options->types, "only these, at any depth; several with commas between")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(codes));
  return [options](Context& context) { return List(context, *options); };
}

}  // namespace

std::vector<Verb> LookVerbs() {
  return {
      {"ls",
       "list processes, or what is in one thing",
       &PrepareList,
       {"gcm ls robot/arm", "gcm ls -R -l", "gcm ls robot --type cmd,event"}},
      {"tree", "show the whole catalogue", [](CLI::App&) -> Verb::Run { return &Tree; }},
      {"show", "tell all about one process, component, interface or member",
       [](CLI::App& app) -> Verb::Run {
         auto path = std::make_shared<std::string>();
         Names(app.add_option("path", *path, "what to show"), WordKind::kPath)->required();
         return [path](Context& context) { return Show(context, *path); };
       }},
  };
}

}  // namespace console
