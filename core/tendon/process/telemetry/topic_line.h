#pragma once

#include <tendon/base/clock.h>

#include <cstdint>
#include <mutex>

namespace tendon {

/// How a subscription hears a topic: what the thread that hears it has to say to the one that made
/// it. Thread-safe.
class TopicLine {
 public:
  /// From now on batches are of this beginning of the subscription.
  void Begin(std::uint64_t beginning) {
    const std::scoped_lock lock(mutex_);
    beginning_ = beginning;
  }
  /// Something is heard, until Rest(). Returns the beginning, or 0 before there is one.
  std::uint64_t Hear() {
    const std::scoped_lock lock(mutex_);
    is_busy_ = true;
    return beginning_;
  }
  void Rest() {
    const std::scoped_lock lock(mutex_);
    is_busy_ = false;
    last_ = SteadyClock().Now();
  }
  /// None while it is the viewer who takes his time.
  [[nodiscard]] SteadyTime::duration silence() const {
    const std::scoped_lock lock(mutex_);
    return is_busy_ ? SteadyTime::duration(0) : SteadyClock().Now() - last_;
  }

 private:
  mutable std::mutex mutex_;
  std::uint64_t beginning_ = 0;
  bool is_busy_ = false;
  SteadyTime last_ = SteadyClock().Now();
};

}  // namespace tendon
