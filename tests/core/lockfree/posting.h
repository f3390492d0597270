#pragma once

#include <support/simulation/simulated_atomics.h>
#include <tendon/lockfree/wakeup.h>

#include <atomic>

namespace tendon::simulation {

/// For simulations: a sleeper that waits for a number of posts by any threads.
template <typename Atomics>
struct Posting {
  Wakeup<Atomics> wakeup;
  typename Atomics::template Atomic<int> posted{0};

  void Post() {
    posted.fetch_add(1, std::memory_order_release);
    wakeup.Notify();
  }
  /// Posts without urgency: the sleeper may sleep until `when`.
  void PostBy(SteadyTime when) {
    posted.fetch_add(1, std::memory_order_release);
    wakeup.NotifyBy(when);
  }
  void Receive(int wanted) {
    const auto ready = [&] { return posted.load(std::memory_order_acquire) >= wanted; };
    Check(wakeup.WaitUntil(ready, SteadyTime::max()), "gave up");
  }
};

}  // namespace tendon::simulation
