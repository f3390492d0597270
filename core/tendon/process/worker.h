#pragma once

#include <tendon/base/clock.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>

namespace tendon {

/// Returns the time until `deadline`, but not less than zero.
[[nodiscard]] inline std::chrono::milliseconds TimeUntil(SteadyTime deadline) {
  using std::chrono::milliseconds;
  const auto left = std::chrono::ceil<milliseconds>(deadline - SteadyClock().Now());
  return std::max(left, milliseconds(0));
}

/// A thread with a queue of tasks, for work that must not be done in a thread of the middleware,
/// such as opening channels, writing files, and retrying later. Executes one task at a time, in the
/// order of their due times. Tasks with the same due time are executed in the order in which they
/// were posted. Logs exceptions of tasks. Sleeps when idle. Thread-safe.
class Worker {
 public:
  using Task = std::function<void()>;

  /// `name` is the name of the thread.
  explicit Worker(const std::string& name) : Worker(name, name) {}
  /// `owner` is the source of the worker's log records.
  Worker(std::string name, std::string owner);
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  /// Calls Stop(). A task may destroy the worker if it holds the last reference. Then no further
  /// task is executed.
  ~Worker();

  void Post(Task task);
  void PostAfter(std::chrono::milliseconds delay, Task task);

  /// Waits for the running task. If this task is opening a link, cancels the attempt. Drops all
  /// other tasks, including tasks that are posted later. Must not be called from a task.
  void Stop();

 private:
  class Queue;

  const std::shared_ptr<Queue> queue_;  // shared with the thread
  std::thread thread_;
};

}  // namespace tendon
