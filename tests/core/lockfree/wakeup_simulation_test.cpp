#include <gtest/gtest.h>
#include <support/simulation/report_matchers.h>
#include <support/simulation/simulated_atomics.h>
#include <support/simulation/weakened_atomics.h>
#include <tendon/lockfree/wakeup.h>

#include <memory>

namespace tendon::simulation {
namespace {

/// A sleeper that wants both of two posts; the posters may be one thread or two.
template <typename Atomics>
struct Posting {
  Wakeup<Atomics> wakeup;
  typename Atomics::template Atomic<int> posted{0};

  void Post() {
    posted.fetch_add(1, std::memory_order_release);
    wakeup.Notify();
  }
  void Receive(int wanted) {
    const auto ready = [&] { return posted.load(std::memory_order_acquire) >= wanted; };
    Check(wakeup.WaitUntil(ready, SteadyTime::max()), "gave up");
  }
};

template <typename Atomics>
Report ExplorePosting() {
  return Explore([](Scenario& scenario) {
    const auto posting = std::make_shared<Posting<Atomics>>();
    scenario.Thread([=] {
      posting->Receive(1);
      posting->Receive(2);
    });
    scenario.Thread([=] { posting->Post(); });
    scenario.Thread([=] { posting->Post(); });
  });
}

TEST(WakeupSimulation, LosesNoWakeUpInAnyInterleaving) {
  EXPECT_THAT(ExplorePosting<SimulatedAtomics>(), Passes(1000));
}

TEST(WakeupSimulation, NeedsItsFences) {
  using NoFullFence = WithoutFence<std::memory_order_seq_cst>;
  EXPECT_THAT(ExplorePosting<NoFullFence>(), FailsWith("every thread waits"));
}

}  // namespace
}  // namespace tendon::simulation
