#include <gtest/gtest.h>
#include <tendon/proxy/network_thread.h>

#include <atomic>

#include "support/wait.h"

namespace {

using std::chrono::milliseconds;
using tendon::NetworkThread;
using tendon::SteadyTime;

struct CountingJob final : tendon::NetworkJob {
  bool Work(SteadyTime now, SteadyTime& next) override {
    ++calls;
    if (pause.count() > 0) next = std::min(next, now + pause);
    return more-- > 0;
  }
  std::atomic<int> calls = 0;
  std::atomic<int> more = 0;
  milliseconds pause{0};
};

TEST(NetworkThread, RunsAJobWhenNotified) {
  NetworkThread thread;
  CountingJob job;
  thread.Add(job);
  for (int round = 0; round < 100; ++round) {
    const int before = job.calls;
    thread.Notify();
    ASSERT_TRUE(EventuallyTrue([&] { return job.calls > before; }));
  }
  thread.Remove(job);
}

TEST(NetworkThread, RunsAgainAtOnceWhileThereIsMoreWork) {
  NetworkThread thread;
  CountingJob job;
  job.more = 1000;
  thread.Add(job);

  EXPECT_TRUE(EventuallyTrue([&] { return job.calls > 1000; }));
  thread.Remove(job);
}

TEST(NetworkThread, RunsAgainAtTheRequestedTime) {
  NetworkThread thread;
  CountingJob job;
  job.pause = milliseconds(1);
  thread.Add(job);

  EXPECT_TRUE(EventuallyTrue([&] { return job.calls > 100; }));
  thread.Remove(job);
}

TEST(NetworkThread, DoesNotRunARemovedJob) {
  NetworkThread thread;
  CountingJob other;
  other.more = 1'000'000'000;  // always has more to do
  thread.Add(other);
  for (int round = 0; round < 100; ++round) {
    auto job = std::make_unique<CountingJob>();
    thread.Add(*job);
    thread.Remove(*job);
    job.reset();
  }
  const int before = other.calls;
  EXPECT_TRUE(EventuallyTrue([&] { return other.calls > before + 10; }));
  thread.Remove(other);
}

}  // namespace
