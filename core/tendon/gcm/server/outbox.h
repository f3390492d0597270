#pragma once

#include <deque>
#include <functional>
#include <mutex>

namespace tendon::server {

/// What a locked section wants done once the lock is free: answering, sending, logging. Actions run
/// in the order in which they were added, one at a time, in whichever thread flushes; no action
/// runs under a lock of the outbox. Thread-safe.
class Outbox {
 public:
  using Action = std::function<void()>;

  void Add(Action action);
  /// Runs all that is there; returns at once when another thread is at it, which then runs ours
  /// too.
  void Flush();

 private:
  std::mutex mutex_;
  std::deque<Action> actions_;
  bool flushing_ = false;
};

}  // namespace tendon::server
