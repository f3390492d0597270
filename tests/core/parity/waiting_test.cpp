#include "core/parity/two_processes.h"

namespace tendon_test {
namespace {

using tendon::Status;
using namespace std::chrono_literals;

/// Calls with a deadline that wait for the execution.
using Waiting = AnyPlacedPair;

TEST_P(Waiting, ReturnsAfterTheServerHasExecutedTheCall) {
  pair.InClient([&](auto& port) {
    using P = PayloadIn<decltype(port)>;
    for (int i = 1; i <= 3; ++i) {
      EXPECT_EQ(port.write.Wait(Sample<P>(i), kLong), Status::kDone);
      EXPECT_EQ(port.reset.Wait(kLong), Status::kDone);
      EXPECT_EQ(port.keep.Wait(Sample<P>(i), kLong), Status::kDone);
      EXPECT_EQ(port.write_filtered.Wait(Sample<P>(i), kLong), Status::kDone);
      std::int32_t executed = 0;
      EXPECT_EQ(port.count(executed), Status::kDone);
      EXPECT_EQ(executed, 4 * i);
    }
  });

  pair.InServer([&](auto& port) {
    ASSERT_EQ(port.received.size(), 3U);
    EXPECT_TRUE(IsSample(port.received[2], 3));
    EXPECT_EQ(port.kept.size(), 3U);
  });
}

INSTANTIATE_TEST_SUITE_P(Parity, Waiting, AllPairsInOneProcess(), NameOfPlacedPair);
INSTANTIATE_TEST_SUITE_P(RemoteParity, Waiting, testing::ValuesIn(RemotePairs()), NameOfPlacedPair);

/// Servers with a thread, which can be busy.
using BusyServer = AnyPair;

TEST_P(BusyServer, ACallNotStartedByItsDeadlineIsNeverExecuted) {
  pair.HoldServer();

  pair.InClient([&](auto& port) {
    using P = PayloadIn<decltype(port)>;
    P value = Sample<P>(4);
    EXPECT_EQ(port.write.Wait(value, 100us), Status::kTimeout);
    EXPECT_EQ(port.take.Wait(value, 100us), Status::kTimeout);
    EXPECT_EQ(port.swap.Wait(Sample<P>(5), value, 100us), Status::kTimeout);
    EXPECT_TRUE(IsSample(value, 4));
  });

  pair.Release();
  pair.InServer([&](auto& port) { EXPECT_EQ(port.executed, 0); });
}

TEST_P(BusyServer, ACallStartedByItsDeadlineHasAnUnknownOutcome) {
  auto& server = std::get<ServerPort<Scan>>(pair.server.ports);
  pair.OnceInClient([&] {
    auto& client = std::get<ClientPort<Scan>>(pair.client.ports);
    Status outcome = Status::kTimeout;
    // Repeats until a deadline passes after the start of the command.
    EXPECT_TRUE(EventuallyTrue([&] {
      outcome = client.block.Wait(1ms);
      return outcome != Status::kTimeout;
    }));
    EXPECT_EQ(outcome, Status::kOutcomeUnknown);
  });
  EXPECT_TRUE(EventuallyTrue([&] { return bool(server.is_blocked); }));

  pair.Release();
  pair.OnceInServer([&] { EXPECT_EQ(server.executed, 1); });
}

INSTANTIATE_TEST_SUITE_P(Parity, BusyServer,
                         testing::Combine(testing::ValuesIn(AllKinds()),
                                          testing::ValuesIn(TaskKinds())),
                         NameOfPair);

/// Two tasks in one thread.
TEST(WaitInOwnThread, IsRefusedAtOnce) {
  Pair pair(Kind::kSignal, Kind::kPeriodic);
  ASSERT_TRUE(pair.manager.Stop("client").ok());
  ASSERT_TRUE(pair.manager.RunAfter("client", "server").ok());
  ASSERT_TRUE(pair.manager.Start("client").ok());

  pair.InClient([&](auto& port) {
    using P = PayloadIn<decltype(port)>;
    P value;
    EXPECT_EQ(port.reset.Wait(kLong), Status::kWouldDeadlock);
    EXPECT_EQ(port.write.Wait(Sample<P>(1), kLong), Status::kWouldDeadlock);
    EXPECT_EQ(port.take.Wait(value, kLong), Status::kWouldDeadlock);
    EXPECT_EQ(port.write(Sample<P>(2)), Status::kQueued);
  });

  pair.InServer([&](auto& port) {
    ASSERT_EQ(port.received.size(), 1U);
    EXPECT_TRUE(IsSample(port.received[0], 2));
  });
}

}  // namespace
}  // namespace tendon_test
