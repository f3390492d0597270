#pragma once

#include <tendon/gcm/system/plan.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace tendon {

/// What carries out one step, and waits for it.
class PlanExecutor {
 public:
  virtual ~PlanExecutor() = default;
  /// Before the first step: from now on until End() nobody else carries out a plan. After an error
  /// no step is made.
  virtual Result<void> Begin() { return {}; }
  virtual Result<void> Execute(const PlanStep& step) = 0;
  virtual void End() {}
};

enum class AfterError { kStop, kGoOn };

/// What came of one step.
struct StepOutcome {
  enum class Fate {
    kDone,
    kFailed,
    kLeft,  ///< not tried
  };

  Fate fate = Fate::kDone;
  std::string reason;  ///< why not; empty also for what is left since the plan was stopped

  bool operator==(const StepOutcome&) const = default;
};

/// What came of the steps of a plan.
struct PlanOutcome {
  std::size_t done = 0;
  std::size_t failed = 0;
  std::size_t left = 0;
  std::optional<Error> error;  ///< the first
  bool is_interrupted = false;

  bool operator==(const PlanOutcome&) const = default;
};

/// Called for each step, the first of which has number 1.
using PlanProgress =
    std::function<void(std::size_t number, const PlanStep& step, const StepOutcome& outcome)>;

/// Whether the rest is not wanted any more; asked before each step.
using PlanInterrupt = std::function<bool()>;

/// Up to the first step that fails, or all. Also then what builds on a step that has failed is
/// left: a component of which one has failed is not touched any more, nor connected to, and one
/// that lacks a connection is not started.
PlanOutcome ExecutePlan(
    const Plan& plan, PlanExecutor& executor, AfterError after_error, const PlanProgress& progress,
    const PlanInterrupt& interrupt = [] { return false; });

}  // namespace tendon
