#include <gcm_gui/system/plan_worker.h>
#include <tendon/gcm/system/client_executor.h>

#include <utility>

namespace tendon::gui {

PlanWorker::PlanWorker(GcmClient& client, std::chrono::milliseconds timeout)
    : client_(client), timeout_(timeout), courier_(std::make_shared<Courier>(this)) {
  thread_.setMaxThreadCount(1);
}

PlanWorker::~PlanWorker() {
  setStopped(true);
  courier_->detach();
  thread_.waitForDone();
}

void PlanWorker::carryOut(Plan plan, AfterError after_error, Progress progress, Done done) {
  setStopped(false);
  thread_.start([this, plan = std::move(plan), after_error, progress = std::move(progress),
                 done = std::move(done)] {
    ClientExecutor executor(client_, timeout_);
    const PlanOutcome outcome = ExecutePlan(
        plan, executor, after_error,
        [&](std::size_t number, const PlanStep& /*of the plan*/, const StepOutcome& came) {
          courier_->post([progress, number, came] { progress(number, came); });
        },
        [this] { return isStopped(); });
    courier_->post([done, outcome] { done(outcome); });
  });
}

void PlanWorker::setStopped(bool stopped) {
  const std::lock_guard lock(mutex_);
  is_stopped_ = stopped;
}

bool PlanWorker::isStopped() {
  const std::lock_guard lock(mutex_);
  return is_stopped_;
}

}  // namespace tendon::gui
