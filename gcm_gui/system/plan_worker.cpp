#include <gcm_gui/system/plan_worker.h>

#include <gcm_gui/guard/exception_guard.h>
#include <tendon/gcm/system/client_executor.h>

#include <utility>

namespace tendon::gui {

PlanWorker::PlanWorker(std::shared_ptr<GcmClient> client, std::chrono::milliseconds timeout)
    : client_(std::move(client)),
      timeout_(timeout),
      poster_(std::make_shared<GuiPoster>(this)),
      is_stopped_(std::make_shared<Flag>()) {}

PlanWorker::~PlanWorker() {
  stop();
  poster_->detach();
}

void PlanWorker::stop() { is_stopped_->Set(true); }

void PlanWorker::carryOut(Plan plan, AfterError after_error, Progress progress, Done done) {
  is_stopped_ = std::make_shared<Flag>();
  thread_.start([client = client_, timeout = timeout_, poster = poster_, is_stopped = is_stopped_,
                 plan = std::move(plan), after_error, progress = std::move(progress),
                 done = std::move(done)] {
    PlanOutcome outcome;
    try {
      ClientExecutor executor(*client, timeout);
      outcome = ExecutePlan(
          plan, executor, after_error,
          [&](std::size_t number, const PlanStep& /*of the plan*/, const StepOutcome& came) {
            poster->post([progress, number, came] { progress(number, came); });
          },
          [&] { return is_stopped->Get(); });
    } catch (...) {
      outcome.error = Error{ErrorCode::kFailed, CurrentExceptionText().toStdString()};
      outcome.failed = 1;
    }
    poster->post([done, outcome] { done(outcome); });
  });
}

}  // namespace tendon::gui
