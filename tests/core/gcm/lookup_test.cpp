#include <gtest/gtest.h>
#include <tendon/gcm/lookup.h>
#include <tendon/interface/compatibility.h>
#include <tests/core/gcm/samples.h>

namespace tendon {
namespace {

using test::kControl;
using test::kRobot;
using Kind = CatalogueChange::Kind;

class Lookup : public testing::Test {
 protected:
  Lookup() {
    Apply(
        {.kind = Kind::kProcess, .process = "desk", .processes = {test::ProcessNamed("desk", 1)}});
    Apply({.kind = Kind::kComponent, .process = "desk", .components = {test::Teleoperation()}});
    Apply({.kind = Kind::kProcess, .process = "robot", .processes = {robot_}});
    Apply({.kind = Kind::kComponent, .process = "robot", .components = {test::Arm()}});
    Apply({.kind = Kind::kComponent, .process = "robot", .components = {test::FakeArm()}});
  }

  void Apply(CatalogueChange change) {
    change.revision = catalogue_.revision() + 1;
    ASSERT_TRUE(catalogue_.Apply(change));
  }

  void SetState(const std::string& process, ProcessState state) {
    auto description = catalogue_.FindProcess(process)->process;
    description.state = state;
    Apply({.kind = Kind::kProcess, .process = process, .processes = {description}});
  }

  void Connect(const InterfaceName& required, const InterfaceName& provided,
               ConnectionState state = ConnectionState::kActive) {
    const ConnectionDescription connection{
        .id = 1, .required = required, .provided = provided, .state = state};
    Apply({.kind = Kind::kConnection, .process = required.process, .connections = {connection}});
  }

  /// Returns code and text of the error: "not found: no process ..."
  [[nodiscard]] std::string PlanError(const InterfaceName& required,
                                      const InterfaceName& provided) const {
    const auto plan = PlanConnect(catalogue_, {required, provided});
    if (plan) return "no error";
    return std::string(ToString(plan.error().code)) + ": " + plan.error().message;
  }

  [[nodiscard]] std::string CommandError(const std::string& path) const {
    const auto command = LookUpCommand(catalogue_, *ParsePath(path));
    return command ? "no error" : command.error().message;
  }

