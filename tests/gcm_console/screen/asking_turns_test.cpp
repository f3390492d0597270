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

void EndAll(AskingTurns& turns, const Names& names) {
  for (const InterfaceName& name : names) turns.End(name);
}

TEST(AskingTurns, EachIsAskedOnceASecond) {
  AskingTurns turns;
  const Names all = NamesOf(2, 2);

  EXPECT_EQ(turns.Begin(all, kStart), all);
  EndAll(turns, all);
  EXPECT_EQ(turns.Begin(all, kStart + AskingTurns::kBetween - kMoment), Names());
  EXPECT_EQ(turns.Begin(all, kStart + AskingTurns::kBetween), all);
}

TEST(AskingTurns, WhoGoesAndComesBackIsNotAskedSooner) {
  AskingTurns turns;
  const Names all = NamesOf(1, 1);
  int asked = 0;

  for (auto now = kStart; now < kStart + 3 * AskingTurns::kBetween; now += 10 * kMoment) {
    EXPECT_EQ(turns.Begin({}, now), Names());
    const Names begun = turns.Begin(all, now);
    EndAll(turns, begun);
    asked += static_cast<int>(begun.size());
  }

  EXPECT_EQ(asked, 3);
}

TEST(AskingTurns, QuestionsAboutWhoHasGoneCountUntilTheyAreAnswered) {
  AskingTurns turns;
  const Names all = NamesOf(1, 2 * AskingTurns::kMostOfOne);
  const Names first(all.begin(), all.begin() + AskingTurns::kMostOfOne);
  const Names others(all.begin() + AskingTurns::kMostOfOne, all.end());
  const auto later = kStart + 10 * AskingTurns::kBetween;
  ASSERT_EQ(turns.Begin(first, kStart), first);

  EXPECT_EQ(turns.Begin({}, later), Names());
  EXPECT_EQ(turns.Begin(others, later), Names());
  EXPECT_EQ(turns.Begin(first, later), Names()) << "they have not answered";
  turns.End(first.front());
  EXPECT_EQ(turns.Begin(others, later).size(), 1U);
}

TEST(AskingTurns, AProcessThatDoesNotAnswerHoldsUpNoOther) {
  AskingTurns turns;
  const Names silent = NamesOf(1, 2 * AskingTurns::kMostOfOne);
  ASSERT_EQ(turns.Begin(silent, kStart).size(), AskingTurns::kMostOfOne);
  Names all = silent;
  all.emplace_back("p2", "user", "Arm");

  EXPECT_EQ(turns.Begin(all, kStart + AskingTurns::kBetween), Names{all.back()});
}

TEST(AskingTurns, AllHaveTheirTurnThoughTheyAreMore) {
  AskingTurns turns;
  const Names all = NamesOf(20, 5);

  const Names first = turns.Begin(all, kStart);
  EXPECT_EQ(first.size(), AskingTurns::kMostAtOnce);
  EXPECT_EQ(turns.Begin(all, kStart), Names()) << "none has answered";
  EndAll(turns, first);
  const Names second = turns.Begin(all, kStart + AskingTurns::kBetween);

  std::set<InterfaceName> asked(first.begin(), first.end());
  asked.insert(second.begin(), second.end());
  EXPECT_EQ(asked.size(), all.size());
}

}  // namespace
}  // namespace console
