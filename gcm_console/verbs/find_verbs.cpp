#include <gcm_console/catalogue/things.h>
#include <gcm_console/graph/svg.h>
#include <gcm_console/report.h>
#include <gcm_console/verb.h>
#include <tendon/base/path.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

namespace console {
namespace {

using nlohmann::ordered_json;
using program::ExitCode;
using tendon::Catalog;
using tendon::Error;
using tendon::ErrorCode;
using tendon::Result;

/// How many there are of each.
struct Health {
  std::size_t processes = 0;
  std::size_t connections = 0;
  std::size_t wrong = 0;
};

/// "3 active, 1 faulted".
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

/// A row of the one table in which everything is, and what is wrong at all.
struct StatusRow {
  std::string kind;
  std::string name;
  std::string state;
  std::string detail;
};

std::vector<StatusRow> StatusRows(const Catalog& catalog, Health& health) {
  std::vector<StatusRow> rows;
  for (const auto& [name, entry] : catalog.processes()) {
    const auto& process = entry.process;
    const bool is_well = process.state == tendon::ProcessState::kAlive;
    ++health.processes;
    health.wrong += is_well ? 0 : 1;
    rows.push_back({"process", name, std::string(ToString(process.state)),
                    is_well ? StatesOf(entry) : process.reason});
    for (const auto& [component, description] : entry.components) {
      const std::string what = description.fault.empty() ? description.warning : description.fault;
      if (what.empty()) continue;
      ++health.wrong;
      rows.push_back(
          {"component", name + "/" + component, std::string(ToString(description.state)), what});
    }
  }
  for (const auto& connection : catalog.connections()) {
    ++health.connections;
    health.wrong += connection.state == tendon::ConnectionState::kActive ? 0 : 1;
    rows.push_back({"connection", ToString(connection.required),
                    std::string(ToString(connection.state)),
                    "-> " + ToString(connection.provided) +
                        (connection.reason.empty() ? "" : ": " + connection.reason)});
  }
  return rows;
}

std::string Count(std::size_t count, const std::string& noun) {
  const std::string end = noun.ends_with("s") ? "es" : "s";
  return std::to_string(count) + " " + noun + (count == 1 ? "" : end);
}

Result<ExitCode> Status(Context& context) {
  const auto client = context.Client();
  if (!client) return client.error();
  Health health;
  const auto rows = StatusRows((*client)->catalog(), health);
  if (context.settings().json) {
    ordered_json all = ordered_json::array();
    for (const auto& [kind, name, state, detail] : rows) {
      all.push_back({{"kind", kind}, {"name", name}, {"state", state}, {"detail", detail}});
    }
    context.PrintJson({{"wrong", health.wrong}, {"things", std::move(all)}});
    return program::kOk;
  }
  Table table({"WHAT", "NAME", "STATE", "DETAIL"});
  for (const auto& [kind, name, state, detail] : rows) table.Add({kind, name, state, detail});
  context.Print(table);
  context.out().flush();
  context.err() << "gcm: " << Count(health.processes, "process") << ", "
                << Count(health.connections, "connection") << "; "
                << (health.wrong == 0 ? "all is well"
                                      : Count(health.wrong, "thing") +
                                            " not as it should be: see gcm explain, gcm log")
                << '\n';
  return program::kOk;
}

std::string Lower(std::string text) {
  for (char& letter : text) {
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return text;
}

/// A pattern where it has a star, else any part, in upper or lower case.
bool Fits(const std::string& wanted, const std::string& text) {
  if (wanted.find('*') != std::string::npos) return tendon::MatchesGlob(wanted, text);
  return Lower(text).find(Lower(wanted)) != std::string::npos;
}

bool FitsTerm(const std::string& term, const Thing& thing) {
  if (term.starts_with("type:")) return !thing.type.empty() && Fits(term.substr(5), thing.type);
  if (term.starts_with("state:")) return !thing.state.empty() && Fits(term.substr(6), thing.state);
  if (term.starts_with("host:")) return Fits(term.substr(5), thing.host);
  return Fits(term, thing.path);
}

Result<void> CheckTerm(const std::string& term) {
  static const std::vector<std::string> kKeys = {"type", "state", "host"};
  const auto colon = term.find(':');
  if (colon == std::string::npos) return {};
  const std::string key = term.substr(0, colon);
  if (std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end()) return {};
  const std::string near = tendon::DidYouMean(key, kKeys);
  return Error{ErrorCode::kInvalid, "'" + term + "': there is no '" + key + ":'" + near +
                                        (near.empty() ? "; " : " ") +
                                        "known are type:, state: and host:"};
}

Result<ExitCode> Find(Context& context, const std::vector<std::string>& terms) {
  for (const std::string& term : terms) {
    if (auto known = CheckTerm(term); !known) return known.error();
  }
  const auto client = context.Client();
  if (!client) return client.error();
  auto things = ThingsIn((*client)->catalog());
  std::erase_if(things, [&](const Thing& thing) {
    return !std::all_of(terms.begin(), terms.end(),
                        [&](const std::string& term) { return FitsTerm(term, thing); });
  });
  if (things.empty()) {
    std::string all;
    for (const std::string& term : terms) all += (all.empty() ? "" : " ") + term;
    return Error{ErrorCode::kNotFound,
                 "nothing fits '" + all + "'; gcm ls -R lists everything there is"};
  }
  PrintThings(context, things);
  return program::kOk;
}

std::string Quoted(const std::string& text) { return "\"" + Plain(text) + "\""; }

/// A component's node.
std::string NodeOf(const tendon::InterfaceName& end) {
  return Quoted(end.process + "/" + end.component);
}

/// For Graphviz: `gcm graph --dot | dot -Tsvg`.
void PrintDot(const Catalog& catalog, std::ostream& out) {
  out << "digraph system {\n  rankdir=LR;\n  node [shape=box];\n";
  for (const auto& [name, entry] : catalog.processes()) {
    out << "  subgraph " << Quoted("cluster_" + name) << " {\n    label=" << Quoted(name) << ";\n";
    for (const auto& [component, description] : entry.components) {
      out << "    " << NodeOf({name, component, ""}) << " [label=" << Quoted(component) << "];\n";
    }
    out << "  }\n";
  }
  for (const auto& connection : catalog.connections()) {
    const bool is_active = connection.state == tendon::ConnectionState::kActive;
    out << "  " << NodeOf(connection.required) << " -> " << NodeOf(connection.provided)
        << " [label="
        << Quoted(connection.required.interface + " -> " + connection.provided.interface)
        << (is_active ? "" : ", style=dashed") << "];\n";
  }
  out << "}\n";
}

/// Each component with what it uses, and what nobody is connected to.
void PrintText(const Catalog& catalog, std::ostream& out) {
  for (const auto& [name, entry] : catalog.processes()) {
    for (const auto& [component, description] : entry.components) {
      out << Plain(name) << '/' << Plain(component) << '\n';
      for (const auto& one : description.required) {
        out << "  " << Plain(one.name) << "  "
            << Plain(ProviderOf(catalog, {name, component, one.name})) << '\n';
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
  const Catalog catalog = (*client)->catalog();
  if (context.settings().json) {
    ordered_json nodes = ordered_json::array();
    ordered_json edges = ordered_json::array();
    for (const Thing& thing : ThingsIn(catalog)) {
      if (thing.noun == "component") nodes.push_back(thing.path);
    }
    for (const auto& connection : catalog.connections()) {
      edges.push_back({{"required", ToString(connection.required)},
                       {"provided", ToString(connection.provided)},
                       {"state", ToString(connection.state)}});
    }
    context.PrintJson({{"components", std::move(nodes)}, {"connections", std::move(edges)}});
  } else if (options.is_dot) {
    PrintDot(catalog, context.out());
  } else if (options.is_svg) {
    PrintSvg(SheetOf(catalog), context.out());
  } else {
    PrintText(catalog, context.out());
  }
  return program::kOk;
}

Verb::Run PrepareGraph(CLI::App& app) {
  auto options = std::make_shared<GraphOptions>();
  auto* dot = app.add_flag("--dot", options->is_dot, "for Graphviz");
  auto* svg = app.add_flag("--svg", options->is_svg, "a picture of it all")->excludes(dot);
  app.add_flag("--text")
      ->description("a line for each interface that is used (default)")
      ->excludes(dot)
      ->excludes(svg);
  return [options](Context& context) { return Graph(context, *options); };
}

}  // namespace

std::vector<Verb> FindVerbs() {
  return {
      {"status", "tell in one screen how processes and connections are doing",
       [](CLI::App&) -> Verb::Run { return &Status; }},
      {"find",
       "list whatever fits a pattern",
       [](CLI::App& app) -> Verb::Run {
         auto terms = std::make_shared<std::vector<std::string>>();
         app.add_option("expression", *terms,
                        "a part of a path, or all of it with * and **; type:, state: or host: with "
                        "the same; all of them must fit")
             ->required();
         return [terms](Context& context) { return Find(context, *terms); };
       },
       {"gcm find Joints", "gcm find '**/Control.*' type:arm.*", "gcm find state:faulted"}},
      {"graph",
       "show which component uses which",
       &PrepareGraph,
       {"gcm graph --svg > system.svg", "gcm graph --dot | dot -Tpng > system.png"}},
  };
}

}  // namespace console
