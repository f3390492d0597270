#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/simulation/simulated_atomics.h>
#include <support/simulation/weakened_atomics.h>
#include <tendon/lockfree/completion.h>
#include <tendon/lockfree/flag.h>

#include <chrono>
#include <memory>
#include <thread>

namespace tendon {
namespace {

using namespace std::chrono_literals;
using simulation::Check;
using simulation::Explore;
using simulation::Report;
using simulation::Scenario;
using testing::HasSubstr;
using testing::IsEmpty;
using Ending = Completion<>::Ending;

constexpr auto kNever = [] { return false; };

SteadyTime In(std::chrono::nanoseconds time) { return StdAtomics::Now() + time; }

TEST(Completion, IsTakenByOne) {
  Completion<> completion;

  EXPECT_TRUE(completion.TryTake());
  EXPECT_FALSE(completion.TryTake());
  completion.Free();

  EXPECT_TRUE(completion.TryTake());
}

TEST(Completion, AnExecutedCallEndsTheWait) {
  Completion<> completion;
  ASSERT_TRUE(completion.TryTake());
  std::jthread server([&] {
    ASSERT_TRUE(completion.Start());
    completion.Finish(Status::kFailed);
  });

  EXPECT_EQ(completion.Await(kNever, In(60s)), Ending::kDone);

  EXPECT_EQ(completion.status(), Status::kFailed);
  EXPECT_FALSE(completion.TryTake());  // until it is freed
}

TEST(Completion, ACallAbandonedInTimeIsNeverStarted) {
  Completion<> completion;
  ASSERT_TRUE(completion.TryTake());

  EXPECT_EQ(completion.Await(kNever, In(1ms)), Ending::kNotStarted);

  EXPECT_FALSE(completion.TryTake());  // the server has not seen it yet
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

/// A call with a result in ordinary memory, and the next call with the same record; the first may
/// be interrupted at any moment.
template <typename Atomics>
struct Call {
  using End = typename Completion<Atomics>::Ending;

  Completion<Atomics> completion;
  Published<bool, Atomics> posted{false};
  Published<bool, Atomics> interrupted{false};
  Plain<int> result{0};
  bool is_dropped = false;
  bool is_executed = false;

  void Wait() {
    Check(completion.TryTake(), "a fresh one is free");
    posted.Set(true);
    const End end = completion.Await([this] { return interrupted.Get(); }, SteadyTime::max());
    if (end == End::kDone) {
      Check(result.Read() == 1, "done without its result");
      completion.Free();
    }
    is_dropped = end == End::kNotStarted;
    if (completion.TryTake()) result.Write(0);  // the next caller's
  }
  void Serve() {
    for (unsigned looks = 0; !posted.Get(); ++looks) Atomics::Pause(looks);
    if (!completion.Start()) return;
    is_executed = true;
    result.Write(1);
    completion.Finish(Status::kDone);
  }
  void Interrupt() {
    interrupted.Set(true);
    completion.Interrupt();
  }
};

template <typename Atomics>
Report ExploreCall() {
  return Explore([](Scenario& scenario) {
    const auto call = std::make_shared<Call<Atomics>>();
    scenario.Thread([=] { call->Wait(); });
    scenario.Thread([=] { call->Serve(); });
    scenario.Thread([=] { call->Interrupt(); });
    scenario.Finally(
        [=] { Check(call->is_executed != call->is_dropped, "executed, or dropped, never both"); });
  });
}

TEST(CompletionSimulation, EndsOnceWhoeverIsFirst) {
  const Report report = ExploreCall<SimulatedAtomics>();
  EXPECT_THAT(report.failure, IsEmpty());
  EXPECT_TRUE(report.is_complete);
  EXPECT_GT(report.executions, 1000U);
}

TEST(CompletionSimulation, NeedsItsReleases) {
  EXPECT_THAT(ExploreCall<WithoutRelease>().failure, HasSubstr("races"));
}

TEST(CompletionSimulation, NeedsItsAcquires) {
  EXPECT_THAT(ExploreCall<WithoutAcquire>().failure, HasSubstr("races"));
}

}  // namespace
}  // namespace tendon
