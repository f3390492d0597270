#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/interface/compatibility.h>

#include <atomic>
#include <thread>

#include "core/interface/arm_fixture.h"
#include "support/allocation_guard.h"
#include "support/refusal.h"

namespace tendon_test {
namespace {

using tendon::Connection;
using tendon::ErrorCode;
using tendon::Status;
using tendon::test::Refusal;
using testing::HasSubstr;
using testing::MatchesRegex;
using namespace std::chrono_literals;

/// A server and a client that are connected.
struct Connected {
  Arm arm;
  Teleoperation teleoperation;
  std::unique_ptr<Connection> connection = std::move(*Connect(teleoperation, arm));
};

TEST(Function, ReportsThatItIsNotConnected) {
  Teleoperation teleoperation;

  EXPECT_EQ(teleoperation.stop(), Status::kNotConnected);
  EXPECT_FALSE(teleoperation.stop.is_connected());
}

TEST(Function, ReportsNotConnectedWithoutAnInterface) {
  tendon::VoidFunction stop;

  EXPECT_EQ(stop(), Status::kNotConnected);
}

TEST(Connection, CommandsRunInTheServersThreadInOrder) {
  Connected both;
  JointGoal first;
  first.position[0] = 1.0;
  JointGoal second;
  second.position[0] = 2.0;

  EXPECT_EQ(both.teleoperation.move_to(first), Status::kQueued);
  EXPECT_EQ(both.teleoperation.move_to(second), Status::kQueued);
  EXPECT_EQ(both.teleoperation.stop(), Status::kQueued);
  EXPECT_TRUE(both.arm.moves.empty());
  EXPECT_EQ(both.arm.inbox.ExecuteQueued(), 3U);

  EXPECT_EQ(both.arm.moves, (std::vector<JointGoal>{first, second}));
  EXPECT_EQ(both.arm.stops, 1);
}

TEST(Connection, DynamicPayloadsArriveComplete) {
  Connected both;

  EXPECT_EQ(both.teleoperation.say({"hello", {1.0, 2.0}}), Status::kQueued);
  EXPECT_EQ(both.teleoperation.say({"world", {}}), Status::kQueued);
  both.arm.inbox.ExecuteQueued();

  EXPECT_EQ(both.arm.texts, (std::vector<std::string>{"hello", "world"}));
}

TEST(Connection, ReadsGiveTheNewestRowAndNoSampleBeforeTheFirst) {
  Connected both;
  JointGoal read;

  EXPECT_EQ(both.teleoperation.get_joints(read), Status::kNoSample);
  both.arm.joints.position[3] = 0.5;
  both.arm.Advance();

  EXPECT_EQ(both.teleoperation.get_joints(read), Status::kDone);
  EXPECT_EQ(read.position[3], 0.5);
}

TEST(Connection, QualifiedReadsAnswerAndContainExceptions) {
  Connected both;
  both.arm.joints.position[6] = 0.25;
  both.arm.Advance();
  double position = 0.0;

  EXPECT_EQ(both.teleoperation.get_joint(6, position), Status::kDone);
  EXPECT_EQ(position, 0.25);
  EXPECT_EQ(both.teleoperation.get_joint(7, position), Status::kFailed);
}

TEST(Connection, EventsRunInTheClientsThread) {
  Connected both;

  both.arm.limit_exceeded(4);
  both.arm.stopped();
  EXPECT_TRUE(both.teleoperation.limits.empty());
  both.teleoperation.inbox.ExecuteQueued();

  EXPECT_EQ(both.teleoperation.limits, std::vector<std::int32_t>{4});
  EXPECT_EQ(both.teleoperation.stops_seen, 1);
}

TEST(Connection, AnEventReachesEveryConnectedClientOnce) {
  Arm arm;
  Teleoperation one;
  Teleoperation two;
  const auto first = Connect(one, arm);
  const auto second = Connect(two, arm);

  arm.limit_exceeded(1);
  one.inbox.ExecuteQueued();
  two.inbox.ExecuteQueued();

  EXPECT_EQ(one.limits, std::vector<std::int32_t>{1});
  EXPECT_EQ(two.limits, std::vector<std::int32_t>{1});
}

TEST(Connection, CallingAllocatesNothing) {
  Connected both;
  both.arm.Advance();
  JointGoal joints;
  double position = 0.0;
  both.arm.moves.reserve(8);
  both.teleoperation.limits.reserve(8);

  const tendon::AllocationGuard guard;
  EXPECT_EQ(both.teleoperation.move_to(joints), Status::kQueued);
  EXPECT_EQ(both.teleoperation.get_joints(joints), Status::kDone);
  EXPECT_EQ(both.teleoperation.get_joint(1, position), Status::kDone);
  both.arm.limit_exceeded(2);
  both.arm.inbox.ExecuteQueued();
  both.teleoperation.inbox.ExecuteQueued();
}

TEST(Connection, AFullMailboxRefusesAndCountsCalls) {
  Arm arm;
  Teleoperation teleoperation;
  teleoperation.robot.SetMailboxCapacity(4);
  const auto connection = std::move(*Connect(teleoperation, arm));

  for (int i = 0; i < 4; ++i) EXPECT_EQ(teleoperation.stop(), Status::kQueued);
  EXPECT_EQ(teleoperation.stop(), Status::kQueueFull);
  EXPECT_EQ(connection->refused(), 1U);
  EXPECT_EQ(connection->waiting(), 4U);
  arm.inbox.ExecuteQueued();

  EXPECT_EQ(arm.stops, 4);
  EXPECT_EQ(teleoperation.stop(), Status::kQueued);
}

TEST(Connection, CountsAnEventForAFullMailboxAsLost) {
  Arm arm;
  Teleoperation teleoperation;
  teleoperation.robot.SetMailboxCapacity(1);
  const auto connection = Connect(teleoperation, arm);

  arm.limit_exceeded(1);
  arm.limit_exceeded(2);

  EXPECT_EQ(arm.limit_exceeded.lost(), 1U);
}

TEST(Connection, AStoppedServerRefusesCalls) {
  Connected both;
  both.arm.inbox.SetAccepting(false);

  EXPECT_EQ(both.teleoperation.stop(), Status::kNotActive);
}

TEST(Connection, RefusesASecondConnectionOfARequiredInterface) {
  Connected both;
  Arm other;

  const auto second = Connect(both.teleoperation, other);

  ASSERT_FALSE(second.ok());
  EXPECT_EQ(second.error().code, ErrorCode::kExists);
  EXPECT_EQ(both.teleoperation.stop(), Status::kQueued);
}

TEST(Connection, ARefusalNamesBothEndsAndEveryMember) {
  Arm arm;
  tendon::RequiredInterface robot("Robot", nullptr);
  tendon::WriteFunction<JointGoalInDegrees> move_to;
  tendon::VoidFunction fly;
  tendon::WriteFunction<JointGoal> get_joints;
  robot.AddFunction(move_to, "MoveTo");
  robot.AddFunction(fly, "Fly");
  robot.AddFunction(get_joints, "GetJoints");

  const auto connection = Connection::Make(robot, arm.control, "desk/Robot", "arm/Control");

  ASSERT_FALSE(connection.ok());
  EXPECT_EQ(connection.error().code, ErrorCode::kIncompatible);
  EXPECT_EQ(connection.error().message,
            "desk/Robot does not fit arm/Control: needs write command 'MoveTo' of test.JointGoal, "
            "but the provider offers another test.JointGoal (position of test.JointGoal: "
            "float64[7] in deg "
            "needed, float64[7] in rad offered); missing void command 'Fly'; needs write command "
            "'GetJoints' of test.JointGoal, but the provider offers a read "
            "one");
  EXPECT_FALSE(move_to.is_connected());
}

TEST(Connection, AnOptionalFunctionWithoutAnOfferStaysEmpty) {
  Connected both;

  EXPECT_EQ(both.teleoperation.wave(), Status::kNotConnected);
  EXPECT_EQ(both.teleoperation.stop(), Status::kQueued);
}

TEST(Connection, TheSameTypeInAnotherLayoutIsConverted) {
  Arm arm;
  tendon::RequiredInterface robot("Robot", nullptr);
  tendon::WriteFunction<PaddedJointGoal> move_to;
  tendon::ReadFunction<PaddedJointGoal> get_joints;
  robot.AddFunction(move_to, "MoveTo");
  robot.AddFunction(get_joints, "GetJoints");
  const auto connection = Connection::Make(robot, arm.control, "desk/Robot", "arm/Control");
  ASSERT_TRUE(connection.ok()) << connection.error().message;
  PaddedJointGoal goal;
  goal.position[2] = 0.75;

  EXPECT_EQ(move_to(goal), Status::kQueued);
  arm.inbox.ExecuteQueued();
  ASSERT_EQ(arm.moves.size(), 1U);
  EXPECT_EQ(arm.moves[0].position[2], 0.75);

  arm.joints = arm.moves[0];
  arm.Advance();
  PaddedJointGoal read;
  EXPECT_EQ(get_joints(read), Status::kDone);
  EXPECT_EQ(read.position[2], 0.75);
}

TEST(Connection, ClosingExecutesAcceptedCallsThenRefuses) {
  Connected both;
  EXPECT_EQ(both.teleoperation.stop(), Status::kQueued);
  std::atomic<bool> done = false;
  std::thread server([&] {
    while (!done) both.arm.inbox.ExecuteQueued();
  });

  const std::size_t dropped = both.connection->Close(10s);
  done = true;
  server.join();

  EXPECT_EQ(dropped, 0U);
  EXPECT_EQ(both.arm.stops, 1);
  EXPECT_EQ(both.teleoperation.stop(), Status::kNotConnected);
}

TEST(Connection, ClosingDropsAndCountsUnexecutedCalls) {
  Connected both;
  EXPECT_EQ(both.teleoperation.stop(), Status::kQueued);
  both.arm.limit_exceeded(1);

  EXPECT_EQ(both.connection->Close(0ms), 2U);
  EXPECT_EQ(both.arm.inbox.ExecuteQueued(), 0U);
  both.arm.limit_exceeded(2);
  EXPECT_EQ(both.teleoperation.inbox.ExecuteQueued(), 0U);
}

TEST(Inbox, ANestedCallExecutesNothing) {
  struct Nesting {
    tendon::Inbox inbox;
    tendon::ProvidedInterface control{"Control", &inbox};
    std::size_t nested = 99;
    Nesting() {
      control.AddCommandVoid(&Nesting::Again, this, "Again");
      inbox.SetAccepting(true);
    }
    void Again() { nested = inbox.ExecuteQueued(); }
  } server;
  tendon::RequiredInterface required("R", nullptr);
  tendon::VoidFunction again;
  required.AddFunction(again, "Again");
  const auto connection = Connection::Make(required, server.control, "a/R", "b/Control");

  EXPECT_EQ(again(), Status::kQueued);
  EXPECT_EQ(again(), Status::kQueued);

  EXPECT_EQ(server.inbox.ExecuteQueued(), 2U);
  EXPECT_EQ(server.nested, 0U);
}

TEST(Inbox, RethrowsACommandsExceptionAndContinues) {
  struct Throwing {
    tendon::Inbox inbox;
    tendon::ProvidedInterface control{"Control", &inbox};
    int calls = 0;
    Throwing() {
      control.AddCommandVoid(&Throwing::Throw, this, "Throw");
      inbox.SetAccepting(true);
    }
    void Throw() {
      if (++calls == 1) throw std::runtime_error("broken");
    }
  } server;
  tendon::RequiredInterface required("R", nullptr);
  tendon::VoidFunction call;
  required.AddFunction(call, "Throw");
  const auto connection = Connection::Make(required, server.control, "a/R", "b/Control");
  EXPECT_EQ(call(), Status::kQueued);
  EXPECT_EQ(call(), Status::kQueued);

  EXPECT_THROW(server.inbox.ExecuteQueued(), std::runtime_error);
  EXPECT_EQ(server.inbox.ExecuteQueued(), 1U);
  EXPECT_EQ(server.calls, 2);
}

TEST(ProvidedInterface, RefusesADuplicateMemberNamingTheFirst) {
  Arm arm;
  const std::string found =
      " already exists in interface 'Control' \\(added at "
      "arm_fixture\\.h:[0-9]+\\)";

  EXPECT_THAT(Refusal([&] { arm.control.AddCommandVoid(&Arm::Stop, &arm, "Stop"); }),
              MatchesRegex("command 'Stop'" + found));
  EXPECT_THAT(Refusal([&] { arm.control.AddEvent(arm.stopped, "Stopped"); }),
              MatchesRegex("event 'Stopped'" + found));
  EXPECT_THAT(Refusal([&] { arm.control.AddEvent(arm.stopped, "Stop"); }),
              MatchesRegex("event 'Stop'" + found));
  EXPECT_THAT(Refusal([&] { arm.control.AddCommandVoid(&Arm::Stop, &arm, "Stop it"); }),
              HasSubstr("command name 'Stop it' has ' ' at 5"));
}

TEST(RequiredInterface, RefusesADuplicateMemberNamingTheFirst) {
  Teleoperation client;
  const std::string found =
      " already exists in interface 'Robot' \\(added at "
      "arm_fixture\\.h:[0-9]+\\)";

  EXPECT_THAT(Refusal([&] { client.robot.AddFunction(client.stop, "Stop"); }),
              MatchesRegex("function 'Stop'" + found));
  EXPECT_THAT(Refusal([&] {
                client.robot.AddEventHandlerVoid(&Teleoperation::OnStopped, &client, "Stopped");
              }),
              MatchesRegex("event handler 'Stopped'" + found));
}

TEST(ProvidedInterface, RefusesMembersOnceSealed) {
  Arm arm;
  arm.control.Seal();

  EXPECT_THROW(arm.control.AddCommandVoid(&Arm::Stop, &arm, "Halt"), tendon::ConfigurationError);
}

TEST(RequiredInterface, RefusesAMailboxCapacityOutOfRange) {
  Teleoperation teleoperation;

  EXPECT_THROW(teleoperation.robot.SetMailboxCapacity(0), tendon::ConfigurationError);
  EXPECT_THROW(teleoperation.robot.SetMailboxCapacity((1U << 24U) + 1), tendon::ConfigurationError);
}

/// A pointer and a goal fit into one cache line. With a time, they need two.
TEST(Connection, ReportsTheMemoryOfItsMailboxes) {
  Arm arm;
  Teleoperation teleoperation;
  tendon::RequiredInterface plain("Plain", nullptr);

  EXPECT_EQ(Connection::MailboxBytes(plain, arm.control), 64U * (64 + 64));
  EXPECT_EQ(Connection::MailboxBytes(teleoperation.robot, arm.control), 64U * (64 + 64));
  teleoperation.robot.AddEventHandlerWrite(&Arm::MoveTo, &arm, "Moved", tendon::Need::kOptional);
  teleoperation.robot.SetMailboxCapacity(3);
  EXPECT_EQ(Connection::MailboxBytes(teleoperation.robot, arm.control), 3U * (64 + 128));
}

TEST(Connection, ReconnectingUnderLoadLosesNoAcceptedCall) {
  Arm arm;
  Teleoperation teleoperation;
  std::atomic<bool> done = false;
  std::atomic<int> accepted = 0;
  std::thread server([&] {
    while (!done) {
      arm.inbox.ExecuteQueued();
      arm.stopped();
    }
    arm.inbox.ExecuteQueued();
  });
  std::thread client([&] {
    while (!done) {
      accepted += teleoperation.stop() == Status::kQueued ? 1 : 0;
      teleoperation.inbox.ExecuteQueued();
    }
  });

  std::size_t dropped = 0;
  for (int round = 0; round < 200; ++round) {
    const auto connection = Connect(teleoperation, arm);
    ASSERT_TRUE(connection.ok());
    const int before = accepted;
    while (accepted == before) std::this_thread::yield();
    dropped += (*connection)->Close(10s);
  }
  done = true;
  server.join();
  client.join();

  EXPECT_EQ(dropped, 0U);
  EXPECT_EQ(arm.stops, accepted);
  EXPECT_GT(teleoperation.stops_seen, 0);
}

}  // namespace
}  // namespace tendon_test
