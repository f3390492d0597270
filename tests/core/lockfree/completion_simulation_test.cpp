#include <gtest/gtest.h>
#include <support/simulation/report_matchers.h>
#include <support/simulation/simulated_atomics.h>
#include <support/simulation/weakened_atomics.h>
#include <tendon/lockfree/completion.h>
#include <tendon/lockfree/flag.h>

#include <memory>

namespace tendon::simulation {
namespace {

/// A call with a result in plain memory, and the next call with the same record. The caller may
/// give up the first call at any moment.
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
    if (completion.TryTake()) result.Write(0);  // the next caller writes here
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

TEST(CompletionSimulation, EndsOnceInEveryInterleaving) {
  EXPECT_THAT(ExploreCall<SimulatedAtomics>(), Passes(1000));
}

TEST(CompletionSimulation, NeedsItsReleases) {
  EXPECT_THAT(ExploreCall<WithoutRelease>(), FailsWith("races"));
}

TEST(CompletionSimulation, NeedsItsAcquires) {
  EXPECT_THAT(ExploreCall<WithoutAcquire>(), FailsWith("races"));
}

}  // namespace
}  // namespace tendon::simulation
