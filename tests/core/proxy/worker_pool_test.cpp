#include <gtest/gtest.h>
#include <tendon/proxy/worker_pool.h>

#include <atomic>
#include <future>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

#include "support/wait.h"

namespace tendon {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kMany = 1000;

/// Calls wait at the barrier until it is opened.
class Barrier {
 public:
  void Enter() {
    ++entered_;
    open_.wait();
  }
  void Open() { opener_.set_value(); }
  [[nodiscard]] int entered() const { return entered_; }

 private:
  std::promise<void> opener_;
  std::shared_future<void> open_ = opener_.get_future().share();
  std::atomic<int> entered_ = 0;
};

SteadyTime Later() { return SteadyClock().Now() + 30s; }

TEST(WorkerPool, RunsTheCallsOfALineSequentially) {
  WorkerPool threads("test");
  const auto executor = threads.MakeExecutor(kMany);
  std::vector<std::size_t> executed;  // a data race, unless only one thread runs at a time

  for (std::size_t i = 0; i < kMany; ++i) {
    ASSERT_TRUE(executor->Post([&executed, i] { executed.push_back(i); }));
  }
  EXPECT_TRUE(executor->Drain(Later()));

  ASSERT_EQ(executed.size(), kMany);
  for (std::size_t i = 0; i < kMany; ++i) EXPECT_EQ(executed[i], i);
}

TEST(WorkerPool, RunsSeveralLinesInParallel) {
  WorkerPool threads("test");
  Barrier barrier;
  std::vector<std::shared_ptr<SerialExecutor>> executors;
  for (std::size_t i = 0; i < WorkerPool::kMax; ++i)
    executors.push_back(threads.MakeExecutor(kMany));

  for (const auto& executor : executors)
    ASSERT_TRUE(executor->Post([&barrier] { barrier.Enter(); }));

  EXPECT_TRUE(
      EventuallyTrue([&] { return barrier.entered() == static_cast<int>(WorkerPool::kMax); }));
  barrier.Open();
  for (const auto& executor : executors) EXPECT_TRUE(executor->Drain(Later()));
}

TEST(WorkerPool, LimitsItsThreads) {
  WorkerPool threads("test");
  Barrier barrier;
  std::vector<std::shared_ptr<SerialExecutor>> executors;
  for (std::size_t i = 0; i <= WorkerPool::kMax; ++i) {
    executors.push_back(threads.MakeExecutor(kMany));
    ASSERT_TRUE(executors.back()->Post([&barrier] { barrier.Enter(); }));
  }

  EXPECT_TRUE(
      EventuallyTrue([&] { return barrier.entered() == static_cast<int>(WorkerPool::kMax); }));
  EXPECT_FALSE(executors.back()->Drain(SteadyClock().Now() + 20ms));
  EXPECT_EQ(barrier.entered(), static_cast<int>(WorkerPool::kMax));

  barrier.Open();
  for (const auto& executor : executors) EXPECT_TRUE(executor->Drain(Later()));
  EXPECT_EQ(barrier.entered(), static_cast<int>(WorkerPool::kMax) + 1);
}

TEST(WorkerPool, HungCallsOfOneKindDoNotBlockOthers) {
  Barrier barrier;
  CallExecutors sorts;
  for (std::size_t i = 0; i < 2 * WorkerPool::kMax; ++i) {
    ASSERT_TRUE(sorts.reads.MakeExecutor(kMany)->Post([&barrier] { barrier.Enter(); }));
  }
  const auto executor = sorts.commands.MakeExecutor(kMany);
  bool is_executed = false;

  ASSERT_TRUE(executor->Post([&] { is_executed = true; }));

  EXPECT_TRUE(executor->Drain(Later()));
  EXPECT_TRUE(is_executed);
  barrier.Open();
}

TEST(WorkerPool, LimitsTheCallsOfALine) {
  WorkerPool threads("test");
  Barrier barrier;
  const auto executor = threads.MakeExecutor(2);
  const auto other = threads.MakeExecutor(2);

  EXPECT_TRUE(executor->Post([&barrier] { barrier.Enter(); }));
  EXPECT_TRUE(executor->Post([] {}));
  EXPECT_FALSE(executor->Post([] {}));
  EXPECT_TRUE(other->Post([] {}));

  barrier.Open();
  EXPECT_TRUE(executor->Drain(Later()));
  EXPECT_TRUE(executor->Post([] {}));
}

TEST(WorkerPool, LimitsTheBytesOfALineExceptForOneCall) {
  WorkerPool threads("test");
  Barrier barrier;
  const auto executor = threads.MakeExecutor(kMany, 100);

  EXPECT_TRUE(executor->Post([&barrier] { barrier.Enter(); }, 1000));
  EXPECT_FALSE(executor->Post([] {}, 1));
  barrier.Open();
  EXPECT_TRUE(executor->Drain(Later()));

  Barrier next;
  EXPECT_TRUE(executor->Post([&next] { next.Enter(); }, 50));
  EXPECT_TRUE(executor->Post([] {}, 50));
  EXPECT_FALSE(executor->Post([] {}, 1));
  next.Open();
  EXPECT_TRUE(executor->Drain(Later()));
}

TEST(WorkerPool, ContinuesAfterAThrowingCall) {
  WorkerPool threads("test");
  const auto executor = threads.MakeExecutor(kMany);
  std::atomic<bool> is_executed = false;

  EXPECT_TRUE(executor->Post([] { throw std::runtime_error("on purpose"); }));
  EXPECT_TRUE(executor->Post([&] { is_executed = true; }));
  EXPECT_TRUE(executor->Drain(Later()));

  EXPECT_TRUE(is_executed);
}

TEST(WorkerPool, FinishesTheRunningCallAndDropsTheRest) {
  std::optional<WorkerPool> threads(std::in_place, "test");
  const auto executor = threads->MakeExecutor(1000 * kMany);
  Barrier barrier;
  std::atomic<bool> has_run = false;
  const auto owned = std::make_shared<int>();
  ASSERT_TRUE(executor->Post([&] {
    barrier.Enter();
    has_run = true;
  }));
  std::atomic<bool> is_executed = false;
  ASSERT_TRUE(executor->Post([&is_executed, owned] { is_executed = true; }));
  ASSERT_TRUE(EventuallyTrue([&] { return barrier.entered() == 1; }));

  auto end = std::async(std::launch::async, [&] { threads.reset(); });
  EXPECT_TRUE(EventuallyTrue([&] { return !executor->Post([] {}); })) << "none is taken any more";
  barrier.Open();
  end.get();

  EXPECT_TRUE(has_run);
  EXPECT_FALSE(is_executed);
  EXPECT_EQ(owned.use_count(), 1);
}

}  // namespace
}  // namespace tendon
