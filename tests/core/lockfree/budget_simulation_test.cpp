#include <gtest/gtest.h>
#include <support/simulation/report_matchers.h>
#include <support/simulation/simulated_atomics.h>
#include <tendon/lockfree/budget.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace tendon::simulation {
namespace {

/// Two threads that each take a part of the budget and give it back.
struct Shared {
  Budget<SimulatedAtomics> budget{3};

  void TakeAndGive(std::uint64_t n) {
    for (int times = 0; times < 2; ++times) {
      if (budget.Take(n)) budget.Give(n);
    }
  }
};

TEST(BudgetSimulation, IsCompleteAfterAnyInterleaving) {
  const Report report = Explore([](Scenario& scenario) {
    const auto shared = std::make_shared<Shared>();
    scenario.Thread([=] { shared->TakeAndGive(1); });
    scenario.Thread([=] { shared->TakeAndGive(3); });
    scenario.Finally([=] {
      Check(shared->budget.Take(3), "something was not given back");
      Check(!shared->budget.Take(1), "more was given back than was taken");
    });
  });

  EXPECT_THAT(report, Passes(20));
}

/// The threads give nothing back, so both parts fit, or one thread is refused.
TEST(BudgetSimulation, NeverGrantsMoreThanItsTotal) {
  const Report report = Explore([](Scenario& scenario) {
    const auto shared = std::make_shared<Shared>();
    const auto taken = std::make_shared<std::array<bool, 2>>();
    for (std::size_t i = 0; i < 2; ++i) {
      scenario.Thread([=] { taken->at(i) = shared->budget.Take(2); });
    }
    scenario.Finally([=] { Check(!(taken->at(0) && taken->at(1)), "both have 2 of 3"); });
  });

  EXPECT_THAT(report, Passes(2));
}

}  // namespace
}  // namespace tendon::simulation
