#include <gcm_console/catalogue/glob.h>
#include <gcm_console/catalogue/path_target.h>
#include <gcm_console/catalogue/payload_text.h>
#include <gcm_console/catalogue/system_items.h>
#include <gcm_console/feeds/task_feed.h>
#include <gcm_console/output/catalogue_json.h>
#include <gcm_console/output/table.h>
#include <gcm_console/output/text.h>
#include <gcm_console/verbs/path_details.h>
#include <gcm_console/verbs/queries.h>
#include <gcm_console/verbs/verb.h>
#include <tendon/base/text.h>
#include <tendon/gcm/initial_arguments.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/text.h>
#include <tendon/gcm/waiting.h>
#include <tendon/payload/json.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>
#include <thread>

namespace console {
namespace {

using nlohmann::ordered_json;
using program::ExitCode;
using tendon::Catalogue;
using tendon::InterfaceName;
using tendon::Result;
using tendon::message::SystemHealth;

/// Returns the options of the component's own thread; empty if it has no thread or the options are
/// the defaults.
std::string ThreadText(const tendon::ComponentDescription& component) {
  const bool is_usual =
      component.thread.empty() || component.thread.front() == tendon::ThreadOptions();
  return is_usual ? "" : tendon::ToJson(component.thread.front());
}

/// Adds the file of a plug-in, and how this file differs from the running code.
void AddPlugin(const tendon::PluginDescription& plugin, Table& table) {
  table.Add({"library", plugin.name + ": " + tendon::PluginText(plugin)});
  const std::string change = tendon::PluginChangeText(plugin);
  if (change.empty()) return;
  const bool is_gone = plugin.state == tendon::PluginState::kGone;
  table.Add(
      {"plug-in file", change + (is_gone ? "" : ", but the process still uses the old file")});
}

void AddProcess(Context& context, const tendon::ProcessDescription& process, Table& table) {
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
  if (const auto history = AskHistory(context, process.name)) {
    table.Add({"history", tendon::HistoryText(*history)});
  }
  for (const tendon::PluginDescription& plugin : process.plugins) AddPlugin(plugin, table);
}

void AddComponent(const tendon::ProcessEntry& process,
                  const tendon::ComponentDescription& component, Table& table) {
  table.Add({"component", component.name});
  table.Add({"class", component.class_name});
  const auto* plugin = tendon::FindNamed(process.process.plugins, component.library);
  if (plugin != nullptr) {
    AddPlugin(*plugin, table);
  } else if (!component.library.empty()) {
    table.Add({"library", component.library});
  }
  if (!component.configuration.empty()) table.Add({"configuration", component.configuration});
  table.Add({"state", std::string(ToString(component.state))});
  for (const tendon::UnsatisfiedInterface& need : WaitsOf(process, component)) {
    table.Add({"waiting for", need.interface + ": " + need.reason});
  }
  if (!component.fault.empty()) {
    table.Add({"fault", component.fault});
    table.Add({"faulted at", tendon::WallTimeText(component.fault_time)});
  }
  if (!component.warning.empty()) table.Add({"warning", component.warning});
  if (component.period > 0.0) {
    table.Add({"period", ordered_json(component.period).dump() + " s"});
  }
  if (!component.leader.empty()) table.Add({"runs after", component.leader});
  if (const std::string thread = ThreadText(component); !thread.empty()) {
    table.Add({"thread", thread});
  }
}

/// Returns the facts about an object, one per line.
Table Facts(Context& context, const Catalogue& catalogue, const PathTarget& target) {
  Table table({"WHAT", "VALUE"});
  const auto& process = target.process->process;
  table.Add({"process", process.name});
  if (target.component == nullptr) {
    AddProcess(context, process, table);
    return table;
  }
  const auto& component = *target.component;
  AddComponent(*target.process, component, table);
  const auto name_of = [&](const std::string& interface) {
    return InterfaceName(process.name, component.name, interface);
  };
  if (target.provided != nullptr) {
    table.Add({"provided", target.provided->name});
    const std::string users = UsersOf(catalogue, name_of(target.provided->name));
    if (!users.empty()) table.Add({"connection", users});
  }
  if (target.required != nullptr) {
    table.Add({"required", target.required->name});
    const InterfaceName required = name_of(target.required->name);
    table.Add({"connection", ProviderOf(catalogue, required)});
    const auto* connection = catalogue.FindConnection(required);
    if (connection != nullptr) table.Add({"number", std::to_string(connection->id)});
  }
  if (target.member != nullptr && !target.member->hazard.empty()) {
    table.Add({"hazard", target.member->hazard});
  }
  if (target.member != nullptr && target.member->expires_after > 0.0) {
    table.Add(
        {"expires", "unless called again within " + ExpiryText(target.member->expires_after)});
  }
  return table;
}

/// Adds the timing of a running task in the last second. The task's state table contains these
/// figures.
void AddTask(tendon::GcmClient& client, const PathTarget& target, Table& table) {
  using namespace std::chrono_literals;
  constexpr double kMicro = 1e6;
  constexpr double kPercent = 100.0;
  TaskFeed feed(client, target.process->process.name + "/" + target.component->name);
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

/// Returns "3 of 64 used".
std::string WaitingText(std::uint64_t waiting, std::uint64_t capacity) {
  return std::to_string(waiting) + " of " + std::to_string(capacity) + " used";
}

/// Adds the health of a working connection.
void AddCounts(Context& context, const PathTarget& target, Table& table) {
  const auto counts = AskCounts(context, target);
  if (!counts) return;
  using Seconds = std::chrono::duration<double>;
  using Microseconds = std::chrono::duration<double, std::micro>;
  const double age = Seconds(counts->age).count();
  table.Add({"connected for", Fixed(age, 1) + " s"});
  if (counts->round_trip.count() >= 0) {
    table.Add({"round trip", Fixed(Microseconds(counts->round_trip).count(), 0) + " us"});
  }
  const double rate = age > 0.0 ? static_cast<double>(counts->taken) / age : 0.0;
  table.Add({"calls, events", std::to_string(counts->taken) + ", " + Fixed(rate, 1) +
                                  " per second since the connection was made; reads do not use the "
                                  "mailbox and are not counted"});
  if (counts->capacity > 0) {
    table.Add({"mailbox", WaitingText(counts->waiting, counts->capacity)});
  }
  table.Add({"refused", std::to_string(counts->refused)});
  table.Add({"replaced", std::to_string(counts->replaced)});
  table.Add({"lost events", std::to_string(counts->lost_events)});
}

/// Prints the fields of a member's argument or result. Requests the type from the process.
void PrintPayload(Context& context, const std::string& process, const std::string& title,
                  const tendon::Fingerprint& fingerprint) {
  const auto schema = AskSchema(context, process, fingerprint);
  if (!schema) {
    context.err() << "gcm: the content of the " << title
                  << " is unknown: " << Plain(schema.error().message) << '\n';
    return;
  }
  context.out() << '\n' << title << '\n';
  context.Print(FieldsOf(*schema));
}

/// Prints the read commands that return the value that a command sets, as lines to copy. `show`
/// does not call them, because it must only display.
void PrintReads(Context& context, const PathTarget& target, const std::string& path,
                const tendon::Schema& schema) {
  const std::string interface = path.substr(0, path.rfind('.') + 1);
  for (const auto& read : MatchingReads(*target.provided, *target.member)) {
    std::string what = "all of it";
    if (!read.is_whole) {
      const auto offered = AskSchema(context, target.process->process.name, read.type);
      if (!offered) return;
      what = Joined(CommonFields(schema, *offered), ", ");
    }
    if (what.empty()) continue;
    context.out() << "gcm get " << interface << read.name << "  # the current values of: " << what
                  << '\n';
  }
}

/// Prints the line that calls the command, so that the user can copy it.
void PrintCall(Context& context, const PathTarget& target, const std::string& path) {
  const auto& member = *target.member;
  if (!TakesArgument(member.signature)) {
    context.out() << "\ngcm call " << path << '\n';
    return;
  }
  const auto schema = AskSchema(context, target.process->process.name, member.signature.in);
  if (!schema) return;
  context.out() << "\ngcm call " << path << " '" << JsonSkeleton(*schema) << "'\n";
  PrintReads(context, target, path, *schema);
}

void PrintPayloads(Context& context, const PathTarget& target, const std::string& path) {
  const auto& member = *target.member;
  const std::string& process = target.process->process.name;
  const auto& signature = member.signature;
  if (TakesArgument(signature)) PrintPayload(context, process, "argument", signature.in);
  if (HasResult(member)) PrintPayload(context, process, "result", member.signature.out);
  if (target.noun == "command") PrintCall(context, target, path);
}

void PrintTarget(Context& context, const Catalogue& catalogue, const PathTarget& target,
                 const std::string& path) {
  Table facts = Facts(context, catalogue, target);
  const bool is_component =
      target.component != nullptr && target.provided == nullptr && target.required == nullptr;
  if (is_component && target.component->state == tendon::ComponentState::kActive) {
    if (const auto client = context.Client()) AddTask(**client, target, facts);
  }
  if (is_component) {
    const auto fill = AskFill(context, target);
    if (fill) facts.Add({"mailbox", WaitingText(fill->waiting, fill->capacity)});
  }
  if (target.required != nullptr) AddCounts(context, target, facts);
  context.Print(facts);
  context.out() << '\n';
  context.Print(ListingOf(catalogue, target));
  if (target.member != nullptr) PrintPayloads(context, target, path);
}

/// Shows all objects that match, each below its path.
Result<ExitCode> ShowAll(Context& context, const std::string& glob) {
  const auto client = context.Client();
  if (!client) return client.error();
  const Catalogue catalogue = (*client)->catalogue();
  const auto items = MatchingItems(catalogue, glob);
  if (!items) return items.error();
  auto all = nlohmann::ordered_json::array();
  for (const SystemItem& item : *items) {
    const auto target = FindTarget(catalogue, item.path);
    if (!target) continue;
    if (context.settings().json) {
      all.push_back({{"path", item.path}});
      all.back().update(JsonOf(context, catalogue, *target));
      continue;
    }
    context.out() << (&item == &items->front() ? "" : "\n") << Plain(item.path) << ":\n";
    PrintTarget(context, catalogue, *target, item.path);
  }
  if (context.settings().json) context.PrintJson({{"things", std::move(all)}});
  return program::kOk;
}

Result<ExitCode> Show(Context& context, const std::string& path) {
  if (IsGlob(path)) return ShowAll(context, path);
  const auto client = context.Client();
  if (!client) return client.error();
  const Catalogue catalogue = (*client)->catalogue();
  const auto target = FindTarget(catalogue, path);
  if (!target) return target.error();
  if (context.settings().json) {
    context.PrintJson(JsonOf(context, catalogue, *target));
  } else {
    PrintTarget(context, catalogue, *target, path);
  }
  return program::kOk;
}

}  // namespace

std::vector<Verb> ShowVerbs() {
  return {
      {"show", "show all details of a process, component, interface or member",
       [](CLI::App& app) -> Verb::Run {
         auto path = std::make_shared<std::string>();
         WithKind(app.add_option("path", *path, "path, or a pattern with * that matches several"),
                  WordKind::kPath)
             ->required();
         return [path](Context& context) { return Show(context, *path); };
       }},
  };
}

}  // namespace console
