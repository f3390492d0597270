#include <tendon/gcm/system/plan.h>

#include <tendon/base/text.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/system/comparison.h>
#include <tendon/gcm/system/leaders.h>
#include <tendon/gcm/system/running_system.h>
#include <tendon/gcm/system/start_order.h>
#include <tendon/manager/unsatisfied_interface.h>
#include <tendon/process/lifecycle/configuration_base.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace tendon {
namespace {

using Kind = PlanStep::Kind;

bool IsMadeByItsProgram(const SystemFile::Component& component) {
  return component.class_name.empty();
}

/// Returns true if at most the states of the two differ. Then the component need not be created or
/// configured again.
bool IsSameInParts(const SystemFile::Component& wanted, const SystemFile::Component& now) {
  return wanted.class_name == now.class_name && IsSameLibrary(wanted, now) &&
         IsSameThread(wanted, now) && IsSameJson(wanted.configuration, now.configuration);
}

std::string TextOf(const ComponentPath& path) { return path.first + "/" + path.second; }

std::string TextOf(const message::ConnectionEnds& ends) {
  return ToString(ends.required) + " -> " + ToString(ends.provided);
}

/// Sorts steps so that the step of a component comes after the step of its leader.
void SortByLeaders(std::vector<PlanStep>& steps) {
  std::map<ComponentPath, PlanStep> by_path;
  std::vector<ComponentPath> order;
  for (PlanStep& step : steps) {
    order.emplace_back(step.process, step.component.name);
    by_path.emplace(order.back(), std::move(step));
  }
  tendon::PutLeadersFirst(order, [&by_path](const ComponentPath& path) {
    return by_path.at(path).component.runs_after;
  });
  steps.clear();
  for (const ComponentPath& path : order) steps.push_back(std::move(by_path.at(path)));
}

/// Makes a plan. Collects the steps of each kind in a separate list, and joins the lists at the
/// end.
class Planner {
 public:
  Planner(const Catalogue& catalogue, const SystemFile& wanted)
      : catalogue_(catalogue), wanted_(wanted), running_(SystemOf(catalogue, wanted.name)) {
    for (const auto& [name, entry] : catalogue.processes()) {
      for (const auto& [id, one] : entry.connections) connections_.emplace(one.required, &one);
    }
    for (const auto& process : wanted.processes) {
      for (const auto& one : process.components) {
        leads_.emplace(process.name, LeaderOf({process.name, one.name}));
      }
    }
  }

  Plan Run() {
    for (const auto& process : wanted_.processes) FindUnsettled(process);
    for (const auto& process : wanted_.processes) PlanProcess(process);
    PlanDisconnects();
    for (const auto& [required, provided, comment] : wanted_.connections) {
      PlanConnection({required, provided});
    }
    plan_.untouched = CompareSystems(wanted_, running_.file, StartComparison::kIgnore).equal;
    AddStops();
    SortByLeaders(makings_);
    std::ranges::reverse(removals_);
    SortByLeaders(removals_);  // sorts the reversed list, so that followers come before their
                               // leaders at the end
    std::ranges::reverse(removals_);
    for (auto* part : {&disconnects_, &removals_, &births_, &makings_, &connects_}) {
      plan_.steps.insert(plan_.steps.end(), part->begin(), part->end());
    }
    Judge();
    AddStarts();
    return std::move(plan_);
  }

