#include <tendon/gcm/lookup.h>
#include <tendon/gcm/system/comparison.h>
#include <tendon/gcm/system/plan.h>
#include <tendon/gcm/system/running_system.h>
#include <tendon/gcm/system/start_order.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace tendon {
namespace {

using Kind = PlanStep::Kind;

std::string Counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

bool IsMadeByItsProgram(const SystemFile::Component& component) {
  return component.class_name.empty();
}

ComponentPath OwnerOf(const InterfaceName& name) { return {name.process, name.component}; }

std::string TextOf(const ComponentPath& path) { return path.first + "/" + path.second; }

std::string TextOf(const message::Wire& wire) {
  return ToString(wire.required) + " -> " + ToString(wire.provided);
}

/// Steps are put into one list for each kind, and strung together in the end.
class Planner {
 public:
  Planner(const Catalog& catalog, const SystemFile& wanted)
      : catalog_(catalog), wanted_(wanted), running_(SystemOf(catalog, wanted.name)) {
    for (const auto& [name, entry] : catalog.processes()) {
      for (const auto& [id, one] : entry.connections) connections_.emplace(one.required, &one);
    }
  }

  Plan Run() {
    for (const auto& process : wanted_.processes) PlanProcess(process);
    PlanDisconnects();
    for (const auto& [required, provided, comment] : wanted_.connections) {
      PlanConnection({required, provided});
    }
    plan_.untouched = CompareSystems(wanted_, running_.file, Threads::kUnknownInSecond).equal;
    AddRests();
    for (auto* part : {&disconnects_, &removals_, &births_, &makings_, &connects_}) {
      plan_.steps.insert(plan_.steps.end(), part->begin(), part->end());
    }
    AddStarts();
    return std::move(plan_);
  }

 private:
  void PlanProcess(const SystemFile::Process& process) {
    const auto* running = running_index_.FindProcess(process.name);
    if (running == nullptr) return process.start ? PlanBirth(process) : Miss(process);
    for (const auto& component : running->components) {
      const ComponentPath path(process.name, component.name);
      if (wanted_index_.FindComponent(path.first, path.second) == nullptr) {
        PlanRemoval(path, component);
      }
    }
    for (const auto& component : process.components) {
      const ComponentPath path(process.name, component.name);
      const auto* now = running_index_.FindComponent(path.first, path.second);
      if (now == nullptr) {
        PlanCreation(path, component);
      } else {
        PlanChange(path, component, *now);
      }
    }
  }

  /// The GCM starts it; what it had before it was lost counts no more.
  void PlanBirth(const SystemFile::Process& process) {
    born_.insert(process.name);
    births_.push_back(
        {.kind = Kind::kStartProcess, .process = process.name, .restart = process.start->restart});
    for (const auto& component : process.components) {
      PlanCreation({process.name, component.name}, component);
    }
  }

  [[nodiscard]] bool IsAbsent(const std::string& process) const {
    return running_index_.FindProcess(process) == nullptr && !born_.contains(process);
  }

  void Miss(const SystemFile::Process& process) {
    const auto is_program =
        std::all_of(process.components.begin(), process.components.end(), IsMadeByItsProgram);
    const bool is_own = is_program && !process.components.empty();
    plan_.obstacles.push_back("process '" + process.name + "' is not there, nor " +
                              Counted(process.components.size(), "component") + " of it; start " +
                              (is_own ? "its program" : "it: lcm --name " + process.name));
  }

  [[nodiscard]] PlanStep StepOf(Kind kind, const ComponentPath& path,
                                const SystemFile::Component& component) const {
    return {.kind = kind,
            .process = path.first,
            .instance = Instance(path.first),
            .component = component};
  }

  [[nodiscard]] PlanStep StepOf(Kind kind, const message::Wire& wire) const {
    return {.kind = kind, .wire = wire, .instance = Instance(wire.required.process)};
  }

  /// Any of a process that is started before.
  [[nodiscard]] std::uint64_t Instance(const std::string& process) const {
    return born_.contains(process) ? 0 : InstanceOf(catalog_, process);
  }

  void PlanRest(Kind kind, const ComponentPath& path, const SystemFile::Component& component) {
    PlanStep& step = rests_.emplace(path, StepOf(kind, path, component)).first->second;
    step.takes_away = true;
  }

  void PlanRemoval(const ComponentPath& path, const SystemFile::Component& now) {
    if (IsMadeByItsProgram(now)) {
      plan_.obstacles.push_back(TextOf(path) +
                                " is not in the file, but was made by its own program, which "
                                "alone can do without it");
      return;
    }
    if (IsRunning(now.state)) PlanRest(Kind::kStop, path, now);
    removed_.insert(path);
    removals_.push_back(StepOf(Kind::kRemove, path, now));
    removals_.back().takes_away = true;
  }

