#include <gtest/gtest.h>
#include <support/simulation/report_matchers.h>
#include <support/simulation/simulated_atomics.h>
#include <support/simulation/weakened_atomics.h>
#include <tendon/lockfree/shared_slot_ring.h>

#include <cstddef>
#include <memory>

namespace tendon::simulation {
namespace {

/// Two producers with one message each. Both messages pass through a ring of one slot.
template <typename Atomics>
struct Transfer {
  SharedSlotRing<Atomics> ring{1, 8, 8};
  Plain<int> slot;

  void Produce(int message) {
    std::byte* claimed = nullptr;
    for (unsigned looks = 0; (claimed = ring.Claim()) == nullptr; ++looks) Atomics::Pause(looks);
    slot.Write(message);
    ring.Publish(claimed);
  }
  void Consume() {
    int sum = 0;
    for (int message = 0; message < 2; ++message) {
      for (unsigned looks = 0; ring.Front() == nullptr; ++looks) Atomics::Pause(looks);
      sum += slot.Read();
      ring.Release();
    }
    Check(sum == 3, "a message is lost or comes twice");
  }
};

template <typename Atomics>
Report ExploreSharedTransfer() {
  return Explore([](Scenario& scenario) {
    const auto transfer = std::make_shared<Transfer<Atomics>>();
    scenario.Thread([=] { transfer->Produce(1); });
    scenario.Thread([=] { transfer->Produce(2); });
    scenario.Thread([=] { transfer->Consume(); });
    scenario.Finally([=] { Check(transfer->ring.size() == 0, "something is left"); });
  });
}

TEST(SharedSlotRingSimulation, PassesEverySlotInEveryInterleaving) {
  EXPECT_THAT(ExploreSharedTransfer<SimulatedAtomics>(), Passes(1000));
}

TEST(SharedSlotRingSimulation, NeedsItsReleases) {
  EXPECT_THAT(ExploreSharedTransfer<WithoutRelease>(), FailsWith("races"));
}

TEST(SharedSlotRingSimulation, NeedsItsAcquires) {
  EXPECT_THAT(ExploreSharedTransfer<WithoutAcquire>(), FailsWith("races"));
}

}  // namespace
}  // namespace tendon::simulation
