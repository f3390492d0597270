#pragma once

#include <tendon/base/clock.h>
#include <tendon/lockfree/flag.h>
#include <tendon/lockfree/wakeup.h>

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

  /// Waits until `deadline`; nothing, and the value refused from then on, when it has passed.
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