 private:
  void PlanProcess(const SystemFile::Process& process) {
    const auto* running = running_index_.FindProcess(process.name);
    if (running == nullptr && IsStarting(process.name)) return Await(process.name);
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

  /// Finds components that must be created again because their leader is removed or created again.
  /// A leader cannot be removed while it has followers.
  void FindUnsettled(const SystemFile::Process& process) {
    const auto* running = catalogue_.FindProcess(process.name);
    if (running == nullptr || running_index_.FindProcess(process.name) == nullptr) return;
    std::multimap<std::string, const ComponentDescription*> followers;
    std::vector<std::string> unsettled;
    for (const auto& [name, component] : running->components) {
      followers.emplace(component.leader, &component);
      const auto* wanted = wanted_index_.FindComponent(process.name, name);
      const auto* now = running_index_.FindComponent(process.name, name);
      if (wanted == nullptr || !IsSameInParts(*wanted, *now)) unsettled.push_back(name);
    }
    while (!unsettled.empty()) {
      const std::string leader = std::move(unsettled.back());
      unsettled.pop_back();
      const auto [begin, end] = followers.equal_range(leader);
      for (auto follower = begin; follower != end; ++follower) {
        const std::string& name = follower->second->name;
        if (unsettled_.emplace(process.name, name).second) unsettled.push_back(name);
      }
    }
  }

  /// Plans the start of a process by the GCM. Its former components in the catalogue are ignored.
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

  [[nodiscard]] bool IsStarting(const std::string& process) const {
    const auto* entry = catalogue_.FindProcess(process);
    return entry != nullptr && entry->process.state == ProcessState::kStarting;
  }

  void Await(const std::string& process) {
    const std::int64_t pid = catalogue_.FindProcess(process)->process.pid;
    plan_.obstacles.push_back("process '" + process + "' is starting" +
                              (pid == 0 ? "" : " (pid " + std::to_string(pid) + ")") +
                              "; plan again when it has joined");
  }

  void Miss(const SystemFile::Process& process) {
    const auto is_program =
        std::all_of(process.components.begin(), process.components.end(), IsMadeByItsProgram);
    const bool is_own = is_program && !process.components.empty();
    plan_.obstacles.push_back(
        "process '" + process.name + "' with " +
        Counted(process.components.size(), "component", "components") +
        " is not available; start " +
        (is_own ? "the program of this process" : "this process: lcm --name " + process.name));
  }

  [[nodiscard]] PlanStep StepOf(Kind kind, const ComponentPath& path,
                                const SystemFile::Component& component) const {
    return {.kind = kind,
            .process = path.first,
            .instance = Instance(path.first),
            .component = component};
  }

  [[nodiscard]] PlanStep StepOf(Kind kind, const message::ConnectionEnds& ends) const {
    return {.kind = kind, .ends = ends, .instance = Instance(ends.required.process)};
  }

  /// Returns the instance for the steps of a process. Returns 0, which means any instance, if the
  /// plan starts the process.
  [[nodiscard]] std::uint64_t Instance(const std::string& process) const {
    return born_.contains(process) ? 0 : InstanceOf(catalogue_, process);
  }

  void PlanStop(Kind kind, const ComponentPath& path, const SystemFile::Component& component) {
    PlanStep& step = stops_.emplace(path, StepOf(kind, path, component)).first->second;
    step.takes_away = true;
  }

  void PlanRemoval(const ComponentPath& path, const SystemFile::Component& now) {
    if (IsMadeByItsProgram(now)) {
      plan_.obstacles.push_back(TextOf(path) +
                                " is not in the file, but the program of the process created the "
                                "component, and only that program can remove it");
      return;
    }
    if (IsRunning(now.state)) PlanStop(Kind::kStop, path, now);
    removed_.insert(path);
    removals_.push_back(StepOf(Kind::kRemove, path, now));
    removals_.back().takes_away = true;
  }

  void PlanCreation(const ComponentPath& path, const SystemFile::Component& component) {
    if (IsMadeByItsProgram(component)) {
      plan_.obstacles.push_back(
          TextOf(path) +
          " does not exist, and only the program of the process can create this component");
      missing_.insert(path);
      return;
    }
    PlanMaking(Kind::kCreate, path, component);
  }

  void PlanMaking(Kind kind, const ComponentPath& path, const SystemFile::Component& component) {
    made_.insert(path);
    makings_.push_back(StepOf(kind, path, component));
    PlanState(path, component, ComponentState::kConstructed);
  }

  void PlanChange(const ComponentPath& path, const SystemFile::Component& component,
                  const SystemFile::Component& now) {
    const bool is_another = component.class_name != now.class_name ||
                            !IsSameLibrary(component, now) || !IsSameThread(component, now) ||
                            unsettled_.contains(path);
    if (!is_another && IsSameJson(component.configuration, now.configuration)) {
      const bool has_periods = component.period > 0.0 && now.period > 0.0;
      if (has_periods && component.period != now.period) {
        plan_.obstacles.push_back(
            TextOf(path) + " does not have the period of the file (" + ChangesOf(component, now) +
            "): only the class of the component can set its period; save the file again, or change "
            "the period in the configuration, if it has one");
      }
      return PlanState(path, component, now.state);
    }
    if (IsMadeByItsProgram(component) || IsMadeByItsProgram(now)) {
      const std::string changes = ChangesOf(now, component);
      plan_.obstacles.push_back(
          TextOf(path) +
          (changes.empty() ? " must be created again, because it runs after a component that will "
                             "be removed or created again; only the program of the process can "
                             "do this: stop that program first"
                           : " cannot be changed to match the file, because the program of the "
                             "process creates the component: " +
                                 changes));
      return;
    }
    if (is_another) {
      PlanRemoval(path, now);
      return PlanMaking(Kind::kCreate, path, WithThreadOf(path, now, component));
    }
    if (IsRunning(now.state)) PlanStop(Kind::kStop, path, now);
    PlanMaking(Kind::kConfigure, path, component);
    const auto* known = catalogue_.FindComponent(path.first, path.second);
    makings_.back().based_on = BaseOf(known->configuration);
  }

  /// Returns the leader in the file. If the file does not describe the thread, returns the present
  /// leader.
  [[nodiscard]] std::string LeaderOf(const ComponentPath& path) const {
    const auto* wanted = wanted_index_.FindComponent(path.first, path.second);
    if (wanted != nullptr && wanted->tells_thread()) return wanted->runs_after;
    const auto* now = running_index_.FindComponent(path.first, path.second);
    return now == nullptr ? std::string() : now->runs_after;
  }

  /// Returns the component in the file. If the file does not describe the thread, adds the present
  /// thread and leader.
  [[nodiscard]] SystemFile::Component WithThreadOf(const ComponentPath& path,
                                                   const SystemFile::Component& now,
                                                   SystemFile::Component component) const {
    if (component.tells_thread() || component.class_name != now.class_name) return component;
    component.thread = now.thread;
    const bool stays = wanted_index_.FindComponent(path.first, now.runs_after) != nullptr;
    if (stays) component.runs_after = now.runs_after;
    return component;
  }

  void PlanState(const ComponentPath& path, const SystemFile::Component& component,
                 ComponentState now) {
    const ComponentState wanted = component.state;
    if (SatisfiesSameRequest(now, wanted)) return;
    if (!IsRunning(wanted)) return PlanStop(Kind::kStop, path, component);
    if (wanted == ComponentState::kActive) {
      starts_.emplace(path, StepOf(Kind::kStart, path, component));
    } else if (now == ComponentState::kActive) {
      PlanStop(Kind::kSuspend, path, component);
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

  void PlanConnection(const message::ConnectionEnds& ends) {
    const ComponentPath client = OwnerOf(ends.required);
    const ComponentPath server = OwnerOf(ends.provided);
    if (IsAbsent(client.first) || missing_.contains(client)) return;
    if (IsAbsent(server.first)) Lack(ends, "process '" + server.first + "' is not available");
    if (missing_.contains(server)) return Lack(ends, TextOf(server) + " does not exist");
    const auto* now = ConnectionOf(ends.required);
    const bool is_same = now != nullptr && now->provided == ends.provided;
    const bool is_of_new = made_.contains(client) || made_.contains(server);
    if (is_same && now->state == ConnectionState::kFailed && !is_of_new) {
      plan_.obstacles.push_back("the connection " + TextOf(ends) + " has failed: " + now->reason);
      return Lack(ends, now->reason);
    }
    if (is_same && !removed_.contains(server)) return;
    if (!is_of_new) {
      const auto checked = PlanConnect(catalogue_, ends, WhenConnected::kReplace);
      if (!checked) {
        plan_.obstacles.push_back(checked.error().message);
        refusals_.push_back(checked.error().code);
        return Lack(ends, checked.error().message);
      }
    }
    const bool replaces = now != nullptr && !is_same;
    connects_.push_back(StepOf(replaces ? Kind::kReplace : Kind::kConnect, ends));
    connects_.back().takes_away = replaces;
  }

  /// Sets Plan::refusal if all obstacles are refused connections with the same error code.
  void Judge() {
    if (refusals_.empty() || refusals_.size() < plan_.obstacles.size()) return;
    const ErrorCode first = refusals_.front();
    if (std::ranges::count(refusals_, first) == std::ssize(refusals_)) plan_.refusal = first;
  }

  /// Records that a component must not start, because a connection in the file cannot be made.
  void Lack(const message::ConnectionEnds& ends, const std::string& why) {
    lacks_.emplace(OwnerOf(ends.required), "its connection " + TextOf(ends) + ": " + why);
  }

  /// Records that a component must not start, because the file lacks connections that it needs.
  /// Does nothing if the interfaces of the component are not known yet.
  void FindUnmetNeeds(const ComponentPath& path) {
    const auto* component = catalogue_.FindComponent(path.first, path.second);
    const bool is_known = component != nullptr && !born_.contains(path.first) &&
                          !missing_.contains(path) &&
                          (!made_.contains(path) || !removed_.contains(path));
    if (!is_known) return;
    std::string names;
    for (const RequiredDescription& required : component->required) {
      const InterfaceName name(path.first, path.second, required.name);
      if (!IsNeeded(required) || wanted_index_.FindConnection(name) != nullptr) continue;
      names += (names.empty() ? "" : ", ") + required.name;
    }
    if (names.empty()) return;
    lacks_.emplace(
        path,
        "a connection for " + names +
            ", and the file is strict; add the connection to the file, or leave out \"strict\"");
  }

  void AddStops() {
    const std::vector<ComponentPath> order = StartOrder(running_.file);
    for (auto path = order.rbegin(); path != order.rend(); ++path) {
      const auto step = stops_.find(*path);
      if (step != stops_.end()) plan_.steps.push_back(step->second);
    }
  }

  void AddStarts() {
    for (const auto& [required, provided, comment] : wanted_.connections) {
      const auto step = starts_.find(OwnerOf(required));
      if (step != starts_.end()) step->second.needs.push_back({required, provided});
    }
    std::vector<PlanStep> suspends;
    std::vector<ComponentPath> order = StartOrder(wanted_);
    tendon::PutLeadersFirst(order, [this](const ComponentPath& path) { return LeaderOf(path); });
    for (const ComponentPath& path : order) {
      const auto step = starts_.find(path);
      if (step == starts_.end()) continue;
      if (wanted_.strict) FindUnmetNeeds(path);
      const auto lack = lacks_.find(path);
      if (lack == lacks_.end()) {
        PlanStep& start = plan_.steps.emplace_back(step->second);
        start.is_strict = wanted_.strict;
        if (start.kind != Kind::kStartSuspended || !leads_.contains(path)) continue;
        start.kind = Kind::kStart;  // followers of a suspended component cannot start
        suspends.push_back(StepOf(Kind::kSuspend, path, start.component));
      } else {
        plan_.obstacles.push_back(TextOf(path) + " is not started, because it lacks " +
                                  lack->second);
      }
    }
    plan_.steps.insert(plan_.steps.end(), suspends.begin(), suspends.end());
  }

  const Catalogue& catalogue_;
  const SystemFile& wanted_;
  const RunningSystem running_;
  const SystemIndex wanted_index_{wanted_};
  const SystemIndex running_index_{running_.file};
  std::map<InterfaceName, const ConnectionDescription*> connections_;  // of the whole catalogue
  Plan plan_;
  std::map<ComponentPath, PlanStep> stops_;
  std::vector<PlanStep> disconnects_;
  std::vector<PlanStep> removals_;
  std::vector<PlanStep> births_;  // starts of processes
  std::vector<PlanStep> makings_;
  std::vector<PlanStep> connects_;
  std::map<ComponentPath, PlanStep> starts_;
  std::set<std::string> born_;         // processes that the plan starts
  std::set<ComponentPath> leads_;      // leaders of other components
  std::set<ComponentPath> unsettled_;  // created again because of their leaders
  std::set<ComponentPath> removed_;    // removed components; the plan may create them again
  std::set<ComponentPath> made_;       // created or configured
  std::set<ComponentPath> missing_;    // missing components that only their own programs can create
  std::map<ComponentPath, std::string> lacks_;  // why the component must not start
  std::vector<ErrorCode> refusals_;             // error codes of refused connections
};

/// " (SimulatedArm of simulated_arm)".
std::string Origin(const SystemFile::Component& component) {
  const std::string from = component.library.empty() ? "" : " of " + component.library;
  const std::string after =
      component.runs_after.empty() ? "" : ", which runs after " + component.runs_after;
  return " (" + component.class_name + from + after + ")";
}

}  // namespace

bool Plan::TakesAway() const {
  return std::any_of(steps.begin(), steps.end(),
                     [](const PlanStep& step) { return step.takes_away; });
}

Plan MakePlan(const Catalogue& catalogue, const SystemFile& wanted) {
  return Planner(catalogue, wanted).Run();
}

Plan WithEnds(Plan plan, const Catalogue& catalogue, const std::vector<PlanStep>& births) {
  for (const PlanStep& birth : births) {
    const ProcessEntry* entry = catalogue.FindProcess(birth.process);
    if (birth.kind != PlanStep::Kind::kStartProcess || entry == nullptr) continue;
    const ProcessDescription& now = entry->process;
    const bool comes_again =
        now.state == ProcessState::kLost && birth.restart != RestartPolicy::kNever;
    if (now.instance != birth.instance || !(IsPresent(now) || comes_again)) continue;
    plan.steps.push_back({.kind = PlanStep::Kind::kEndProcess,
                          .process = birth.process,
                          .instance = birth.instance,
                          .restart = birth.restart,
                          .takes_away = true});
  }
  return plan;
}

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
    case Kind::kEndProcess:
      return "end-process";
  }
  return "?";
}

std::string ToString(const PlanStep& step) {
  std::string text(ToString(step.kind));
  if (step.process.empty())
    return text + " " + ToString(step.ends.required) + " -> " + ToString(step.ends.provided);
  if (step.kind == Kind::kStartProcess) {
    return "start process " + step.process + " (restart " + std::string(ToString(step.restart)) +
           ")";
  }
  if (step.kind == Kind::kEndProcess) return "end process " + step.process;
  const std::string path = step.process + "/" + step.component.name;
  if (step.kind == Kind::kStartSuspended) return "start " + path + ", then suspend it";
  text += " " + path;
  return step.kind == Kind::kCreate ? text + Origin(step.component) : text;
}

}  // namespace tendon
