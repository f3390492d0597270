#include "core/parity/pair.h"

namespace tendon_test {
namespace {

using tendon::ComponentState;
using tendon::kNoWait;
using tendon::Status;

/// The lifecycle of every kind of component.
struct Lifecycle : AnyServer {
  tendon::LocalManager& manager = pair.manager;
  [[nodiscard]] ComponentState state() const { return pair.server.component().state(); }
};

TEST_P(Lifecycle, ChangesWithAndWithoutWaiting) {
  ASSERT_TRUE(manager.Suspend("server").ok());
  EXPECT_EQ(state(), ComponentState::kSuspended);
  ASSERT_TRUE(manager.Start("server").ok());
  EXPECT_EQ(state(), ComponentState::kActive);
  ASSERT_TRUE(manager.Suspend("server", kNoWait).ok());
  ASSERT_TRUE(manager.WaitFor("server", ComponentState::kSuspended, kLong).ok());
  ASSERT_TRUE(manager.Start("server", kNoWait).ok());
  ASSERT_TRUE(manager.WaitFor("server", ComponentState::kActive, kLong).ok());
  ASSERT_TRUE(manager.Stop("server", kNoWait).ok());
  ASSERT_TRUE(manager.WaitFor("server", ComponentState::kFinished, kLong).ok());
  ASSERT_TRUE(manager.Start("server").ok());
  ASSERT_TRUE(manager.Stop("server").ok());
  EXPECT_EQ(state(), ComponentState::kFinished);
}

TEST_P(Lifecycle, AWaitForAStateEndsAtItsDeadline) {
  const auto waited = manager.WaitFor("server", ComponentState::kSuspended, kNoWait);

  ASSERT_FALSE(waited.ok());
  EXPECT_EQ(waited.error().code, tendon::ErrorCode::kTimeout);
}

TEST_P(Lifecycle, ChangesForAllTogether) {
  ASSERT_TRUE(manager.SuspendAll().ok());
  EXPECT_TRUE(manager.WaitForAll(ComponentState::kSuspended, kLong).ok());
  ASSERT_TRUE(manager.StartAll().ok());
  EXPECT_TRUE(manager.WaitForAll(ComponentState::kActive, kLong).ok());
  ASSERT_TRUE(manager.StopAll().ok());
  EXPECT_TRUE(manager.WaitForAll(ComponentState::kFinished, kLong).ok());
}

TEST_P(Lifecycle, CyclesRunInOneOwnOrLentThread) {
  if (GetParam() == Kind::kThreadless) {
    EXPECT_EQ(pair.server.runs, 0U);
    return;
  }
  std::thread::id first;
  pair.OnceInServer([&] { first = pair.server.run_thread; });
  for (int i = 0; i < 3; ++i) {
    pair.OnceInServer([&] {
      EXPECT_EQ(pair.server.run_thread, first);
      EXPECT_EQ(std::this_thread::get_id(), first);
    });
  }
  EXPECT_NE(first, std::this_thread::get_id());
}

INSTANTIATE_TEST_SUITE_P(Parity, Lifecycle, testing::ValuesIn(AllKinds()), NameOfKind);

/// The lifecycle of a server as its client sees it.
struct ServerLifecycle : AnyPair {
  tendon::LocalManager& manager = pair.manager;

  void ExpectService(int seed) {
    pair.InClient([&](auto& port) {
      using P = PayloadIn<decltype(port)>;
      EXPECT_EQ(port.write.Wait(Sample<P>(seed), kLong), Status::kDone);
    });
    pair.InServer([&](auto& port) {
      ASSERT_FALSE(port.received.empty());
      EXPECT_TRUE(IsSample(port.received.back(), seed));
    });
  }
  void ExpectRefusal(Status status) {
    pair.InClient([&](auto& port) {
      using P = PayloadIn<decltype(port)>;
      P value;
      EXPECT_EQ(port.write(Sample<P>(1)), status);
      EXPECT_EQ(port.write.Wait(Sample<P>(1), kLong), status);
      EXPECT_EQ(port.take.Wait(value, kLong), status);
    });
  }
};

TEST_P(ServerLifecycle, RefusesWhileSuspendedAndServesAfterResuming) {
  ExpectService(1);
  ASSERT_TRUE(manager.Suspend("server").ok());
  ExpectRefusal(Status::kNotActive);

  ASSERT_TRUE(manager.Start("server").ok());
  ExpectService(2);
}

TEST_P(ServerLifecycle, RefusesWhileStoppedAndServesAfterARestart) {
  ASSERT_TRUE(manager.Stop("server").ok());
  ExpectRefusal(Status::kNotActive);

  ASSERT_TRUE(manager.Start("server").ok());
  ExpectService(2);
}

TEST_P(ServerLifecycle, RemovalKeepsItsClientRunning) {
  ExpectService(1);

  pair.Remove(pair.server);

  ExpectRefusal(Status::kNotConnected);
  EXPECT_EQ(pair.client.component().state(), ComponentState::kActive);
}

TEST_P(ServerLifecycle, RemovingAClientKeepsItRunning) {
  ExpectService(1);

  pair.Remove(pair.client);

  pair.InServer([](auto& port) {
    using P = PayloadIn<decltype(port)>;
    port.reached(Sample<P>(1));
    EXPECT_EQ(port.reached.lost(), 0U);
    EXPECT_EQ(port.received.size(), 1U);
  });
}

INSTANTIATE_TEST_SUITE_P(Parity, ServerLifecycle, AllPairs(), NameOfPair);

}  // namespace
}  // namespace tendon_test
