#pragma once

#include <tendon/gcm/system/plan.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace tendon {

/// Executes the steps of a plan, one at a time. Each function waits until it is done.
class PlanExecutor {
 public:
  virtual ~PlanExecutor() = default;
  /// Called before the first step. Takes the plan lock until End(). After an error, no step is
  /// executed.
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
  /// The reason why the step failed or was not executed. Empty if the plan ended before this step.
  std::string reason;

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

/// Called with the outcome of each step. The first step has number 1.
using PlanProgress =
    std::function<void(std::size_t number, const PlanStep& step, const StepOutcome& outcome)>;

/// Called before each step. If it returns true, this and all further steps are not executed.
using PlanInterrupt = std::function<bool()>;

/// Executes a plan. kStop: ends after the first failure. kGoOn: continues after a failure, but does
/// not execute steps that depend on the failed step. A component with a failed step is not changed
/// or connected any more. A component whose planned connection failed is not started.
PlanOutcome ExecutePlan(
    const Plan& plan, PlanExecutor& executor, AfterError after_error, const PlanProgress& progress,
    const PlanInterrupt& interrupt = [] { return false; });

}  // namespace tendon
