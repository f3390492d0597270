#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/allocation_guard.h>
#include <support/simulation/simulated_atomics.h>
#include <support/simulation/weakened_atomics.h>
#include <tendon/lockfree/lease.h>
#include <tendon/lockfree/snapshot.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>

namespace tendon {
namespace {

using simulation::Check;
using simulation::Explore;
using simulation::Report;
using simulation::Scenario;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Snapshot, GivesTheNewestValueOnce) {
  Snapshot<int> snapshot;
  EXPECT_EQ(snapshot.Take(), nullptr);

  EXPECT_FALSE(snapshot.Write(1));
  EXPECT_TRUE(snapshot.Write(2));
  EXPECT_TRUE(snapshot.is_fresh());

  ASSERT_NE(snapshot.Take(), nullptr);
  EXPECT_FALSE(snapshot.is_fresh());
  EXPECT_EQ(snapshot.Take(), nullptr);
  EXPECT_FALSE(snapshot.Write(3));
  EXPECT_EQ(*snapshot.Take(), 3);
}

TEST(Snapshot, KeepsWhatItsValuesHaveAllocated) {
  const std::string text(100, 'x');
  Snapshot<std::string> snapshot;
  for (int i = 0; i < 3; ++i) {
    snapshot.Write(text);
    snapshot.Take();
  }

  const AllocationGuard guard;
  for (int i = 0; i < 10; ++i) snapshot.Write(text);
  ASSERT_NE(snapshot.Take(), nullptr);
}

TEST(Snapshot, ATakenValueStaysWholeWhileNewerOnesAreWritten) {
  using Block = std::array<std::uint64_t, 32>;
  constexpr std::uint64_t kWrites = 200'000;
  const auto snapshot = std::make_unique<Snapshot<Block>>();
  std::jthread writer([&] {
    Block block{};
    for (std::uint64_t n = 1; n <= kWrites; ++n) {
      block.fill(n);
      snapshot->Write(block);
    }
  });

  std::uint64_t wrong = 0;
  for (std::uint64_t last = 0; last < kWrites;) {
    const Block* block = snapshot->Take();
    if (block == nullptr) {
      std::this_thread::yield();
      continue;
    }
    Block expected;
    expected.fill((*block)[0]);
    if (*block != expected || (*block)[0] <= last) ++wrong;
    last = (*block)[0];
  }

  EXPECT_EQ(wrong, 0U);
}

/// A value of ordinary memory that is assigned.
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
    const auto snapshot = std::make_shared<Snapshot<Cell, Atomics>>();
    scenario.Thread([=] {
      for (int value = 1; value <= 3; ++value) snapshot->Write(Cell(value));
    });
    scenario.Thread([=] {
      for (int last = 0, looks = 0; looks < 3; ++looks) {
        const Cell* cell = snapshot->Take();
        if (cell == nullptr) continue;
        Check(cell->plain.Read() > last, "an old value came again");
        last = cell->plain.Read();
      }
    });
  });
}

TEST(SnapshotSimulation, NeverGivesAValueThatIsBeingWritten) {
  const Report report = ExploreWriterAndReader<SimulatedAtomics>();
  EXPECT_THAT(report.failure, IsEmpty());
  EXPECT_TRUE(report.is_complete);
  EXPECT_GT(report.executions, 100U);
}

TEST(SnapshotSimulation, NeedsItsReleases) {
  EXPECT_THAT(ExploreWriterAndReader<WithoutRelease>().failure, HasSubstr("races"));
}

TEST(SnapshotSimulation, NeedsItsAcquires) {
  EXPECT_THAT(ExploreWriterAndReader<WithoutAcquire>().failure, HasSubstr("races"));
}

TEST(Lease, OneHasItAtATime) {
  Lease<> lease;

  EXPECT_TRUE(lease.TryTake());
  EXPECT_FALSE(lease.TryTake());
  lease.Return();

  EXPECT_TRUE(lease.TryTake());
}

template <typename Atomics>
Report ExploreLease() {
  struct Shared {
    Lease<Atomics> lease;
    Plain<int> value{0};
  };
  return Explore([](Scenario& scenario) {
    const auto shared = std::make_shared<Shared>();
    for (int thread = 0; thread < 2; ++thread) {
      scenario.Thread([=] {
        if (!shared->lease.TryTake()) return;
        shared->value.Write(shared->value.Read() + 1);
        shared->lease.Return();
      });
    }
  });
}

TEST(LeaseSimulation, WhoHasItIsAlone) {
  EXPECT_THAT(ExploreLease<SimulatedAtomics>().failure, IsEmpty());
}

TEST(LeaseSimulation, NeedsItsOrders) {
  EXPECT_THAT(ExploreLease<WithoutRelease>().failure, HasSubstr("races"));
  EXPECT_THAT(ExploreLease<WithoutAcquire>().failure, HasSubstr("races"));
}

}  // namespace
}  // namespace tendon
