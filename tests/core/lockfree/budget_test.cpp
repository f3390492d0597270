#include <gtest/gtest.h>
#include <tendon/lockfree/budget.h>

#include <thread>

namespace {

using tendon::Budget;

TEST(Budget, GrantsUpToItsLimitAndAgainAfterReturns) {
  Budget<> budget(10);
  EXPECT_TRUE(budget.Take(6));
  EXPECT_TRUE(budget.Take(4));
  EXPECT_FALSE(budget.Take(1));

  budget.Give(4);

  EXPECT_FALSE(budget.Take(5));
  EXPECT_TRUE(budget.Take(4));
}

TEST(Budget, GrantsASingleHolderMoreThanItsLimit) {
  Budget<> budget(10);
  EXPECT_TRUE(budget.Take(1000));
  EXPECT_FALSE(budget.Take(0));

  budget.Give(1000);

  EXPECT_TRUE(budget.Take(1));
  EXPECT_FALSE(budget.Take(1000));
}

TEST(Budget, WithoutALimitIsNeverExhausted) {
  Budget<> budget;
  EXPECT_TRUE(budget.Take(Budget<>::kNoLimit));
  EXPECT_TRUE(budget.Take(Budget<>::kNoLimit));
}

TEST(Budget, LosesNothingBetweenTwoThreads) {
  constexpr int kTimes = 100'000;
  Budget<> budget(3);
  const auto take_and_give = [&budget] {
    for (int i = 0; i < kTimes; ++i) {
      if (budget.Take(2)) budget.Give(2);
    }
  };
  {
    const std::jthread other(take_and_give);
    take_and_give();
  }

  EXPECT_TRUE(budget.Take(3));
  EXPECT_FALSE(budget.Take(1));
}

}  // namespace
