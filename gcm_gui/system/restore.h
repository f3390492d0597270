#pragma once

#include <gcm_gui/reports/system_reports.h>
#include <gcm_gui/system/plan_runner.h>
#include <gcm_gui/system/system_document.h>
#include <tendon/gcm/life/class_check.h>
#include <tendon/gcm/system/plan.h>

#include <QObject>
#include <QString>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace tendon::gui {

/// Brings the running system to a wanted state in three moves: a plan to look at, its steps one by
/// one, and a way back. Processes that have something to make are asked for their classes before a
/// plan is shown. GUI thread.
class Restore : public QObject {
  Q_OBJECT

 public:
  enum class Phase { kIdle, kAsking, kPreview, kRunning, kDone };

  Restore(const SystemDocument& document, PlanRunner& runner, SystemReports& reports,
          QObject* parent = nullptr);

  [[nodiscard]] Phase phase() const { return phase_; }
  /// What it leads to: "demo.gcm.json", "the state at 12:04".
  [[nodiscard]] const QString& goal() const { return goal_; }
  [[nodiscard]] const Plan& plan() const { return plan_; }
  /// Of the steps that are over, in their order.
  [[nodiscard]] const std::vector<StepOutcome>& outcomes() const { return outcomes_; }
  [[nodiscard]] const PlanOutcome& outcome() const { return outcome_; }
  [[nodiscard]] bool canUndo() const { return before_.has_value() && phase_ == Phase::kDone; }

  /// Plans, and does nothing yet. Not while one is being carried out. A plan that leads to the same
  /// goal stays in sight until the new one is made.
  void preview(const SystemFile& wanted, const QString& goal);
  void execute(AfterError after_error);
  /// After the step that is being made.
  void stop() { runner_.stop(); }
  /// Previews the system as it was before execute(); processes that were started are ended.
  void undo();
  /// From the preview of an undo back to what it would have undone. No answer is waited for then.
  void leave();

 Q_SIGNALS:
  void changed();

 private:
  /// A plan that was carried out, and what came of it.
  struct Done {
    Plan plan;
    QString goal;
    std::vector<StepOutcome> outcomes;
    PlanOutcome outcome;
  };

  /// The classes that are known when a plan is made, and how many answers are still to come.
  struct Question {
    KnownClasses known;
    std::size_t open = 0;
  };
  using Finish = std::function<Plan(Plan)>;

  /// Plans once all have answered; `finish` has the last word on the plan.
  void plan(const SystemFile& wanted, const QString& goal, Finish finish);
  void show(Plan plan, const QString& goal);
  void noteBirth();

  const SystemDocument& document_;
  PlanRunner& runner_;
  SystemReports& reports_;
  Phase phase_ = Phase::kIdle;
  QString goal_;
  SystemFile wanted_;  // by the newest plan
  Plan plan_;
  std::shared_ptr<Question> question_;  // of the newest plan; null where none is waited for
  std::vector<StepOutcome> outcomes_;
  PlanOutcome outcome_;
  std::optional<SystemFile> before_;
  std::optional<Done> to_undo_;   // while its undo is only looked at
  std::vector<PlanStep> births_;  // of processes, since then, with the instances that came of them
};

}  // namespace tendon::gui
