#include <core/lockfree/ring_transfer.h>
#include <core/seeded/faults.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

namespace tendon::seeded {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::size_t kProducer = 1;
constexpr std::size_t kConsumer = 2;
// The indices of the ring, in the order of their creation.
constexpr MemoryModel::Location kWrite = 0;
constexpr MemoryModel::Location kRead = 1;

using Transfer = simulation::RingTransfer<SeededAtomics>;

simulation::Report ExploreTransfer(const Fault& fault) {
  return Explore(fault, [](simulation::Scenario& scenario) {
    const auto transfer = std::make_shared<Transfer>();
    scenario.Thread([=] { transfer->Produce(); });
    scenario.Thread([=] { transfer->Consume(); });
  });
}

TEST(SeededQueueSimulation, PassesWithoutAFault) {
  const auto report = ExploreTransfer(None());
  EXPECT_THAT(report.failure, IsEmpty());
  EXPECT_TRUE(report.is_complete);
  EXPECT_GT(report.executions, 1000U);
}

class SeededQueueFaultSimulation : public testing::TestWithParam<Fault> {};

TEST_P(SeededQueueFaultSimulation, IsCaught) {
  EXPECT_THAT(ExploreTransfer(GetParam()).failure,
              AnyOf(HasSubstr("races"), HasSubstr("a message is lost")));
}

constexpr auto kOneMore = [](std::uint64_t index) { return index + 1; };

INSTANTIATE_TEST_SUITE_P(
    , SeededQueueFaultSimulation,
    testing::Values(Relaxed("PublishDoesNotRelease", Step::kStore, kWrite),
                    Relaxed("ReleaseOfASlotDoesNotRelease", Step::kStore, kRead),
                    Relaxed("ConsumerDoesNotAcquire", Step::kLoad, kWrite, kConsumer),
                    Relaxed("ProducerDoesNotAcquire", Step::kLoad, kRead, kProducer),
                    WithoutCheck("FullCheckLetsOneMorePass", kRead, kProducer, kOneMore),
                    WithoutCheck("EmptyCheckLetsOneMorePass", kWrite, kConsumer, kOneMore)),
    NameOf());

}  // namespace
}  // namespace tendon::seeded
