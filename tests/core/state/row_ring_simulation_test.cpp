#include <core/state/tick_rows.h>
#include <gtest/gtest.h>
#include <support/simulation/report_matchers.h>
#include <support/simulation/simulated_atomics.h>
#include <support/simulation/weakened_atomics.h>

#include <cstdint>
#include <memory>

namespace tendon::simulation {
namespace {

using tendon_test::TickRows;

template <typename Atomics>
Report ExploreNewest() {
  return Explore([](Scenario& scenario) {
    const auto table = std::make_shared<TickRows<Atomics>>();
    table->Write(0);
    scenario.Thread([=] {
      for (std::uint64_t tick = 1; tick <= 3; ++tick) table->Write(tick);
    });
    scenario.Thread([=] {
      typename TickRows<Atomics>::Words words{};
      std::uint64_t tick = 0;
      if (table->ring.ReadNewest(tick, TickRows<Atomics>::Into(words)) != RowResult::kDone) return;
      Check(words[0] == tick && words[1] == tick, "a torn row passed");
    });
  });
}

template <typename Atomics>
Report ExploreAt() {
  return Explore([](Scenario& scenario) {
    const auto table = std::make_shared<TickRows<Atomics>>();
    table->Write(0);
    table->Write(1);
    scenario.Thread([=] {
      for (std::uint64_t tick = 2; tick <= 4; ++tick) table->Write(tick);
    });
    scenario.Thread([=] {
      typename TickRows<Atomics>::Words words{};
      std::int64_t time = 1;
      const bool is_done = table->ring.Read(1, TickRows<Atomics>::Into(words)) == RowResult::kDone;
      if (is_done) Check(words[0] == 1 && words[1] == 1, "a torn row passed");
      if (table->ring.ReadTime(1, time) == RowResult::kDone) Check(time == 1, "a torn time passed");
    });
  });
}

TEST(RowRingSimulation, NeverReturnsATornNewestRow) {
  EXPECT_THAT(ExploreNewest<SimulatedAtomics>(), Passes(1000));
}

TEST(RowRingSimulation, NeverReturnsATornRowDuringReplacement) {
  EXPECT_THAT(ExploreAt<SimulatedAtomics>(), Passes(1000));
}

/// Tests on x86 and ThreadSanitizer cannot detect this missing fence.
TEST(RowRingSimulation, NeedsTheWritersFence) {
  using NoReleaseFence = WithoutFence<std::memory_order_release>;
  EXPECT_THAT(ExploreAt<NoReleaseFence>(), FailsWith("torn"));
}

TEST(RowRingSimulation, NeedsTheReadersFence) {
  using NoAcquireFence = WithoutFence<std::memory_order_acquire>;
  EXPECT_THAT(ExploreAt<NoAcquireFence>(), FailsWith("torn"));
}

TEST(RowRingSimulation, NeedsItsReleases) {
  EXPECT_THAT(ExploreNewest<WithoutRelease>(), FailsWith("torn"));
}

TEST(RowRingSimulation, NeedsItsAcquires) {
  EXPECT_THAT(ExploreNewest<WithoutAcquire>(), FailsWith("torn"));
}

}  // namespace
}  // namespace tendon::simulation
