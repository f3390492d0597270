#include <gtest/gtest.h>
#include <tendon/gcm/members/registry.h>
#include <tendon/middleware/channel.h>
#include <tests/core/gcm/samples.h>

namespace tendon::server {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using test::kControl;
using test::kRobot;
using Kind = CatalogueChange::Kind;

class RegistryTest : public testing::Test {
 protected:
  SessionToken Join(const std::string& name, std::uint64_t instance,
                    std::vector<ComponentDescription> components = {},
                    std::vector<ConnectionDescription> connections = {}, SessionToken held = 0) {
    const auto admission = registry_.Join(
        {test::ProcessNamed(name, instance), std::move(components), std::move(connections)}, held,
        nullptr);
    EXPECT_TRUE(admission) << admission.error().message;
    return admission ? admission->session : 0;
  }

  Error JoinError(message::Join join, SessionToken held = 0) {
    const auto admission = registry_.Join(std::move(join), held, nullptr);
    EXPECT_FALSE(admission);
    return admission ? Error{} : admission.error();
  }

  /// Advances the time. Only the leases in `renewing` are renewed.
  void Pass(std::chrono::milliseconds time, const std::vector<SessionToken>& renewing = {}) {
    constexpr auto kStep = 50ms;
    for (auto passed = 0ms; passed < time; passed += kStep) {
      clock_.Advance(kStep);
      for (const SessionToken session : renewing) ASSERT_TRUE(registry_.Renew(session));
      registry_.Tick();
    }
  }

  [[nodiscard]] ProcessDescription Process(const std::string& name) const {
    const ProcessEntry* entry = registry_.catalogue().FindProcess(name);
    return entry == nullptr ? ProcessDescription{} : entry->process;
  }

  [[nodiscard]] ConnectionDescription Connection(std::uint64_t id = 1) const {
    return {.id = id, .required = kRobot, .provided = kControl, .state = ConnectionState::kActive};
  }

