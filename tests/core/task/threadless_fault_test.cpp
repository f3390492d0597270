#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "core/task/scripted.h"
#include "support/wait.h"

/// Tests of components without a thread: which code runs in the threads of their peers, and when.
namespace {

using tendon::ComponentState;
using tendon::EventWaiter;
using tendon::Need;
using tendon::Status;
using tendon_test::Client;
using tendon_test::Periodic;
using tendon_test::Script;
using tendon_test::Signal;
using tendon_test::Threadless;
using namespace std::chrono_literals;

struct ThreadlessServer : testing::Test {
  tendon::LocalManager manager;
  Threadless& arm = manager.Add<Threadless>("arm");
  Periodic& bystander = manager.Add<Periodic>("bystander", 1ms);
  Client& client = manager.Add<Client>("client");

  void SetUp() override {
    ASSERT_TRUE(manager.Connect({"client", "Server"}, {"arm", "Control"}).ok());
    ASSERT_TRUE(manager.Start("bystander").ok());
  }
};

TEST_F(ThreadlessServer, TakesCallsOnlyWhileItIsActive) {
  EXPECT_EQ(client.poke(), Status::kNotActive);
  ASSERT_TRUE(manager.Start("arm").ok());
  EXPECT_EQ(client.poke(), Status::kDone);
  ASSERT_TRUE(manager.Suspend("arm").ok());
  EXPECT_EQ(client.poke(), Status::kNotActive);
  ASSERT_TRUE(manager.Start("arm").ok());
  EXPECT_EQ(client.poke.Wait(1s), Status::kDone);
  ASSERT_TRUE(manager.Stop("arm").ok());
  EXPECT_EQ(client.poke.Wait(1s), Status::kNotActive);

  EXPECT_EQ(arm.pokes, 2);
}

TEST_F(ThreadlessServer, AThrowingHandlerFaultsIt) {
  ASSERT_TRUE(manager.Start("arm").ok());
  arm.throws = Script::kHandler;

  EXPECT_EQ(client.poke(), Status::kFailed);

  EXPECT_EQ(arm.state(), ComponentState::kFaulted);
  EXPECT_EQ(arm.fault(), "a command or event handler: cable cut");
  EXPECT_EQ(client.poke(), Status::kNotActive);
  EXPECT_EQ(arm.pokes, 1);
  EXPECT_EQ(bystander.state(), ComponentState::kActive);
  EXPECT_EQ(arm.cleanups, 0);
}

TEST_F(ThreadlessServer, ANonStandardExceptionFaultsIt) {
  ASSERT_TRUE(manager.Start("arm").ok());
  arm.throws_a_number = true;
  arm.throws = Script::kHandler;

  EXPECT_EQ(client.poke(), Status::kFailed);

  EXPECT_EQ(arm.fault(),
            "a command or event handler: an exception that does not derive from std::exception");
}

TEST_F(ThreadlessServer, NamesTheNestedCausesOfItsFault) {
  ASSERT_TRUE(manager.Start("arm").ok());
  arm.throws_nested = true;
  arm.throws = Script::kHandler;

  EXPECT_EQ(client.poke(), Status::kFailed);

  EXPECT_EQ(arm.fault(), "a command or event handler: no arm: cable cut");
}

TEST_F(ThreadlessServer, ARestartClearsItsFault) {
  ASSERT_TRUE(manager.Start("arm").ok());
  arm.throws = Script::kHandler;
  EXPECT_EQ(client.poke(), Status::kFailed);
  arm.throws = Script::kNone;

  ASSERT_TRUE(manager.Start("arm").ok());

  EXPECT_EQ(client.poke(), Status::kDone);
  EXPECT_EQ(arm.fault(), "");
  EXPECT_EQ(arm.configures, 2);
}

TEST_F(ThreadlessServer, RefusesCallsOnceItsCleanupStarts) {
  ASSERT_TRUE(manager.Start("arm").ok());
  arm.blocks = Script::kCleanup;
  std::jthread stopping([this] { (void)manager.Stop("arm", tendon::kNoWait); });
  const bool is_blocked = EventuallyTrue([this] { return arm.is_blocked.load(); });

  EXPECT_EQ(client.poke(), Status::kNotActive);

  arm.blocks = Script::kNone;
  EXPECT_TRUE(is_blocked);
  EXPECT_EQ(arm.pokes, 0);
}

/// A component with a call that runs during the stop, and that fails while Cleanup() runs.
class FailsLate final : public tendon::Component {
 public:
  explicit FailsLate(std::string name) : Component(std::move(name)) {
    AddProvidedInterface("Control").AddCommandVoid(&FailsLate::Poke, this, "Poke");
  }
  std::atomic<bool> is_poked = false;
  std::atomic<bool> has_failed = false;

