#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/interface/connection.h>
#include <tendon/manager/component_registry.h>

#include <array>
#include <exception>
#include <stdexcept>

#include "core/interface/arm_fixture.h"
#include "core/task/scripted.h"
#include "support/allocation_guard.h"
#include "support/wait.h"

// Tests of the faults in the second table of this folder's README.md. The numbers are from the
// table.

namespace tendon_test {
namespace {

using tendon::ComponentRegistry;
using tendon::ComponentState;
using tendon::Connection;
using tendon::Inbox;
using tendon::LocalManager;
using tendon::Overflow;
using tendon::Status;
using namespace std::chrono_literals;

/// A server that executes calls as fast as the test allows.
struct Flooded {
  Inbox inbox;
  tendon::ProvidedInterface control{"Control", &inbox};
  std::vector<JointGoal> refusing;
  std::vector<JointGoal> latest;

  Flooded() {
    refusing.reserve(1024);
    latest.reserve(1024);
    control.AddCommandWrite(&Flooded::Refuse, this, "Refuse");
    control.AddCommandWrite(&Flooded::Keep, this, "Keep").SetOverflow(Overflow::kLatestOnly);
    inbox.SetAccepting(true);
  }
  void Refuse(const JointGoal& goal) { refusing.push_back(goal); }
  void Keep(const JointGoal& goal) { latest.push_back(goal); }
};

struct Flooding {
  tendon::RequiredInterface robot{"Robot", nullptr};
  tendon::WriteFunction<JointGoal> refuse;
  tendon::WriteFunction<JointGoal> keep;

  Flooding() {
    robot.AddFunction(refuse, "Refuse");
    robot.AddFunction(keep, "Keep");
  }
};

JointGoal GoalOf(int number) {
  JointGoal goal;
  goal.position.fill(number);
  return goal;
}

/// Repeatedly makes ten times as many calls as the mailbox holds.
struct CallFlood : testing::TestWithParam<std::size_t> {
  Flooded server;
  Flooding client;
  std::unique_ptr<Connection> connection;
  const int capacity = static_cast<int>(GetParam());

