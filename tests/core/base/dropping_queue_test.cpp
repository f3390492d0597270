#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/base/dropping_queue.h>

#include <memory>
#include <vector>

namespace {

using tendon::DroppingQueue;
using testing::ElementsAre;
using testing::IsEmpty;

class DroppingQueueTest : public testing::Test {
 protected:
  void Push(int value, std::size_t bytes) {
    queue.Push(value, bytes, [this](int oldest) { dropped.push_back(oldest); });
  }

  DroppingQueue<int> queue{{.elements = 4, .bytes = 100}};
  std::vector<int> dropped;
};

TEST_F(DroppingQueueTest, ReturnsItemsInOrder) {
  for (int i = 1; i <= 3; ++i) Push(i, 10);

  EXPECT_THAT(queue.Take(100), ElementsAre(1, 2, 3));
  EXPECT_TRUE(queue.is_empty());
  EXPECT_EQ(queue.bytes(), 0U);
  EXPECT_THAT(dropped, IsEmpty());
}

TEST_F(DroppingQueueTest, DropsTheOldestIfThereAreTooMany) {
  for (int i = 1; i <= 6; ++i) Push(i, 1);

  EXPECT_THAT(dropped, ElementsAre(1, 2));
  EXPECT_THAT(queue.Take(100), ElementsAre(3, 4, 5, 6));
}

TEST_F(DroppingQueueTest, DropsTheOldestIfTheyAreTooLarge) {
  for (int i = 1; i <= 3; ++i) Push(i, 40);
  EXPECT_THAT(dropped, ElementsAre(1));

  Push(4, 90);

  EXPECT_THAT(dropped, ElementsAre(1, 2, 3));
  EXPECT_EQ(queue.bytes(), 90U);
}

TEST_F(DroppingQueueTest, KeepsASingleItemLargerThanTheLimit) {
  Push(1, 40);
  Push(2, 1000);
  EXPECT_THAT(dropped, ElementsAre(1));
  EXPECT_THAT(queue.Take(100), ElementsAre(2)) << "at least one is given";

  Push(3, 1000);
  Push(4, 1);
  EXPECT_THAT(dropped, ElementsAre(1, 3));
}

TEST_F(DroppingQueueTest, TakesNoMoreThanRequested) {
  for (int i = 1; i <= 3; ++i) Push(i, 30);

  EXPECT_THAT(queue.Take(60), ElementsAre(1, 2));
  EXPECT_EQ(queue.front(), 3);
  EXPECT_THAT(queue.Take(0), ElementsAre(3));
  EXPECT_THAT(queue.Take(60), IsEmpty());
}

TEST(MoveOnlyDroppingQueue, AcceptsMoveOnlyItems) {
  DroppingQueue<std::unique_ptr<int>> queue({.elements = 1, .bytes = 100});
  int dropped = 0;
  const auto count = [&](const std::unique_ptr<int>& oldest) { dropped += *oldest; };
  queue.Push(std::make_unique<int>(1), 1, count);
  queue.Push(std::make_unique<int>(2), 1, count);

  EXPECT_EQ(dropped, 1);
  EXPECT_EQ(*queue.Take(100).front(), 2);
}

}  // namespace
