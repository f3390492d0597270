#include <tendon/task/thread/thread_setup.h>
#include <tendon/task/thread/threaded_task.h>

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

Result<void> ThreadedTask::RunAfter(Task& other) {
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
    return refused("it is " + std::string(is_starting() ? "starting" : ToString(state())) +
                   "; stop it first");
  }
  Join();
  Follow(other);
  return {};
}

Result<void> ThreadedTask::Launch() {
  if (leader() != nullptr) return LaunchInLeader();
  Join();  // the thread of the last time, which has ended or is about to
  options_in_use_ = options_;
  PrepareStart();
  Order(LifeRequest::kStart);
  try {
    thread_ = std::thread([this] { ThreadMain(); });
  } catch (const std::system_error& error) {
    return Error{ErrorCode::kFailed,
                 "component '" + name() + "' got no thread: " + std::string(error.what())};
  }
  return {};
}

Result<void> ThreadedTask::LaunchInLeader() {
  if (leader()->is_at_rest() || leader()->state() == ComponentState::kSuspended) {
    return Error{ErrorCode::kFailed, "component '" + name() + "' runs after '" + leader()->name() +
                                         "', which is " + std::string(ToString(leader()->state())) +
                                         "; start '" + leader()->name() + "' first"};
  }
  PrepareStart();
  Order(LifeRequest::kStart);
  return {};
}

void ThreadedTask::Join() {
  if (!thread_.joinable()) return;
  Order(LifeRequest::kStop);
  thread_.join();
}

void ThreadedTask::ThreadMain() {
  SetUpThisThread(options_in_use_, name());
  ObeyOrders();
  while (state() == ComponentState::kActive || state() == ComponentState::kSuspended) {
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
