#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/manager/local_manager.h>

#include <chrono>
#include <memory>

#include "core/interface/arm_fixture.h"
#include "core/task/scripted.h"
#include "support/log/log_record.h"
#include "support/refusal.h"

namespace {

using tendon::ConnectionState;
using tendon::ErrorCode;
using tendon::Status;
using tendon::test::Refusal;
using tendon_test::Periodic;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::SizeIs;

/// A component without a thread: commands run in the caller's thread.
class Arm final : public tendon::Component {
 public:
  explicit Arm(std::string name) : Component(std::move(name)) {
    auto& control = AddProvidedInterface("Control");
    control.AddCommandVoid(&Arm::Stop, this, "Stop");
    control.AddEvent(stopped, "Stopped");
  }
  int stops = 0;
  tendon::VoidEvent stopped;

 private:
  void Stop() {
    ++stops;
    stopped();
  }
};

class Operator final : public tendon::Component {
 public:
  explicit Operator(std::string name) : Component(std::move(name)) {
    auto& robot = AddRequiredInterface("Robot");
    robot.AddFunction(stop, "Stop");
    robot.AddEventHandlerVoid(&Operator::OnStopped, this, "Stopped");
  }
  tendon::VoidFunction stop;
  int seen = 0;

 private:
  void OnStopped() { ++seen; }
};

struct LocalManagerTest : testing::Test {
  tendon::LocalManager manager;
  Arm& arm = manager.Add<Arm>("arm");
  Operator& person = manager.Add<Operator>("operator");
};

TEST_F(LocalManagerTest, ComponentsWithoutThreadsRunInTheCallersThread) {
  ASSERT_TRUE(manager.Connect({"operator", "Robot"}, {"arm", "Control"}).ok());
  ASSERT_TRUE(manager.StartAll().ok());

  EXPECT_EQ(person.stop(), Status::kDone);

  EXPECT_EQ(arm.stops, 1);
  EXPECT_EQ(person.seen, 1);
}

TEST_F(LocalManagerTest, RefusesADuplicateComponentName) {
  const auto refusal = [this](const std::string& name) {
    return Refusal([&] { manager.Add<Arm>(name); });
  };
  manager.Add(std::make_unique<Arm>("loaded"), {"SimulatedArm", "simulated_arm"});

  EXPECT_THAT(refusal("arm"),
              MatchesRegex("component 'arm' already exists in this process \\(added at "
                           "local_manager_test\\.cpp:[0-9]+\\); choose another name"));
  EXPECT_EQ(refusal("loaded"),
            "component 'loaded' already exists in this process (of class SimulatedArm); choose "
            "another name");
  EXPECT_THAT(manager.components(), SizeIs(3));
}

TEST(LocalManager, ListsConvertedFunctionsOfAConnection) {
  class Client final : public tendon::Component {
   public:
    explicit Client(std::string name) : Component(std::move(name)) {
      auto& robot = AddRequiredInterface("Robot");
      robot.AddFunction(move_to_, "MoveTo");
      robot.AddFunction(look_at_, "LookAt");
    }

   private:
    tendon::WriteFunction<tendon_test::PaddedJointGoal> move_to_;
    tendon::WriteFunction<tendon_test::JointGoal> look_at_;
  };
  class Server final : public tendon::Component {
   public:
    explicit Server(std::string name) : Component(std::move(name)) {
      auto& control = AddProvidedInterface("Control");
      control.AddCommandWrite(&Server::Take, this, "MoveTo");
      control.AddCommandWrite(&Server::Take, this, "LookAt");
    }

   private:
    void Take(const tendon_test::JointGoal& /*goal*/) {}
  };
  tendon::LocalManager manager;
  manager.Add<Client>("client");
  manager.Add<Server>("server");
  ASSERT_TRUE(manager.Connect({"client", "Robot"}, {"server", "Control"}).ok());

  EXPECT_THAT(manager.connections()[0].converted, testing::ElementsAre("MoveTo"));
}

/// A connection to a task that executes nothing, because no thread runs its cycles.
struct ConnectionToAnIdleTask : testing::Test {
  const tendon::InterfaceName required{"client", "Server"};
  tendon::LocalManager manager;
  tendon_test::Callback& server = manager.Add<tendon_test::Callback>("server");
  tendon_test::Client& client = manager.Add<tendon_test::Client>("client");

