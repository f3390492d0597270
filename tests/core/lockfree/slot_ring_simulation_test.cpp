#include <core/lockfree/ring_transfer.h>
#include <gtest/gtest.h>
#include <support/simulation/report_matchers.h>
#include <support/simulation/simulated_atomics.h>
#include <support/simulation/weakened_atomics.h>

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

/// cisst has this fault: it reads the two indices without any memory order.
TEST(SlotRingSimulation, ASizeReadByAThirdThreadNeverExceedsTheCapacity) {
  const Report report = Explore([](Scenario& scenario) {
    const auto transfer = std::make_shared<RingTransfer<SimulatedAtomics>>();
    scenario.Thread([=] { transfer->Produce(); });
    scenario.Thread([=] { transfer->Consume(); });
    scenario.Thread([=] { Check(transfer->ring.size() <= 2, "more than fits"); });
  });
  EXPECT_EQ(report.failure, "");
}

}  // namespace
}  // namespace tendon::simulation
