#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/simulation/simulated_atomics.h>
#include <support/simulation/weakened_atomics.h>
#include <tendon/state/row_ring.h>

#include <array>
#include <cstdint>
#include <memory>

namespace tendon {
namespace {

using simulation::Check;
using simulation::Explore;
using simulation::Report;
using simulation::Scenario;
using testing::HasSubstr;
using testing::IsEmpty;

/// A ring of two rows of two words, both of which hold the row's tick.
template <typename Atomics>
struct Table {
  using Words = std::array<std::uint64_t, 2>;

  RowRing<Atomics> ring;

  Table() { ring.Allocate(1, 2); }

  void Write(std::uint64_t tick) {
    ring.Begin(static_cast<std::int64_t>(tick));
    const Words words{tick, tick};
    ring.Store(0, words);
    ring.Publish();
  }
  static auto Into(Words& words) {
    return [&words](const auto* row) {
      for (std::size_t i = 0; i < words.size(); ++i) {
        words[i] = row[i].load(std::memory_order_relaxed);
      }
    };
  }
};

template <typename Atomics>
Report ExploreNewest() {
  return Explore([](Scenario& scenario) {
    const auto table = std::make_shared<Table<Atomics>>();
    table->Write(0);
    scenario.Thread([=] {
      for (std::uint64_t tick = 1; tick <= 3; ++tick) table->Write(tick);
    });
    scenario.Thread([=] {
      typename Table<Atomics>::Words words{};
      std::uint64_t tick = 0;
      if (table->ring.ReadNewest(tick, Table<Atomics>::Into(words)) != RowResult::kDone) return;
      Check(words[0] == tick && words[1] == tick, "a torn row passed");
    });
  });
}

template <typename Atomics>
Report ExploreAt() {
  return Explore([](Scenario& scenario) {
    const auto table = std::make_shared<Table<Atomics>>();
    table->Write(0);
    table->Write(1);
    scenario.Thread([=] {
      for (std::uint64_t tick = 2; tick <= 4; ++tick) table->Write(tick);
    });
    scenario.Thread([=] {
      typename Table<Atomics>::Words words{};
      std::int64_t time = 1;
      const bool is_done = table->ring.Read(1, Table<Atomics>::Into(words)) == RowResult::kDone;
      if (is_done) Check(words[0] == 1 && words[1] == 1, "a torn row passed");
      if (table->ring.ReadTime(1, time) == RowResult::kDone) Check(time == 1, "a torn time passed");
    });
  });
}

TEST(RowRingSimulation, NeverGivesATornNewestRow) {
  const Report report = ExploreNewest<SimulatedAtomics>();
  EXPECT_THAT(report.failure, IsEmpty());
  EXPECT_TRUE(report.is_complete);
  EXPECT_GT(report.executions, 1000U);
}

TEST(RowRingSimulation, NeverGivesATornRowThatIsReplaced) {
  const Report report = ExploreAt<SimulatedAtomics>();
  EXPECT_THAT(report.failure, IsEmpty());
  EXPECT_TRUE(report.is_complete);
  EXPECT_GT(report.executions, 1000U);
}

/// Invisible on x86, and to ThreadSanitizer.
TEST(RowRingSimulation, NeedsTheWritersFence) {
  using NoReleaseFence = WithoutFence<std::memory_order_release>;
  EXPECT_THAT(ExploreAt<NoReleaseFence>().failure, HasSubstr("torn"));
}

TEST(RowRingSimulation, NeedsTheReadersFence) {
  using NoAcquireFence = WithoutFence<std::memory_order_acquire>;
  EXPECT_THAT(ExploreAt<NoAcquireFence>().failure, HasSubstr("torn"));
}

TEST(RowRingSimulation, NeedsItsReleases) {
  EXPECT_THAT(ExploreNewest<WithoutRelease>().failure, HasSubstr("torn"));
}

TEST(RowRingSimulation, NeedsItsAcquires) {
  EXPECT_THAT(ExploreNewest<WithoutAcquire>().failure, HasSubstr("torn"));
}

}  // namespace
}  // namespace tendon
