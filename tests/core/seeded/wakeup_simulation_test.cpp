#include <core/lockfree/posting.h>
#include <core/seeded/faults.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

namespace tendon::seeded {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::size_t kSleeper = 1;
constexpr std::size_t kPoster = 2;
constexpr MemoryModel::Location kAsleep = 0;

using Posting = simulation::Posting<SeededAtomics>;

simulation::Report ExplorePosting(const Fault& fault) {
  return Explore(fault, [](simulation::Scenario& scenario) {
    const auto posting = std::make_shared<Posting>();
    scenario.Thread([=] { posting->Receive(1); });
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
