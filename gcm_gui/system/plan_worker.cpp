#include <gcm_gui/system/plan_worker.h>
#include <tendon/gcm/system/client_executor.h>

#include <mutex>
#include <utility>

namespace tendon::gui {

/// Whether a plan is to be left after the step that is being made.
struct PlanWorker::Order {
  void stop() {
    const std::lock_guard lock(mutex);
    is_stopped = true;
  }
  [[nodiscard]] bool isStopped() {
    const std::lock_guard lock(mutex);
    return is_stopped;
  }

  std::mutex mutex;
  bool is_stopped = false;  // guarded by mutex
};

PlanWorker::PlanWorker(std::shared_ptr<GcmClient> client, std::chrono::milliseconds timeout)
    : client_(std::move(client)),
      timeout_(timeout),
      courier_(std::make_shared<Courier>(this)),
      order_(std::make_shared<Order>()) {}

PlanWorker::~PlanWorker() {
  stop();
  courier_->detach();
}

void PlanWorker::stop() { order_->stop(); }

void PlanWorker::carryOut(Plan plan, AfterError after_error, Progress progress, Done done) {
  order_ = std::make_shared<Order>();
  thread_.start([client = client_, timeout = timeout_, courier = courier_, order = order_,
                 plan = std::move(plan), after_error, progress = std::move(progress),
                 done = std::move(done)] {
    ClientExecutor executor(*client, timeout);
    const PlanOutcome outcome = ExecutePlan(
        plan, executor, after_error,
        [&](std::size_t number, const PlanStep& /*of the plan*/, const StepOutcome& came) {
          courier->post([progress, number, came] { progress(number, came); });
        },
        [&] { return order->isStopped(); });
    courier->post([done, outcome] { done(outcome); });
  });
}

}  // namespace tendon::gui
