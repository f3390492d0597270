#include <tendon/gcm/system/plan_execution.h>

#include <tendon/gcm/system/system_index.h>

#include <map>
#include <utility>

namespace tendon {
namespace {

using State = StepOutcome::State;
using Kind = PlanStep::Kind;

bool IsOfConnection(const PlanStep& step) { return step.process.empty(); }

/// The path that represents the process itself.
ComponentPath PathOf(const std::string& process) { return {process, ""}; }

/// Collects the failures on which later steps depend.
class Failures {
 public:
  /// Adds a step that has failed or was not executed. `cause` is the step that failed first.
  void Note(const PlanStep& step, const std::string& cause) {
    if (IsOfConnection(step)) {
      lacking_.emplace(OwnerOf(step.ends.required), cause);
    } else {
      unfit_.emplace(ComponentPath(step.process, step.component.name), cause);
    }
  }

  /// Returns the failed step on which `step` depends; empty if it depends on none.
  [[nodiscard]] std::string Before(const PlanStep& step) const {
    if (step.kind == Kind::kDisconnect) return {};
    if (IsOfConnection(step)) {
      const std::string client = Find(unfit_, OwnerOf(step.ends.required));
      return client.empty() ? Find(unfit_, OwnerOf(step.ends.provided)) : client;
    }
    const ComponentPath path(step.process, step.component.name);
    const bool starts = step.kind == Kind::kStart || step.kind == Kind::kStartSuspended;
    std::string before = Find(unfit_, path);
    if (before.empty() && starts) before = Find(lacking_, path);
    const std::string& leader = step.component.runs_after;
    const bool needs_leader = !leader.empty() && (starts || step.kind == Kind::kCreate);
    if (before.empty() && needs_leader) before = Find(unfit_, {step.process, leader});
    for (const message::ConnectionEnds& ends : step.needs) {
      if (before.empty()) before = Find(unfit_, OwnerOf(ends.provided));
    }
    return before;
  }

 private:
  using Steps = std::map<ComponentPath, std::string>;

  static std::string Find(const Steps& steps, const ComponentPath& path) {
    auto found = steps.find(path);
    if (found == steps.end()) found = steps.find(PathOf(path.first));
    return found == steps.end() ? std::string() : found->second;
  }

  Steps unfit_;    // components and processes that are not as planned
  Steps lacking_;  // components without a planned connection
};

/// Returns the outcome of a plan whose steps were not executed. Only the first step is reported
/// with the reason.
PlanOutcome LeaveAll(const Plan& plan, const Error& why, const PlanProgress& progress) {
  std::string reason = why.message;
  std::size_t number = 0;
  for (const PlanStep& step : plan.steps) {
    progress(++number, step, {State::kLeft, std::exchange(reason, "")});
  }
  return {.left = number, .error = why};
}

}  // namespace

PlanOutcome ExecutePlan(const Plan& plan, PlanExecutor& executor, AfterError after_error,
                        const PlanProgress& progress, const PlanInterrupt& interrupt) {
  if (plan.steps.empty()) return {};
  if (const auto begun = executor.Begin(); !begun) return LeaveAll(plan, begun.error(), progress);
  PlanOutcome outcome;
  Failures failures;
  std::size_t number = 0;
  for (const PlanStep& step : plan.steps) {
    ++number;
    outcome.is_interrupted = outcome.is_interrupted || interrupt();
    if (outcome.is_interrupted || (outcome.error && after_error == AfterError::kStop)) {
      ++outcome.left;
      progress(number, step, {State::kLeft, ""});
      continue;
    }
    if (const std::string before = failures.Before(step); !before.empty()) {
      ++outcome.left;
      failures.Note(step, before);
      progress(number, step,
               {State::kLeft, "not executed, because an earlier step failed: " + before});
      continue;
    }
    const Result<void> made = executor.Execute(step);
    ++(made ? outcome.done : outcome.failed);
    if (!made) {
      failures.Note(step, ToString(step));
      if (!outcome.error) outcome.error = made.error();
    }
    progress(number, step,
             made ? StepOutcome() : StepOutcome{State::kFailed, made.error().message});
  }
  executor.End();
  return outcome;
}

}  // namespace tendon
