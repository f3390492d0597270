#include <gmock/gmock.h>
#include <tendon/gcm/client.h>
#include <tendon/proxy/component_proxy.h>

#include "support/network_test.h"
#include "support/plant.h"

namespace {

using plant::Operator;
using plant::Plant;
using std::chrono::seconds;
using tendon::ConnectionState;
using tendon::ErrorCode;
using tendon::InterfaceName;
using tendon::Process;
using tendon::ProcessState;
using tendon::Status;
using testing::HasSubstr;

const InterfaceName kOperatorsRobot("desk", "operator", "Robot");
const InterfaceName kPlantsControl("robot", "plant", "Control");

class Membership : public NetworkTest {
 protected:
  [[nodiscard]] const tendon::ProcessEntry* Entry(const std::string& process) {
    catalogue_ = gcm().catalogue();
    return catalogue_.FindProcess(process);
  }
  bool EventuallyIn(const std::string& process, ProcessState state) {
    return EventuallyTrue([&] {
      const auto* entry = Entry(process);
      return entry != nullptr && entry->process.state == state;
    });
  }
  bool EventuallyListed(const InterfaceName& required, ConnectionState state) {
    return EventuallyTrue([&] {
      catalogue_ = gcm().catalogue();
      const auto* connection = catalogue_.FindConnection(required);
      return connection != nullptr && connection->state == state;
    });
  }
  /// Connects two interfaces through the GCM, like a viewer.
  tendon::Result<tendon::ConnectionDescription> ConnectByGcm(const InterfaceName& required,
                                                             const InterfaceName& provided) {
    tendon::GcmClient client(NewMiddleware(), {.name = "test", .address = gcm().address()});
    EXPECT_TRUE(client.WaitUntilWatching().ok());
    return tendon::Wait<tendon::ConnectionDescription>(
        seconds(20), [&](auto handler) { client.Connect(required, provided, handler); });
  }
  tendon::Result<void> DisconnectByGcm(const InterfaceName& required) {
    tendon::GcmClient client(NewMiddleware(), {.name = "test", .address = gcm().address()});
    EXPECT_TRUE(client.WaitUntilWatching().ok());
    return tendon::Wait<void>(seconds(20),
                              [&](auto handler) { client.Disconnect(required, handler); });
  }

