#pragma once

#include <deque>
#include <functional>
#include <mutex>

namespace tendon::server {

/// Actions that a locked section adds, to be run after the lock is released: answering, sending,
/// logging. Runs them in the order of Add(), one at a time, in a thread that calls Flush(), without
/// a lock. Thread-safe.
class DeferredActions {
 public:
  using Action = std::function<void()>;

  void Add(Action action);
  /// Runs all waiting actions. Returns at once if another thread is running them, which then also
  /// runs the new ones.
  void Flush();

 private:
  std::mutex mutex_;
  std::deque<Action> actions_;
  bool flushing_ = false;
};

}  // namespace tendon::server
