#include <gcm_gui/system/plan_controller.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/system/system_parts.h>
#include <tendon/gcm/lookup.h>

#include <QPointer>
#include <utility>

namespace tendon::gui {
namespace {

/// Returns the state that an undo of `plan` restores. If the plan starts a process, the state
/// contains this process without components. If the plan ends a process, the state contains the
/// start command of this process.
SystemFile Before(const Plan& plan, SystemFile running) {
  for (const PlanStep& step : plan.steps) {
    const bool is_there = running.FindProcess(step.process) != nullptr;
    if (step.kind == PlanStep::Kind::kStartProcess && !is_there) {
      running.processes.push_back({.name = step.process, .components = {}});
    }
    if (step.kind != PlanStep::Kind::kEndProcess) continue;
    for (auto& process : running.processes) {
      if (process.name == step.process) process.start = SystemFile::Start{step.restart};
    }
  }
  return running;
}

}  // namespace

PlanController::PlanController(const SystemDocument& document, PlanRunner& runner,
                               SystemReports& reports, QObject* parent)
    : QObject(parent), document_(document), runner_(runner), reports_(reports) {}

void PlanController::preview(const SystemFile& wanted, const QString& goal) {
  if (phase_ == Phase::kRunning) return;
  to_undo_.reset();
  plan(wanted, goal, [](Plan made) { return made; });
}

void PlanController::plan(const SystemFile& wanted, const QString& goal, Finish finish) {
  const std::vector<std::string> asked = ProcessesToAsk(document_.catalogue(), wanted);
  const auto make = [this, wanted, goal, finish = std::move(finish)](const KnownClasses& known) {
    show(finish(MakeCheckedPlan(document_.catalogue(), wanted, known)), goal);
  };
  const bool stays = phase_ == Phase::kPreview && goal == goal_ && wanted == wanted_;
  wanted_ = wanted;
  question_.reset();
  if (asked.empty()) return make({});
  if (!stays) {
    goal_ = goal;
    phase_ = Phase::kAsking;
    plan_ = {};
    outcomes_.clear();
    outcome_ = {};
  }
  const auto question = std::make_shared<ClassQuery>();
  question->open = asked.size();
  question_ = question;
  if (!stays) Q_EMIT changed();
  for (const std::string& process : asked) {
    reports_.askClasses(process, [self = QPointer(this), question, process,
                                  make](const Result<message::Classes>& classes) {
      if (self == nullptr || self->question_ != question) return;
      // If the classes of the process are unknown, the process itself will refuse the step.
      if (classes) question->known[process] = *classes;
      if (--question->open == 0) make(question->known);
    });
  }
}

void PlanController::show(Plan plan, const QString& goal) {
  question_.reset();
  plan_ = std::move(plan);
  goal_ = goal;
  outcomes_.clear();
  outcome_ = {};
  phase_ = Phase::kPreview;
  Q_EMIT changed();
}

void PlanController::undo() {
  if (!canUndo()) return;
  to_undo_ = {plan_, goal_, outcomes_, outcome_};
  plan(*before_, Words::tr("the previous state"), [this](Plan made) {
    return WithEnds(std::move(made), document_.catalogue(), started_processes_);
  });
}

void PlanController::execute(AfterError after_error) {
  if (phase_ != Phase::kPreview || plan_.steps.empty()) return;
  to_undo_.reset();
  question_.reset();
  before_ = Before(plan_, WholeSystem(document_.catalogue()));
  started_processes_.clear();
  phase_ = Phase::kRunning;
  Q_EMIT changed();
  runner_.carryOut(
      plan_, after_error,
      [self = QPointer(this)](std::size_t /*number*/, const StepOutcome& came) {
        if (self == nullptr) return;
        self->outcomes_.push_back(came);
        self->recordStartedProcess();
        Q_EMIT self->changed();
      },
      [self = QPointer(this)](const PlanOutcome& outcome) {
        if (self == nullptr) return;
        self->outcome_ = outcome;
        self->phase_ = Phase::kDone;
        Q_EMIT self->changed();
      });
}

/// Stores which process the last step has started. The catalogue already contains this process.
void PlanController::recordStartedProcess() {
  if (outcomes_.size() > plan_.steps.size()) return;
  const PlanStep& step = plan_.steps[outcomes_.size() - 1];
  const bool is_start = step.kind == PlanStep::Kind::kStartProcess;
  if (!is_start || outcomes_.back().state != StepOutcome::State::kDone) return;
  started_processes_.push_back(step);
  started_processes_.back().instance = InstanceOf(document_.catalogue(), step.process);
}

void PlanController::leave() {
  if (phase_ == Phase::kRunning) return;
  question_.reset();
  phase_ = Phase::kIdle;
  if (to_undo_) {
    plan_ = std::move(to_undo_->plan);
    goal_ = to_undo_->goal;
    outcomes_ = std::move(to_undo_->outcomes);
    outcome_ = to_undo_->outcome;
    to_undo_.reset();
    phase_ = Phase::kDone;
  }
  Q_EMIT changed();
}

}  // namespace tendon::gui