 private:
  void Poke() {
    is_poked = true;
    EXPECT_TRUE(EventuallyTrue([this] { return cleans_up_.load(); }));
    throw std::runtime_error("cable cut");
  }
  void Cleanup() override {
    cleans_up_ = true;
    EXPECT_TRUE(EventuallyTrue([this] { return has_failed.load(); }));
  }
  std::atomic<bool> cleans_up_ = false;
};

TEST(ThreadlessComponent, AFaultDuringAStopPersists) {
  tendon::LocalManager manager;
  auto& arm = manager.Add<FailsLate>("arm");
  auto& client = manager.Add<Client>("client");
  ASSERT_TRUE(manager.Connect({"client", "Server"}, {"arm", "Control"}).ok());
  ASSERT_TRUE(manager.StartAll().ok());
  std::jthread caller([&] {
    EXPECT_EQ(client.poke(), Status::kFailed);
    arm.has_failed = true;
  });
  ASSERT_TRUE(EventuallyTrue([&] { return arm.is_poked.load(); }));

  EXPECT_FALSE(manager.Stop("arm").ok());

  EXPECT_EQ(arm.state(), ComponentState::kFaulted);
}

/// Handles the event of a component in every possible way.
class Listener final : public tendon::Component {
 public:
  Listener(std::string name, bool directly) : Component(std::move(name)) {
    auto& source = AddRequiredInterface("Source");
    if (directly) {
      source.AddEventHandlerVoid(&Listener::OnPoked, this, "Poked", tendon::kThreadSafe);
    } else {
      source.AddEventHandlerVoid(&Listener::OnPoked, this, "Poked");
    }
  }
  std::atomic<int> heard = 0;
  std::atomic<bool> throws = false;
  [[nodiscard]] const tendon::RequiredInterface& source() const { return *FindRequired("Source"); }

 private:
  void OnPoked() {
    ++heard;
    if (throws) throw std::runtime_error("not expected");
  }
};

struct ThreadlessListener : testing::TestWithParam<bool> {
  tendon::LocalManager manager;
  Threadless& arm = manager.Add<Threadless>("arm");
  Listener& listener = manager.Add<Listener>("listener", GetParam());
  Client& client = manager.Add<Client>("client");

  void SetUp() override {
    ASSERT_TRUE(manager.Connect({"client", "Server"}, {"arm", "Control"}).ok());
    ASSERT_TRUE(manager.Connect({"listener", "Source"}, {"arm", "Control"}).ok());
    ASSERT_TRUE(manager.Start("arm").ok());
  }
};

TEST_P(ThreadlessListener, ThrowingFaultsItNotTheSource) {
  ASSERT_TRUE(manager.Start("listener").ok());
  listener.throws = true;

  EXPECT_EQ(client.poke(), Status::kDone);

  EXPECT_EQ(listener.state(), ComponentState::kFaulted);
  EXPECT_EQ(listener.fault(), "a command or event handler: not expected");
  EXPECT_EQ(arm.state(), ComponentState::kActive);
  EXPECT_EQ(arm.poked.lost(), 1U);
  EXPECT_EQ(listener.source().lost_events(), 1U);
}

INSTANTIATE_TEST_SUITE_P(, ThreadlessListener, testing::Bool(),
                         [](const auto& one) { return one.param ? "Directly" : "Queued"; });

TEST(LostEvent, OfAnInactiveListenerIsCountedAtBothEnds) {
  tendon::LocalManager manager;
  auto& arm = manager.Add<Threadless>("arm");
  auto& listener = manager.Add<Listener>("listener", false);
  auto& client = manager.Add<Client>("client");
  ASSERT_TRUE(manager.Connect({"client", "Server"}, {"arm", "Control"}).ok());
  ASSERT_TRUE(manager.Connect({"listener", "Source"}, {"arm", "Control"}).ok());
  ASSERT_TRUE(manager.Start("arm").ok());

  EXPECT_EQ(client.poke(), Status::kDone);
  ASSERT_TRUE(manager.Start("listener").ok());
  EXPECT_EQ(client.poke(), Status::kDone);

  EXPECT_EQ(listener.heard, 1);
  EXPECT_EQ(arm.poked.lost(), 1U);
  EXPECT_EQ(listener.source().lost_events(), 1U);
}

/// A task with a command and a handler that run in other threads.
class Reckless final : public tendon::PeriodicTask {
 public:
  Reckless(std::string name, std::chrono::nanoseconds period)
      : PeriodicTask(std::move(name), period) {
    AddProvidedInterface("Control").AddCommandVoid(&Reckless::Break, this, "Poke",
                                                   tendon::kThreadSafe);
    AddRequiredInterface("Source", Need::kOptional)
        .AddEventHandlerVoid(&Reckless::Break, this, "Poked", tendon::kThreadSafe);
  }
  ~Reckless() override { Join(); }

