#pragma once

#include <deque>
#include <functional>
#include <mutex>

namespace tendon::server {

/// Actions that are added while a lock is held, and run after the lock is released: replying,
/// sending, logging. They run one at a time, in the order of Add(), in a thread that calls Flush().
/// Thread-safe.
class DeferredActions {
 public:
  using Action = std::function<void()>;

  void Add(Action action);
  /// Runs all pending actions. If another thread is already running actions, returns at once, and
  /// that thread also runs the pending actions.
  void Flush();

 private:
  std::mutex mutex_;
  std::deque<Action> actions_;
  bool flushing_ = false;
};

}  // namespace tendon::server
