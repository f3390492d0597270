#pragma once

#include <tendon/gcm/system/plan.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace tendon {

/// Executes one step and waits for it.
class PlanExecutor {
 public:
  virtual ~PlanExecutor() = default;
  /// Called before the first step: reserves the execution of plans until End(). After an error no
  /// step is executed.
  virtual Result<void> Begin() { return {}; }
  virtual Result<void> Execute(const PlanStep& step) = 0;
  virtual void End() {}
};

enum class AfterError { kStop, kGoOn };

/// The outcome of one step.
struct StepOutcome {
  enum class State {
    kDone,
    kFailed,
    kLeft,  ///< not executed
  };

  State state = State::kDone;
  std::string reason;  ///< why it was not executed; empty for steps after the end of the plan

  bool operator==(const StepOutcome&) const = default;
};

/// The outcome of a plan.
struct PlanOutcome {
  std::size_t done = 0;
  std::size_t failed = 0;
  std::size_t left = 0;
  std::optional<Error> error;  ///< the first error
  bool is_interrupted = false;

  bool operator==(const PlanOutcome&) const = default;
};

/// Called for each step; the first has number 1.
using PlanProgress =
    std::function<void(std::size_t number, const PlanStep& step, const StepOutcome& outcome)>;

/// Called before each step; returns true to cancel the rest.
using PlanInterrupt = std::function<bool()>;

/// With kStop, executes the plan up to the first failure. With kGoOn, continues, but skips steps
/// that depend on a failure: a component with a failed step is not changed or connected any more,
/// and a component without a planned connection is not started.
PlanOutcome ExecutePlan(
    const Plan& plan, PlanExecutor& executor, AfterError after_error, const PlanProgress& progress,
    const PlanInterrupt& interrupt = [] { return false; });

}  // namespace tendon
