#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/manager/local_manager.h>

#include "core/interface/arm_fixture.h"

namespace {

using tendon::ConnectionState;
using tendon::ErrorCode;
using tendon::Status;
using testing::HasSubstr;
using testing::SizeIs;

/// Components without threads: commands run in the caller's.
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

TEST_F(LocalManagerTest, ASecondComponentOfOneNameIsRefused) {
  EXPECT_THROW(manager.Add<Arm>("arm"), tendon::ConfigurationError);
  EXPECT_THAT(manager.components(), SizeIs(2));
}

TEST_F(LocalManagerTest, ConnectNamesTheMissingComponentAndTheNearest) {
  const auto connected = manager.Connect({"operator", "Robot"}, {"arn", "Control"});

  ASSERT_FALSE(connected.ok());
  EXPECT_EQ(connected.error().code, ErrorCode::kNotFound);
  EXPECT_EQ(connected.error().message, "no component 'arn'; did you mean 'arm'?");
}

TEST_F(LocalManagerTest, ConnectNamesTheMissingInterfaceAndTheNearest) {
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
  EXPECT_EQ(disconnected.error().message, "operator/Robot is not connected");
}

TEST_F(LocalManagerTest, RemovingAComponentEndsItsConnections) {
  ASSERT_TRUE(manager.Connect({"operator", "Robot"}, {"arm", "Control"}).ok());

  ASSERT_TRUE(manager.Remove("arm").ok());

  EXPECT_EQ(person.stop(), Status::kNotConnected);
  EXPECT_THAT(manager.connections(), SizeIs(0));
  EXPECT_EQ(manager.Find("arm"), nullptr);
}

TEST_F(LocalManagerTest, EveryChangeIsObserved) {
  int changes = 0;
  manager.SetObserver([&changes] { ++changes; });
  const auto observed = [&changes] { return std::exchange(changes, 0) > 0; };

  manager.Add<Arm>("second");
  EXPECT_TRUE(observed());
  ASSERT_TRUE(manager.Connect({"operator", "Robot"}, {"arm", "Control"}).ok());
  EXPECT_TRUE(observed());
  ASSERT_TRUE(manager.StartAll().ok());
  EXPECT_TRUE(observed());
  ASSERT_TRUE(manager.Disconnect({"operator", "Robot"}).ok());
  EXPECT_TRUE(observed());
  ASSERT_TRUE(manager.Remove("second").ok());
  EXPECT_TRUE(observed());
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
