#include <gcm_console/catalogue/find_term.h>
#include <gcm_console/catalogue/system_items.h>
#include <gcm_console/feeds/query_throttle.h>
#include <gcm_console/output/dot.h>
#include <gcm_console/output/svg.h>
#include <gcm_console/output/table.h>
#include <gcm_console/output/text.h>
#include <gcm_console/verbs/verb.h>
#include <tendon/base/text.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/text.h>
#include <tendon/gcm/waiting.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>

namespace console {
namespace {

using nlohmann::ordered_json;
using program::ExitCode;
using tendon::Catalogue;
using tendon::Error;
using tendon::ErrorCode;
using tendon::Result;

/// Counts the objects and the problems of a system.
struct Health {
  std::size_t processes = 0;
  std::size_t connections = 0;
  std::size_t wrong = 0;
  std::set<std::string> at_rest{};  ///< components that have connections but do not run
  std::set<std::string> verbs{};    ///< verbs that show details or help to solve the problem
};

/// Returns the number of components in each state: "3 active, 1 faulted".
std::string StatesOf(const tendon::ProcessEntry& entry) {
  std::map<std::string, int> states;
  for (const auto& [name, component] : entry.components) {
    ++states[std::string(ToString(component.state))];
  }
  std::string text;
  for (const auto& [state, count] : states) {
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + state;
  }
  return text.empty() ? "no components" : "components: " + text;
}

/// For each connection that does not work, its reason and duration as its process reports them.
using Waits = std::map<tendon::InterfaceName, std::string>;

/// Requests the reasons from the processes. Sends no more requests than are allowed at once, and
/// waits only briefly for the replies.
Waits AskForWaits(tendon::GcmClient& client, const Catalogue& catalogue) {
  constexpr std::chrono::milliseconds kSoon(500);
  struct Replies {
    std::mutex mutex;
    std::condition_variable changed;
    std::size_t missing = 0;
    Waits waits;
  };
  std::vector<tendon::InterfaceName> broken;
  for (const auto& one : catalogue.connections()) {
    const auto* owner = catalogue.FindProcess(one.required.process);
    const bool can_tell = owner != nullptr && IsPresent(owner->process);
    if (one.state != tendon::ConnectionState::kActive && can_tell) broken.push_back(one.required);
  }
  const auto asked = QueryThrottle().Begin(broken, tendon::SteadyClock().Now());
  const auto replies = std::make_shared<Replies>();
  replies->missing = asked.size();
  for (const auto& one : asked) {
    client.GetCounts(one, [replies, required = one](const auto& counts) {
      const std::scoped_lock lock(replies->mutex);
      --replies->missing;
      const bool is_reason = !counts && counts.error().code == ErrorCode::kFailed;
      if (is_reason) replies->waits.emplace(required, counts.error().message);
      replies->changed.notify_all();
    });
  }
  std::unique_lock lock(replies->mutex);
  replies->changed.wait_for(lock, kSoon, [&] { return replies->missing == 0; });
  return replies->waits;
}

/// A row in the table of all objects with problems.
struct StatusRow {
  std::string kind;
  std::string name;
  std::string state;
  std::string detail;
};

/// Adds the plug-ins whose files differ from the running code.
void AddPlugins(const tendon::ProcessDescription& process, std::vector<StatusRow>& rows,
                Health& health) {
  for (const tendon::PluginDescription& plugin : process.plugins) {
    if (plugin.state == tendon::PluginState::kCurrent || !IsPresent(process)) continue;
    ++health.wrong;
    health.verbs.insert("gcm doctor");
    rows.push_back({"plug-in", process.name + " " + plugin.name,
                    std::string(ToString(plugin.state)), OutdatedPluginText(process.name, plugin)});
  }
}

/// Adds a component that is faulted, late or waiting. A failed connection is not added here,
/// because it has its own row.
void AddComponent(const tendon::ProcessEntry& entry, const tendon::ComponentDescription& component,
                  std::vector<StatusRow>& rows, Health& health) {
  const auto add = [&](const std::string& what) {
    rows.push_back({"component", entry.process.name + "/" + component.name,
                    std::string(ToString(component.state)), what});
  };
  const std::string& trouble = component.fault.empty() ? component.warning : component.fault;
  if (!trouble.empty()) {
    ++health.wrong;
    health.verbs.insert("gcm log");
    add(trouble);
  }
  const auto waits = WaitsOf(entry, component);
  if (waits.empty()) return;
  add(WaitingReasons(waits));
  if (std::ranges::all_of(waits, &tendon::UnsatisfiedInterface::has_connection)) return;
  ++health.wrong;
  health.verbs.insert("gcm doctor");  // gcm doctor names the interface that is not connected
}

std::vector<StatusRow> StatusRows(const Catalogue& catalogue, const Waits& waits, Health& health) {
  std::vector<StatusRow> rows;
  for (const auto& [name, entry] : catalogue.processes()) {
    const auto& process = entry.process;
    const bool is_alive = process.state == tendon::ProcessState::kAlive;
    const bool is_well = is_alive && process.reason.empty();
    ++health.processes;
    health.wrong += is_well ? 0 : 1;
    if (!is_well) {
      const bool is_to_be_looked_at = is_alive || HasFallenSilent(process);
      health.verbs.insert(is_to_be_looked_at   ? "gcm doctor"
                          : IsPresent(process) ? "gcm log"
                                               : "gcm forget");
    }
    rows.push_back({"process", name, std::string(ToString(process.state)),
                    is_well ? StatesOf(entry) : process.reason});
    AddPlugins(process, rows, health);
    for (const auto& [component, description] : entry.components) {
      AddComponent(entry, description, rows, health);
    }
  }
  for (const auto& connection : catalogue.connections()) {
    ++health.connections;
    const bool is_well = connection.state == tendon::ConnectionState::kActive;
    health.wrong += is_well ? 0 : 1;
    if (!is_well) health.verbs.insert("gcm explain");
    for (const tendon::InterfaceName* end : {&connection.required, &connection.provided}) {
      const auto* component = catalogue.FindComponent(end->process, end->component);
      const bool rests = component != nullptr && component->fault.empty() &&
                         component->state != tendon::ComponentState::kActive;
      if (is_well && rests) health.at_rest.insert(end->process + "/" + end->component);
    }
    const auto wait = waits.find(connection.required);
    const std::string& why = wait == waits.end() ? connection.reason : wait->second;
    rows.push_back({"connection", ToString(connection.required),
                    std::string(ToString(connection.state)),
                    "-> " + ToString(connection.provided) + (why.empty() ? "" : ": " + why)});
  }
  return rows;
}

/// Returns "all is well", or a sentence about the problems.
std::string VerdictOn(const Health& health) {
  if (health.wrong > 0) {
    return tendon::Counted(health.wrong, "object", "objects") + " with a problem: see " +
           Joined(health.verbs, ", ");
  }
  if (health.at_rest.empty()) return "all is well";
  return "no problem was found, but some connected components do not run: " +
         Joined(health.at_rest, ", ");
}

Result<ExitCode> Status(Context& context) {
  const auto client = context.Client();
  if (!client) return client.error();
  Health health;
  const Catalogue catalogue = (*client)->catalogue();
  const auto rows = StatusRows(catalogue, AskForWaits(**client, catalogue), health);
  if (context.settings().json) {
    ordered_json all = ordered_json::array();
    for (const auto& [kind, name, state, detail] : rows) {
      all.push_back({{"kind", kind}, {"name", name}, {"state", state}, {"detail", detail}});
    }
    context.PrintJson({{"wrong", health.wrong},
                       {"content_hash", ToString(catalogue.ContentHash())},
                       {"things", std::move(all)}});
    return program::kOk;
  }
  Table table({"WHAT", "NAME", "STATE", "DETAIL"});
  for (const auto& [kind, name, state, detail] : rows) table.Add({kind, name, state, detail});
  context.Print(table);
  context.out().flush();
  context.err() << "gcm: " << tendon::Counted(health.processes, "process", "processes") << ", "
                << tendon::Counted(health.connections, "connection", "connections") << "; "
                << VerdictOn(health) << '\n';
  return program::kOk;
}

Result<ExitCode> Find(Context& context, const std::vector<std::string>& words) {
  std::vector<FindTerm> terms;
  for (const std::string& word : words) {
    const auto term = FindTerm::Parse(word);
    if (!term) return term.error();
    terms.push_back(*term);
  }
  const auto client = context.Client();
  if (!client) return client.error();
  auto items = ItemsIn((*client)->catalogue());
  std::erase_if(items, [&terms](const SystemItem& item) {
    return !std::ranges::all_of(terms, [&](const FindTerm& term) { return term.Fits(item); });
  });
  if (items.empty()) {
    return Error{ErrorCode::kNotFound,
                 "nothing matches '" + Joined(words, " ") + "'; to list all names: gcm ls -R"};
  }
  PrintItems(context, items);
  return program::kOk;
}

/// Prints each component with its connections and its unconnected interfaces.
void PrintText(const Catalogue& catalogue, std::ostream& out) {
  for (const auto& [name, entry] : catalogue.processes()) {
    for (const auto& [component, description] : entry.components) {
      out << Plain(name) << '/' << Plain(component) << '\n';
      for (const auto& one : description.required) {
        out << "  " << Plain(one.name) << "  "
            << Plain(ProviderOf(catalogue, {name, component, one.name})) << '\n';
      }
    }
  }
}

struct GraphOptions {
  bool is_dot = false;
  bool is_svg = false;
};

Result<ExitCode> Graph(Context& context, const GraphOptions& options) {
  const auto client = context.Client();
  if (!client) return client.error();
  const Catalogue catalogue = (*client)->catalogue();
  if (context.settings().json) {
    ordered_json nodes = ordered_json::array();
    ordered_json edges = ordered_json::array();
    for (const SystemItem& item : ItemsIn(catalogue)) {
      if (item.kind == "component") nodes.push_back(item.path);
    }
    for (const auto& connection : catalogue.connections()) {
      edges.push_back({{"required", ToString(connection.required)},
                       {"provided", ToString(connection.provided)},
                       {"state", ToString(connection.state)}});
    }
    context.PrintJson({{"components", std::move(nodes)}, {"connections", std::move(edges)}});
  } else if (options.is_dot) {
    PrintDot(catalogue, context.out());
  } else if (options.is_svg) {
    PrintSvg(DiagramOf(catalogue), context.out());
  } else {
    PrintText(catalogue, context.out());
  }
  return program::kOk;
}

Verb::Run PrepareGraph(CLI::App& app) {
  auto options = std::make_shared<GraphOptions>();
  auto* dot = app.add_flag("--dot", options->is_dot, "for Graphviz");
  auto* svg =
      app.add_flag("--svg", options->is_svg, "print a picture of the whole system")->excludes(dot);
  app.add_flag("--text")
      ->description("print a line for each interface that is used (default)")
      ->excludes(dot)
      ->excludes(svg);
  return [options](Context& context) { return Graph(context, *options); };
}

}  // namespace

std::vector<Verb> FindVerbs() {
  return {
      {"status", "show the state of all processes and connections on one screen",
       [](CLI::App&) -> Verb::Run { return &Status; }},
      {"find",
       "list everything that matches a pattern",
       [](CLI::App& app) -> Verb::Run {
         auto terms = std::make_shared<std::vector<std::string>>();
         app.add_option("expression", *terms,
                        "a part of a path, a whole path with * and **, or a regular /expression/; "
                        "a term after type:, state:, host: or proc: is compared with this "
                        "property; a term after ! must not match; all terms must match")
             ->required();
         return [terms](Context& context) { return Find(context, *terms); };
       },
       {"gcm find Joints", "gcm find '**/Control.*' type:arm.*", "gcm find '/Get|Set/' type:cmd",
        "gcm find state:faulted", "gcm find type:required 'state:!active'"}},
      {"graph",
       "show which component uses which other component",
       &PrepareGraph,
       {"gcm graph --svg > system.svg", "gcm graph --dot | dot -Tpng > system.png"}},
  };
}

}  // namespace console
