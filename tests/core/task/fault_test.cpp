#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/task/scripted.h"
#include "support/wait.h"

namespace {

using tendon::ComponentState;
using tendon::kNoWait;
using tendon_test::Callback;
using tendon_test::Client;
using tendon_test::Periodic;
using tendon_test::Script;
using namespace std::chrono_literals;

struct FaultCase {
  Script::Function function;
  const char* name;
  const char* where;
};

struct Fault : testing::TestWithParam<FaultCase> {
  tendon::LocalManager manager;
  Periodic& arm = manager.Add<Periodic>("arm", 1ms);
  Periodic& bystander = manager.Add<Periodic>("bystander", 1ms);
  Client& client = manager.Add<Client>("client");

  void SetUp() override {
    ASSERT_TRUE(manager.Connect({"client", "Server"}, {"arm", "Control"}).ok());
    ASSERT_TRUE(manager.Start("bystander").ok());
    ASSERT_TRUE(manager.Start("client").ok());
  }

  /// Runs the component until the function with the fault is called.
  void Provoke() {
    arm.throws = GetParam().function;
    (void)manager.Start("arm");
    if (GetParam().function == Script::kHandler) {
      EXPECT_EQ(client.poke(), tendon::Status::kQueued);
    }
    if (GetParam().function == Script::kCleanup) (void)manager.Stop("arm");
    EXPECT_TRUE(manager.WaitFor("arm", ComponentState::kFaulted, 20s).ok());
  }

  void ExpectTheOthersToRun() {
    EXPECT_EQ(bystander.state(), ComponentState::kActive);
    const std::uint64_t runs = bystander.runs;
    EXPECT_TRUE(EventuallyTrue([&] { return bystander.runs > runs; }));
  }
};

TEST_P(Fault, NamesFunctionAndReasonAndAffectsNoOthers) {
  const auto before = std::chrono::system_clock::now();

  Provoke();

  const auto told = std::chrono::nanoseconds(manager.components()[0].fault_time);
  EXPECT_GE(told, before.time_since_epoch());
  EXPECT_LE(told, std::chrono::system_clock::now().time_since_epoch());
  EXPECT_EQ(arm.fault(), std::string(GetParam().where) + ": cable cut");
  EXPECT_EQ(manager.components()[0].state, ComponentState::kFaulted);
  EXPECT_EQ(manager.components()[0].fault, arm.fault());
  EXPECT_FALSE(client.poke());
  ExpectTheOthersToRun();
}

TEST_P(Fault, ContainsNonStandardExceptions) {
  arm.throws_a_number = true;

  Provoke();

  EXPECT_EQ(arm.fault(), std::string(GetParam().where) +
                             ": an exception that does not derive from std::exception");
  ExpectTheOthersToRun();
}

TEST_P(Fault, NamesNestedCauses) {
  arm.throws_nested = true;

  Provoke();

  EXPECT_EQ(arm.fault(), std::string(GetParam().where) + ": no arm: cable cut");
}

TEST_P(Fault, EndsWithARestart) {
  Provoke();
  arm.throws = Script::kNone;

  ASSERT_TRUE(manager.Start("arm").ok());

  EXPECT_EQ(arm.state(), ComponentState::kActive);
  EXPECT_EQ(arm.fault(), "");
  EXPECT_EQ(manager.components()[0].fault_time, 0);
  EXPECT_EQ(arm.configures, 2);
  EXPECT_TRUE(client.poke());
}

INSTANTIATE_TEST_SUITE_P(InEachFunction, Fault,
                         testing::Values(FaultCase{Script::kConfigure, "Configure", "Configure"},
                                         FaultCase{Script::kStartup, "Startup", "Startup"},
                                         FaultCase{Script::kRun, "Run", "Run"},
                                         FaultCase{Script::kHandler, "Handler",
                                                   "a command or event handler"},
                                         FaultCase{Script::kCleanup, "Cleanup", "Cleanup"}),
                         [](const auto& one) { return one.param.name; });

TEST(EventHandlerFault, FaultsTheListenerNotTheSource) {
  class Listener final : public tendon::SignalTask {
   public:
    explicit Listener(std::string name) : SignalTask(std::move(name)) {
      AddRequiredInterface("Source").AddEventHandlerVoid(&Listener::OnPoked, this, "Poked");
    }

   private:
    void Run() override { ProcessQueuedCommands(); }
    void OnPoked() { throw std::runtime_error("not expected"); }
  };
  tendon::LocalManager manager;
  auto& source = manager.Add<Periodic>("source", 1ms);
  auto& listener = manager.Add<Listener>("listener");
  auto& client = manager.Add<Client>("client");
  ASSERT_TRUE(manager.Connect({"listener", "Source"}, {"source", "Control"}).ok());
  ASSERT_TRUE(manager.Connect({"client", "Server"}, {"source", "Control"}).ok());
  ASSERT_TRUE(manager.StartAll().ok());

  EXPECT_EQ(client.poke(), tendon::Status::kQueued);

  ASSERT_TRUE(manager.WaitFor("listener", ComponentState::kFaulted, 20s).ok());
  EXPECT_EQ(listener.fault(), "a command or event handler: not expected");
  EXPECT_EQ(source.state(), ComponentState::kActive);
}

TEST(Restart, WorksAThousandTimes) {
  tendon::LocalManager manager;
  auto& arm = manager.Add<Periodic>("arm", 10us);
  arm.throws = Script::kRun;

  for (int i = 0; i < 1000; ++i) {
    ASSERT_TRUE(manager.Start("arm", kNoWait).ok()) << "time " << i;
    ASSERT_TRUE(manager.WaitFor("arm", ComponentState::kFaulted, 20s).ok()) << "time " << i;
  }

  EXPECT_EQ(arm.startups, 1000);
  EXPECT_EQ(arm.runs, 1000U);
  EXPECT_EQ(arm.cleanups, 0);
}

TEST(Restart, DropsCallsQueuedBeforeTheFault) {
  tendon::LocalManager manager;
  auto& arm = manager.Add<Callback>("arm");
  auto& client = manager.Add<Client>("client");
  ASSERT_TRUE(manager.Connect({"client", "Server"}, {"arm", "Control"}).ok());
  ASSERT_TRUE(manager.StartAll().ok());
  arm.throws = Script::kHandler;
  EXPECT_EQ(client.poke(), tendon::Status::kQueued);
  // This call still waits when the first call has faulted the component.
  EXPECT_EQ(client.poke(), tendon::Status::kQueued);
  EXPECT_FALSE(arm.Cycle());
  ASSERT_EQ(arm.state(), ComponentState::kFaulted);

  ASSERT_TRUE(manager.Start("arm").ok());

  EXPECT_TRUE(arm.Cycle());
  EXPECT_EQ(arm.pokes, 1);
}

}  // namespace