  void PlanCreation(const ComponentPath& path, const SystemFile::Component& component) {
    if (IsMadeByItsProgram(component)) {
      plan_.obstacles.push_back(TextOf(path) +
                                " is not there, and only its own program can make it");
      missing_.insert(path);
      return;
    }
    PlanMaking(Kind::kCreate, path, component);
  }

  void PlanMaking(Kind kind, const ComponentPath& path, const SystemFile::Component& component) {
    if (component.thread && kind == Kind::kConfigure) {
      plan_.obstacles.push_back(TextOf(path) +
                                " keeps the thread that it has, whatever the file says of that; "
                                "to make it anew: gcm rm " +
                                TextOf(path) + ", and plan again");
    }
    made_.insert(path);
    makings_.push_back(StepOf(kind, path, component));
    PlanState(path, component, ComponentState::kConstructed);
  }

  void PlanChange(const ComponentPath& path, const SystemFile::Component& component,
                  const SystemFile::Component& now) {
    const bool is_other_class =
        component.class_name != now.class_name || !IsSameLibrary(component, now);
    if (!is_other_class && IsSameJson(component.configuration, now.configuration)) {
      const bool has_periods = component.period > 0.0 && now.period > 0.0;
      if (has_periods && component.period != now.period) {
        plan_.obstacles.push_back(TextOf(path) + " has another period than the file says (" +
                                  ChangesOf(component, now, Threads::kUnknownInSecond) +
                                  "), which its class has chosen; save the file again, or see "
                                  "whether its configuration has one");
      }
      return PlanState(path, component, now.state);
    }
    if (IsMadeByItsProgram(component) || IsMadeByItsProgram(now)) {
      plan_.obstacles.push_back(TextOf(path) +
                                " cannot become what the file says, for its own program "
                                "makes it: " +
                                ChangesOf(now, component, Threads::kUnknownInSecond));
      return;
    }
    if (is_other_class) {
      PlanRemoval(path, now);
      return PlanMaking(Kind::kCreate, path, component);
    }
    if (IsRunning(now.state)) PlanRest(Kind::kStop, path, now);
    PlanMaking(Kind::kConfigure, path, component);
  }

  void PlanState(const ComponentPath& path, const SystemFile::Component& component,
                 ComponentState now) {
    const ComponentState wanted = component.state;
    if (IsSameDesire(now, wanted)) return;
    if (!IsRunning(wanted)) return PlanRest(Kind::kStop, path, component);
    if (wanted == ComponentState::kActive) {
      starts_.emplace(path, StepOf(Kind::kStart, path, component));
    } else if (now == ComponentState::kActive) {
      PlanRest(Kind::kSuspend, path, component);
    } else {
      starts_.emplace(path, StepOf(Kind::kStartSuspended, path, component));
    }
  }

  void PlanDisconnects() {
    for (const auto* connections : {&running_.file.connections, &running_.loose}) {
      for (const auto& [required, provided, comment] : *connections) {
        const bool is_ours = wanted_index_.FindProcess(required.process) != nullptr;
        const bool is_wanted = wanted_index_.FindConnection(required) != nullptr;
        if (!is_ours || is_wanted || removed_.contains(OwnerOf(required))) continue;
        disconnects_.push_back(StepOf(Kind::kDisconnect, {required, provided}));
        disconnects_.back().takes_away = true;
      }
    }
  }

  [[nodiscard]] const ConnectionDescription* ConnectionOf(const InterfaceName& required) const {
    const auto found = connections_.find(required);
    const bool is_there = found != connections_.end() && !born_.contains(required.process) &&
                          !removed_.contains(OwnerOf(required));
    return is_there ? found->second : nullptr;
  }

