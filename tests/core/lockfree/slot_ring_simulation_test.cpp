#include <core/lockfree/ring_transfer.h>
#include <gtest/gtest.h>
#include <support/simulation/report_matchers.h>
#include <support/simulation/simulated_atomics.h>
#include <support/simulation/weakened_atomics.h>
#include <tendon/lockfree/spsc_queue.h>

#include <memory>

namespace tendon::simulation {
namespace {

template <typename Atomics>
Report ExploreTransfer() {
  return Explore([](Scenario& scenario) {
    const auto transfer = std::make_shared<RingTransfer<Atomics>>();
    scenario.Thread([=] { transfer->Produce(); });
    scenario.Thread([=] { transfer->Consume(); });
    scenario.Finally([=] { Check(transfer->ring.size() == 0, "something is left"); });
  });
}

TEST(SlotRingSimulation, PassesEverySlotInEveryInterleaving) {
  EXPECT_THAT(ExploreTransfer<SimulatedAtomics>(), Passes(1000));
}

TEST(SlotRingSimulation, NeedsItsReleases) {
  EXPECT_THAT(ExploreTransfer<WithoutRelease>(), FailsWith("races"));
}

TEST(SlotRingSimulation, NeedsItsAcquires) {
  EXPECT_THAT(ExploreTransfer<WithoutAcquire>(), FailsWith("races"));
}

/// The fault of the reference system: indices without any order.
TEST(SlotRingSimulation, ASizeReadByAThirdThreadNeverExceedsTheCapacity) {
  const Report report = Explore([](Scenario& scenario) {
    const auto transfer = std::make_shared<RingTransfer<SimulatedAtomics>>();
    scenario.Thread([=] { transfer->Produce(); });
    scenario.Thread([=] { transfer->Consume(); });
    scenario.Thread([=] { Check(transfer->ring.size() <= 2, "more than fits"); });
  });
  EXPECT_EQ(report.failure, "");
}

TEST(SpscQueueSimulation, PassesEveryValueInEveryInterleaving) {
  const Report report = Explore([](Scenario& scenario) {
    const auto queue = std::make_shared<SpscQueue<int, SimulatedAtomics>>(1);
    scenario.Thread([=] {
      for (int value = 1; value <= 2; ++value) {
        while (!queue->Push(value)) SimulatedAtomics::Pause(0);
      }
    });
    scenario.Thread([=] {
      for (int expected = 1; expected <= 2; ++expected) {
        int value = 0;
        while (!queue->Pop(value)) SimulatedAtomics::Pause(0);
        Check(value == expected, "values come out of order");
      }
    });
  });
  EXPECT_THAT(report, Passes());
}

}  // namespace
}  // namespace tendon::simulation