 private:
  void Run() override { ProcessQueuedCommands(); }
  void Break() { throw std::runtime_error("not expected"); }
};

TEST(ThrowingDirectCommand, FaultsItsTask) {
  tendon::LocalManager manager;
  auto& reckless = manager.Add<Reckless>("reckless", 1ms);
  auto& client = manager.Add<Client>("client");
  ASSERT_TRUE(manager.Connect({"client", "Server"}, {"reckless", "Control"}).ok());
  // A component that does not run yet cannot become faulted.
  EXPECT_EQ(client.poke(), Status::kFailed);
  EXPECT_EQ(reckless.state(), ComponentState::kConstructed);

  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(manager.Start("reckless").ok());
    EXPECT_EQ(client.poke(), Status::kFailed);
    ASSERT_TRUE(manager.WaitFor("reckless", ComponentState::kFaulted, 20s).ok());
    EXPECT_EQ(reckless.fault(), "a command or event handler: not expected");
  }
}

TEST(ThrowingDirectHandler, FaultsItsTaskEvenWhileSuspended) {
  tendon::LocalManager manager;
  auto& source = manager.Add<Threadless>("source");
  auto& reckless = manager.Add<Reckless>("reckless", 1ms);
  auto& client = manager.Add<Client>("client");
  ASSERT_TRUE(manager.Connect({"client", "Server"}, {"source", "Control"}).ok());
  ASSERT_TRUE(manager.Connect({"reckless", "Source"}, {"source", "Control"}).ok());
  ASSERT_TRUE(manager.StartAll().ok());
  ASSERT_TRUE(manager.Suspend("reckless").ok());

  EXPECT_EQ(client.poke(), Status::kDone);

  EXPECT_TRUE(manager.WaitFor("reckless", ComponentState::kFaulted, 20s).ok());
  EXPECT_EQ(source.state(), ComponentState::kActive);
  EXPECT_EQ(source.poked.lost(), 1U);
  EXPECT_EQ(reckless.state(), ComponentState::kFaulted);
}

struct FollowerTask : testing::Test {
  tendon::LocalManager manager;
  Client& client = manager.Add<Client>("client");

  template <typename Leader, typename... Arguments>
  void StartAfter(Arguments... arguments) {
    manager.Add<Leader>("leader", arguments...);
    manager.Add<Reckless>("reckless", 1ms);
    ASSERT_TRUE(manager.RunAfter("reckless", "leader").ok());
    ASSERT_TRUE(manager.Connect({"client", "Server"}, {"reckless", "Control"}).ok());
    ASSERT_TRUE(manager.StartAll().ok());
  }
  void ExpectOnlyItsFault(ComponentState leader) {
    EXPECT_EQ(client.poke(), Status::kFailed);
    EXPECT_TRUE(manager.WaitFor("reckless", ComponentState::kFaulted, 20s).ok());
    EXPECT_EQ(manager.Find("leader")->state(), leader);
    EXPECT_EQ(client.poke(), Status::kNotActive);
  }
};

TEST_F(FollowerTask, IsFaultedByAThrowingDirectCommand) {
  StartAfter<Periodic>(1ms);
  ExpectOnlyItsFault(ComponentState::kActive);
}

TEST_F(FollowerTask, IsFaultedEvenWhileItsLeaderIsSuspended) {
  StartAfter<Periodic>(1ms);
  ASSERT_TRUE(manager.Suspend("leader").ok());
  ExpectOnlyItsFault(ComponentState::kSuspended);
}

TEST_F(FollowerTask, IsFaultedEvenWithoutACycleOfItsLeader) {
  StartAfter<Signal>();
  ExpectOnlyItsFault(ComponentState::kActive);
}

}  // namespace
