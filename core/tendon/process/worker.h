#pragma once

#include <tendon/base/clock.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>

namespace tendon {

/// For what must end by then: not below zero.
[[nodiscard]] inline std::chrono::milliseconds TimeUntil(SteadyTime deadline) {
  using std::chrono::milliseconds;
  const auto left = std::chrono::ceil<milliseconds>(deadline - SteadyClock().Now());
  return std::max(left, milliseconds(0));
}

/// A thread with a queue of tasks, for what must not be done in a thread of the middleware: opening
/// channels, writing files, trying again later. Tasks run one at a time; those due at one time in
/// the order in which they were posted. What a task throws is logged, and the others run.
/// Thread-safe. Idle, it sleeps.
class Worker {
 public:
  using Task = std::function<void()>;

  /// `name` is the thread's.
  explicit Worker(const std::string& name) : Worker(name, name) {}
  /// `owner` is who stands in the log.
  Worker(std::string name, std::string owner);
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  /// Stop(). A task of its own may do it, who holds the last reference: it is the last one then.
  ~Worker();

  void Post(Task task);
  void PostAfter(std::chrono::milliseconds delay, Task task);

  /// Waits for the running task, and ends its wait for a link; the others are dropped, as are those
  /// posted later. Not from a task.
  void Stop();

 private:
  class Queue;

  const std::shared_ptr<Queue> queue_;  // its thread's as well
  std::thread thread_;
};

}  // namespace tendon