  void SetUp() override {
    ASSERT_TRUE(manager.Connect(required, {"server", "Control"}).ok());
    ASSERT_TRUE(manager.StartAll().ok());
    for (int i = 0; i < 70; ++i) (void)client.poke();
  }
};

TEST_F(ConnectionToAnIdleTask, CountsItsCalls) {
  const auto flooded = manager.Counts(required);
  ASSERT_TRUE(flooded.ok());
  EXPECT_GT(flooded->age.count(), 0);
  EXPECT_EQ(*flooded, (tendon::ConnectionCounts{
                          .age = flooded->age, .capacity = 64, .waiting = 64, .refused = 6}));
  EXPECT_EQ(*manager.FillOf("server"), (tendon::MailboxFill{.waiting = 64, .capacity = 64}));

  EXPECT_TRUE(server.Cycle());

  EXPECT_EQ(manager.Counts(required)->waiting, 0U);
  EXPECT_EQ(manager.Counts(required)->taken, 64U);
  EXPECT_EQ(*manager.FillOf("server"), (tendon::MailboxFill{.waiting = 0, .capacity = 64}));
  EXPECT_EQ(manager.FillOf("sever").error().code, tendon::ErrorCode::kNotFound);
  ASSERT_TRUE(manager.Disconnect(required).ok());
  EXPECT_EQ(manager.Counts(required).error().message, "client/Server is not connected");
}

TEST_F(ConnectionToAnIdleTask, LogsCallsDroppedByADisconnect) {
  const tendon_test::LogRecord log("client");

  ASSERT_TRUE(manager.Suspend("server").ok());
  ASSERT_TRUE(manager.Disconnect(required).ok());

  EXPECT_THAT(log.texts(), testing::ElementsAre(
                               "the disconnect of client/Server from server/Control has dropped "
                               "64 calls and events that were not executed"));
}

TEST_F(ConnectionToAnIdleTask, LogsCallsDroppedByRemovingAnEnd) {
  const tendon_test::LogRecord log("client");

  ASSERT_TRUE(manager.Remove("client").ok());

  EXPECT_THAT(log.texts(), testing::ElementsAre(HasSubstr("has dropped 64 calls")));
}

TEST_F(LocalManagerTest, RefusesANullComponent) {
  EXPECT_EQ(Refusal([&] { manager.Add(nullptr, {}); }), "LocalManager::Add: null component");
}

TEST_F(LocalManagerTest, RequestsNameTheMissingComponentAndSuggestOne) {
  const std::string sentence = "no component 'arn'; did you mean 'arm'?";

  EXPECT_EQ(manager.Start("arn").error().message, sentence);
  EXPECT_EQ(manager.Suspend("arn").error().message, sentence);
  EXPECT_EQ(manager.Stop("arn").error().message, sentence);
  EXPECT_EQ(manager.Remove("arn").error().message, sentence);
  EXPECT_EQ(manager.RunAfter("arn", "operator").error().message, sentence);
  EXPECT_EQ(manager.RunAfter("operator", "arn").error().message, sentence);
  EXPECT_EQ(
      manager.WaitFor("arn", tendon::ComponentState::kActive, tendon::kNoWait).error().message,
      sentence);
}

TEST_F(LocalManagerTest, AConnectionLeadsFromARequiredToAProvidedInterface) {
  manager.Add<Operator>("other");

  const auto to_required = manager.Connect({"operator", "Robot"}, {"other", "Robot"});
  const auto to_itself = manager.Connect({"operator", "Robot"}, {"operator", "Robot"});
  const auto from_provided = manager.Connect({"arm", "Control"}, {"arm", "Control"});

  ASSERT_FALSE(to_required.ok());
  EXPECT_EQ(
      to_required.error().message,
      "interface 'Robot' of component 'other' is a required interface; give a provided interface");
  ASSERT_FALSE(to_itself.ok());
  EXPECT_EQ(to_itself.error().message,
            "interface 'Robot' of component 'operator' is a required interface; give a provided "
            "interface");
  ASSERT_FALSE(from_provided.ok());
  EXPECT_EQ(
      from_provided.error().message,
      "interface 'Control' of component 'arm' is a provided interface; give a required interface");
}

TEST_F(LocalManagerTest, RefusesASecondServerForARequiredInterface) {
  manager.Add<Arm>("second");
  ASSERT_TRUE(manager.Connect({"operator", "Robot"}, {"arm", "Control"}).ok());

  const auto connected = manager.Connect({"operator", "Robot"}, {"second", "Control"});

  ASSERT_FALSE(connected.ok());
  EXPECT_EQ(connected.error().code, ErrorCode::kExists);
  EXPECT_THAT(connected.error().message, HasSubstr("operator/Robot is already connected"));
}

TEST_F(LocalManagerTest, ConnectNamesTheMissingComponentAndSuggestsOne) {
  const auto connected = manager.Connect({"operator", "Robot"}, {"arn", "Control"});

  ASSERT_FALSE(connected.ok());
  EXPECT_EQ(connected.error().code, ErrorCode::kNotFound);
  EXPECT_EQ(connected.error().message, "no component 'arn'; did you mean 'arm'?");
}

TEST_F(LocalManagerTest, ConnectNamesTheMissingInterfaceAndSuggestsOne) {
  const auto connected = manager.Connect({"operator", "Robto"}, {"arm", "Control"});

  ASSERT_FALSE(connected.ok());
  EXPECT_EQ(connected.error().message,
            "component 'operator' has no required interface 'Robto'; did you mean 'Robot'?");
}

TEST_F(LocalManagerTest, ConnectionsAreListedUntilTheyEnd) {
  const auto id = manager.Connect({"operator", "Robot"}, {"arm", "Control"});
  ASSERT_TRUE(id.ok());

  ASSERT_THAT(manager.connections(), SizeIs(1));
  EXPECT_EQ(manager.connections()[0].id, *id);
  EXPECT_EQ(manager.connections()[0].state, ConnectionState::kActive);
  ASSERT_TRUE(manager.Disconnect({"operator", "Robot"}).ok());

  EXPECT_THAT(manager.connections(), SizeIs(0));
  EXPECT_EQ(person.stop(), Status::kNotConnected);
}

TEST_F(LocalManagerTest, DisconnectingTwiceIsRefused) {
  const auto disconnected = manager.Disconnect({"operator", "Robot"});

  ASSERT_FALSE(disconnected.ok());
  EXPECT_EQ(disconnected.error().message,
            "operator/Robot is not connected: there is nothing to disconnect");
}

TEST_F(LocalManagerTest, RemovingAComponentEndsItsConnections) {
  ASSERT_TRUE(manager.Connect({"operator", "Robot"}, {"arm", "Control"}).ok());

  ASSERT_TRUE(manager.Remove("arm").ok());

  EXPECT_EQ(person.stop(), Status::kNotConnected);
  EXPECT_THAT(manager.connections(), SizeIs(0));
  EXPECT_EQ(manager.Find("arm"), nullptr);
}

class ObservingManager final : public tendon::LocalManager {
 public:
  ObservingManager() {
    SetObserver([this] { ++changes_; });
  }
  int Heard() { return std::exchange(changes_, 0); }
  bool HasHeard() { return Heard() > 0; }

