#include <core/seeded/faults.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/lockfree/wakeup.h>

#include <memory>

namespace tendon::seeded {
namespace {

using simulation::Check;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::size_t kSleeper = 1;
constexpr std::size_t kPoster = 2;
constexpr MemoryModel::Location kAsleep = 0;

/// A sleeper that wants something posted.
struct Posting {
  Wakeup<SeededAtomics> wakeup;
  SeededAtomics::Atomic<int> posted{0};

  void Post() {
    posted.fetch_add(1, std::memory_order_release);
    wakeup.Notify();
  }
  void Receive() {
    const auto ready = [&] { return posted.load(std::memory_order_acquire) > 0; };
    Check(wakeup.WaitUntil(ready, SteadyTime::max()), "gave up");
  }
};

simulation::Report ExplorePosting(const Fault& fault) {
  return Explore(fault, [](simulation::Scenario& scenario) {
    const auto posting = std::make_shared<Posting>();
    scenario.Thread([=] { posting->Receive(); });
    scenario.Thread([=] { posting->Post(); });
  });
}

TEST(SeededWakeupSimulation, PassesWithoutAFault) {
  const auto report = ExplorePosting(None());
  EXPECT_THAT(report.failure, IsEmpty());
  EXPECT_TRUE(report.is_complete);
  EXPECT_GT(report.executions, 10U);
}

class SeededWakeupFaultSimulation : public testing::TestWithParam<Fault> {};

TEST_P(SeededWakeupFaultSimulation, IsCaught) {
  EXPECT_THAT(ExplorePosting(GetParam()).failure, HasSubstr("every thread waits"));
}

constexpr auto kAlwaysAwake = [](std::uint64_t /*flag*/) { return std::uint64_t{0}; };

INSTANTIATE_TEST_SUITE_P(
    , SeededWakeupFaultSimulation,
    testing::Values(WithoutFence("PosterHasNoFence", std::memory_order_seq_cst, kPoster),
                    WithoutFence("SleeperHasNoFence", std::memory_order_seq_cst, kSleeper),
                    WithoutCheckAfterFence("SleeperDoesNotLookAgain", kSleeper, 0),
                    WithoutCheck("PosterDoesNotSeeTheFlag", kAsleep, kPoster, kAlwaysAwake)),
    NameOf());

}  // namespace
}  // namespace tendon::seeded
