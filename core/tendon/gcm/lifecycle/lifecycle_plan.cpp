#include <tendon/gcm/lifecycle/lifecycle_plan.h>

#include <tendon/gcm/lifecycle/followers.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/waiting.h>
#include <tendon/process/lifecycle/configuration_base.h>

#include <algorithm>
#include <optional>
#include <string_view>

namespace tendon {
namespace {

using message::HistoryEntry;
using message::LifecycleOrder;
using message::LifecycleStep;

std::optional<LifecycleRequest> RequestOf(LifecycleVerb verb) {
  switch (verb) {
    case LifecycleVerb::kStart:
      return LifecycleRequest::kStart;
    case LifecycleVerb::kSuspend:
      return LifecycleRequest::kSuspend;
    case LifecycleVerb::kStop:
      return LifecycleRequest::kStop;
    default:
      return std::nullopt;
  }
}

std::string PathOf(const LifecycleStep& step) { return step.process + "/" + step.component; }

Error ChangedError(const LifecycleStep& step, const std::string& how) {
  return {ErrorCode::kFailed, PathOf(step) + " " + how};
}

/// Returns the state of a component after a step, if the verb changes the state.
std::optional<ComponentState> StateAfter(std::string_view verb) {
  if (verb == ToString(LifecycleVerb::kStart)) return ComponentState::kActive;
  if (verb == ToString(LifecycleVerb::kSuspend)) return ComponentState::kSuspended;
  if (verb == ToString(LifecycleVerb::kStop)) return ComponentState::kFinished;
  return std::nullopt;
}

/// Adds the orders that bring a stopped component back to `state`.
void AddOrdersInto(ComponentState state, const LifecycleOrder& order,
                   std::vector<LifecycleOrder>& orders) {
  if (!IsRunning(state)) return;
  orders.push_back(order);
  orders.back().verb = LifecycleVerb::kStart;
  if (state != ComponentState::kSuspended) return;
  orders.push_back(order);
  orders.back().verb = LifecycleVerb::kSuspend;
}

}  // namespace

Result<void> CheckTarget(const Catalogue& catalogue, const LifecycleOrder& order) {
  const auto entry = LookUpProcess(catalogue, order.process);
  if (!entry) return entry.error();
  const ProcessDescription& process = (*entry)->process;
  if (auto present = RequirePresent(process); !present) return present;
  if (order.instance != 0 && order.instance != process.instance) {
    return Error{
        ErrorCode::kFailed,
        "process '" + process.name +
            "' was restarted meanwhile: nothing was done; check the process and try again"};
  }
  if (order.verb == LifecycleVerb::kLoad || order.verb == LifecycleVerb::kCreate) return {};
  const auto component = LookUpComponent(catalogue, order.process, order.component);
  return component ? Result<void>() : component.error();
}

Result<void> CheckLifecycleOrder(const Catalogue& catalogue, const LifecycleOrder& order) {
  if (auto checked = CheckTarget(catalogue, order); !checked) return checked;
  if (order.verb == LifecycleVerb::kLoad) return CheckName("plug-in", order.library);
  const auto* component = catalogue.FindComponent(order.process, order.component);
  if (order.verb == LifecycleVerb::kCreate) {
    if (auto checked = CheckName("component", order.component); !checked) return checked;
    if (component == nullptr) return {};
    return Error{ErrorCode::kExists, "component '" + order.component +
                                         "' already exists in process '" + order.process + "'"};
  }
  const std::string what = "component '" + order.component + "' ";
  if (order.verb == LifecycleVerb::kRemove || order.verb == LifecycleVerb::kConfigure) {
    if (component->class_name.empty()) {
      return Error{ErrorCode::kFailed, what + "was created by the program of process '" +
                                           order.process + "' itself, not from a class"};
    }
    if (order.verb == LifecycleVerb::kRemove || !IsRunning(component->state)) return {};
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
      return Error{ErrorCode::kInvalid, "'" + pattern +
                                            "' does not name a component: expected "
                                            "process/component, or a pattern such as process/*"};
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
               "no component matches '" + pattern + "'; to list all names: gcm ls -R"};
}

Result<Path> LookUpOneComponent(const Catalogue& catalogue, const std::string& pattern) {
  const auto found = LookUpComponents(catalogue, pattern);
  if (!found) return found.error();
  if (found->size() == 1) return found->front();
  return Error{ErrorCode::kInvalid, "'" + pattern + "' matches " + std::to_string(found->size()) +
                                        " components; give one component"};
}

bool LeavesAsItWas(const HistoryEntry& step) {
  return step.verb == ToString(LifecycleVerb::kStart) &&
         step.lifecycle.state == ComponentState::kActive;
}

std::string StepVerbOf(const LifecycleOrder& order) {
  return std::string(
      ToString(order.verb == LifecycleVerb::kRestart ? LifecycleVerb::kStart : order.verb));
}

LifecycleStep StepOf(const Catalogue& catalogue, const LifecycleOrder& order) {
  if (order.verb == LifecycleVerb::kLoad) return {};
  LifecycleStep step{.process = order.process,
                     .component = order.component,
                     .class_name = order.class_name,
                     .library = order.library,
                     .configuration = order.configuration};
  const auto* before = catalogue.FindComponent(order.process, order.component);
  if (order.verb == LifecycleVerb::kCreate || before == nullptr) return step;
  step.class_name = before->class_name;
  step.library = before->library;
  step.state = before->state;
  step.former = order.verb == LifecycleVerb::kStop
                    ? FollowersText(catalogue, order.process, order.component)
                    : before->configuration;
  if (order.verb != LifecycleVerb::kRemove) return step;
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

void AddOutcome(const message::LifecycleOutcome& outcome, HistoryEntry& entry) {
  LifecycleStep& step = entry.lifecycle;
  step.state = outcome.state;
  step.class_name = outcome.class_name;
  step.library = outcome.library;
  step.thread = outcome.thread;
  step.leader = outcome.leader;
  step.configuration = outcome.configuration;
  const bool has_followers = entry.verb == ToString(LifecycleVerb::kStop);
  if (!has_followers) step.former = outcome.former;
}

Result<void> CheckUndo(const Catalogue& catalogue, const HistoryEntry& step) {
  const LifecycleStep& lifecycle = step.lifecycle;
  const auto* now = catalogue.FindComponent(lifecycle.process, lifecycle.component);
  if (step.is_unknown && now != nullptr && now->state == lifecycle.state &&
      StateAfter(step.verb) == lifecycle.state) {
    return ChangedError(lifecycle, "was " + std::string(ToString(lifecycle.state)) + " before");
  }
  if (step.verb == ToString(LifecycleVerb::kRemove)) {
    if (now != nullptr) return ChangedError(lifecycle, "exists again");
    return {};
  }
  if (now == nullptr) return ChangedError(lifecycle, "no longer exists");
  const bool is_other =
      now->class_name != lifecycle.class_name || now->library != lifecycle.library;
  if (is_other) return ChangedError(lifecycle, "is of class " + now->class_name + " now");
  const std::string state(ToString(now->state));
  if (const auto after = StateAfter(step.verb)) {
    // After a stop, an undo may have created the component again. If it has not run after that, it
    // still counts as stopped.
    const bool is_stopped = *after == ComponentState::kFinished && !IsRunning(now->state) &&
                            now->state != ComponentState::kFaulted;
    if (now->state != *after && !is_stopped) return ChangedError(lifecycle, "is " + state + " now");
    return *after == ComponentState::kFinished ? CheckFollowers(catalogue, lifecycle)
                                               : Result<void>();
  }
  if (step.verb == ToString(LifecycleVerb::kConfigure) &&
      now->configuration != lifecycle.configuration) {
    return ChangedError(lifecycle, "has another configuration now");
  }
  if (IsRunning(now->state)) return ChangedError(lifecycle, "is " + state + " now; stop it first");
  return {};
}

std::optional<std::chrono::nanoseconds> TimeoutWithin(std::chrono::nanoseconds timeout,
                                                      std::chrono::nanoseconds left) {
  const std::chrono::nanoseconds most = left * 2 / 3;
  if (most < std::chrono::milliseconds(1)) return std::nullopt;
  return std::min(timeout, most);
}

UndoPlan PlanUndo(const HistoryEntry& step, std::chrono::nanoseconds timeout) {
  const LifecycleStep& lifecycle = step.lifecycle;
  LifecycleOrder order{.process = lifecycle.process,
                       .instance = step.instance,
                       .component = lifecycle.component,
                       .timeout = timeout};
  UndoPlan plan;
  if (step.verb == ToString(LifecycleVerb::kCreate)) {
    order.verb = LifecycleVerb::kRemove;
    plan.first.push_back(order);
  } else if (step.verb == ToString(LifecycleVerb::kRemove)) {
    LifecycleOrder create = order;
    create.verb = LifecycleVerb::kCreate;
    create.class_name = lifecycle.class_name;
    create.library = lifecycle.library;
    create.configuration = lifecycle.former;
    create.thread = lifecycle.thread;
    create.leader = lifecycle.leader;
    plan.first.push_back(create);
    if (!step.is_unknown) AddOrdersInto(lifecycle.state, order, plan.then);
  } else if (step.verb == ToString(LifecycleVerb::kConfigure)) {
    order.verb = LifecycleVerb::kConfigure;
    order.configuration = lifecycle.former;
    order.based_on = BaseOf(lifecycle.configuration);
    plan.first.push_back(order);
  } else if (step.verb == ToString(LifecycleVerb::kStart)) {
    const bool was_suspended = lifecycle.state == ComponentState::kSuspended;
    order.verb = was_suspended ? LifecycleVerb::kSuspend : LifecycleVerb::kStop;
    plan.first.push_back(order);
  } else if (step.verb == ToString(LifecycleVerb::kSuspend)) {
    order.verb = LifecycleVerb::kStart;
    plan.then.push_back(order);
  } else if (step.verb == ToString(LifecycleVerb::kStop)) {
    plan.then = OrdersToRunAgain(lifecycle, order);
  }
  return plan;
}

}  // namespace tendon
