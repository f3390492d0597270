#include <gtest/gtest.h>
#include <tendon/lockfree/completion.h>
#include <tendon/lockfree/flag.h>

#include <chrono>
#include <memory>
#include <thread>

namespace tendon {
namespace {

using namespace std::chrono_literals;
using Ending = Completion<>::Ending;

constexpr auto kNever = [] { return false; };

SteadyTime In(std::chrono::nanoseconds time) { return StdAtomics::Now() + time; }

TEST(Completion, CanBeTakenOnlyOnce) {
  Completion<> completion;

  EXPECT_TRUE(completion.TryTake());
  EXPECT_FALSE(completion.TryTake());
  completion.Free();

  EXPECT_TRUE(completion.TryTake());
}

TEST(Completion, ExecutingTheCallEndsTheWait) {
  Completion<> completion;
  ASSERT_TRUE(completion.TryTake());
  std::jthread server([&] {
    ASSERT_TRUE(completion.Start());
    completion.Finish(Status::kFailed);
  });

  EXPECT_EQ(completion.Await(kNever, In(60s)), Ending::kDone);

  EXPECT_EQ(completion.status(), Status::kFailed);
  EXPECT_FALSE(completion.TryTake());  // not available until it is freed
}

TEST(Completion, ACallAbandonedInTimeIsNeverStarted) {
  Completion<> completion;
  ASSERT_TRUE(completion.TryTake());

  EXPECT_EQ(completion.Await(kNever, In(1ms)), Ending::kNotStarted);

  EXPECT_FALSE(completion.TryTake());  // the server has not seen yet that the call was abandoned
  EXPECT_FALSE(completion.Start());
  EXPECT_TRUE(completion.TryTake());
}

TEST(Completion, ACallAbandonedTooLateIsFreedByTheServer) {
  Completion<> completion;
  ASSERT_TRUE(completion.TryTake());
  ASSERT_TRUE(completion.Start());

  EXPECT_EQ(completion.Await(kNever, In(1ms)), Ending::kStarted);

  EXPECT_FALSE(completion.TryTake());
  completion.Finish(Status::kDone);
  EXPECT_TRUE(completion.TryTake());
}

TEST(Completion, NotifiesTheListenerOfAnInterruption) {
  Completion<> completion;
  Wakeup<> listener;
  Flag is_interrupted;
  ASSERT_TRUE(completion.TryTake());
  completion.SetListener(listener);
  std::jthread stopping([&] {
    is_interrupted.Set(true);
    completion.Interrupt();
  });

  const SteadyTime deadline = In(60s);
  EXPECT_TRUE(listener.WaitUntil([&] { return is_interrupted.Get(); }, deadline));

  EXPECT_LT(StdAtomics::Now(), deadline) << "it was woken";
}

TEST(Completion, AnInterruptionEndsTheWait) {
  Completion<> completion;
  Flag interrupted;
  ASSERT_TRUE(completion.TryTake());
  std::jthread manager([&] {
    interrupted.Set(true);
    completion.Interrupt();
  });

  EXPECT_EQ(completion.Await([&] { return interrupted.Get(); }, In(60s)), Ending::kNotStarted);
}

}  // namespace
}  // namespace tendon
