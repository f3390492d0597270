#include <core/seeded/faults.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/lockfree/guarded_pointer.h>
#include <tendon/lockfree/shared_guarded_pointer.h>

#include <array>
#include <memory>

namespace tendon::seeded {
namespace {

using simulation::Check;
using testing::AnyOf;
using testing::HasSubstr;
using testing::IsEmpty;

/// A caller of an object in plain memory. The object is replaced, and overwritten at once.
template <typename Guarded>
struct Replacement {
  std::array<Plain<int>, 2> objects{Plain<int>(1), Plain<int>(1)};
  Guarded guarded{&objects[0]};

  void CallTwice() {
    for (int i = 0; i < 2; ++i) {
      const typename Guarded::Call call(guarded);
      if (call.get() != nullptr) Check(call.get()->Read() == 1, "the object was freed");
    }
  }
  void Replace() {
    guarded.Exchange(&objects[1])->Write(0);
    guarded.Exchange(nullptr)->Write(0);
  }
};

constexpr std::size_t kCaller = 1;
constexpr std::size_t kReplacer = 2;

template <typename Guarded>
simulation::Report ExploreReplacement(const Fault& fault) {
  return Explore(fault, [](simulation::Scenario& scenario) {
    const auto shared = std::make_shared<Replacement<Guarded>>();
    scenario.Thread([=] { shared->CallTwice(); });
    scenario.Thread([=] { shared->Replace(); });
  });
}

using Guarded = GuardedPointer<Plain<int>, SeededAtomics>;
using SharedGuarded = SharedGuardedPointer<Plain<int>, SeededAtomics>;

TEST(SeededRetireSimulation, PassesWithoutAFault) {
  for (const auto& explore : {ExploreReplacement<Guarded>, ExploreReplacement<SharedGuarded>}) {
    const auto report = explore(None());
    EXPECT_THAT(report.failure, IsEmpty());
    EXPECT_TRUE(report.is_complete);
    EXPECT_GT(report.executions, 100U);
  }
}

auto IsOfAFreedObject() { return AnyOf(HasSubstr("races"), HasSubstr("was freed")); }

class SeededRetireFaultSimulation : public testing::TestWithParam<Fault> {};

TEST_P(SeededRetireFaultSimulation, IsCaught) {
  EXPECT_THAT(ExploreReplacement<Guarded>(GetParam()).failure, IsOfAFreedObject());
}

constexpr MemoryModel::Location kInCall = 1;  // created after the pointer

INSTANTIATE_TEST_SUITE_P(
    , SeededRetireFaultSimulation,
    testing::Values(WithoutBarrier("NoProcessBarrier"),
                    Relaxed("EndOfACallDoesNotRelease", Step::kStore, kInCall, kCaller),
                    Relaxed("ReplacerDoesNotAcquire", Step::kLoad, kInCall, kReplacer),
                    WithoutCheck("ReplacerDoesNotWait", kInCall, kReplacer,
                                 [](std::uint64_t word) { return word & ~std::uint64_t{1}; })),
    NameOf());

class SeededSharedRetireFaultSimulation : public testing::TestWithParam<Fault> {};

TEST_P(SeededSharedRetireFaultSimulation, IsCaught) {
  EXPECT_THAT(ExploreReplacement<SharedGuarded>(GetParam()).failure, IsOfAFreedObject());
}

// The first place, created after the pointer and the choice.
constexpr MemoryModel::Location kRunning = 2;
constexpr auto kNobody = [](std::uint64_t /*calls*/) { return std::uint64_t{0}; };

INSTANTIATE_TEST_SUITE_P(
    , SeededSharedRetireFaultSimulation,
    testing::Values(WithoutFence("CallerHasNoFence", std::memory_order_seq_cst, kCaller),
                    WithoutFence("ReplacerHasNoFence", std::memory_order_seq_cst, kReplacer),
                    Relaxed("EndOfACallDoesNotRelease", Step::kSubtract, kRunning, kCaller),
                    WithoutCheck("ReplacerDoesNotWait", kRunning, kReplacer, kNobody)),
    NameOf());

}  // namespace
}  // namespace tendon::seeded
