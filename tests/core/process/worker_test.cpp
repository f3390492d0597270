#include <gtest/gtest.h>
#include <support/record.h>
#include <support/wait.h>
#include <tendon/base/log.h>
#include <tendon/middleware/connect_cancellation.h>
#include <tendon/process/worker.h>

#include <atomic>
#include <future>
#include <latch>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace tendon {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

TEST(Worker, RunsTasksInTheOrderTheyWerePosted) {
  Worker worker("test");
  std::vector<int> order;
  std::promise<void> done;
  for (int i = 0; i < 100; ++i) worker.Post([&order, i] { order.push_back(i); });
  worker.Post([&] { done.set_value(); });

  done.get_future().wait();

  ASSERT_EQ(order.size(), 100U);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(order[static_cast<std::size_t>(i)], i);
}

TEST(Worker, ADelayedTaskLetsOthersRunFirst) {
  Worker worker("test");
  std::vector<int> order;
  std::promise<void> done;
  const auto start = SteadyClock().Now();
  worker.PostAfter(1000ms, [&] {
    order.push_back(2);
    done.set_value();
  });
  worker.PostAfter(500ms, [&] { order.push_back(1); });
  worker.Post([&] { order.push_back(0); });

  done.get_future().wait();

  EXPECT_EQ(order, (std::vector{0, 1, 2}));
  EXPECT_GE(SteadyClock().Now() - start, 1000ms);
}

TEST(Worker, ATaskMayPostTheNext) {
  Worker worker("test");
  std::promise<int> done;
  std::function<void(int)> next = [&](int count) {
    if (count == 100) return done.set_value(count);
    worker.Post([&, count] { next(count + 1); });
  };
  worker.Post([&] { next(0); });

  EXPECT_EQ(done.get_future().get(), 100);
}

/// Returns the errors of robot since the first call.
std::vector<std::string> ErrorsOfRobot() {
  static test::Record<std::string> errors;
  static const bool listening = [] {
    AddLogSink([](LogLevel level, std::string_view source, std::string_view text) {
      if (level == LogLevel::kError && source == "robot") errors.Add(std::string(text));
    });
    return true;
  }();
  return listening ? errors.Take() : std::vector<std::string>();
}

TEST(Worker, LogsAThrowingTaskAndRunsTheOthers) {
  ErrorsOfRobot();
  std::promise<void> done;
  Worker worker("test", "robot");

  worker.Post([] { throw std::length_error("much too long"); });
  worker.Post([] { throw 7; });
  worker.Post([&] { done.set_value(); });

  done.get_future().wait();
  EXPECT_EQ(
      ErrorsOfRobot(),
      (std::vector<std::string>{
          "a task of thread 'test' failed: much too long",
          "a task of thread 'test' failed: its exception does not derive from std::exception"}));
}

TEST(Worker, StopWaitsForTheRunningTaskAndDropsTheOthers) {
  Worker worker("test");
  std::latch running(1);
  std::promise<void> release;
  bool ran_second = false;
  const auto dropped = std::make_shared<int>(0);
  worker.Post([&] {
    running.count_down();
    release.get_future().wait();
  });
  worker.Post([&ran_second, dropped] { ran_second = true; });
  running.wait();
  auto stopped = std::async(std::launch::async, [&] { worker.Stop(); });
  EXPECT_TRUE(EventuallyTrue([&] {  // from then on, posted jobs are dropped at once
    const auto late = std::make_shared<int>(0);
    worker.Post([late] {});
    return late.use_count() == 1;
  }));
  EXPECT_EQ(stopped.wait_for(0ms), std::future_status::timeout);

  release.set_value();
  stopped.get();
  worker.Post([&ran_second, dropped] { ran_second = true; });

  EXPECT_FALSE(ran_second);
  EXPECT_EQ(dropped.use_count(), 1);
}

TEST(Worker, StopCancelsOnlyTheRunningTasksConnect) {
  Worker worker("test");
  std::latch running(1);
  std::atomic<bool> is_other_given_up = false;
  const CancellableConnect other([&] { is_other_given_up = true; });
  worker.Post([&] {
    std::atomic<bool> is_given_up = false;
    const CancellableConnect wait([&] {
      is_given_up = true;
      is_given_up.notify_all();
    });
    running.count_down();
    is_given_up.wait(false);
  });
  running.wait();

  worker.Stop();

  EXPECT_FALSE(is_other_given_up);
  EXPECT_FALSE(AreConnectsCancelled());
}

TEST(Worker, MayBeDestroyedByATaskOfItsOwn) {
  auto worker = std::make_shared<Worker>("test");
  std::promise<void> is_last;
  std::promise<void> gone;
  const auto dropped = std::make_shared<int>(0);
  worker->Post([&, mine = worker]() mutable {
    is_last.get_future().wait();
    mine.reset();
    gone.set_value();
  });
  worker->Post([dropped] {});

  worker.reset();
  is_last.set_value();
  gone.get_future().wait();

  EXPECT_EQ(dropped.use_count(), 1);
}

}  // namespace
}  // namespace tendon
