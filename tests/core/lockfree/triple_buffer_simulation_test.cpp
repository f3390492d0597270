#include <gtest/gtest.h>
#include <support/simulation/report_matchers.h>
#include <support/simulation/simulated_atomics.h>
#include <support/simulation/weakened_atomics.h>
#include <tendon/lockfree/triple_buffer.h>
#include <tendon/lockfree/try_lock.h>

#include <memory>

namespace tendon::simulation {
namespace {

/// A value in plain memory that can be assigned.
struct Cell {
  Cell() = default;
  Cell(int value) : plain(value) {}  // NOLINT(google-explicit-constructor)
  Cell& operator=(const Cell& other) {
    plain.Write(other.plain.Read());
    return *this;
  }
  Cell(const Cell&) = delete;

  Plain<int> plain{0};
};

template <typename Atomics>
Report ExploreWriterAndReader() {
  return Explore([](Scenario& scenario) {
    const auto buffer = std::make_shared<TripleBuffer<Cell, Atomics>>();
    scenario.Thread([=] {
      for (int value = 1; value <= 3; ++value) buffer->Write(Cell(value));
    });
    scenario.Thread([=] {
      for (int last = 0, looks = 0; looks < 3; ++looks) {
        const Cell* cell = buffer->Take();
        if (cell == nullptr) continue;
        Check(cell->plain.Read() > last, "an old value came again");
        last = cell->plain.Read();
      }
    });
  });
}

TEST(SnapshotSimulation, NeverReturnsAPartlyWrittenValue) {
  EXPECT_THAT(ExploreWriterAndReader<SimulatedAtomics>(), Passes(100));
}

TEST(SnapshotSimulation, NeedsItsReleases) {
  EXPECT_THAT(ExploreWriterAndReader<WithoutRelease>(), FailsWith("races"));
}

TEST(SnapshotSimulation, NeedsItsAcquires) {
  EXPECT_THAT(ExploreWriterAndReader<WithoutAcquire>(), FailsWith("races"));
}

template <typename Atomics>
Report ExploreLease() {
  struct Leased {
    TryLock<Atomics> lease;
    Plain<int> value{0};
  };
  return Explore([](Scenario& scenario) {
    const auto shared = std::make_shared<Leased>();
    for (int thread = 0; thread < 2; ++thread) {
      scenario.Thread([=] {
        if (!shared->lease.TryTake()) return;
        shared->value.Write(shared->value.Read() + 1);
        shared->lease.Return();
      });
    }
  });
}

TEST(LeaseSimulation, HasOneHolderAtATime) {
  EXPECT_THAT(ExploreLease<SimulatedAtomics>(), Passes());
}

TEST(LeaseSimulation, NeedsItsOrders) {
  EXPECT_THAT(ExploreLease<WithoutRelease>(), FailsWith("races"));
  EXPECT_THAT(ExploreLease<WithoutAcquire>(), FailsWith("races"));
}

}  // namespace
}  // namespace tendon::simulation
