#include <tendon/task/threaded_task.h>

#include <tendon/task/thread_setup.h>

#include <system_error>

namespace tendon {

ThreadedTask::~ThreadedTask() { Join(); }

void ThreadedTask::SetThreadOptions(const ThreadOptions& options) {
  CheckThreadOptions(options, name());
  options_ = options;
}

double ThreadedTask::period() const {
  return leader() != nullptr ? leader()->period() : own_period();
}

Result<void> ThreadedTask::RunAfter(Task& other, SteadyTime deadline) {
  const auto refused = [this, &other](const std::string& why) {
    return Error{ErrorCode::kFailed,
                 "component '" + name() + "' cannot run after '" + other.name() + "': " + why};
  };
  std::string ring = other.name();
  for (const Task* one = &other; one != nullptr; one = one->leader()) {
    if (one != &other) ring += ", which runs after " + one->name();
    if (one == this) return refused("they would wait for each other: " + name() + " after " + ring);
  }
  if (!is_at_rest()) {
    return refused("'" + name() + "' is " +
                   std::string(is_starting() ? "starting" : ToString(state())) + "; stop it first");
  }
  Join();
  const auto joined = JoinLeader(other, deadline);
  return joined ? joined : Error{joined.error().code, refused(joined.error().message).message};
}

Result<void> ThreadedTask::Launch() {
  const Task* const first = leader();
  if (first != nullptr && (first->is_at_rest() || first->state() == ComponentState::kSuspended)) {
    return Error{ErrorCode::kFailed, "component '" + name() + "' runs after '" + first->name() +
                                         "', which is " + std::string(ToString(first->state())) +
                                         "; start '" + first->name() + "' first"};
  }
  Join();  // the thread of the last run has ended, or will soon
  options_in_use_ = options_;
  PrepareStart();
  GiveOrder(LifecycleRequest::kStart);
  if (first != nullptr) return {};
  try {
    thread_ = std::thread([this] { MakeCycles(); });
  } catch (const std::system_error& error) {
    return Error{ErrorCode::kFailed,
                 "component '" + name() +
                     "' could not get a thread (ulimit -u): " + std::string(error.what())};
  }
  return {};
}

void ThreadedTask::Join() {
  if (!thread_.joinable()) return;
  GiveOrder(LifecycleRequest::kStop);
  thread_.join();
}

void ThreadedTask::MakeCycles() {
  SetUpThisThread(options_in_use_, name());
  ObeyOrders();
  while (IsRunning(state())) {
    if (state() == ComponentState::kActive) {
      Loop();
    } else {
      constexpr std::chrono::hours kLong(1);
      wakeup().WaitUntil([this] { return has_orders(); }, SteadyClock().Now() + kLong);
    }
    ObeyOrders();
  }
  EndFollowers();
}

}  // namespace tendon
