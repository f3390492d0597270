#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "core/task/scripted.h"
#include "support/wait.h"

/// Tests the effects of a faulted component on its peers, and that a restart removes all of them.
namespace {

using tendon::ComponentState;
using tendon::ConnectionState;
using tendon::Status;
using tendon_test::Periodic;
using tendon_test::Script;
using testing::HasSubstr;
using namespace std::chrono_literals;

/// A client that uses calls, reads, events and waits.
class Peer final : public tendon::Component {
 public:
  explicit Peer(std::string name) : Component(std::move(name)) {
    auto& server = AddRequiredInterface("Server");
    server.AddFunction(poke, "Poke");
    server.AddFunction(get_runs, "GetRuns");
    server.AddEventWaiter(poked, "Poked");
    AddRequiredInterface("Record").AddFunction(recorded_runs, "Runs");
  }
  tendon::VoidFunction poke;
  tendon::ReadFunction<std::uint64_t> get_runs;
  tendon::EventWaiter<tendon::None> poked;
  tendon::ReadFunction<std::uint64_t> recorded_runs;
};

struct PeerCase {
  Script::Function function;
  const char* name;
};

struct FaultedTaskPeers : testing::TestWithParam<PeerCase> {
  tendon::LocalManager manager;
  Periodic& arm = manager.Add<Periodic>("arm", 1ms);
  Peer& peer = manager.Add<Peer>("peer");

  void SetUp() override {
    ASSERT_TRUE(manager.Connect({"peer", "Server"}, {"arm", "Control"}).ok());
    ASSERT_TRUE(manager.Connect({"peer", "Record"}, {"arm", "state"}).ok());
    ASSERT_TRUE(manager.StartAll().ok());
    std::uint64_t runs = 0;
    ASSERT_TRUE(EventuallyTrue([&] { return static_cast<bool>(peer.get_runs(runs)); }));
  }

