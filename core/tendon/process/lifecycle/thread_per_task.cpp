#include <tendon/process/lifecycle/thread_per_task.h>

#include <tendon/base/log.h>
#include <tendon/base/os/thread.h>

#include <exception>
#include <system_error>

namespace tendon {

Result<void> ThreadPerTask::Do(std::function<void()> task) {
  const std::scoped_lock lock(mutex_);
  JoinEnded();
  if (is_stopped_ || threads_.size() >= most_) {
    return Error{ErrorCode::kFailed, "process '" + owner_ +
                                         "' has too many orders, or is ending: nothing was "
                                         "done"};
  }
  const auto self = threads_.emplace(threads_.end());
  try {
    *self = std::thread([this, self, task = std::move(task)] { Run(task, self); });
    return {};
  } catch (const std::system_error&) {
    threads_.erase(self);
    return Error{
        ErrorCode::kFailed,
        "process '" + owner_ + "' cannot create more threads (ulimit -u): nothing was done"};
  }
}

void ThreadPerTask::Close() {
  const std::scoped_lock lock(mutex_);
  is_stopped_ = true;
}

bool ThreadPerTask::WaitUntilIdle(std::chrono::milliseconds timeout) {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, timeout, [this] { return threads_.empty(); });
}

void ThreadPerTask::Stop() {
  Close();
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return threads_.empty(); });
  JoinEnded();
}

void ThreadPerTask::Run(const std::function<void()>& task, Threads::iterator self) {
  os::NameThisThread("order");
  try {
    task();
  } catch (const std::exception& failure) {
    Log(LogLevel::kError, owner_, std::string("an order failed: ") + failure.what());
  } catch (...) {
    Log(LogLevel::kError, owner_,
        "an order failed: its exception does not derive from std::exception");
  }
  const std::scoped_lock lock(mutex_);
  ended_.splice(ended_.end(), threads_, self);
  changed_.notify_all();
}

/// Joins the threads whose tasks have ended. Called with the lock held. This cannot deadlock,
/// because these threads do not take the lock any more.
void ThreadPerTask::JoinEnded() {
  for (std::thread& thread : ended_) thread.join();
  ended_.clear();
}

}  // namespace tendon
