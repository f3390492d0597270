#pragma once

#include <tendon/base/clock.h>
#include <tendon/lockfree/flag.h>
#include <tendon/lockfree/wakeup.h>

#include <mutex>
#include <optional>
#include <utility>

namespace tendon {

/// Passes a single value from one thread to another thread, which waits for it. Both threads share
/// this object. Thread-safe.
template <typename T>
class OneShotValue {
 public:
  /// Sets the value and wakes the waiting thread. Returns false if a value was set before, or if
  /// the other thread has stopped waiting.
  bool Give(T value) {
    {
      const std::scoped_lock lock(mutex_);
      if (is_done_) return false;
      is_done_ = true;
      value_ = std::move(value);
    }
    given_.Set(true);
    wakeup_.Notify();
    return true;
  }

  /// Waits for the value until `deadline`. Returns no value if no value was set in time; a later
  /// Give() then fails.
  std::optional<T> WaitUntil(SteadyTime deadline) {
    wakeup_.WaitUntil([this] { return given_.Get(); }, deadline);
    const std::scoped_lock lock(mutex_);
    is_done_ = true;
    return std::exchange(value_, std::nullopt);
  }

 private:
  std::mutex mutex_;
  bool is_done_ = false;
  std::optional<T> value_;
  Flag given_;
  Wakeup<> wakeup_;
};

}  // namespace tendon
