#include <core/lockfree/posting.h>
#include <gtest/gtest.h>
#include <support/simulation/report_matchers.h>
#include <support/simulation/simulated_atomics.h>
#include <support/simulation/weakened_atomics.h>

#include <chrono>
#include <memory>

namespace tendon::simulation {
namespace {

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

/// The sleeper wakes up only by a post.
template <typename Atomics>
Report ExplorePostingBy() {
  return Explore([](Scenario& scenario) {
    const auto posting = std::make_shared<Posting<Atomics>>();
    scenario.Thread([=] {
      posting->Receive(1);
      posting->Receive(2);
    });
    scenario.Thread([=] { posting->PostBy(SteadyTime{} + std::chrono::hours(1)); });
    scenario.Thread([=] { posting->PostBy(SteadyTime{} + std::chrono::hours(2)); });
  });
}

TEST(WakeupSimulation, LosesNoWakeUpInAnyInterleaving) {
  EXPECT_THAT(ExplorePosting<SimulatedAtomics>(), Passes(1000));
  EXPECT_THAT(ExplorePostingBy<SimulatedAtomics>(), Passes(1000));
}

TEST(WakeupSimulation, NeedsItsFences) {
  using NoFullFence = WithoutFence<std::memory_order_seq_cst>;
  EXPECT_THAT(ExplorePosting<NoFullFence>(), FailsWith("every thread waits"));
  EXPECT_THAT(ExplorePostingBy<NoFullFence>(), FailsWith("every thread waits"));
}

}  // namespace
}  // namespace tendon::simulation
