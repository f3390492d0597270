#include <gcm_console/completion/path_completion.h>

#include <gcm_console/catalogue/path_target.h>
#include <gcm_console/catalogue/telemetry_column.h>
#include <gcm_console/command_line/command_line.h>
#include <tendon/interface/observed_call.h>

#include <algorithm>
#include <set>

namespace console {
namespace {

/// Collects the paths that begin with a prefix, each up to its next name.
class NextNames {
 public:
  explicit NextNames(std::string prefix) : prefix_(std::move(prefix)) {}

  void Add(const std::string& path) {
    if (!path.starts_with(prefix_)) return;
    const auto end = path.find_first_of("/.", prefix_.size());
    steps_.insert(end == std::string::npos ? path : path.substr(0, end + 1));
  }
  /// Returns true if paths that begin with `way` may also begin with the prefix.
  [[nodiscard]] bool Leads(const std::string& way) const {
    return way.starts_with(prefix_) || prefix_.starts_with(way);
  }
  [[nodiscard]] std::vector<std::string> steps() const { return {steps_.begin(), steps_.end()}; }

 private:
  std::string prefix_;
  std::set<std::string> steps_;
};

template <typename Members>
void AddMembers(const std::string& interface, const Members& members, NextNames& steps) {
  for (const auto& member : members) steps.Add(interface + "." + member.name);
}

void AddProvided(const std::string& path, const tendon::ProvidedDescription& interface,
                 WordKind kind, NextNames& steps) {
  const bool is_table = IsTable(interface.name);
  if (kind == WordKind::kProvided || kind == WordKind::kPath) steps.Add(path);
  if (kind == WordKind::kEvent && !interface.events.empty()) steps.Add(path);
  if (kind == WordKind::kPath || kind == WordKind::kEvent)
    AddMembers(path, interface.events, steps);
  if (kind == WordKind::kEvent) {
    for (const auto& command : interface.commands) {
      if (CanBeObserved(command.signature)) steps.Add(path + "." + command.name);
    }
  }
  if (kind == WordKind::kPath || (kind == WordKind::kColumn && is_table) ||
      (kind == WordKind::kCommand && !is_table)) {
    AddMembers(path, interface.commands, steps);
  }
  if (kind != WordKind::kReadable) return;
  for (const auto& command : interface.commands) {
    if (command.signature.kind == tendon::CommandKind::kRead) steps.Add(path + "." + command.name);
  }
}

void AddComponent(const std::string& path, const tendon::ComponentDescription& component,
                  WordKind kind, NextNames& steps) {
  if (kind == WordKind::kComponent || kind == WordKind::kPath) steps.Add(path);
  for (const auto& interface : component.provided) {
    const std::string way = path + "/" + interface.name;
    if (steps.Leads(way)) AddProvided(way, interface, kind, steps);
  }
  for (const auto& interface : component.required) {
    const std::string way = path + "/" + interface.name;
    if (kind == WordKind::kRequired || kind == WordKind::kPath) steps.Add(way);
    if (kind == WordKind::kPath) {
      AddMembers(way, interface.functions, steps);
      AddMembers(way, interface.event_handlers, steps);
    }
  }
}

constexpr const char* kSeparators = "/.";

/// Returns the only name below `way` that equals `begin` or begins with it; empty if there is none
/// or more than one.
std::string CompletedName(const tendon::Catalogue& catalogue, WordKind kind, const std::string& way,
                          const std::string& begin) {
  std::set<std::string> names;
  for (const std::string& path : PathsOf(catalogue, kind, way + begin)) {
    const std::string rest = path.substr(way.size());
    names.insert(rest.substr(0, rest.find_first_of(kSeparators)));
  }
  if (names.contains(begin)) return begin;
  return names.size() == 1 && !begin.empty() ? *names.begin() : "";
}

}  // namespace

std::vector<std::string> PathsOf(const tendon::Catalogue& catalogue, WordKind kind,
                                 const std::string& prefix) {
  NextNames steps(prefix);
  for (const auto& [name, entry] : catalogue.processes()) {
    if (!steps.Leads(name)) continue;
    if (kind == WordKind::kProcess || kind == WordKind::kPath) steps.Add(name);
    if (kind == WordKind::kProcess) continue;
    for (const auto& [component, description] : entry.components) {
      const std::string way = name + "/" + component;
      if (steps.Leads(way)) AddComponent(way, description, kind, steps);
    }
  }
  return steps.steps();
}

std::string WholePath(const tendon::Catalogue& catalogue, WordKind kind, const std::string& path) {
  std::string whole;
  std::size_t begin = 0;
  while (begin < path.size()) {
    const bool is_member = whole.ends_with('.');
    const std::size_t end =
        std::min(path.find_first_of(is_member ? ".[" : kSeparators, begin), path.size());
    const std::string name = CompletedName(catalogue, kind, whole, path.substr(begin, end - begin));
    if (name.empty()) return path;
    whole += name;
    if (is_member || end == path.size())
      return whole + path.substr(end);  // fields are not completed
    whole += path[end];
    begin = end + 1;
  }
  return path;
}

std::string PathFrom(const tendon::Catalogue& catalogue, const std::string& at,
                     const std::string& typed) {
  const std::string first = typed.substr(0, typed.find_first_of(kSeparators));
  const std::string below = ResolvedPath(at, first);
  const bool is_below = at.empty() || first == typed ||
                        FindTarget(catalogue, WholePath(catalogue, WordKind::kPath, below));
  const std::string process = WholePath(catalogue, WordKind::kProcess, first);
  return ResolvedPath(is_below || catalogue.FindProcess(process) == nullptr ? at : "", typed);
}

}  // namespace console