 private:
  tendon::Catalogue catalogue_;
};

TEST_P(Membership, ReportsTheContentOfTheProcess) {
  auto robot = Start("robot");
  robot->Add<Plant>("plant");
  ASSERT_TRUE(robot->StartAll().ok());

  EXPECT_TRUE(EventuallyTrue([&] {
    const auto* entry = Entry("robot");
    return entry != nullptr && entry->components.contains("plant") &&
           entry->components.at("plant").state == tendon::ComponentState::kActive;
  }));
  const auto* entry = Entry("robot");
  EXPECT_EQ(entry->process.address, robot->address());
  EXPECT_EQ(entry->process.instance, robot->instance());
  EXPECT_EQ(entry->components.at("plant").tables.size(), 1U);

  ASSERT_TRUE(robot->Remove("plant").ok());
  EXPECT_TRUE(EventuallyTrue([&] { return Entry("robot")->components.empty(); }));
  robot.reset();
  EXPECT_TRUE(EventuallyIn("robot", ProcessState::kLeft));
}

TEST_P(Membership, ReportsTheResourceUsageOfTheProcess) {
  const auto robot = Start("robot");
  tendon::GcmClient client(NewMiddleware(), {.name = "test", .address = gcm().address()});
  ASSERT_TRUE(client.WaitUntilWatching().ok());

  tendon::message::ProcessHealth health;
  EXPECT_TRUE(EventuallyTrue([&] {
    const auto all = tendon::Wait<tendon::message::SystemHealth>(
        seconds(20), [&](auto handler) { client.GetHealth(handler); });
    if (!all.ok() || all->processes.size() != 1) return false;
    health = all->processes.front();
    return health.cpu >= 0.0 && health.clock_uncertainty >= std::chrono::nanoseconds(0);
  }));

  EXPECT_EQ(health.process, "robot");
  EXPECT_EQ(health.instance, robot->instance());
  EXPECT_GT(health.memory, 0U);
  EXPECT_EQ(health.clock_offset, std::chrono::nanoseconds(0));
}

TEST_P(Membership, LetsTheGcmConnectTwoOthers) {
  auto robot = Start("robot");
  robot->Add<Plant>("plant");
  auto desk = Start("desk");
  auto& user = desk->Add<Operator>("operator");
  ASSERT_TRUE(robot->StartAll().ok());
  ASSERT_TRUE(EventuallyTrue([&] {
    return Entry("robot")->components.size() == 1 && Entry("desk")->components.size() == 1;
  }));

  const auto made = ConnectByGcm(kOperatorsRobot, kPlantsControl);

  ASSERT_TRUE(made.ok()) << made.error().message;
  EXPECT_EQ(made->state, ConnectionState::kActive);
  EXPECT_TRUE(EventuallyListed(kOperatorsRobot, ConnectionState::kActive));
  EXPECT_EQ(user.stop(), Status(Status::kQueued));

  const auto broken = DisconnectByGcm(kOperatorsRobot);
  ASSERT_TRUE(broken.ok()) << broken.error().message;
  EXPECT_EQ(user.stop(), Status(Status::kNotConnected));
  EXPECT_EQ(gcm().catalogue().FindConnection(kOperatorsRobot), nullptr);
}

TEST_P(Membership, LetsTheGcmConnectWithinOneProcess) {
  auto robot = Start("robot");
  robot->Add<Plant>("plant");
  auto& user = robot->Add<Operator>("operator");
  ASSERT_TRUE(robot->StartAll().ok());
  ASSERT_TRUE(EventuallyTrue([&] { return Entry("robot")->components.size() == 2; }));

  const auto made = ConnectByGcm({"robot", "operator", "Robot"}, kPlantsControl);

  ASSERT_TRUE(made.ok()) << made.error().message;
  EXPECT_EQ(user.stop(), Status(Status::kQueued));
  EXPECT_TRUE(robot->proxies().empty());
  EXPECT_TRUE(EventuallyListed({"robot", "operator", "Robot"}, ConnectionState::kActive));
}

TEST_P(Membership, KeepsConnectionsWhenTheGcmIsKilled) {
  auto robot = Start("robot");
  auto& plant = robot->Add<Plant>("plant");
  auto desk = Start("desk");
  auto& user = desk->Add<Operator>("operator");
  ASSERT_TRUE(robot->StartAll().ok());
  ASSERT_TRUE(desk->Connect(kOperatorsRobot, kPlantsControl).ok());
  ASSERT_TRUE(EventuallyActive(*desk, 1));
  ASSERT_TRUE(EventuallyListed(kOperatorsRobot, ConnectionState::kActive));
  ASSERT_TRUE(EventuallyTrue([&] {
    return gcm().catalogue().FindComponent("robot", "plant")->state ==
           tendon::ComponentState::kActive;
  }));
  const tendon::Fingerprint before = gcm().catalogue().ContentHash();

  KillGcm();
  ASSERT_TRUE(EventuallyTrue([&] { return !desk->is_joined() && !robot->is_joined(); }));
  EXPECT_EQ(user.stop(), Status(Status::kQueued));
  EXPECT_TRUE(EventuallyTrue([&] { return plant.stops.size() == 1; }));
  EXPECT_EQ(desk->connections().front().state, ConnectionState::kActive);

  StartGcm();
  EXPECT_TRUE(EventuallyTrue([&] { return gcm().catalogue().ContentHash() == before; }));
  EXPECT_EQ(user.stop(), Status(Status::kQueued));
  EXPECT_TRUE(EventuallyTrue([&] { return plant.stops.size() == 2; }));
}

TEST_P(Membership, RefusesATakenNameUntilItIsFree) {
  auto first = Start("robot");
  Process second("robot", Options());

  const auto refused = second.WaitUntilJoined(seconds(20));

  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::kExists);
  EXPECT_THAT(refused.error().message, HasSubstr("'robot' is in use by host"));
  EXPECT_FALSE(second.is_joined());
  second.Add<Plant>("plant");
  EXPECT_TRUE(second.StartAll().ok());
  EXPECT_TRUE(first->is_joined());

  first.reset();
  EXPECT_TRUE(EventuallyTrue([&] { return second.is_joined(); }));
}

TEST_P(Membership, NamesTheAddressWithoutAGcm) {
  const std::string address = gcm().address();
  KillGcm();
  auto options = Options();
  options.retry = false;
  const Process process("robot", options);

  const auto joined = process.WaitUntilJoined(seconds(20));

  ASSERT_FALSE(joined.ok());
  EXPECT_EQ(joined.error().code, ErrorCode::kUnreachable);
  EXPECT_THAT(joined.error().message, HasSubstr("no GCM at " + address));
  EXPECT_THAT(joined.error().message, HasSubstr("start one with: gcm serve --gcm " + address));
}

TEST_P(Membership, StartsWhenTheGcmStarts) {
  KillGcm();
  const Process process("robot", Options());
  ASSERT_FALSE(process.is_joined());

  StartGcm();

  EXPECT_TRUE(process.WaitUntilJoined(seconds(20)).ok());
}

TEST_P(Membership, IsOptional) {
  auto options = Options();
  options.gcm.clear();
  Process process("alone", options);
  process.Add<Plant>("plant");
  auto& user = process.Add<Operator>("operator");
  ASSERT_TRUE(process.StartAll().ok());

  ASSERT_TRUE(process.Connect({"operator", "Robot"}, {"alone", "plant", "Control"}).ok());

  EXPECT_EQ(user.stop(), Status(Status::kQueued));
  EXPECT_EQ(process.connections().front().required, InterfaceName("alone", "operator", "Robot"));
  EXPECT_FALSE(process.WaitUntilJoined(seconds(0)).ok());
}

TEST_P(Membership, RefusesAnInvalidName) {
  EXPECT_THROW(Process("a b", Options()), tendon::ConfigurationError);
  EXPECT_THROW(Process("robot", tendon::ProcessOptions{}), tendon::ConfigurationError);
}

TEST_P(Membership, RequiresAnOwnAddress) {
  const auto robot = Start("robot");
  auto options = Options();
  options.listen = robot->address();

  EXPECT_THROW(Process("desk", options), tendon::ConfigurationError);
}

INSTANTIATE_TEST_SUITE_P(Over, Membership, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

}  // namespace
