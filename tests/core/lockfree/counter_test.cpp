#include <gtest/gtest.h>
#include <tendon/lockfree/counter.h>
#include <tendon/lockfree/flag.h>

#include <array>
#include <cstdint>
#include <thread>

namespace tendon {
namespace {

TEST(Counter, CountsUp) {
  Counter<> counter;
  EXPECT_EQ(counter.value(), 0U);
  counter.Add();
  counter.Add(41);
  EXPECT_EQ(counter.value(), 42U);
}

TEST(Counter, CanBeReadWhileAnotherThreadCounts) {
  constexpr std::uint64_t kCounts = 100'000;
  Counter<> counter;

  std::thread writer([&] {
    for (std::uint64_t i = 0; i < kCounts; ++i) counter.Add();
  });
  std::uint64_t before = 0;
  while (before < kCounts) {
    const std::uint64_t now = counter.value();
    ASSERT_GE(now, before);
    before = now;
  }
  writer.join();

  EXPECT_EQ(counter.value(), kCounts);
}

TEST(SharedCounter, ManyThreadsCountWithoutLoss) {
  constexpr std::uint64_t kCounts = 50'000;
  SharedCounter<> counter;
  {
    std::array<std::jthread, 3> threads;
    for (auto& thread : threads) {
      thread = std::jthread([&] {
        for (std::uint64_t i = 0; i < kCounts; ++i) counter.Add();
      });
    }
  }
  EXPECT_EQ(counter.value(), 3 * kCounts);
}

TEST(Flag, PublishesEarlierWrites) {
  Flag flag;
  int data = 0;

  std::thread writer([&] {
    data = 7;
    flag.Set(true);
  });
  while (!flag.Get()) std::this_thread::yield();
  EXPECT_EQ(data, 7);
  writer.join();
}

}  // namespace
}  // namespace tendon
