#pragma once

#include <tendon/base/clock.h>

#include <condition_variable>
#include <mutex>
#include <optional>
#include <utility>

namespace tendon {

/// One value that one thread waits for and another brings, once. Thread-safe; held by both.
template <typename T>
class Handover {
 public:
  /// False where there was a value before or nobody waits any more.
  bool Give(T value) {
    std::unique_lock lock(mutex_);
    if (is_done_) return false;
    is_done_ = true;
    value_ = std::move(value);
    lock.unlock();  // who is woken with the lock held goes to sleep once more
    given_.notify_one();
    return true;
  }

  /// Waits until `deadline`; nothing, and the value refused from then on, when it has passed.
  std::optional<T> WaitUntil(SteadyTime deadline) {
    std::unique_lock lock(mutex_);
    given_.wait_until(lock, deadline, [this] { return is_done_; });
    is_done_ = true;
    return std::exchange(value_, std::nullopt);
  }

 private:
  std::mutex mutex_;
  std::condition_variable given_;
  bool is_done_ = false;
  std::optional<T> value_;
};

}  // namespace tendon