  const ProcessDescription robot_ = test::ProcessNamed("robot", 2);
  Catalogue catalogue_;
};

TEST_F(Lookup, APlanHasTheAddressOfTheProvider) {
  const auto plan = PlanConnect(catalogue_, {kRobot, kControl});

  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_EQ(plan->ends, (message::ConnectionEnds{kRobot, kControl}));
  EXPECT_EQ(plan->address, robot_.address);
  EXPECT_EQ(plan->instance, robot_.instance);
}

TEST_F(Lookup, AnUnknownNameIsReportedWithASuggestion) {
  EXPECT_EQ(PlanError(kRobot, {"robot", "arn", "Control"}),
            "not found: no component 'robot/arn'; did you mean 'arm'?");
  EXPECT_EQ(PlanError(kRobot, {"robot", "arm", "Kontrol"}),
            "not found: no provided interface 'robot/arm/Kontrol'; did you mean 'Control'?");
  EXPECT_EQ(PlanError({"desk", "teleoperation", "Robo"}, kControl),
            "not found: no required interface 'desk/teleoperation/Robo'; did you mean 'Robot'?");
  EXPECT_EQ(PlanError({"dsk", "teleoperation", "Robot"}, kControl),
            "not found: no process 'dsk'; did you mean 'desk'?");
  EXPECT_EQ(PlanError({"elsewhere", "teleoperation", "Robot"}, kControl),
            "not found: no process 'elsewhere'; there is 'desk', 'robot'");
}

TEST_F(Lookup, ConnectingToAnUnknownProcessIsPending) {
  const auto plan = PlanConnect(catalogue_, {kRobot, {"elsewhere", "arm", "Control"}});

  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_EQ(plan->address, "");
}

TEST_F(Lookup, AReplacementMayRepeatTheConnection) {
  Connect(kRobot, kControl);

  EXPECT_TRUE(PlanConnect(catalogue_, {kRobot, kControl}, WhenConnected::kReplace));
}

TEST_F(Lookup, AnAbsentProviderReplacesOnlyFailedConnections) {
  const message::ConnectionEnds ends{kRobot, {"elsewhere", "arm", "Control"}};
  Connect(kRobot, kControl);
  EXPECT_EQ(
      PlanConnect(catalogue_, ends, WhenConnected::kReplace).error().message,
      "desk/teleoperation/Robot stays connected to robot/arm/Control, because the new provided "
      "interface must be available first: no process 'elsewhere'; there is 'desk', 'robot'");

  Connect(kRobot, kControl, ConnectionState::kFailed);

  EXPECT_TRUE(PlanConnect(catalogue_, ends, WhenConnected::kReplace));
}

TEST_F(Lookup, ReportsAnInterfaceOfTheWrongKind) {
  EXPECT_EQ(PlanError(kRobot, kRobot),
            "not found: desk/teleoperation/Robot is a required interface; a provided interface is "
            "needed; desk/teleoperation has none");
  EXPECT_EQ(PlanError(kControl, kControl),
            "not found: robot/arm/Control is a provided interface; a required interface is needed; "
            "robot/arm has none");
}

TEST_F(Lookup, EscapesAnInvalidName) {
  EXPECT_EQ(PlanError(kRobot, {"robot", "a\x1b[31m", "Control"}),
            "invalid: component name 'a\\x1b[31m' has '\\x1b' at 2; allowed: letters digits _ - "
            "(max 64)");
  EXPECT_EQ(PlanError({"teleoperation", "Robot"}, kControl), "invalid: process name is empty");
}

TEST_F(Lookup, IncompatibleEndsGetTheCommonRefusal) {
  const InterfaceName fake("robot", "fake", "Control");
  const auto compatibility =
      Compare(*catalogue_.FindRequired(kRobot), *catalogue_.FindProvided(fake));
  ASSERT_FALSE(compatibility.fits());

  EXPECT_EQ(PlanError(kRobot, fake),
            "incompatible: " + Refusal(ToString(kRobot), ToString(fake), compatibility));
}

TEST_F(Lookup, ReportsTheExistingConnectionAndTheRemedy) {
  Connect(kRobot, kControl);

  EXPECT_EQ(PlanError(kRobot, {"robot", "fake", "Control"}),
            "exists: desk/teleoperation/Robot is connected to robot/arm/Control; to replace this "
            "connection: gcm connect desk/teleoperation/Robot robot/fake/Control --replace");
  EXPECT_EQ(PlanError(kRobot, kControl),
            "exists: desk/teleoperation/Robot is connected to robot/arm/Control already");
}

TEST_F(Lookup, ReportsPendingAndRefusedConnectionsAsSuch) {
  Connect(kRobot, kControl);
  ConnectionDescription connection = *catalogue_.FindConnection(kRobot);
  const auto set = [&](ConnectionState state, const std::string& reason) {
    connection.state = state;
    connection.reason = reason;
    Apply({.kind = Kind::kConnection, .process = "desk", .connections = {connection}});
  };

  set(ConnectionState::kPending, "process 'robot' does not answer");
  EXPECT_EQ(PlanError(kRobot, kControl),
            "exists: desk/teleoperation/Robot waits to be connected to robot/arm/Control already: "
            "process 'robot' does not answer; to see why: gcm explain desk/teleoperation/Robot; to "
            "cancel the connection: gcm disconnect desk/teleoperation/Robot");
  set(ConnectionState::kFailed, "it does not fit");
  EXPECT_EQ(
      PlanError(kRobot, kControl)
          .find("exists: desk/teleoperation/Robot was refused by robot/arm/Control already: it "),
      0U);
}

TEST_F(Lookup, FindsAConnectionByNumber) {
  Connect(kRobot, kControl);

  EXPECT_EQ(*LookUpConnected(catalogue_, "1"), kRobot);
  EXPECT_EQ(*LookUpConnected(catalogue_, "desk/1"), kRobot);
  EXPECT_EQ(*LookUpConnected(catalogue_, "desk/teleoperation/Robot"), kRobot);
  EXPECT_EQ(*LookUpConnected(catalogue_, "desk/teleoperation/1"),
            InterfaceName("desk", "teleoperation", "1"));
  EXPECT_EQ(LookUpConnected(catalogue_, "robot/1").error().message,
            "no connection has the number robot/1");

  const InterfaceName other("robot", "follower", "Robot");
  Connect(other, kControl);
  const auto ambiguous = LookUpConnected(catalogue_, "1");
  ASSERT_FALSE(ambiguous);
  EXPECT_EQ(ambiguous.error().code, ErrorCode::kInvalid);
  EXPECT_EQ(
      ambiguous.error().message,
      "more than one connection has the number 1: desk/1 belongs to desk/teleoperation/Robot, "
      "robot/1 belongs to robot/follower/Robot");
}

TEST_F(Lookup, ConnectingToALostProcessIsPendingIfItFits) {
  SetState("robot", ProcessState::kLost);

  const auto plan = PlanConnect(catalogue_, {kRobot, kControl});
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_EQ(plan->address, "");
  EXPECT_EQ(PlanError(kRobot, {"robot", "fake", "Control"}).substr(0, 12), "incompatible");
}

TEST_F(Lookup, RefusesToConnectFromALostProcess) {
  SetState("desk", ProcessState::kLost);
  EXPECT_EQ(PlanError(kRobot, kControl), "failed: process 'desk' is lost; start it again first");
  SetState("desk", ProcessState::kLeft);
  EXPECT_EQ(PlanError(kRobot, kControl), "failed: process 'desk' has left; start it again first");
  SetState("desk", ProcessState::kSuspect);
  EXPECT_EQ(PlanError(kRobot, kControl), "no error");
}

TEST_F(Lookup, ADisconnectNeedsAConnection) {
  EXPECT_EQ(PlanDisconnect(catalogue_, kRobot).error().message,
            "desk/teleoperation/Robot is not connected: there is nothing to disconnect");
  Connect(kRobot, kControl);

  const auto plan = PlanDisconnect(catalogue_, kRobot);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->provided, kControl);
}

TEST_F(Lookup, FindsCommandsAndColumns) {
  const auto command = LookUpCommand(catalogue_, *ParsePath("robot/arm/Control.MoveTo"));
  ASSERT_TRUE(command);
  EXPECT_EQ(command->signature.kind, CommandKind::kWrite);

  const auto column = LookUpCommand(catalogue_, *ParsePath("robot/arm/state.Joints.position[0]"));
  ASSERT_TRUE(column);
  EXPECT_EQ(column->signature, (SignatureOf<None, test::Joints>(CommandKind::kRead)));

  EXPECT_EQ(CommandError("robot/arm/Control.MoveToo"),
            "no command 'robot/arm/Control.MoveToo'; did you mean 'MoveTo'?");
  EXPECT_EQ(CommandError("robot/arm/stat.Joints"),
            "no provided interface 'robot/arm/stat'; did you mean 'state'?");
  EXPECT_EQ(CommandError("robot/arm/state.Joint"),
            "no column 'robot/arm/state.Joint'; did you mean 'Joints'?");
}

TEST_F(Lookup, ReportsACommandOfARequiredInterface) {
  EXPECT_EQ(CommandError("desk/teleoperation/Robot.Stop"),
            "desk/teleoperation/Robot is a required interface; a provided interface is needed; "
            "desk/teleoperation has none");
}

TEST_F(Lookup, ListsATableInterfaceOnce) {
  ComponentDescription arm = test::Arm();
  arm.provided.push_back({.name = "state"});
  Apply({.kind = Kind::kComponent, .process = "robot", .components = {arm}});

  EXPECT_EQ(CommandError("robot/arm/Gripper.Stop"),
            "no provided interface 'robot/arm/Gripper'; there is 'Control', 'state'");
}

}  // namespace
}  // namespace tendon
