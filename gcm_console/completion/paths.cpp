#include <gcm_console/catalogue/telemetry_column.h>
#include <gcm_console/completion/completer.h>

#include <algorithm>
#include <set>

namespace console {
namespace {

/// Collects the next name of each path that begins with a prefix.
class Steps {
 public:
  explicit Steps(std::string prefix) : prefix_(std::move(prefix)) {}

  void Add(const std::string& path) {
    if (!path.starts_with(prefix_)) return;
    const auto end = path.find_first_of("/.", prefix_.size());
    steps_.insert(end == std::string::npos ? path : path.substr(0, end + 1));
  }
  /// True if a path that begins with `way` may match.
  [[nodiscard]] bool Leads(const std::string& way) const {
    return way.starts_with(prefix_) || prefix_.starts_with(way);
  }
  [[nodiscard]] std::vector<std::string> steps() const { return {steps_.begin(), steps_.end()}; }

 private:
  std::string prefix_;
  std::set<std::string> steps_;
};

template <typename Members>
void AddMembers(const std::string& interface, const Members& members, Steps& steps) {
  for (const auto& member : members) steps.Add(interface + "." + member.name);
}

void AddProvided(const std::string& path, const tendon::ProvidedDescription& interface,
                 WordKind kind, Steps& steps) {
  const bool is_table = IsTable(interface.name);
  if (kind == WordKind::kProvided || kind == WordKind::kPath) steps.Add(path);
  if (kind == WordKind::kEvent && !interface.events.empty()) steps.Add(path);
  if (kind == WordKind::kPath || kind == WordKind::kEvent)
    AddMembers(path, interface.events, steps);
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
                  WordKind kind, Steps& steps) {
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

}  // namespace

std::vector<std::string> PathsOf(const tendon::Catalogue& catalogue, WordKind kind,
                                 const std::string& prefix) {
  Steps steps(prefix);
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

}  // namespace console
