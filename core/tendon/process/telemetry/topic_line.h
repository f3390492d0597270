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
  /// The subscription hears no more of it.
  void End() { Begin(0); }

  /// While it lives, something is heard.
  class Hearing {
   public:
    explicit Hearing(TopicLine& line) : line_(line) { line_.SetBusy(true); }
    Hearing(const Hearing&) = delete;
    Hearing& operator=(const Hearing&) = delete;
    ~Hearing() { line_.SetBusy(false); }

   private:
    TopicLine& line_;
  };
  /// 0 where there is none.
  [[nodiscard]] std::uint64_t beginning() const {
    const std::scoped_lock lock(mutex_);
    return beginning_;
  }
  /// None while it is the viewer who takes his time.
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
