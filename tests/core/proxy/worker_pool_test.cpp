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
  const auto line = threads.MakeLine(kMany);
  std::vector<std::size_t> executed;  // a data race, unless only one thread runs at a time

  for (std::size_t i = 0; i < kMany; ++i) {
    ASSERT_TRUE(line->Post([&executed, i] { executed.push_back(i); }));
  }
  EXPECT_TRUE(line->Drain(Later()));

  ASSERT_EQ(executed.size(), kMany);
  for (std::size_t i = 0; i < kMany; ++i) EXPECT_EQ(executed[i], i);
}

TEST(WorkerPool, RunsSeveralLinesInParallel) {
  WorkerPool threads("test");
  Barrier barrier;
  std::vector<std::shared_ptr<SerialExecutor>> lines;
  for (std::size_t i = 0; i < WorkerPool::kMost; ++i) lines.push_back(threads.MakeLine(kMany));

  for (const auto& line : lines) ASSERT_TRUE(line->Post([&barrier] { barrier.Enter(); }));

  EXPECT_TRUE(
      EventuallyTrue([&] { return barrier.entered() == static_cast<int>(WorkerPool::kMost); }));
  barrier.Open();
  for (const auto& line : lines) EXPECT_TRUE(line->Drain(Later()));
}

TEST(WorkerPool, LimitsItsThreads) {
  WorkerPool threads("test");
  Barrier barrier;
  std::vector<std::shared_ptr<SerialExecutor>> lines;
  for (std::size_t i = 0; i <= WorkerPool::kMost; ++i) {
    lines.push_back(threads.MakeLine(kMany));
    ASSERT_TRUE(lines.back()->Post([&barrier] { barrier.Enter(); }));
  }

  EXPECT_TRUE(
      EventuallyTrue([&] { return barrier.entered() == static_cast<int>(WorkerPool::kMost); }));
  EXPECT_FALSE(lines.back()->Drain(SteadyClock().Now() + 20ms));
  EXPECT_EQ(barrier.entered(), static_cast<int>(WorkerPool::kMost));

  barrier.Open();
  for (const auto& line : lines) EXPECT_TRUE(line->Drain(Later()));
  EXPECT_EQ(barrier.entered(), static_cast<int>(WorkerPool::kMost) + 1);
}

TEST(WorkerPool, HungCallsOfOneKindDoNotBlockOthers) {
  Barrier barrier;
  CallExecutors sorts;
  for (std::size_t i = 0; i < 2 * WorkerPool::kMost; ++i) {
    ASSERT_TRUE(sorts.reads.MakeLine(kMany)->Post([&barrier] { barrier.Enter(); }));
  }
  const auto line = sorts.commands.MakeLine(kMany);
  bool is_executed = false;

  ASSERT_TRUE(line->Post([&] { is_executed = true; }));

  EXPECT_TRUE(line->Drain(Later()));
  EXPECT_TRUE(is_executed);
  barrier.Open();
}

TEST(WorkerPool, LimitsTheCallsOfALine) {
  WorkerPool threads("test");
  Barrier barrier;
  const auto line = threads.MakeLine(2);
  const auto other = threads.MakeLine(2);

  EXPECT_TRUE(line->Post([&barrier] { barrier.Enter(); }));
  EXPECT_TRUE(line->Post([] {}));
  EXPECT_FALSE(line->Post([] {}));
  EXPECT_TRUE(other->Post([] {}));

  barrier.Open();
  EXPECT_TRUE(line->Drain(Later()));
  EXPECT_TRUE(line->Post([] {}));
}

TEST(WorkerPool, LimitsTheBytesOfALineExceptForOneCall) {
  WorkerPool threads("test");
  Barrier barrier;
  const auto line = threads.MakeLine(kMany, 100);

  EXPECT_TRUE(line->Post([&barrier] { barrier.Enter(); }, 1000));
  EXPECT_FALSE(line->Post([] {}, 1));
  barrier.Open();
  EXPECT_TRUE(line->Drain(Later()));

  Barrier next;
  EXPECT_TRUE(line->Post([&next] { next.Enter(); }, 50));
  EXPECT_TRUE(line->Post([] {}, 50));
  EXPECT_FALSE(line->Post([] {}, 1));
  next.Open();
  EXPECT_TRUE(line->Drain(Later()));
}

TEST(WorkerPool, ContinuesAfterAThrowingCall) {
  WorkerPool threads("test");
  const auto line = threads.MakeLine(kMany);
  std::atomic<bool> is_executed = false;

  EXPECT_TRUE(line->Post([] { throw std::runtime_error("on purpose"); }));
  EXPECT_TRUE(line->Post([&] { is_executed = true; }));
  EXPECT_TRUE(line->Drain(Later()));

  EXPECT_TRUE(is_executed);
}

TEST(WorkerPool, FinishesTheRunningCallAndDropsTheRest) {
  std::optional<WorkerPool> threads(std::in_place, "test");
  const auto line = threads->MakeLine(1000 * kMany);
  Barrier barrier;
  std::atomic<bool> has_run = false;
  const auto owned = std::make_shared<int>();
  ASSERT_TRUE(line->Post([&] {
    barrier.Enter();
    has_run = true;
  }));
  std::atomic<bool> is_executed = false;
  ASSERT_TRUE(line->Post([&is_executed, owned] { is_executed = true; }));
  ASSERT_TRUE(EventuallyTrue([&] { return barrier.entered() == 1; }));

  auto end = std::async(std::launch::async, [&] { threads.reset(); });
  EXPECT_TRUE(EventuallyTrue([&] { return !line->Post([] {}); })) << "none is taken any more";
  barrier.Open();
  end.get();

  EXPECT_TRUE(has_run);
  EXPECT_FALSE(is_executed);
  EXPECT_EQ(owned.use_count(), 1);
}

}  // namespace
}  // namespace tendon
