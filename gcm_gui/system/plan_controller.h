#pragma once

#include <gcm_gui/session/system_reports.h>
#include <gcm_gui/system/plan_runner.h>
#include <gcm_gui/system/system_document.h>
#include <tendon/gcm/lifecycle/class_check.h>
#include <tendon/gcm/system/plan.h>

#include <QObject>
#include <QString>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace tendon::gui {

/// Changes the running system to a target state: shows a plan, executes it step by step, and can
/// undo it. A plan may create components, so the classes of the processes concerned are requested
/// first. GUI thread.
class PlanController : public QObject {
  Q_OBJECT

 public:
  enum class Phase { kIdle, kAsking, kPreview, kRunning, kDone };

  PlanController(const SystemDocument& document, PlanRunner& runner, SystemReports& reports,
                 QObject* parent = nullptr);

  [[nodiscard]] Phase phase() const { return phase_; }
  /// The name of the target state: "demo.gcm.json", "the state at 12:04".
  [[nodiscard]] const QString& goal() const { return goal_; }
  [[nodiscard]] const Plan& plan() const { return plan_; }
  /// The results of the finished steps, in order.
  [[nodiscard]] const std::vector<StepOutcome>& outcomes() const { return outcomes_; }
  [[nodiscard]] const PlanOutcome& outcome() const { return outcome_; }
  [[nodiscard]] bool canUndo() const { return before_.has_value() && phase_ == Phase::kDone; }

  /// Makes a plan without executing it. Ignored while a plan is executed. If a plan for the same
  /// goal is shown already, this plan stays visible until the new plan is ready.
  void preview(const SystemFile& wanted, const QString& goal);
  void execute(AfterError after_error);
  /// Stops the execution after the present step.
  void stop() { runner_.stop(); }
  /// Makes a plan that restores the system to its state before execute(). The plan also stops the
  /// processes that were started after that state.
  void undo();
  /// Ends the preview of an undo and shows the executed plan again. Replies that have not arrived
  /// yet are ignored.
  void leave();

 Q_SIGNALS:
  void changed();

 private:
  /// An executed plan with the results of its steps.
  struct ExecutedPlan {
    Plan plan;
    QString goal;
    std::vector<StepOutcome> outcomes;
    PlanOutcome outcome;
  };

  /// The known classes for a plan, and the number of replies that are still missing.
  struct ClassQuery {
    KnownClasses known;
    std::size_t open = 0;
  };
  using Finish = std::function<Plan(Plan)>;

  /// Makes the plan as soon as all processes have answered. Then calls `finish`, which may change
  /// the plan.
  void plan(const SystemFile& wanted, const QString& goal, Finish finish);
  void show(Plan plan, const QString& goal);
  void recordStartedProcess();

  const SystemDocument& document_;
  PlanRunner& runner_;
  SystemReports& reports_;
  Phase phase_ = Phase::kIdle;
  QString goal_;
  SystemFile wanted_;  // the target of the newest plan
  Plan plan_;
  // The query for the newest plan; null if no reply is missing.
  std::shared_ptr<ClassQuery> question_;
  std::vector<StepOutcome> outcomes_;
  PlanOutcome outcome_;
  std::optional<SystemFile> before_;
  std::optional<ExecutedPlan> to_undo_;      // the executed plan, while its undo is previewed
  std::vector<PlanStep> started_processes_;  // processes started by `to_undo_`, with instances
};

}  // namespace tendon::gui
