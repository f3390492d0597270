#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/simulation/simulated_atomics.h>
#include <support/simulation/weakened_atomics.h>

#include <memory>
#include <set>
#include <utility>

namespace tendon::simulation {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using Number = SimulatedAtomics::Atomic<int>;

constexpr auto kRelaxed = std::memory_order_relaxed;
constexpr auto kAcquire = std::memory_order_acquire;
constexpr auto kRelease = std::memory_order_release;
constexpr auto kTotal = std::memory_order_seq_cst;

struct Shared {
  Number x;
  Number y;
  Plain<int> data;
};

/// The possible results of two threads.
using Outcomes = std::set<std::pair<int, int>>;

template <typename First, typename Second>
Outcomes OutcomesOf(First first, Second second) {
  Outcomes outcomes;
  const Report report = Explore([&](Scenario& scenario) {
    const auto shared = std::make_shared<Shared>();
    const auto results = std::make_shared<std::pair<int, int>>();
    scenario.Thread([=] { results->first = first(*shared); });
    scenario.Thread([=] { results->second = second(*shared); });
    scenario.Finally([=, &outcomes] { outcomes.insert(*results); });
  });
  EXPECT_THAT(report.failure, IsEmpty());
  EXPECT_TRUE(report.is_complete);
  return outcomes;
}

int StoreXLoadY(Shared& shared, bool fence) {
  shared.x.store(1, kRelaxed);
  if (fence) SimulatedAtomics::Fence(kTotal);
  return shared.y.load(kRelaxed);
}

int StoreYLoadX(Shared& shared, bool fence) {
  shared.y.store(1, kRelaxed);
  if (fence) SimulatedAtomics::Fence(kTotal);
  return shared.x.load(kRelaxed);
}

TEST(Simulation, RelaxedStoresMayBecomeVisibleLate) {
  EXPECT_EQ(OutcomesOf([](Shared& s) { return StoreXLoadY(s, false); },
                       [](Shared& s) { return StoreYLoadX(s, false); }),
            (Outcomes{{0, 0}, {0, 1}, {1, 0}, {1, 1}}));
}

TEST(Simulation, FullFencesOnBothSidesForbidStoreBuffering) {
  EXPECT_EQ(OutcomesOf([](Shared& s) { return StoreXLoadY(s, true); },
                       [](Shared& s) { return StoreYLoadX(s, true); }),
            (Outcomes{{0, 1}, {1, 0}, {1, 1}}));
}

TEST(Simulation, AFenceOnOneSideIsNotEnough) {
  EXPECT_EQ(OutcomesOf([](Shared& s) { return StoreXLoadY(s, true); },
                       [](Shared& s) { return StoreYLoadX(s, false); }),
            (Outcomes{{0, 0}, {0, 1}, {1, 0}, {1, 1}}));
}

TEST(Simulation, AProcessBarrierOnOneSideReplacesBothFences) {
  const auto heavy = [](Shared& shared) {
    shared.x.store(1, kRelaxed);
    SimulatedAtomics::ProcessBarrier();
    return shared.y.load(kRelaxed);
  };
  EXPECT_EQ(OutcomesOf(heavy, [](Shared& s) { return StoreYLoadX(s, false); }),
            (Outcomes{{0, 1}, {1, 0}, {1, 1}}));
}

TEST(Simulation, AThreadNeverReadsAnOlderValue) {
  const auto store_twice = [](Shared& shared) {
    shared.x.store(1, kRelaxed);
    shared.x.store(2, kRelaxed);
    return 0;
  };
  const auto load_twice = [](Shared& shared) {
    const int first = shared.x.load(kRelaxed);
    return 10 * first + shared.x.load(kRelaxed);
  };
  EXPECT_EQ(OutcomesOf(store_twice, load_twice),
            (Outcomes{{0, 0}, {0, 1}, {0, 2}, {0, 11}, {0, 12}, {0, 22}}));
}

TEST(Simulation, AReadModifyWriteReadsTheNewestValue) {
  const auto add = [](Shared& shared) { return shared.x.fetch_add(1, kRelaxed); };
  EXPECT_EQ(OutcomesOf(add, add), (Outcomes{{0, 1}, {1, 0}}));
}

Report PassMessage(std::memory_order store, std::memory_order load, bool fences) {
  return Explore([=](Scenario& scenario) {
    const auto shared = std::make_shared<Shared>();
    scenario.Thread([=] {
      shared->data.Write(7);
      if (fences) SimulatedAtomics::Fence(kRelease);
      shared->x.store(1, store);
    });
    scenario.Thread([=] {
      if (shared->x.load(load) == 0) return;
      if (fences) SimulatedAtomics::Fence(kAcquire);
      Check(shared->data.Read() == 7, "the message is not there");
    });
  });
}

TEST(Simulation, ReleaseAndAcquirePassAMessage) {
  EXPECT_THAT(PassMessage(kRelease, kAcquire, false).failure, IsEmpty());
}

TEST(Simulation, FencesPassAMessageOverRelaxedAtomics) {
  EXPECT_THAT(PassMessage(kRelaxed, kRelaxed, true).failure, IsEmpty());
}

TEST(Simulation, AMessageWithoutReleaseOrWithoutAcquireIsARace) {
  EXPECT_THAT(PassMessage(kRelaxed, kAcquire, false).failure, HasSubstr("races"));
  EXPECT_THAT(PassMessage(kRelease, kRelaxed, false).failure, HasSubstr("races"));
}

TEST(Simulation, AWriteAfterAnothersReadIsARace) {
  const Report report = Explore([](Scenario& scenario) {
    const auto shared = std::make_shared<Shared>();
    scenario.Thread([=] { (void)shared->data.Read(); });
    scenario.Thread([=] { shared->data.Write(1); });
  });
  EXPECT_THAT(report.failure, HasSubstr("races"));
}

TEST(Simulation, ReportsADeadlock) {
  const Report report = Explore([](Scenario& scenario) {
    const auto word = std::make_shared<SimulatedAtomics::Atomic<std::uint32_t>>();
    scenario.Thread([=] { SimulatedAtomics::Sleep(*word, 0, {}); });
    // In one order of steps, this comes before the wait.
    scenario.Thread([=] { SimulatedAtomics::Wake(*word); });
  });
  EXPECT_THAT(report.failure, HasSubstr("every thread waits"));
}

TEST(Simulation, AFailureListsItsSteps) {
  const Report report = Explore([](Scenario& scenario) {
    const auto shared = std::make_shared<Shared>();
    scenario.Thread([=] { shared->x.store(5, kRelaxed); });
    scenario.Thread([=] { Check(shared->x.load(kRelaxed) == 0, "x has changed"); });
  });
  EXPECT_THAT(report.failure, HasSubstr("x has changed\n  thread 1 stores atomic 0: 5\n"));
}

TEST(Simulation, WithoutPreemptionsThreadsRunOneAfterTheOther) {
  const Limits none{.preemptions = 0, .stale_reads = 0};
  const Report report = Explore(
      [](Scenario& scenario) {
        const auto shared = std::make_shared<Shared>();
        const auto step_twice = [=] {
          shared->x.store(1, kRelaxed);
          shared->x.store(0, kRelaxed);
        };
        scenario.Thread(step_twice);
        scenario.Thread([=] { Check(shared->x.load(kRelaxed) == 0, "interleaved"); });
      },
      none);
  EXPECT_THAT(report.failure, IsEmpty());
  EXPECT_EQ(report.executions, 2U);
}

}  // namespace
}  // namespace tendon::simulation
