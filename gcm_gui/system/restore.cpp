#include <gcm_gui/system/restore.h>
#include <gcm_gui/system/system_parts.h>

#include <QPointer>
#include <utility>

namespace tendon::gui {
namespace {

/// So that what a plan makes in processes that it starts is gone again.
SystemFile Before(const Plan& plan, SystemFile running) {
  for (const PlanStep& step : plan.steps) {
    if (running.FindProcess(step.process) != nullptr) continue;
    if (step.kind != PlanStep::Kind::kStartProcess) continue;
    running.processes.push_back({.name = step.process, .components = {}});
  }
  return running;
}

}  // namespace

Restore::Restore(const SystemDocument& document, PlanRunner& runner, QObject* parent)
    : QObject(parent), document_(document), runner_(runner) {}

void Restore::preview(const SystemFile& wanted, const QString& goal) {
  if (phase_ == Phase::kRunning) return;
  plan_ = MakePlan(document_.catalogue(), wanted);
  goal_ = goal;
  outcomes_.clear();
  outcome_ = {};
  phase_ = Phase::kPreview;
  Q_EMIT changed();
}

void Restore::undo() {
  if (canUndo()) preview(*std::exchange(before_, std::nullopt), QStringLiteral("what was before"));
}

void Restore::execute(AfterError after_error) {
  if (phase_ != Phase::kPreview || plan_.steps.empty()) return;
  before_ = Before(plan_, WholeSystem(document_.catalogue()));
  phase_ = Phase::kRunning;
  Q_EMIT changed();
  runner_.carryOut(
      plan_, after_error,
      [self = QPointer(this)](std::size_t /*number*/, const StepOutcome& came) {
        if (self == nullptr) return;
        self->outcomes_.push_back(came);
        Q_EMIT self->changed();
      },
      [self = QPointer(this)](const PlanOutcome& outcome) {
        if (self == nullptr) return;
        self->outcome_ = outcome;
        self->phase_ = Phase::kDone;
        Q_EMIT self->changed();
      });
}

void Restore::leave() {
  if (phase_ == Phase::kRunning) return;
  phase_ = Phase::kIdle;
  Q_EMIT changed();
}

}  // namespace tendon::gui
