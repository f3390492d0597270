#include <core/seeded/faults.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/lockfree/ready_flag.h>
#include <tendon/lockfree/wakeup.h>

#include <array>
#include <memory>

namespace tendon::seeded {
namespace {

using simulation::Check;
using testing::HasSubstr;
using testing::IsEmpty;

using Flag = ReadyFlag<SeededAtomics>;

/// Producers that each publish items under one flag, and a consumer that takes them all; it looks
/// nowhere as long as the flag is down.
template <std::size_t kProducers>
struct Delivery {
  static constexpr int kItems = 3 - static_cast<int>(kProducers);  // few: every order is tried
  static constexpr int kAll = kItems * static_cast<int>(kProducers);

  Flag ready;
  Wakeup<SeededAtomics> wakeup;
  std::array<SeededAtomics::Atomic<int>, kProducers> published;
  std::array<int, kProducers> taken{};  // of the consumer, as the rest
  int sum = 0;

  void Produce(std::size_t producer, Wakeup<SeededAtomics>* sleeper) {
    for (int item = 1; item <= kItems; ++item) {
      published[producer].store(item, std::memory_order_release);
      ready.Raise(sleeper);
    }
  }
  bool HasItems() {
    for (std::size_t i = 0; i < kProducers; ++i) {
      if (published[i].load(std::memory_order_acquire) > taken[i]) return true;
    }
    return false;
  }
  void Take() {
    for (std::size_t i = 0; i < kProducers; ++i) {
      const int items = published[i].load(std::memory_order_acquire);
      sum += items - taken[i];
      taken[i] = items;
    }
  }
  bool IsReady(Flag::IfEmpty if_empty) {
    return ready.IsReady([this] { return HasItems(); }, if_empty);
  }
  void ConsumeAwake() {
    for (unsigned looks = 0; sum < kAll; ++looks) {
      if (IsReady(Flag::IfEmpty::kLower)) {
        Take();
      } else {
        SeededAtomics::Pause(looks);
      }
    }
  }
  /// Lowers the flag before it goes to sleep, as a task does after a cycle without calls.
  void ConsumeAsleep() {
    while (sum < kAll) {
      if (IsReady(Flag::IfEmpty::kLower)) {
        Take();
        continue;
      }
      const auto is_ready = [this] { return IsReady(Flag::IfEmpty::kLeaveUp); };
      Check(wakeup.WaitUntil(is_ready, SteadyTime::max()), "gave up");
    }
  }
};

template <std::size_t kProducers>
simulation::Report ExploreAwake(const Fault& fault) {
  return Explore(fault, [](simulation::Scenario& scenario) {
    const auto delivery = std::make_shared<Delivery<kProducers>>();
    for (std::size_t i = 0; i < kProducers; ++i) {
      scenario.Thread([=] { delivery->Produce(i, nullptr); });
    }
    scenario.Thread([=] { delivery->ConsumeAwake(); });
  });
}

simulation::Report ExploreAsleep(const Fault& fault) {
  return Explore(fault, [](simulation::Scenario& scenario) {
    const auto delivery = std::make_shared<Delivery<1>>();
    scenario.Thread([=] { delivery->Produce(0, &delivery->wakeup); });
    scenario.Thread([=] { delivery->ConsumeAsleep(); });
  });
}

constexpr std::size_t kSender = 1;
constexpr std::size_t kReceiver = 2;

TEST(SeededReadySimulation, PassesWithoutAFault) {
  for (const auto& explore : {ExploreAwake<1>, ExploreAwake<2>, ExploreAsleep}) {
    const auto report = explore(None());
    EXPECT_THAT(report.failure, IsEmpty());
    EXPECT_TRUE(report.is_complete);
    EXPECT_GT(report.executions, 100U);
  }
}

class SeededReadyFaultSimulation : public testing::TestWithParam<Fault> {};

TEST_P(SeededReadyFaultSimulation, IsCaught) {
  EXPECT_THAT(ExploreAwake<1>(GetParam()).failure, HasSubstr("every thread waits"));
}

INSTANTIATE_TEST_SUITE_P(
    , SeededReadyFaultSimulation,
    testing::Values(WithoutFence("ProducerHasNoFence", std::memory_order_seq_cst, kSender),
                    WithoutFence("ConsumerHasNoFence", std::memory_order_seq_cst, kReceiver),
                    WithoutCheckAfterFence("ConsumerDoesNotLookAgain", kReceiver, 0)),
    NameOf());

/// It needs the fence that stands after the flag was raised, not only the one before: here that of
/// the last item, which nothing follows.
TEST(SeededSleepingConsumerSimulation, MissesAFlagRaisedTooLate) {
  constexpr std::size_t kLast = 3;  // two for an item that finds the flag down
  const auto report = ExploreAsleep(WithoutOneFence("NoFence", kSender, kLast));
  EXPECT_THAT(report.failure, HasSubstr("every thread waits"));
}

}  // namespace
}  // namespace tendon::seeded
