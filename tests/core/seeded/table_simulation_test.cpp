#include <core/seeded/faults.h>
#include <core/state/tick_rows.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

namespace tendon::seeded {
namespace {

using simulation::Check;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::size_t kReader = 2;
constexpr MemoryModel::Location kNext = 0;  // the index of the next row is created first

using Table = tendon_test::TickRows<SeededAtomics>;

/// Reads the newest row while the writer writes.
simulation::Report ExploreNewest(const Fault& fault) {
  return Explore(fault, [](simulation::Scenario& scenario) {
    const auto table = std::make_shared<Table>();
    table->Write(0);
    scenario.Thread([=] {
      for (std::uint64_t tick = 1; tick <= 3; ++tick) table->Write(tick);
    });
    scenario.Thread([=] {
      Table::Words words{};
      std::uint64_t tick = 0;
      if (table->ring.ReadNewest(tick, Table::Into(words)) != RowResult::kDone) return;
      Check(words[0] == tick && words[1] == tick, "a torn row passed");
    });
  });
}

/// Reads a row that the writer is about to replace.
simulation::Report ExploreReplaced(const Fault& fault) {
  return Explore(fault, [](simulation::Scenario& scenario) {
    const auto table = std::make_shared<Table>();
    table->Write(0);
    table->Write(1);
    scenario.Thread([=] {
      for (std::uint64_t tick = 2; tick <= 4; ++tick) table->Write(tick);
    });
    scenario.Thread([=] {
      Table::Words words{};
      if (table->ring.Read(1, Table::Into(words)) != RowResult::kDone) return;
      Check(words[0] == 1 && words[1] == 1, "a torn row passed");
    });
  });
}

TEST(SeededTableSimulation, PassesWithoutAFault) {
  for (const auto& explore : {ExploreNewest, ExploreReplaced}) {
    const auto report = explore(None());
    EXPECT_THAT(report.failure, IsEmpty());
    EXPECT_TRUE(report.is_complete);
    EXPECT_GT(report.executions, 100U);
  }
}

class SeededNewestRowFaultSimulation : public testing::TestWithParam<Fault> {};

TEST_P(SeededNewestRowFaultSimulation, IsCaught) {
  EXPECT_THAT(ExploreNewest(GetParam()).failure, HasSubstr("torn"));
}

INSTANTIATE_TEST_SUITE_P(, SeededNewestRowFaultSimulation,
                         testing::Values(Relaxed("PublishDoesNotRelease", Step::kStore, kNext),
                                         Relaxed("ReaderDoesNotAcquire", Step::kLoad, kNext,
                                                 kReader)),
                         NameOf());

class SeededReplacedRowFaultSimulation : public testing::TestWithParam<Fault> {};

TEST_P(SeededReplacedRowFaultSimulation, IsCaught) {
  EXPECT_THAT(ExploreReplaced(GetParam()).failure, HasSubstr("torn"));
}

INSTANTIATE_TEST_SUITE_P(
    , SeededReplacedRowFaultSimulation,
    testing::Values(WithoutFence("WriterHasNoFence", std::memory_order_release),
                    WithoutFence("ReaderHasNoFence", std::memory_order_acquire),
                    WithoutCheckAfterFence("ReaderDoesNotCheckTheTick", kReader, 1)),
    NameOf());

}  // namespace
}  // namespace tendon::seeded