  void Fault() {
    const Script::Function function = GetParam().function;
    if (function == Script::kConfigure || function == Script::kStartup) {
      arm.throws = Script::kRun;
      ASSERT_TRUE(manager.WaitFor("arm", ComponentState::kFaulted, 20s).ok());
      arm.throws = function;
      EXPECT_FALSE(manager.Start("arm").ok());
    }
    arm.throws = function;
    if (function == Script::kHandler) {
      EXPECT_EQ(peer.poke(), Status::kQueued);
    }
    if (function == Script::kCleanup) {
      EXPECT_FALSE(manager.Stop("arm").ok());
    }
    ASSERT_TRUE(manager.WaitFor("arm", ComponentState::kFaulted, 20s).ok());
  }
};

TEST_P(FaultedTaskPeers, GetAClearStatusAndNoStaleValue) {
  Fault();
  std::uint64_t runs = 0;

  EXPECT_EQ(peer.poke(), Status::kNotActive);
  EXPECT_EQ(peer.poke.Wait(20s), Status::kNotActive);
  EXPECT_EQ(peer.get_runs(runs), Status::kNotActive);
  EXPECT_EQ(peer.poked.Wait(20s), Status::kNotActive);
  EXPECT_FALSE(peer.poke.is_connected());

  EXPECT_EQ(peer.recorded_runs(runs), Status::kDone) << "its record stays readable";
}

TEST_P(FaultedTaskPeers, AreReconnectedAfterARestart) {
  Fault();
  arm.throws = Script::kNone;

  ASSERT_TRUE(manager.Start("arm").ok());

  EXPECT_TRUE(peer.poke.is_connected());
  peer.poked.Forget();
  EXPECT_EQ(peer.poke(), Status::kQueued);
  EXPECT_EQ(peer.poked.Wait(20s), Status::kDone);
  std::uint64_t runs = 0;
  EXPECT_EQ(peer.get_runs(runs), Status::kDone);
}

TEST_P(FaultedTaskPeers, AreListedAsPendingWithTheReason) {
  Fault();

  for (const auto& connection : manager.connections()) {
    EXPECT_EQ(connection.state, ConnectionState::kPending);
    EXPECT_EQ(connection.reason,
              "component 'arm' is faulted: " + arm.fault() +
                  "; the connection is made again when that component is started");
  }
  arm.throws = Script::kNone;
  ASSERT_TRUE(manager.Start("arm").ok());
  for (const auto& connection : manager.connections()) {
    EXPECT_EQ(connection.state, ConnectionState::kActive);
    EXPECT_EQ(connection.reason, "");
  }
}

INSTANTIATE_TEST_SUITE_P(InEachFunction, FaultedTaskPeers,
                         testing::Values(PeerCase{Script::kConfigure, "Configure"},
                                         PeerCase{Script::kStartup, "Startup"},
                                         PeerCase{Script::kRun, "Run"},
                                         PeerCase{Script::kHandler, "Handler"},
                                         PeerCase{Script::kCleanup, "Cleanup"}),
                         [](const auto& one) { return one.param.name; });

struct WaitingPeer : FaultedTaskPeers {};

TEST_P(WaitingPeer, IsReleasedAtOnce) {
  arm.blocks = Script::kRun;
  ASSERT_TRUE(EventuallyTrue([&] { return arm.is_blocked.load(); }));
  std::atomic<int> answered = 0;
  std::jthread caller([&] {
    EXPECT_EQ(peer.poke.Wait(1h), Status::kNotActive);
    ++answered;
  });
  std::jthread waiter([&] {
    EXPECT_EQ(peer.poked.Wait(1h), Status::kNotActive);
    ++answered;
  });

  arm.throws = Script::kRun;
  arm.blocks = Script::kNone;

  EXPECT_TRUE(EventuallyTrue([&] { return answered == 2; }));
}

INSTANTIATE_TEST_SUITE_P(, WaitingPeer, testing::Values(PeerCase{Script::kRun, "Run"}),
                         [](const auto& one) { return one.param.name; });

TEST(Restart, RestoresTheConnectionsAThousandTimes) {
  tendon::LocalManager manager;
  auto& arm = manager.Add<Periodic>("arm", 10us);
  auto& peer = manager.Add<Peer>("peer");
  ASSERT_TRUE(manager.Connect({"peer", "Server"}, {"arm", "Control"}).ok());

  for (int i = 0; i < 1000; ++i) {
    arm.throws = Script::kNone;
    ASSERT_TRUE(manager.Start("arm").ok()) << "time " << i;
    peer.poked.Forget();
    ASSERT_EQ(peer.poke(), Status::kQueued) << "time " << i;
    ASSERT_EQ(peer.poked.Wait(20s), Status::kDone) << "time " << i;
    arm.throws = i % 2 == 0 ? Script::kRun : Script::kHandler;
    (void)peer.poke();
    ASSERT_TRUE(manager.WaitFor("arm", ComponentState::kFaulted, 20s).ok()) << "time " << i;
    ASSERT_EQ(peer.poke(), Status::kNotActive) << "time " << i;
  }

  EXPECT_EQ(manager.connections().size(), 1U);
}

TEST(FaultedPeer, CanBeConnectedAndWorksAfterItsStart) {
  tendon::LocalManager manager;
  auto& arm = manager.Add<Periodic>("arm", 1ms);
  auto& peer = manager.Add<Peer>("peer");
  arm.throws = Script::kStartup;
  ASSERT_FALSE(manager.Start("arm").ok());

  ASSERT_TRUE(manager.Connect({"peer", "Server"}, {"arm", "Control"}).ok());

  EXPECT_EQ(peer.poke(), Status::kNotActive);
  EXPECT_EQ(peer.poked.Wait(20s), Status::kNotActive);
  arm.throws = Script::kNone;
  ASSERT_TRUE(manager.Start("arm").ok());
  EXPECT_EQ(peer.poke(), Status::kQueued);
  EXPECT_EQ(peer.poked.Wait(20s), Status::kDone);
}

}  // namespace
