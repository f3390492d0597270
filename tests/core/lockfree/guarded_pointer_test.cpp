#include <gtest/gtest.h>
#include <support/allocation_guard.h>
#include <tendon/lockfree/guarded_pointer.h>
#include <tendon/lockfree/shared_guarded_pointer.h>

#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace tendon {
namespace {

/// Tests that apply to one calling thread and to several.
template <typename Guarded>
class AnyGuardedPointer : public testing::Test {};

using Kinds = testing::Types<GuardedPointer<int>, SharedGuardedPointer<int>>;
TYPED_TEST_SUITE(AnyGuardedPointer, Kinds);

TYPED_TEST(AnyGuardedPointer, IsInitiallyNull) {
  TypeParam guarded;
  const typename TypeParam::Call call(guarded);
  EXPECT_EQ(call.get(), nullptr);
}

TYPED_TEST(AnyGuardedPointer, ExchangeReturnsTheOldObject) {
  int first = 1;
  int second = 2;
  TypeParam guarded(&first);

  EXPECT_EQ(guarded.Exchange(&second), &first);

  EXPECT_EQ(guarded.Get(), &second);
  const typename TypeParam::Call call(guarded);
  EXPECT_EQ(call.get(), &second);
}

/// Makes a call between the two steps of an exchange.
struct WithACallBetween : StdAtomics {
  static inline std::function<void()> call;

  static void Fence(std::memory_order order) noexcept {
    StdAtomics::Fence(order);
    if (call) std::exchange(call, nullptr)();
  }
  static void ProcessBarrier() noexcept {
    if (call) std::exchange(call, nullptr)();
    StdAtomics::ProcessBarrier();
  }
};

/// Returns the object of a call that begins during the exchange and is still running when the
/// exchange returns.
template <typename Guarded>
int* ObjectOfACallThatBeginsMeanwhile(Guarded& guarded, int& next) {
  std::optional<typename Guarded::Call> call;
  WithACallBetween::call = [&] { call.emplace(guarded); };
  guarded.Exchange(&next);
  return call->get();
}

TEST(GuardedPointer, AnExchangeDoesNotWaitForCallsOfTheNewObject) {
  int first = 1;
  int second = 2;
  GuardedPointer<int, WithACallBetween> guarded(&first);

  EXPECT_EQ(ObjectOfACallThatBeginsMeanwhile(guarded, second), &second);
}

TEST(SharedGuardedPointer, AnExchangeDoesNotWaitForCallsOfTheNewObject) {
  int first = 1;
  int second = 2;
  SharedGuardedPointer<int, WithACallBetween> guarded(&first);

  EXPECT_EQ(ObjectOfACallThatBeginsMeanwhile(guarded, second), &second);
}

TEST(GuardedPointer, ExchangingBackDoesNotFreeTheObjectOfANestedCall) {
  int first = 1;
  int second = 2;
  GuardedPointer<int> guarded(&first);
  const GuardedPointer<int>::Call outer(guarded);
  EXPECT_FALSE(guarded.TryExchange(&second, SteadyTime::min()));
  {
    const GuardedPointer<int>::Call inner(guarded);
    ASSERT_EQ(inner.get(), &second);

    EXPECT_FALSE(guarded.TryExchange(&first, SteadyTime::min()));
  }
  EXPECT_TRUE(guarded.TryExchange(&first, SteadyTime::min()));
}

TEST(GuardedPointer, AnExchangeTimesOutWhileTheOldObjectIsInUse) {
  int first = 1;
  int second = 2;
  GuardedPointer<int> guarded(&first);
  {
    const GuardedPointer<int>::Call call(guarded);
    std::thread manager([&] { EXPECT_FALSE(guarded.TryExchange(&second, SteadyTime::min())); });
    manager.join();
    EXPECT_EQ(call.get(), &first);
  }

  EXPECT_EQ(guarded.Get(), &second);
  EXPECT_TRUE(guarded.TryExchange(nullptr, SteadyTime::min()));
}

TYPED_TEST(AnyGuardedPointer, AnExchangeWaitsForCallsOfTheOldObject) {
  int object = 1;
  TypeParam guarded(&object);
  std::atomic<bool> has_call_ended = false;
  std::atomic<bool> had_call_ended = false;
  std::thread manager;
  {
    const typename TypeParam::Call call(guarded);
    manager = std::thread([&] {
      guarded.Exchange(nullptr);
      had_call_ended = has_call_ended.load();
    });
    while (guarded.Get() != nullptr) std::this_thread::yield();
    EXPECT_EQ(call.get(), &object);
    has_call_ended = true;
  }
  manager.join();

  EXPECT_TRUE(had_call_ended);
}

TYPED_TEST(AnyGuardedPointer, ANestedCallDoesNotEndTheOuterOne) {
  int object = 1;
  TypeParam guarded(&object);
  std::atomic<bool> has_call_ended = false;
  std::atomic<bool> had_call_ended = false;
  std::thread manager;
  {
    const typename TypeParam::Call outer(guarded);
    { const typename TypeParam::Call before(guarded); }
    manager = std::thread([&] {
      guarded.Exchange(nullptr);
      had_call_ended = has_call_ended.load();
    });
    while (guarded.Get() != nullptr) std::this_thread::yield();
    {
      const typename TypeParam::Call inner(guarded);
      EXPECT_EQ(inner.get(), nullptr);
    }
    has_call_ended = true;
  }
  manager.join();

  EXPECT_TRUE(had_call_ended);
}

TYPED_TEST(AnyGuardedPointer, ACallAllocatesNothing) {
  int object = 1;
  TypeParam guarded(&object);
  const AllocationGuard guard;
  const typename TypeParam::Call call(guarded);
  EXPECT_EQ(call.get(), &object);
}

/// Several threads call without a pause. Each object is freed as soon as the exchange returns.
template <template <typename, typename> typename Guarded>
int WrongValuesSeen(std::size_t callers) {
  constexpr int kExchanges = 2'000;
  constexpr int kCalls = 50'000;
  constexpr int kAlive = 17;
  Guarded<int, StdAtomics> guarded(std::make_unique<int>(kAlive).release());
  std::atomic<bool> is_over = false;
  std::atomic<int> wrong = 0;
  std::atomic<int> calls = 0;
  std::vector<std::jthread> threads;
  for (std::size_t i = 0; i < callers; ++i) {
    threads.emplace_back([&] {
      while (!is_over) {
        const typename Guarded<int, StdAtomics>::Call call(guarded);
        if (*call.get() != kAlive) ++wrong;
        calls.fetch_add(1, std::memory_order_relaxed);
      }
    });
  }
  for (int i = 0; i < kExchanges || calls < kCalls; ++i) {
    const std::unique_ptr<int> old(guarded.Exchange(std::make_unique<int>(kAlive).release()));
    *old = 0;
  }
  is_over = true;
  threads.clear();
  const std::unique_ptr<int> last(guarded.Exchange(nullptr));
  return wrong;
}

TEST(GuardedPointer, ABusyCallerSeesNoFreedObject) {
  EXPECT_EQ(WrongValuesSeen<GuardedPointer>(1), 0);
}

TEST(SharedGuardedPointer, BusyCallersSeeNoFreedObject) {
  EXPECT_EQ(WrongValuesSeen<SharedGuardedPointer>(3), 0);
}

}  // namespace
}  // namespace tendon
