#pragma once

#include <tendon/base/clock.h>

#include <cstdint>
#include <mutex>

namespace tendon {

/// The shared state of the thread that receives a topic and the subscription that uses it.
/// Thread-safe.
class TopicState {
 public:
  /// From now on, batches belong to this activation of the subscription.
  void Begin(std::uint64_t beginning) {
    const std::scoped_lock lock(mutex_);
    beginning_ = beginning;
  }
  /// From now on, the subscription gets no batches.
  void End() { Begin(0); }

  /// While it lives, a message is being handled.
  class Hearing {
   public:
    explicit Hearing(TopicState& line) : line_(line) { line_.SetBusy(true); }
    Hearing(const Hearing&) = delete;
    Hearing& operator=(const Hearing&) = delete;
    ~Hearing() { line_.SetBusy(false); }

   private:
    TopicState& line_;
  };
  /// 0 if there is none.
  [[nodiscard]] std::uint64_t beginning() const {
    const std::scoped_lock lock(mutex_);
    return beginning_;
  }
  /// The time since the last message; zero while the viewer is handling a message.
  [[nodiscard]] SteadyTime::duration silence() const {
    const std::scoped_lock lock(mutex_);
    return is_busy_ ? SteadyTime::duration(0) : SteadyClock().Now() - last_;
  }

 private:
  void SetBusy(bool is_busy) {
    const std::scoped_lock lock(mutex_);
    is_busy_ = is_busy;
    last_ = SteadyClock().Now();
  }

  mutable std::mutex mutex_;
  std::uint64_t beginning_ = 0;
  bool is_busy_ = false;
  SteadyTime last_ = SteadyClock().Now();
};

}  // namespace tendon
