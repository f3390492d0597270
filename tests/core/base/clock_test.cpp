#include <gtest/gtest.h>
#include <tendon/base/clock.h>

#include <chrono>

namespace tendon {
namespace {

using namespace std::chrono_literals;

TEST(DeadlineAfter, AddsTheTimeoutToNow) {
  const SteadyTime before = SteadyClock().Now();

  const SteadyTime deadline = DeadlineAfter(50ms);

  EXPECT_GE(deadline, before + 50ms);
  EXPECT_LE(deadline, SteadyClock().Now() + 50ms);
}

TEST(DeadlineAfter, DoesNotOverflowForTheLongestTimeout) {
  const SteadyTime deadline = DeadlineAfter(std::chrono::nanoseconds::max());

  EXPECT_GT(deadline, SteadyClock().Now() + 364 * 24h);
  EXPECT_LE(deadline, SteadyClock().Now() + kLongestWait);
}

TEST(DeadlineAfter, LiesInThePastForANegativeTimeout) {
  for (const std::chrono::nanoseconds timeout : {-1ns, std::chrono::nanoseconds::min()}) {
    const SteadyTime deadline = DeadlineAfter(timeout);

    EXPECT_LT(deadline, SteadyClock().Now());
  }
}

}  // namespace
}  // namespace tendon
