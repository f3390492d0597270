#include <gcm_console/feeds/inbox_queue.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace console {
namespace {

using Numbers = InboxQueue<int, std::uint64_t>;

void Push(Numbers& numbers, int number) {
  numbers.Push(number, 1, [](const int&) { return std::uint64_t{1}; });
}

/// Returns each number with the loss before it.
std::vector<std::pair<int, std::uint64_t>> Take(Numbers& numbers) {
  std::vector<std::pair<int, std::uint64_t>> all;
  for (const auto& [number, lost_before] : numbers.Take()) all.emplace_back(number, lost_before);
  return all;
}

TEST(InboxQueue, KeepsALossBetweenTheElementsAroundIt) {
  Numbers numbers;
  Push(numbers, 1);
  numbers.AddLost(7);
  Push(numbers, 2);

  EXPECT_EQ(Take(numbers), (std::vector<std::pair<int, std::uint64_t>>{{1, 0}, {2, 7}}));
  EXPECT_EQ(numbers.TakeLost(), 0U);
}

TEST(InboxQueue, CountsDroppedElementsBeforeTheOldestKept) {
  Numbers numbers({.elements = 2, .bytes = 100});
  Push(numbers, 1);
  numbers.AddLost(10);
  Push(numbers, 2);
  Push(numbers, 3);  // drops 1
  Push(numbers, 4);  // drops 2, together with the loss before 2

  EXPECT_EQ(Take(numbers), (std::vector<std::pair<int, std::uint64_t>>{{3, 12}, {4, 0}}));
}

TEST(InboxQueue, TakesTheTrailingLossOnceAfterTheLastElement) {
  Numbers numbers;
  Push(numbers, 1);
  numbers.AddLost(3);

  EXPECT_EQ(numbers.TakeLost(), 0U) << "an older element waits";
  EXPECT_EQ(Take(numbers).size(), 1U);
  EXPECT_EQ(numbers.TakeLost(), 3U);
  EXPECT_EQ(numbers.TakeLost(), 0U);
}

}  // namespace
}  // namespace console
