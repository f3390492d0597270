#pragma once

#include <tendon/base/result.h>

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <list>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

namespace tendon {

/// Executes each task in its own thread, so that no task waits for another task. This is necessary
/// because code of component authors may take long, or never return. Thread-safe.
class ThreadPerTask {
 public:
  /// At most `most` tasks may run at a time. Errors and log records name the process `owner`.
  ThreadPerTask(std::string owner, std::size_t most) : owner_(std::move(owner)), most_(most) {}
  ThreadPerTask(const ThreadPerTask&) = delete;
  ThreadPerTask& operator=(const ThreadPerTask&) = delete;
  /// Calls Stop().
  ~ThreadPerTask() { Stop(); }

  /// Executes `task`. Fails, without executing it, if too many tasks run, if no thread can be
  /// started, or after Stop().
  Result<void> Do(std::function<void()> task);
  /// From now on, no task is started.
  void Close();
  /// Returns true if all tasks have ended within `timeout`.
  [[nodiscard]] bool WaitUntilIdle(std::chrono::milliseconds timeout);
  /// Calls Close() and waits for running tasks. Must not be called from a task.
  void Stop();

 private:
  using Threads = std::list<std::thread>;

  void Run(const std::function<void()>& task, Threads::iterator self);
  void JoinEnded();

  const std::string owner_;
  const std::size_t most_;
  std::mutex mutex_;
  std::condition_variable changed_;
  Threads threads_;
  Threads ended_;  // to be joined
  bool is_stopped_ = false;
};

}  // namespace tendon