 private:
  int changes_ = 0;
};

constexpr std::chrono::hours kPeriod(1);

TEST(LocalManager, AReplacementKeepsPlaceLeaderAndConnections) {
  ObservingManager manager;
  manager.Add<Periodic>("leader", kPeriod);
  manager.Add<Periodic>("follower", kPeriod);
  manager.Add<Arm>("arm");
  auto& person = manager.Add<Operator>("operator");
  ASSERT_TRUE(manager.Connect({"operator", "Robot"}, {"arm", "Control"}).ok());
  ASSERT_TRUE(manager.RunAfter("follower", "leader").ok());
  (void)manager.Heard();

  auto made = std::make_unique<Arm>("arm");
  const Arm& arm = *made;
  ASSERT_TRUE(manager.Replace(std::move(made), {.class_name = "Arm", .library = {}}).ok());
  EXPECT_EQ(manager.Heard(), 1);
  ASSERT_TRUE(manager.Replace(std::make_unique<Periodic>("follower", kPeriod), {}).ok());
  EXPECT_EQ(manager.Heard(), 1);

  const auto components = manager.components();
  ASSERT_THAT(components, SizeIs(4));
  EXPECT_EQ(components[1].leader, "leader");
  EXPECT_EQ(components[2].class_name, "Arm");
  EXPECT_EQ(manager.Find("arm"), &arm);
  ASSERT_TRUE(manager.Start("arm").ok());
  EXPECT_EQ(person.stop(), Status::kDone);
  EXPECT_EQ(arm.stops, 1);
}

TEST(LocalManager, AFailedReplacementChangesNothing) {
  tendon::LocalManager manager;
  manager.Add<Periodic>("leader", kPeriod);
  manager.Add<Periodic>("follower", kPeriod);
  auto& arm = manager.Add<Arm>("arm");
  manager.Add<Operator>("operator");
  ASSERT_TRUE(manager.Connect({"operator", "Robot"}, {"arm", "Control"}).ok());
  ASSERT_TRUE(manager.RunAfter("follower", "leader").ok());
  ASSERT_TRUE(manager.Start("arm").ok());
  const auto reason = [&manager](std::unique_ptr<tendon::Component> made) {
    const auto replaced = manager.Replace(std::move(made), {});
    return replaced ? std::string() : replaced.error().message;
  };

  EXPECT_EQ(reason(std::make_unique<Arm>("arm")),
            "component 'arm' is not replaced: it runs; stop it first");
  EXPECT_EQ(reason(std::make_unique<Periodic>("leader", kPeriod)),
            "component 'leader' is not replaced: 'follower' runs after it");
  EXPECT_EQ(reason(std::make_unique<Arm>("follower")),
            "component 'follower' is not replaced: the new component has no thread, so it "
            "cannot run after 'leader'");
  EXPECT_EQ(reason(std::make_unique<Arm>("amr")), "no component 'amr'; did you mean 'arm'?");

  EXPECT_EQ(manager.Find("arm"), &arm);
  EXPECT_THAT(manager.connections(), SizeIs(1));
  EXPECT_EQ(manager.SettingsOf("follower")->leader, "leader");
}

TEST(LocalManager, NotifiesADerivedManagerOfEveryChange) {
  ObservingManager manager;

  manager.Add<Arm>("arm");
  manager.Add<Operator>("operator");
  EXPECT_TRUE(manager.HasHeard());
  ASSERT_TRUE(manager.Connect({"operator", "Robot"}, {"arm", "Control"}).ok());
  EXPECT_TRUE(manager.HasHeard());
  ASSERT_TRUE(manager.StartAll().ok());
  EXPECT_TRUE(manager.HasHeard());
  ASSERT_TRUE(manager.Disconnect({"operator", "Robot"}).ok());
  EXPECT_TRUE(manager.HasHeard());
  ASSERT_TRUE(manager.Remove("arm").ok());
  EXPECT_TRUE(manager.HasHeard());
}

TEST_F(LocalManagerTest, DescribesItsComponents) {
  const auto components = manager.components();

  ASSERT_THAT(components, SizeIs(2));
  EXPECT_EQ(components[0].name, "arm");
  ASSERT_THAT(components[0].provided, SizeIs(1));
  EXPECT_EQ(components[0].provided[0].commands[0].name, "Stop");
  EXPECT_EQ(components[0].provided[0].events[0].name, "Stopped");
  ASSERT_THAT(components[1].required, SizeIs(1));
  EXPECT_EQ(components[1].required[0].functions[0].name, "Stop");
}

}  // namespace
