#include <gtest/gtest.h>
#include <support/allocation_guard.h>
#include <tendon/lockfree/spsc_queue.h>

#include <cstdint>
#include <memory>
#include <thread>

namespace tendon {
namespace {

TEST(SpscQueue, ACapacityOf64Holds64) {
  SpscQueue<int> queue(64);
  int pushed = 0;
  while (queue.Push(pushed)) ++pushed;

  EXPECT_EQ(pushed, 64);
  EXPECT_EQ(queue.size(), 64U);
}

TEST(SpscQueue, GivesValuesBackInOrder) {
  SpscQueue<int> queue(3);
  for (int value = 0; value < 20; ++value) {
    EXPECT_TRUE(queue.Push(2 * value));
    EXPECT_TRUE(queue.Push(2 * value + 1));
    int popped = -1;
    EXPECT_TRUE(queue.Pop(popped));
    EXPECT_EQ(popped, 2 * value);
    EXPECT_TRUE(queue.Pop(popped));
    EXPECT_EQ(popped, 2 * value + 1);
  }
}

TEST(SpscQueue, PushToAFullQueueKeepsTheValue) {
  SpscQueue<std::unique_ptr<int>> queue(1);
  EXPECT_TRUE(queue.Push(std::make_unique<int>(1)));
  auto second = std::make_unique<int>(2);

  EXPECT_FALSE(queue.Push(std::move(second)));

  ASSERT_NE(second, nullptr);
  EXPECT_EQ(*second, 2);
}

TEST(SpscQueue, PopFromAnEmptyQueueKeepsTheTarget) {
  SpscQueue<int> queue(1);
  int value = 42;

  EXPECT_FALSE(queue.Pop(value));

  EXPECT_EQ(value, 42);
}

TEST(SpscQueue, DestroysRemainingValues) {
  const auto counted = std::make_shared<int>();
  {
    SpscQueue<std::shared_ptr<int>> queue(4);
    EXPECT_TRUE(queue.Push(counted));
    EXPECT_TRUE(queue.Push(counted));
    std::shared_ptr<int> popped;
    EXPECT_TRUE(queue.Pop(popped));
    EXPECT_EQ(counted.use_count(), 3);
  }
  EXPECT_EQ(counted.use_count(), 1);
}

TEST(SpscQueue, AllocatesNothingOnceMade) {
  SpscQueue<std::uint64_t> queue(8);
  std::uint64_t value = 0;

  const AllocationGuard guard;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    EXPECT_TRUE(queue.Push(i));
    EXPECT_TRUE(queue.Pop(value));
  }
}

TEST(SpscQueue, TwoThreadsLoseAndReorderNothing) {
  constexpr std::uint64_t kValues = 200'000;
  SpscQueue<std::unique_ptr<std::uint64_t>> queue(16);

  std::thread producer([&] {
    for (std::uint64_t i = 0; i < kValues; ++i) {
      auto value = std::make_unique<std::uint64_t>(i);
      while (!queue.Push(std::move(value))) std::this_thread::yield();
    }
  });
  std::uint64_t wrong = 0;
  for (std::uint64_t i = 0; i < kValues; ++i) {
    std::unique_ptr<std::uint64_t> value;
    while (!queue.Pop(value)) std::this_thread::yield();
    if (*value != i) ++wrong;
  }
  producer.join();

  EXPECT_EQ(wrong, 0U);
}

}  // namespace
}  // namespace tendon
