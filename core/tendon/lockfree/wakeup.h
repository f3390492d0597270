#pragma once

#include <tendon/lockfree/atomics.h>

#include <atomic>
#include <cstdint>

namespace tendon {

/// Lets one thread sleep until others have work for it. A thread that posts work pays a fence and a
/// load of a flag (about 5 ns) while the sleeper is awake, and a system call while the sleeper
/// sleeps.
///
/// No wake-up is lost: the poster publishes, then reads the flag; the sleeper raises the flag, then
/// checks for work. With a full fence between the two steps on both sides, at least one side sees
/// what the other side has stored.
///
/// Thread safety: any thread may Notify(); one thread may WaitUntil().
template <typename Atomics = StdAtomics>
class Wakeup {
 public:
  /// Wakes the sleeper. Called after the work was published. Wait-free except for the system call.
  void Notify() noexcept {
    Atomics::Fence(std::memory_order_seq_cst);  // (A) the work is visible before the flag is read
    NotifyAfterFence();
  }
  /// Like Notify(), for a poster that has already executed a full fence after it published the
  /// work.
  void NotifyAfterFence() noexcept {
    if (asleep_.load(std::memory_order_relaxed) == kAwake) return;
    if (asleep_.exchange(kAwake, std::memory_order_relaxed) == kAsleep) Atomics::Wake(asleep_);
  }
  /// Like Notify(), for work that may wait until `when`. Does nothing if the sleeper wakes by
  /// itself before `when`.
  void NotifyBy(SteadyTime when) noexcept {
    Atomics::Fence(std::memory_order_seq_cst);  // (A)
    if (asleep_.load(std::memory_order_acquire) == kAwake) return;
    if (until_.load(std::memory_order_relaxed) > when) NotifyAfterFence();
  }

  /// Sleeps until `ready()` or until `deadline`; returns the last result of `ready()`. `ready()`
  /// runs in this thread, a few times more than needed; it checks for work that posters publish
  /// before they notify.
  template <typename Predicate>
  bool WaitUntil(Predicate ready, SteadyTime deadline) {
    while (!ready()) {
      const SteadyTime now = Atomics::Now();
      if (now >= deadline) return false;
      until_.store(deadline, std::memory_order_relaxed);
      asleep_.store(kAsleep, std::memory_order_release);  // pairs with the load in NotifyBy()
      Atomics::Fence(std::memory_order_seq_cst);          // (B) raised before the check for work
      const bool is_ready = ready();
      if (!is_ready) Atomics::Sleep(asleep_, kAsleep, deadline - now);
      asleep_.store(kAwake, std::memory_order_relaxed);
      if (is_ready) break;
    }
    return true;
  }

 private:
  static constexpr std::uint32_t kAwake = 0;
  static constexpr std::uint32_t kAsleep = 1;

  typename Atomics::template Atomic<std::uint32_t> asleep_{kAwake};
  typename Atomics::template Atomic<SteadyTime> until_{SteadyTime{}};  // latest end of the sleep
};

}  // namespace tendon
