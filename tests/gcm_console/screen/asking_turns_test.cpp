#include <gcm_console/screen/asking_turns.h>
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

/// So many required interfaces of each process "p1", "p2" and so on.
Names NamesOf(int processes, int of_each) {
  Names names;
  for (int process = 1; process <= processes; ++process) {
    for (int i = 1; i <= of_each; ++i) {
      names.emplace_back("p" + std::to_string(process), "user", "Arm" + std::to_string(i));
    }
  }
  return names;
}

void EndAll(QueryThrottle& turns, const Names& names) {
  for (const InterfaceName& name : names) turns.End(name);
}

TEST(QueryThrottle, EachIsAskedOnceASecond) {
  QueryThrottle turns;
  const Names all = NamesOf(2, 2);

  EXPECT_EQ(turns.Begin(all, kStart), all);
  EndAll(turns, all);
  EXPECT_EQ(turns.Begin(all, kStart + QueryThrottle::kBetween - kMoment), Names());
  EXPECT_EQ(turns.Begin(all, kStart + QueryThrottle::kBetween), all);
}

TEST(QueryThrottle, WhoGoesAndComesBackIsNotAskedSooner) {
  QueryThrottle turns;
  const Names all = NamesOf(1, 1);
  int asked = 0;

  for (auto now = kStart; now < kStart + 3 * QueryThrottle::kBetween; now += 10 * kMoment) {
    EXPECT_EQ(turns.Begin({}, now), Names());
    const Names begun = turns.Begin(all, now);
    EndAll(turns, begun);
    asked += static_cast<int>(begun.size());
  }

  EXPECT_EQ(asked, 3);
}

TEST(QueryThrottle, QuestionsAboutWhoHasGoneCountUntilTheyAreAnswered) {
  QueryThrottle turns;
  const Names all = NamesOf(1, 2 * QueryThrottle::kMostOfOne);
  const Names first(all.begin(), all.begin() + QueryThrottle::kMostOfOne);
  const Names others(all.begin() + QueryThrottle::kMostOfOne, all.end());
  const auto later = kStart + 10 * QueryThrottle::kBetween;
  ASSERT_EQ(turns.Begin(first, kStart), first);

  EXPECT_EQ(turns.Begin({}, later), Names());
  EXPECT_EQ(turns.Begin(others, later), Names());
  EXPECT_EQ(turns.Begin(first, later), Names()) << "they have not answered";
  turns.End(first.front());
  EXPECT_EQ(turns.Begin(others, later).size(), 1U);
}

TEST(QueryThrottle, AProcessThatDoesNotAnswerHoldsUpNoOther) {
  QueryThrottle turns;
  const Names silent = NamesOf(1, 2 * QueryThrottle::kMostOfOne);
  ASSERT_EQ(turns.Begin(silent, kStart).size(), QueryThrottle::kMostOfOne);
  Names all = silent;
  all.emplace_back("p2", "user", "Arm");

  EXPECT_EQ(turns.Begin(all, kStart + QueryThrottle::kBetween), Names{all.back()});
}

TEST(QueryThrottle, AllHaveTheirTurnThoughTheyAreMore) {
  QueryThrottle turns;
  const Names all = NamesOf(20, 5);

  const Names first = turns.Begin(all, kStart);
  EXPECT_EQ(first.size(), QueryThrottle::kMostAtOnce);
  EXPECT_EQ(turns.Begin(all, kStart), Names()) << "none has answered";
  EndAll(turns, first);
  const Names second = turns.Begin(all, kStart + QueryThrottle::kBetween);

  std::set<InterfaceName> asked(first.begin(), first.end());
  asked.insert(second.begin(), second.end());
  EXPECT_EQ(asked.size(), all.size());
}

}  // namespace
}  // namespace console
