#pragma once

#include <tendon/base/clock.h>
#include <tendon/lockfree/flag.h>
#include <tendon/lockfree/wakeup.h>

#include <mutex>
#include <optional>
#include <utility>

namespace tendon {

/// Hands one value from one thread to another that waits for it, once. Thread-safe; both own it.
template <typename T>
class OneShotValue {
 public:
  /// Returns false if a value was given before or nobody waits any more.
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

  /// Waits until `deadline`. Returns nothing if no value came; later values are refused.
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
