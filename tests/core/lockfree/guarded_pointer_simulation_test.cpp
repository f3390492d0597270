#include <gtest/gtest.h>
#include <support/simulation/report_matchers.h>
#include <support/simulation/simulated_atomics.h>
#include <support/simulation/weakened_atomics.h>
#include <tendon/lockfree/guarded_pointer.h>
#include <tendon/lockfree/shared_guarded_pointer.h>

#include <array>
#include <memory>

namespace tendon::simulation {
namespace {

/// Two objects in plain memory. The replaced object is overwritten at once.
template <typename Guarded>
struct Replacement {
  using Object = Plain<int>;

  std::array<Object, 2> objects{Object(1), Object(1)};
  Guarded guarded{&objects[0]};

  void CallTwice() {
    for (int i = 0; i < 2; ++i) {
      const typename Guarded::Call call(guarded);
      if (call.get() != nullptr) Check(call.get()->Read() == 1, "the object was freed");
    }
  }
  void CallNested() {
    const typename Guarded::Call outer(guarded);
    { const typename Guarded::Call inner(guarded); }
    if (outer.get() != nullptr) Check(outer.get()->Read() == 1, "the object was freed");
  }
  void Replace() {
    guarded.Exchange(&objects[1])->Write(0);
    guarded.Exchange(nullptr)->Write(0);
  }
};

template <typename Atomics>
using Guarded = GuardedPointer<Plain<int>, Atomics>;
template <typename Atomics>
using SharedGuarded = SharedGuardedPointer<Plain<int>, Atomics>;

template <typename Guarded>
Report ExploreReplacement() {
  return Explore([](Scenario& scenario) {
    const auto shared = std::make_shared<Replacement<Guarded>>();
    scenario.Thread([=] {
      shared->CallTwice();
      shared->CallNested();
    });
    scenario.Thread([=] { shared->Replace(); });
  });
}

template <typename Guarded>
Report ExploreTwoCallers() {
  return Explore([](Scenario& scenario) {
    const auto shared = std::make_shared<Replacement<Guarded>>();
    scenario.Thread([=] { shared->CallNested(); });
    scenario.Thread([=] { shared->CallTwice(); });
    scenario.Thread([=] { shared->Replace(); });
  });
}

/// A pointer that its calling thread sets, to an object that another thread announces and
/// withdraws. A component admits its peer in this way.
template <typename Atomics>
struct Admission {
  Plain<int> object{1};
  GuardedPointer<Plain<int>, Atomics> announced{nullptr};
  GuardedPointer<Plain<int>, Atomics> admitted{nullptr};

  void Manage() {
    announced.Exchange(&object);
    announced.Exchange(nullptr);
    admitted.Exchange(nullptr);
    object.Write(0);
  }
  void AdmitAndCall() {
    for (int i = 0; i < 2; ++i) {
      {
        const typename GuardedPointer<Plain<int>, Atomics>::Call call(announced);
        if (call.get() != nullptr) admitted.SetByCaller(call.get());
      }
      const typename GuardedPointer<Plain<int>, Atomics>::Call call(admitted);
      if (call.get() != nullptr) Check(call.get()->Read() == 1, "the object was freed");
    }
  }
};

template <typename Atomics>
Report ExploreAdmission() {
  return Explore([](Scenario& scenario) {
    const auto shared = std::make_shared<Admission<Atomics>>();
    scenario.Thread([=] { shared->AdmitAndCall(); });
    scenario.Thread([=] { shared->Manage(); });
    scenario.Finally(
        [=] { Check(shared->admitted.Get() == nullptr, "nothing that was freed is left"); });
  });
}

TEST(GuardedPointerSimulation, ACallerAdmitsNoWithdrawnObject) {
  EXPECT_THAT(ExploreAdmission<SimulatedAtomics>(), Passes());
}

TEST(GuardedPointerSimulation, AdmissionNeedsTheProcessBarrier) {
  EXPECT_THAT(ExploreAdmission<WithoutProcessBarrier>(), FailsWith("races"));
}

TEST(GuardedPointerSimulation, NeverFreesAnObjectInUse) {
  EXPECT_THAT(ExploreReplacement<Guarded<SimulatedAtomics>>(), Passes(1000));
}

TEST(GuardedPointerSimulation, NeedsTheProcessBarrier) {
  EXPECT_THAT(ExploreReplacement<Guarded<WithoutProcessBarrier>>(), FailsWith("races"));
}

TEST(GuardedPointerSimulation, NeedsItsReleases) {
  EXPECT_THAT(ExploreReplacement<Guarded<WithoutRelease>>(), FailsWith("races"));
}

TEST(GuardedPointerSimulation, NeedsItsAcquires) {
  EXPECT_THAT(ExploreReplacement<Guarded<WithoutAcquire>>(), FailsWith("races"));
}

TEST(SharedGuardedPointerSimulation, NeverFreesAnObjectInUse) {
  EXPECT_THAT(ExploreTwoCallers<SharedGuarded<SimulatedAtomics>>(), Passes());
}

TEST(SharedGuardedPointerSimulation, NeedsItsFences) {
  using NoFullFence = WithoutFence<std::memory_order_seq_cst>;
  EXPECT_THAT(ExploreTwoCallers<SharedGuarded<NoFullFence>>(), FailsWith("races"));
}

TEST(SharedGuardedPointerSimulation, NeedsItsReleases) {
  EXPECT_THAT(ExploreTwoCallers<SharedGuarded<WithoutRelease>>(), FailsWith("races"));
}

TEST(SharedGuardedPointerSimulation, NeedsItsAcquires) {
  EXPECT_THAT(ExploreTwoCallers<SharedGuarded<WithoutAcquire>>(), FailsWith("races"));
}

}  // namespace
}  // namespace tendon::simulation
