#pragma once

#include <tendon/gcm/system/plan_execution.h>

#include <cstddef>
#include <functional>

namespace tendon::gui {

/// Executes plans, one at a time. Each function returns at once. Handlers are called in the GUI
/// thread, and never after the runner is destroyed.
class PlanRunner {
 public:
  /// Called with the result of one step; the first step has number 1.
  using Progress = std::function<void(std::size_t number, const StepOutcome& outcome)>;
  using Done = std::function<void(const PlanOutcome& outcome)>;

  PlanRunner() = default;
  PlanRunner(const PlanRunner&) = delete;
  PlanRunner& operator=(const PlanRunner&) = delete;
  virtual ~PlanRunner() = default;

  virtual void carryOut(Plan plan, AfterError after_error, Progress progress, Done done) = 0;
  /// Stops the execution after the present step.
  virtual void stop() = 0;
};

}  // namespace tendon::gui