  ManualClock clock_;
  Registry registry_{Leases{}, clock_};
};

TEST_F(RegistryTest, JoiningAddsTheWholeProcessToTheCatalogue) {
  Join("desk", 1, {test::Teleoperation()}, {Connection()});

  EXPECT_EQ(Process("desk").state, ProcessState::kAlive);
  EXPECT_EQ(*registry_.catalogue().FindComponent("desk", "teleoperation"), test::Teleoperation());
  EXPECT_EQ(*registry_.catalogue().FindConnection(kRobot), Connection());
  EXPECT_EQ(registry_.peers().processes, std::vector{Process("desk")});
}

TEST_F(RegistryTest, StoresEqualInterfacesOnce) {
  const auto interfaces_of = [this](const std::string& process, const std::string& component) {
    const auto* found = registry_.catalogue().FindComponent(process, component);
    return found == nullptr ? nullptr : found->provided.data();
  };
  Join("robot", 1, {test::Arm()});
  const SessionToken spare = Join("spare", 2);
  ASSERT_TRUE(
      registry_.Report(spare, {{{.kind = Kind::kComponent, .components = {test::Arm("other")}},
                                {.kind = Kind::kComponent, .components = {test::FakeArm()}}}}));

  EXPECT_NE(interfaces_of("robot", "arm"), nullptr);
  EXPECT_EQ(interfaces_of("robot", "arm"), interfaces_of("spare", "other"));
  EXPECT_NE(interfaces_of("robot", "arm"), interfaces_of("spare", "fake"));
  EXPECT_EQ(*registry_.catalogue().FindComponent("spare", "other"), test::Arm("other"));
}

TEST_F(RegistryTest, TheChangesBuildTheCatalogue) {
  const SessionToken desk = Join("desk", 1, {test::Teleoperation()}, {Connection()});
  Join("robot", 2, {test::Arm()});
  registry_.End(desk, ProcessState::kLost, "killed");
  Join("desk", 3, {test::Teleoperation()});
  Pass(2s);
  ASSERT_TRUE(registry_.Forget("robot"));

  Catalogue copy;
  for (const CatalogueChange& change : registry_.TakeChanges()) ASSERT_TRUE(copy.Apply(change));

  EXPECT_EQ(copy, registry_.catalogue());
  EXPECT_TRUE(registry_.TakeChanges().empty());
}

TEST_F(RegistryTest, ARefusedDuplicateNameReportsItsHolder) {
  const SessionToken session = Join("robot", 7);
  clock_.Advance(80ms);

  const Error error = JoinError({test::ProcessNamed("robot", 8), {}, {}});

  EXPECT_EQ(error.code, ErrorCode::kExists);
  EXPECT_EQ(error.message.find("process name 'robot' is in use by host bench pid 1007 since 2"), 0U)
      << error.message;
  EXPECT_NE(error.message.find(" (last renewal 80 ms ago)"), std::string::npos) << error.message;
  EXPECT_EQ(Process("robot").instance, 7U);
  EXPECT_TRUE(registry_.Renew(session));
}

TEST_F(RegistryTest, AnUnrenewedLeaseBecomesSuspectThenLost) {
  const SessionToken robot = Join("robot", 1);
  const SessionToken desk = Join("desk", 2);

  Pass(700ms, {desk});
  EXPECT_EQ(Process("robot").state, ProcessState::kAlive);
  Pass(50ms, {desk});
  EXPECT_EQ(Process("robot").state, ProcessState::kSuspect);
  Pass(700ms, {desk});
  EXPECT_EQ(Process("robot").state, ProcessState::kSuspect);
  Pass(50ms, {desk});
  EXPECT_EQ(Process("robot").state, ProcessState::kLost);
  EXPECT_EQ(Process("robot").reason, "no renewal of its lease for 1500 ms");

  EXPECT_EQ(registry_.Renew(robot).error().code, ErrorCode::kDenied);
  EXPECT_EQ(Process("desk").state, ProcessState::kAlive);
  EXPECT_EQ(registry_.peers().processes, std::vector{Process("desk")});
}

TEST_F(RegistryTest, ASuspectThatRenewsIsAliveAgain) {
  const SessionToken robot = Join("robot", 1);
  Pass(800ms);
  ASSERT_EQ(Process("robot").state, ProcessState::kSuspect);

  ASSERT_TRUE(registry_.Renew(robot));

  EXPECT_EQ(Process("robot").state, ProcessState::kAlive);
  EXPECT_EQ(Process("robot").reason, "");
}

TEST_F(RegistryTest, APauseOfTheGcmExpiresNoLease) {
  const SessionToken robot = Join("robot", 1);
  registry_.Tick();

  clock_.Advance(1h);
  EXPECT_TRUE(registry_.Tick().empty());
  EXPECT_EQ(Process("robot").state, ProcessState::kAlive);

  EXPECT_TRUE(registry_.Renew(robot));
  Pass(1600ms);
  EXPECT_EQ(Process("robot").state, ProcessState::kLost);
}

TEST_F(RegistryTest, ALostNameMayBeReusedAndItsOldOwnerIsFenced) {
  const SessionToken old = Join("robot", 1, {test::Arm()});
  Pass(1600ms);

  const SessionToken taken = Join("robot", 2);

  EXPECT_EQ(Process("robot").instance, 2U);
  EXPECT_EQ(registry_.catalogue().FindComponent("robot", "arm"), nullptr);
  EXPECT_FALSE(registry_.Renew(old));
  EXPECT_FALSE(registry_.Report(old, {}));
  EXPECT_EQ(JoinError({test::ProcessNamed("robot", 1), {}, {}}, old).code, ErrorCode::kExists);
  registry_.End(old, ProcessState::kLost, "late");
  EXPECT_TRUE(registry_.Renew(taken));
  EXPECT_EQ(Process("robot").state, ProcessState::kAlive);
}

TEST_F(RegistryTest, AProcessMayRejoinUnderItsOwnSession) {
  const SessionToken old = Join("robot", 1, {test::Arm()});

  EXPECT_EQ(JoinError({test::ProcessNamed("robot", 1), {}, {}}, old + 1).code, ErrorCode::kExists);
  EXPECT_EQ(JoinError({test::ProcessNamed("robot", 2), {}, {}}, old).code, ErrorCode::kExists);
  const SessionToken next = Join("robot", 1, {test::Arm("other")}, {}, old);

  EXPECT_NE(next, old);
  EXPECT_FALSE(registry_.Renew(old));
  EXPECT_EQ(registry_.catalogue().FindComponent("robot", "arm"), nullptr);
  EXPECT_NE(registry_.catalogue().FindComponent("robot", "other"), nullptr);
}

TEST_F(RegistryTest, ALeftProcessIsKeptForADayUnlessForgotten) {
  registry_.End(Join("robot", 1, {test::Arm()}), ProcessState::kLeft, "left");
  registry_.End(Join("desk", 2), ProcessState::kLost, "killed");

  EXPECT_EQ(Process("robot").state, ProcessState::kLeft);
  EXPECT_NE(registry_.catalogue().FindComponent("robot", "arm"), nullptr);
  EXPECT_TRUE(registry_.Forget("robot"));
  EXPECT_EQ(registry_.catalogue().FindProcess("robot"), nullptr);

  clock_.Advance(23h);
  registry_.Tick();
  EXPECT_NE(registry_.catalogue().FindProcess("desk"), nullptr);
  clock_.Advance(1h);
  registry_.Tick();
  EXPECT_EQ(registry_.catalogue().FindProcess("desk"), nullptr);
}

TEST_F(RegistryTest, OnlyAnAbsentProcessCanBeForgotten) {
  Join("robot", 1);

  EXPECT_EQ(registry_.Forget("robot").error().message,
            "process 'robot' is not gone; only a process that is gone can be forgotten");
  EXPECT_EQ(registry_.Forget("robott").error().message,
            "no process 'robott'; did you mean 'robot'?");
}

TEST_F(RegistryTest, AReportWithoutChangesAddsNoRevision) {
  const SessionToken robot = Join("robot", 1, {test::Arm()});
  const std::uint64_t before = registry_.catalogue().revision();

  ASSERT_TRUE(registry_.Report(
      robot, {{{.kind = Kind::kComponent, .process = "robot", .components = {test::Arm()}},
               {.kind = Kind::kComponentRemoved, .process = "robot", .component = "none"},
               {.kind = Kind::kConnectionRemoved, .process = "robot", .connection = 17}}}));

  EXPECT_EQ(registry_.catalogue().revision(), before);
}

TEST_F(RegistryTest, AProcessCanReportOnlyAboutItself) {
  const SessionToken robot = Join("robot", 1, {test::Arm()});
  Join("desk", 2);
  auto imposter = test::ProcessNamed("robot", 99);
  imposter.state = ProcessState::kLost;
  ConnectionDescription foreign = Connection();
  const Catalogue before = registry_.catalogue();
  const std::vector<CatalogueChange> changes = {
      {.kind = Kind::kComponent, .process = "desk", .components = {test::Arm()}},
      {.kind = Kind::kProcessRemoved, .process = "robot"},
      {.kind = Kind::kProcess, .process = "robot"},
      {.kind = Kind::kComponent, .process = "robot", .components = {test::Arm(""), test::Arm()}},
      {.kind = Kind::kComponent, .process = "robot", .components = {test::Arm("a/b")}},
      {.kind = Kind::kConnection, .process = "robot", .connections = {foreign}}};
  for (const CatalogueChange& change : changes) {
    EXPECT_FALSE(registry_.Report(robot, {{change}}));
    EXPECT_EQ(registry_.catalogue(), before);
  }

  // A process may report its own address, but not change its identity or its state.
  ASSERT_TRUE(registry_.Report(
      robot, {{{.kind = Kind::kProcess, .process = "robot", .processes = {imposter}}}}));
  EXPECT_EQ(Process("robot").address, imposter.address);
  EXPECT_EQ(Process("robot").instance, 1U);
  EXPECT_EQ(Process("robot").state, ProcessState::kAlive);
}

TEST_F(RegistryTest, AnInvalidChangeDoesNotBlockTheOthers) {
  const SessionToken robot = Join("robot", 1);

  EXPECT_FALSE(registry_.Report(
      robot, {{{.kind = Kind::kComponent, .process = "robot"},
               {.kind = Kind::kComponent, .process = "robot", .components = {test::Arm()}}}}));

  EXPECT_NE(registry_.catalogue().FindComponent("robot", "arm"), nullptr);
}

TEST_F(RegistryTest, RefusesAnInvalidJoinEntirely) {
  const auto process = test::ProcessNamed("robot", 1);
  const auto invalid = [&](message::Join join) {
    EXPECT_EQ(JoinError(std::move(join)).code, ErrorCode::kInvalid);
    EXPECT_TRUE(registry_.catalogue().processes().empty());
  };
  invalid({test::ProcessNamed("", 1), {}, {}});
  invalid({test::ProcessNamed("a b", 1), {}, {}});
  invalid({test::ProcessNamed(std::string(1U << 20U, 'x'), 1), {}, {}});
  invalid({process, {test::Arm(), test::Arm()}, {}});
  invalid({process, {test::Arm("\x1b[31m")}, {}});
  invalid({process, {}, {Connection()}});
  invalid({test::ProcessNamed("desk", 1), {}, {Connection(1), Connection(2)}});
  ComponentDescription bad_member = test::Arm();
  bad_member.provided[0].commands[0].name = "Move To";
  invalid({process, {bad_member}, {}});
}

TEST_F(RegistryTest, KeepsFreeTextPrintableAndShort) {
  ComponentDescription arm = test::Arm();
  arm.fault = "\x1b[2J" + std::string(1U << 20U, 'x');
  auto process = test::ProcessNamed("robot", 1);
  process.host = "evil\n";
  ASSERT_TRUE(registry_.Join({process, {arm}, {}}, 0, nullptr));

  const std::string fault = registry_.catalogue().FindComponent("robot", "arm")->fault;
  EXPECT_EQ(fault.substr(0, 8), "\\x1b[2Jx");
  EXPECT_LT(fault.size(), 5000U);
  EXPECT_EQ(Process("robot").host, "evil\\x0a");
}

TEST_F(RegistryTest, ALostProcessKeepsItsConnectionsAsWanted) {
  registry_.End(Join("desk", 1, {test::Teleoperation()}, {Connection()}), ProcessState::kLost, "x");

  const auto* connection = registry_.catalogue().FindConnection(kRobot);
  ASSERT_NE(connection, nullptr);
  EXPECT_EQ(connection->state, ConnectionState::kPending);
  EXPECT_EQ(connection->reason, "process 'desk' is gone");
}

TEST_F(RegistryTest, RestoresConnectionsWhenBothEndsReturn) {
  const SessionToken robot = Join("robot", 1, {test::Arm()});
  registry_.End(Join("desk", 2, {test::Teleoperation()}, {Connection()}), ProcessState::kLost, "x");
  EXPECT_TRUE(registry_.TakeDueConnections().empty());

  const SessionToken desk = Join("desk", 3);
  EXPECT_TRUE(registry_.TakeDueConnections().empty());
  ASSERT_TRUE(registry_.Report(
      desk, {{{.kind = Kind::kComponent, .components = {test::Teleoperation()}}}}));

  EXPECT_EQ(registry_.TakeDueConnections(),
            (std::vector{message::ConnectionEnds{kRobot, kControl}}));
  EXPECT_TRUE(registry_.TakeDueConnections().empty());
  EXPECT_TRUE(registry_.Renew(robot));
}

TEST_F(RegistryTest, RestoresConnectionsOnlyToTheSameClass) {
  Join("robot", 1, {test::Arm()});
  registry_.End(Join("desk", 2, {test::Teleoperation()}, {Connection()}), ProcessState::kLost, "x");
  ComponentDescription other = test::Teleoperation();
  other.class_name = "Joystick";

  const SessionToken desk = Join("desk", 3, {other});
  EXPECT_TRUE(registry_.TakeDueConnections().empty());

  ASSERT_TRUE(registry_.Report(
      desk, {{{.kind = Kind::kComponent, .components = {test::Teleoperation()}}}}));
  EXPECT_TRUE(registry_.TakeDueConnections().empty());
}

TEST_F(RegistryTest, RestoresNothingToAContinuingInstance) {
  Join("robot", 1, {test::Arm()});
  registry_.End(Join("desk", 2, {test::Teleoperation()}, {Connection()}), ProcessState::kLost, "x");

  Join("desk", 2, {test::Teleoperation()});

  EXPECT_TRUE(registry_.TakeDueConnections().empty());
  EXPECT_EQ(registry_.catalogue().FindConnection(kRobot), nullptr);
}

TEST_F(RegistryTest, RestoresNothingOverANewConnection) {
  Join("robot", 1, {test::Arm()});
  registry_.End(Join("desk", 2, {test::Teleoperation()}, {Connection()}), ProcessState::kLost, "x");
  registry_.End(Join("desk", 3, {test::Teleoperation()}, {Connection(9)}), ProcessState::kLost,
                "x");
  EXPECT_TRUE(registry_.TakeDueConnections().empty());

  ASSERT_TRUE(registry_.Forget("desk"));
  Join("desk", 4, {test::Teleoperation()});
  EXPECT_TRUE(registry_.TakeDueConnections().empty());
}

TEST_F(RegistryTest, RestoresConnectionsAfterARepeatedCrash) {
  Join("robot", 1, {test::Arm()});
  registry_.End(Join("desk", 2, {test::Teleoperation()}, {Connection()}), ProcessState::kLost, "x");
  registry_.End(Join("desk", 3), ProcessState::kLost, "x");

  Join("desk", 4, {test::Teleoperation()});

  EXPECT_EQ(registry_.TakeDueConnections(),
            (std::vector{message::ConnectionEnds{kRobot, kControl}}));
}

}  // namespace
}  // namespace tendon::server
