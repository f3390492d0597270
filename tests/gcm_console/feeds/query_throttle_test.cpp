#include <gcm_console/feeds/query_throttle.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace console {
namespace {

using tendon::InterfaceName;
using tendon::SteadyTime;
using Names = std::vector<InterfaceName>;

constexpr SteadyTime kStart{std::chrono::hours(1)};
constexpr auto kMoment = std::chrono::milliseconds(1);

/// Returns `of_each` required interfaces for each of the processes "p1", "p2" and so on.
Names NamesOf(int processes, int of_each) {
  Names names;
  for (int process = 1; process <= processes; ++process) {
    for (int i = 1; i <= of_each; ++i) {
      names.emplace_back("p" + std::to_string(process), "user", "Arm" + std::to_string(i));
    }
  }
  return names;
}

void EndAll(QueryThrottle& throttle, const Names& names) {
  for (const InterfaceName& name : names) throttle.End(name);
}

TEST(QueryThrottle, QueriesEachConnectionOncePerSecond) {
  QueryThrottle throttle;
  const Names all = NamesOf(2, 2);

  EXPECT_EQ(throttle.Begin(all, kStart), all);
  EndAll(throttle, all);
  EXPECT_EQ(throttle.Begin(all, kStart + QueryThrottle::kBetween - kMoment), Names());
  EXPECT_EQ(throttle.Begin(all, kStart + QueryThrottle::kBetween), all);
}

TEST(QueryThrottle, AReturningConnectionIsNotQueriedSooner) {
  QueryThrottle throttle;
  const Names all = NamesOf(1, 1);
  int asked = 0;

  for (auto now = kStart; now < kStart + 3 * QueryThrottle::kBetween; now += 10 * kMoment) {
    EXPECT_EQ(throttle.Begin({}, now), Names());
    const Names begun = throttle.Begin(all, now);
    EndAll(throttle, begun);
    asked += static_cast<int>(begun.size());
  }

  EXPECT_EQ(asked, 3);
}

TEST(QueryThrottle, QueriesOfGoneConnectionsCountUntilAnswered) {
  QueryThrottle throttle;
  const Names all = NamesOf(1, 2 * QueryThrottle::kMaxOfOne);
  const Names first(all.begin(), all.begin() + QueryThrottle::kMaxOfOne);
  const Names others(all.begin() + QueryThrottle::kMaxOfOne, all.end());
  const auto later = kStart + 10 * QueryThrottle::kBetween;
  ASSERT_EQ(throttle.Begin(first, kStart), first);

  EXPECT_EQ(throttle.Begin({}, later), Names());
  EXPECT_EQ(throttle.Begin(others, later), Names());
  EXPECT_EQ(throttle.Begin(first, later), Names()) << "they have not answered";
  throttle.End(first.front());
  EXPECT_EQ(throttle.Begin(others, later).size(), 1U);
}

TEST(QueryThrottle, ASilentProcessDelaysNoOther) {
  QueryThrottle throttle;
  const Names silent = NamesOf(1, 2 * QueryThrottle::kMaxOfOne);
  ASSERT_EQ(throttle.Begin(silent, kStart).size(), QueryThrottle::kMaxOfOne);
  Names all = silent;
  all.emplace_back("p2", "user", "Arm");

  EXPECT_EQ(throttle.Begin(all, kStart + QueryThrottle::kBetween), Names{all.back()});
}

TEST(QueryThrottle, QueriesAllInTurnBeyondTheLimit) {
  QueryThrottle throttle;
  const Names all = NamesOf(20, 5);

  const Names first = throttle.Begin(all, kStart);
  EXPECT_EQ(first.size(), QueryThrottle::kMaxAtOnce);
  EXPECT_EQ(throttle.Begin(all, kStart), Names()) << "none has answered";
  EndAll(throttle, first);
  const Names second = throttle.Begin(all, kStart + QueryThrottle::kBetween);

  std::set<InterfaceName> asked(first.begin(), first.end());
  asked.insert(second.begin(), second.end());
  EXPECT_EQ(asked.size(), all.size());
}

}  // namespace
}  // namespace console