  void PlanConnection(const message::Wire& wire) {
    const ComponentPath client = OwnerOf(wire.required);
    const ComponentPath server = OwnerOf(wire.provided);
    if (IsAbsent(client.first) || missing_.contains(client)) return;
    if (IsAbsent(server.first)) Lack(wire, "process '" + server.first + "' is not there");
    if (missing_.contains(server)) return Lack(wire, TextOf(server) + " is not there");
    const auto* now = ConnectionOf(wire.required);
    const bool is_same = now != nullptr && now->provided == wire.provided;
    const bool is_of_new = made_.contains(client) || made_.contains(server);
    if (is_same && now->state == ConnectionState::kFailed && !is_of_new) {
      plan_.obstacles.push_back("the connection " + TextOf(wire) + " has failed: " + now->reason);
      return Lack(wire, now->reason);
    }
    if (is_same && !removed_.contains(server)) return;
    if (!is_of_new) {
      const auto checked = PlanConnect(catalog_, wire, Occupied::kReplaced);
      if (!checked) {
        plan_.obstacles.push_back(checked.error().message);
        return Lack(wire, checked.error().message);
      }
    }
    const bool replaces = now != nullptr && !is_same;
    connects_.push_back(StepOf(replaces ? Kind::kReplace : Kind::kConnect, wire));
    connects_.back().takes_away = replaces;
  }

  /// A component of which the file wants a connection that cannot be made.
  void Lack(const message::Wire& wire, const std::string& why) {
    lacks_.emplace(OwnerOf(wire.required), "its connection " + TextOf(wire) + ": " + why);
  }

  void AddRests() {
    const std::vector<ComponentPath> order = StartOrder(running_.file);
    for (auto path = order.rbegin(); path != order.rend(); ++path) {
      const auto step = rests_.find(*path);
      if (step != rests_.end()) plan_.steps.push_back(step->second);
    }
  }

  void AddStarts() {
    for (const auto& [required, provided, comment] : wanted_.connections) {
      const auto step = starts_.find(OwnerOf(required));
      if (step != starts_.end()) step->second.needs.push_back({required, provided});
    }
    for (const ComponentPath& path : StartOrder(wanted_)) {
      const auto step = starts_.find(path);
      if (step == starts_.end()) continue;
      const auto lack = lacks_.find(path);
      if (lack == lacks_.end()) {
        plan_.steps.push_back(step->second);
      } else {
        plan_.obstacles.push_back(TextOf(path) + " is not started, for it lacks " + lack->second);
      }
    }
  }

  const Catalog& catalog_;
  const SystemFile& wanted_;
  const RunningSystem running_;
  const SystemIndex wanted_index_{wanted_};
  const SystemIndex running_index_{running_.file};
  std::map<InterfaceName, const ConnectionDescription*> connections_;  // all of the catalogue
  Plan plan_;
  std::map<ComponentPath, PlanStep> rests_;
  std::vector<PlanStep> disconnects_;
  std::vector<PlanStep> removals_;
  std::vector<PlanStep> births_;  // of processes
  std::vector<PlanStep> makings_;
  std::vector<PlanStep> connects_;
  std::map<ComponentPath, PlanStep> starts_;
  std::set<std::string> born_;                  // processes that are started
  std::set<ComponentPath> removed_;             // some of them are made again
  std::set<ComponentPath> made_;                // or made anew
  std::set<ComponentPath> missing_;             // of their own programs
  std::map<ComponentPath, std::string> lacks_;  // why not to start it
};

std::string Origin(const SystemFile::Component& component) {
  const std::string from = component.library.empty() ? "" : " of " + component.library;
  return " (" + component.class_name + from + ")";
}

}  // namespace

std::string_view ToString(PlanStep::Kind kind) {
  switch (kind) {
    case Kind::kStop:
      return "stop";
    case Kind::kSuspend:
      return "suspend";
    case Kind::kDisconnect:
      return "disconnect";
    case Kind::kRemove:
      return "remove";
    case Kind::kStartProcess:
      return "start-process";
    case Kind::kConfigure:
      return "configure";
    case Kind::kCreate:
      return "create";
    case Kind::kConnect:
      return "connect";
    case Kind::kReplace:
      return "replace";
    case Kind::kStart:
      return "start";
    case Kind::kStartSuspended:
      return "start-suspended";
  }
  return "?";
}

std::string ToString(const PlanStep& step) {
  std::string text(ToString(step.kind));
  if (step.process.empty()) return text + " " + TextOf(step.wire);
  if (step.kind == Kind::kStartProcess) {
    return "start process " + step.process + " (restart " + std::string(ToString(step.restart)) +
           ")";
  }
  const std::string path = step.process + "/" + step.component.name;
  if (step.kind == Kind::kStartSuspended) return "start " + path + ", then suspend it";
  text += " " + path;
  return step.kind == Kind::kCreate ? text + Origin(step.component) : text;
}

bool Plan::TakesAway() const {
  return std::any_of(steps.begin(), steps.end(),
                     [](const PlanStep& step) { return step.takes_away; });
}

Plan MakePlan(const Catalog& catalog, const SystemFile& wanted) {
  return Planner(catalog, wanted).Run();
}

}  // namespace tendon