  void SetUp() override {
    client.robot.SetMailboxCapacity(GetParam());
    auto made = Connection::Make(client.robot, server.control, "client/Robot", "server/Control");
    ASSERT_TRUE(made.ok()) << made.error().message;
    connection = *std::move(made);
  }
};

TEST_P(CallFlood, AFloodIsRefusedAndCountedWithoutWaiting) {
  for (int round = 1; round <= 3; ++round) {
    server.refusing.clear();
    {
      const tendon::AllocationGuard guard;
      for (int i = 0; i < 10 * capacity; ++i) {
        EXPECT_EQ(client.refuse(GoalOf(i)), i < capacity ? Status::kQueued : Status::kQueueFull);
      }
      EXPECT_EQ(server.inbox.ExecuteQueued(), GetParam());
    }
    EXPECT_EQ(connection->refused(), static_cast<std::size_t>(round) * 9 * GetParam());
    for (int i = 0; i < capacity; ++i) {
      EXPECT_EQ(server.refusing[static_cast<std::size_t>(i)], GoalOf(i));
    }
  }
}

TEST_P(CallFlood, AFloodOfLatestOnlyCallsIsAccepted) {
  for (int i = 0; i < capacity; ++i) EXPECT_EQ(client.refuse(GoalOf(i)), Status::kQueued);
  for (int round = 1; round <= 3; ++round) {
    const tendon::AllocationGuard guard;
    for (int i = 0; i < 10 * capacity; ++i) EXPECT_EQ(client.keep(GoalOf(i)), Status::kQueued);
    server.inbox.ExecuteQueued();
    ASSERT_EQ(server.latest.size(), static_cast<std::size_t>(round));
    EXPECT_EQ(server.latest.back(), GoalOf(10 * capacity - 1));
  }
  EXPECT_EQ(connection->replaced(), 3 * (10 * GetParam() - 1));
  EXPECT_EQ(connection->refused(), 0U);
  EXPECT_EQ(server.refusing.size(), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Capacities, CallFlood, testing::Values(1, 7, 64, 100));

enum class Throws { kStandard, kNested, kNumber, kNestedNumber };

void Throw(Throws what) {
  switch (what) {
    case Throws::kStandard:
      throw std::runtime_error("no port");
    case Throws::kNumber:
      throw 17;
    case Throws::kNested:
    case Throws::kNestedNumber:
      break;
  }
  try {
    Throw(what == Throws::kNested ? Throws::kStandard : Throws::kNumber);
  } catch (...) {
    std::throw_with_nested(std::logic_error("no arm"));
  }
}

/// A component whose constructor throws in the middle.
template <Throws kWhat>
class HalfBuilt final : public tendon::PeriodicTask {
 public:
  explicit HalfBuilt(std::string name) : PeriodicTask(std::move(name), 1ms) {
    AddProvidedInterface("Control").AddCommandVoid(&HalfBuilt::Stop, this, "Stop");
    state_table().Add(number_, "Number");
    Throw(kWhat);
  }

 private:
  void Run() override {}
  void Stop() {}
  double number_ = 0.0;
};

struct ThrowingConstructor : testing::Test {
  ComponentRegistry registry;
  LocalManager manager;

  ThrowingConstructor() {
    registry.Add<HalfBuilt<Throws::kStandard>>("Standard");
    registry.Add<HalfBuilt<Throws::kNested>>("Nested");
    registry.Add<HalfBuilt<Throws::kNumber>>("Number");
    registry.Add<HalfBuilt<Throws::kNestedNumber>>("NestedNumber");
    registry.Add<Threadless>("Good");
  }
  std::string Refusal(const std::string& class_name) {
    auto made = registry.Create(class_name, "arm", "");
    return made ? "it was made" : made.error().message;
  }
};

TEST_F(ThrowingConstructor, IsQuotedWithItsCauses) {
  EXPECT_EQ(Refusal("Standard"),
            "component 'arm' (class Standard): its constructor failed: no port");
  EXPECT_EQ(Refusal("Nested"),
            "component 'arm' (class Nested): its constructor failed: no arm: no port");
  EXPECT_EQ(Refusal("Number"),
            "component 'arm' (class Number): its constructor failed: an exception that does "
            "not derive from std::exception");
  EXPECT_EQ(Refusal("NestedNumber"),
            "component 'arm' (class NestedNumber): its constructor failed: no arm: an exception "
            "that does not derive from std::exception");
}

TEST_F(ThrowingConstructor, TheProcessContinuesAndOthersStart) {
  EXPECT_THROW(manager.Add<HalfBuilt<Throws::kStandard>>("arm"), std::runtime_error);
  EXPECT_THROW(manager.Add<HalfBuilt<Throws::kNumber>>("arm"), int);
  EXPECT_THROW(manager.Add<HalfBuilt<Throws::kNested>>("arm"), std::logic_error);
  EXPECT_TRUE(manager.components().empty());

  auto good = registry.Create("Good", "arm", "");
  ASSERT_TRUE(good.ok()) << good.error().message;
  manager.Add(*std::move(good), {});
  EXPECT_TRUE(manager.StartAll().ok());
  EXPECT_EQ(manager.components()[0].state, ComponentState::kActive);
}

/// One function of the author throws after every start.
struct ThrowingFunction : testing::TestWithParam<Script::Function> {
  LocalManager manager;
  Periodic& arm = manager.Add<Periodic>("arm", 10us);
  Client& client = manager.Add<Client>("client");

  void SetUp() override {
    ASSERT_TRUE(manager.Connect({"client", "Server"}, {"arm", "Control"}).ok());
    ASSERT_TRUE(manager.Start("client").ok());
  }
  /// Runs the component until it is faulted.
  void Live() {
    const bool begins = manager.Start("arm").ok();
    if (begins && GetParam() == Script::kHandler) (void)client.poke();
    if (begins && GetParam() == Script::kCleanup) (void)manager.Stop("arm");
    ASSERT_TRUE(manager.WaitFor("arm", ComponentState::kFaulted, 20s).ok());
  }
};

TEST_P(ThrowingFunction, RestartsAThousandTimesAndPeersSeeEachFault) {
  arm.throws = GetParam();
  for (int life = 1; life <= 1000; ++life) {
    Live();
    ASSERT_FALSE(HasFatalFailure()) << "life " << life;
    std::uint64_t runs = 0;
    ASSERT_EQ(client.poke(), Status::kNotActive) << "life " << life;
    ASSERT_EQ(client.poke.Wait(60s), Status::kNotActive) << "life " << life;
    ASSERT_EQ(client.get_runs(runs), Status::kNotActive) << "life " << life;
    ASSERT_FALSE(client.poke.is_connected()) << "life " << life;
    ASSERT_EQ(arm.configures, life);
  }

  arm.throws = Script::kNone;
  ASSERT_TRUE(manager.Start("arm").ok());
  const int before = arm.pokes;
  EXPECT_EQ(client.poke.Wait(60s), Status::kDone);
  EXPECT_EQ(arm.pokes, before + 1);
  EXPECT_EQ(arm.fault(), "");
}

INSTANTIATE_TEST_SUITE_P(Functions, ThrowingFunction,
                         testing::Values(Script::kConfigure, Script::kStartup, Script::kRun,
                                         Script::kHandler, Script::kCleanup));

}  // namespace
}  // namespace tendon_test
