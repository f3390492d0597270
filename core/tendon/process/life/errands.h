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

/// Does things in a thread each, for none may wait for another: what an author's code does there
/// may take long, or never end. Thread-safe.
class Errands {
 public:
  /// `most` may be under way at once; `owner` is the process that stands in errors and in the log.
  Errands(std::string owner, std::size_t most) : owner_(std::move(owner)), most_(most) {}
  Errands(const Errands&) = delete;
  Errands& operator=(const Errands&) = delete;
  /// Stop().
  ~Errands() { Stop(); }

  /// An error where so many are under way, where there is no further thread, and after Stop(): the
  /// task is not done then.
  Result<void> Do(std::function<void()> task);
  /// From now on nothing is begun.
  void Close();
  /// Whether nothing is under way within `patience`.
  [[nodiscard]] bool WaitUntilIdle(std::chrono::milliseconds patience);
  /// Waits for what is under way, and begins nothing any more. Not from a task.
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
