#include <gtest/gtest.h>
#include <support/allocation_guard.h>
#include <tendon/lockfree/wakeup.h>

#include <array>
#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

namespace tendon {
namespace {

using namespace std::chrono_literals;

SteadyTime After(std::chrono::nanoseconds time) { return StdAtomics::Now() + time; }

TEST(Wakeup, ReturnsAtOnceWhenReady) {
  Wakeup<> wakeup;
  EXPECT_TRUE(wakeup.WaitUntil([] { return true; }, SteadyTime::max()));
}

TEST(Wakeup, FindsWorkAtAPassedDeadline) {
  Wakeup<> wakeup;
  EXPECT_TRUE(wakeup.WaitUntil([] { return true; }, SteadyTime::min()));
  EXPECT_FALSE(wakeup.WaitUntil([] { return false; }, SteadyTime::min()));
}

TEST(Wakeup, GivesUpAtItsDeadlineAndNotBefore) {
  Wakeup<> wakeup;
  const SteadyTime deadline = After(2ms);

  EXPECT_FALSE(wakeup.WaitUntil([] { return false; }, deadline));

  EXPECT_GE(StdAtomics::Now(), deadline);
}

TEST(Wakeup, ANotificationWithoutWorkDoesNotEndTheWait) {
  Wakeup<> wakeup;
  std::atomic<bool> has_work = false;
  std::atomic<int> looks = 0;
  std::thread poster([&] {
    while (looks < 2) std::this_thread::yield();
    for (int i = 0; i < 3; ++i) wakeup.Notify();
    has_work = true;
    wakeup.Notify();
  });

  EXPECT_TRUE(wakeup.WaitUntil(
      [&] {
        ++looks;
        return has_work.load();
      },
      After(60s)));

  EXPECT_TRUE(has_work);
  poster.join();
}

TEST(Wakeup, DoesNotWakeASleeperThatWakesInTime) {
  Wakeup<> wakeup;
  std::atomic<int> looks = 0;
  const SteadyTime until = After(50ms);
  std::thread poster([&] {
    while (StdAtomics::Now() < until) wakeup.NotifyBy(until);
  });

  EXPECT_FALSE(wakeup.WaitUntil([&] { return ++looks == 0; }, until));
  poster.join();

  EXPECT_LE(looks, 10) << "before it sleeps, at its end, and where the kernel wakes it";
}

TEST(Wakeup, WakesASleeperThatWouldWakeTooLate) {
  Wakeup<> wakeup;
  std::atomic<bool> has_work = false;
  std::atomic<int> looks = 0;
  std::thread poster([&] {
    while (looks < 2) std::this_thread::yield();
    has_work = true;
    wakeup.NotifyBy(After(1h));
  });

  EXPECT_TRUE(wakeup.WaitUntil(
      [&] {
        ++looks;
        return has_work.load();
      },
      After(2h)));
  poster.join();
}

TEST(Wakeup, NotifyingAllocatesNothing) {
  Wakeup<> wakeup;
  const AllocationGuard guard;
  wakeup.Notify();
  EXPECT_TRUE(wakeup.WaitUntil([] { return true; }, SteadyTime::max()));
}

TEST(Wakeup, LosesNoneOfManyWakeUps) {
  constexpr int kTurns = 20'000;
  std::array<Wakeup<>, 2> wakeups;
  std::atomic<int> turn = 0;
  std::atomic<int> missed = 0;
  const auto play = [&](int player) {
    for (int mine = player; mine < kTurns; mine += 2) {
      const auto is_mine = [&] { return turn.load(std::memory_order_acquire) == mine; };
      if (!wakeups[static_cast<std::size_t>(player)].WaitUntil(is_mine, After(60s))) ++missed;
      turn.store(mine + 1, std::memory_order_release);
      wakeups[static_cast<std::size_t>(1 - player)].Notify();
    }
  };

  std::thread second([&] { play(1); });
  play(0);
  second.join();

  EXPECT_EQ(missed, 0);
  EXPECT_EQ(turn, kTurns);
}

TEST(Wakeup, ManyPostersWakeOneSleeper) {
  constexpr std::uint64_t kPosts = 5'000;
  Wakeup<> wakeup;
  std::atomic<std::uint64_t> posted = 0;
  std::array<std::jthread, 2> posters;
  for (auto& poster : posters) {
    poster = std::jthread([&] {
      for (std::uint64_t i = 0; i < kPosts; ++i) {
        posted.fetch_add(1, std::memory_order_release);
        wakeup.Notify();
      }
    });
  }

  std::uint64_t seen = 0;
  while (seen < 2 * kPosts) {
    ASSERT_TRUE(wakeup.WaitUntil([&] { return posted.load(std::memory_order_acquire) > seen; },
                                 After(60s)));
    seen = posted;
  }
}

}  // namespace
}  // namespace tendon
