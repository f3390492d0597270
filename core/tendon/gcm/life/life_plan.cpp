#include <tendon/gcm/life/followers.h>
#include <tendon/gcm/life/life_plan.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/waiting.h>
#include <tendon/process/life/configuration_base.h>

#include <algorithm>
#include <optional>
#include <string_view>

namespace tendon {
namespace {

using message::HistoryEntry;
using message::LifeOrder;
using message::LifeStep;

std::optional<LifeRequest> RequestOf(LifeVerb verb) {
  switch (verb) {
    case LifeVerb::kStart:
      return LifeRequest::kStart;
    case LifeVerb::kSuspend:
      return LifeRequest::kSuspend;
    case LifeVerb::kStop:
      return LifeRequest::kStop;
    default:
      return std::nullopt;
  }
}

std::string PathOf(const LifeStep& step) { return step.process + "/" + step.component; }

Error Changed(const LifeStep& step, const std::string& how) {
  return {ErrorCode::kFailed, PathOf(step) + " " + how};
}

/// The state in which a step leaves its component, if the step is a change of state.
std::optional<ComponentState> StateAfter(std::string_view verb) {
  if (verb == ToString(LifeVerb::kStart)) return ComponentState::kActive;
  if (verb == ToString(LifeVerb::kSuspend)) return ComponentState::kSuspended;
  if (verb == ToString(LifeVerb::kStop)) return ComponentState::kFinished;
  return std::nullopt;
}

/// Adds the orders that bring a stopped component to the state that it had.
void AddOrdersInto(ComponentState state, const LifeOrder& order, std::vector<LifeOrder>& orders) {
  if (!IsRunning(state)) return;
  orders.push_back(order);
  orders.back().verb = LifeVerb::kStart;
  if (state != ComponentState::kSuspended) return;
  orders.push_back(order);
  orders.back().verb = LifeVerb::kSuspend;
}

}  // namespace

Result<void> CheckTarget(const Catalogue& catalogue, const LifeOrder& order) {
  const auto entry = LookUpProcess(catalogue, order.process);
  if (!entry) return entry.error();
  const ProcessDescription& process = (*entry)->process;
  if (auto present = RequirePresent(process); !present) return present;
  if (order.instance != 0 && order.instance != process.instance) {
    return Error{ErrorCode::kFailed, "process '" + process.name +
                                         "' was restarted meanwhile: nothing was done; check it "
                                         "and try again"};
  }
  if (order.verb == LifeVerb::kLoad || order.verb == LifeVerb::kCreate) return {};
  const auto component = LookUpComponent(catalogue, order.process, order.component);
  return component ? Result<void>() : component.error();
}

Result<void> CheckLife(const Catalogue& catalogue, const LifeOrder& order) {
  if (auto checked = CheckTarget(catalogue, order); !checked) return checked;
  if (order.verb == LifeVerb::kLoad) return CheckName("plug-in", order.library);
  const auto* component = catalogue.FindComponent(order.process, order.component);
  if (order.verb == LifeVerb::kCreate) {
    if (auto checked = CheckName("component", order.component); !checked) return checked;
    if (component == nullptr) return {};
    return Error{ErrorCode::kExists, "component '" + order.component +
                                         "' already exists in process '" + order.process + "'"};
  }
  const std::string what = "component '" + order.component + "' ";
  if (order.verb == LifeVerb::kRemove || order.verb == LifeVerb::kConfigure) {
    if (component->class_name.empty()) {
      return Error{ErrorCode::kFailed, what + "was created by the program of process '" +
                                           order.process + "' itself, not from a class"};
    }
    if (order.verb == LifeVerb::kRemove || !IsRunning(component->state)) return {};
    return Error{ErrorCode::kFailed, what + "is " + std::string(ToString(component->state)) +
                                         "; stop it first to configure it again"};
  }
  const auto request = RequestOf(order.verb);
  if (!request) return {};
  const Transition& transition = TransitionOf(component->state, *request);
  if (transition.refusal.empty()) {
    if (!order.is_strict) return {};
    const ProcessEntry& process = *catalogue.FindProcess(order.process);
    return CheckNeeds(order.component, UnmetNeedsOf(process, *component));
  }
  return Error{ErrorCode::kFailed, what + "is " + std::string(ToString(component->state)) +
                                       std::string(transition.refusal)};
}

Result<std::vector<Path>> LookUpComponents(const Catalogue& catalogue, const std::string& pattern) {
  if (pattern.find('*') == pattern.npos) {
    const auto path = ParsePath(pattern);
    if (!path) return path.error();
    if (path->component.empty() || !path->interface.empty()) {
      return Error{ErrorCode::kInvalid,
                   "'" + pattern +
                       "' does not name a component: expected process/component, or "
                       "a glob such as process/*"};
    }
    const auto found = LookUpComponent(catalogue, path->process, path->component);
    if (!found) return found.error();
    return std::vector<Path>{*path};
  }
  std::vector<Path> all;
  for (const auto& [process, entry] : catalogue.processes()) {
    if (!IsPresent(entry.process)) continue;
    for (const auto& [component, description] : entry.components) {
      Path path{.process = process, .component = component};
      if (MatchesGlob(pattern, ToString(path))) all.push_back(std::move(path));
    }
  }
  if (!all.empty()) return all;
  return Error{ErrorCode::kNotFound,
               "no component fits '" + pattern + "'; gcm ls -R lists all names"};
}

bool LeavesAsItWas(const HistoryEntry& step) {
  return step.verb == ToString(LifeVerb::kStart) && step.life.state == ComponentState::kActive;
}

std::string StepVerbOf(const LifeOrder& order) {
  return std::string(ToString(order.verb == LifeVerb::kRestart ? LifeVerb::kStart : order.verb));
}

LifeStep StepOf(const Catalogue& catalogue, const LifeOrder& order) {
  if (order.verb == LifeVerb::kLoad) return {};
  LifeStep step{.process = order.process,
                .component = order.component,
                .class_name = order.class_name,
                .library = order.library,
                .configuration = order.configuration};
  const auto* before = catalogue.FindComponent(order.process, order.component);
  if (order.verb == LifeVerb::kCreate || before == nullptr) return step;
  step.class_name = before->class_name;
  step.library = before->library;
  step.state = before->state;
  step.former = order.verb == LifeVerb::kStop
                    ? FollowersText(catalogue, order.process, order.component)
                    : before->configuration;
  if (order.verb != LifeVerb::kRemove) return step;
  for (const ConnectionDescription& one : catalogue.connections()) {
    const auto is_ours = [&](const InterfaceName& end) {
      return end.process == order.process && end.component == order.component;
    };
    if (is_ours(one.required) || is_ours(one.provided)) {
      step.connections.push_back({one.required, one.provided});
    }
  }
  return step;
}

void AddOutcome(const message::LifeOutcome& outcome, HistoryEntry& entry) {
  LifeStep& step = entry.life;
  step.state = outcome.state;
  step.class_name = outcome.class_name;
  step.library = outcome.library;
  step.thread = outcome.thread;
  step.leader = outcome.leader;
  step.configuration = outcome.configuration;
  const bool has_followers = entry.verb == ToString(LifeVerb::kStop);
  if (!has_followers) step.former = outcome.former;
}

Result<void> CheckUndo(const Catalogue& catalogue, const HistoryEntry& step) {
  const LifeStep& life = step.life;
  const auto* now = catalogue.FindComponent(life.process, life.component);
  if (step.is_unknown && now != nullptr && now->state == life.state &&
      StateAfter(step.verb) == life.state) {
    return Changed(life, "was " + std::string(ToString(life.state)) + " before");
  }
  if (step.verb == ToString(LifeVerb::kRemove)) {
    if (now != nullptr) return Changed(life, "exists again");
    return {};
  }
  if (now == nullptr) return Changed(life, "no longer exists");
  const bool is_other = now->class_name != life.class_name || now->library != life.library;
  if (is_other) return Changed(life, "is of class " + now->class_name + " now");
  const std::string state(ToString(now->state));
  if (const auto after = StateAfter(step.verb)) {
    // A stopped component that an undo has created again has not run since.
    const bool is_stopped = *after == ComponentState::kFinished && !IsRunning(now->state) &&
                            now->state != ComponentState::kFaulted;
    if (now->state != *after && !is_stopped) return Changed(life, "is " + state + " now");
    return *after == ComponentState::kFinished ? CheckFollowers(catalogue, life) : Result<void>();
  }
  if (step.verb == ToString(LifeVerb::kConfigure) && now->configuration != life.configuration) {
    return Changed(life, "has another configuration now");
  }
  if (IsRunning(now->state)) return Changed(life, "is " + state + " now; stop it first");
  return {};
}

std::optional<std::chrono::nanoseconds> PatienceWithin(std::chrono::nanoseconds patience,
                                                       std::chrono::nanoseconds left) {
  const std::chrono::nanoseconds most = left * 2 / 3;
  if (most < std::chrono::milliseconds(1)) return std::nullopt;
  return std::min(patience, most);
}

UndoPlan PlanUndo(const HistoryEntry& step, std::chrono::nanoseconds patience) {
  const LifeStep& life = step.life;
  LifeOrder order{.process = life.process,
                  .instance = step.instance,
                  .component = life.component,
                  .patience = patience};
  UndoPlan plan;
  if (step.verb == ToString(LifeVerb::kCreate)) {
    order.verb = LifeVerb::kRemove;
    plan.first.push_back(order);
  } else if (step.verb == ToString(LifeVerb::kRemove)) {
    LifeOrder create = order;
    create.verb = LifeVerb::kCreate;
    create.class_name = life.class_name;
    create.library = life.library;
    create.configuration = life.former;
    create.thread = life.thread;
    create.leader = life.leader;
    plan.first.push_back(create);
    if (!step.is_unknown) AddOrdersInto(life.state, order, plan.then);  // else its state is unknown
  } else if (step.verb == ToString(LifeVerb::kConfigure)) {
    order.verb = LifeVerb::kConfigure;
    order.configuration = life.former;
    order.based_on = BaseOf(life.configuration);
    plan.first.push_back(order);
  } else if (step.verb == ToString(LifeVerb::kStart)) {
    const bool was_suspended = life.state == ComponentState::kSuspended;
    order.verb = was_suspended ? LifeVerb::kSuspend : LifeVerb::kStop;
    plan.first.push_back(order);
  } else if (step.verb == ToString(LifeVerb::kSuspend)) {
    order.verb = LifeVerb::kStart;
    plan.then.push_back(order);
  } else if (step.verb == ToString(LifeVerb::kStop)) {
    plan.then = OrdersToRunAgain(life, order);
  }
  return plan;
}

}  // namespace tendon
