#include <gtest/gtest.h>

#include "core/interface/waiting_fixture.h"
#include "support/allocation_guard.h"

namespace tendon_test {
namespace {

using tendon::Connection;
using tendon::ErrorCode;
using tendon::Status;

/// The time limit of waits; it only limits a failing test.
constexpr auto kLong = 60s;

struct WaitingPair {
  Planner planner;
  Operator client;
  std::unique_ptr<Connection> connection = std::move(*Connect(client, planner));
};

TEST(Waiting, ForAWriteReturnsAfterItsExecution) {
  WaitingPair both;
  const Executor server(both.planner.inbox);

  EXPECT_EQ(both.client.move.Wait(7, kLong), Status::kDone);

  EXPECT_EQ(both.planner.moves, std::vector<std::int32_t>{7});
}

TEST(Waiting, ForAVoidCommandReturnsAfterItsExecution) {
  WaitingPair both;
  const Executor server(both.planner.inbox);

  EXPECT_EQ(both.client.slow.Wait(kLong), Status::kDone);

  EXPECT_EQ(both.planner.slow_begun, 1);
}

TEST(Waiting, KeepsTheOrderOfEarlierCalls) {
  WaitingPair both;
  EXPECT_EQ(both.client.move(1), Status::kQueued);
  EXPECT_EQ(both.client.move(2), Status::kQueued);
  const Executor server(both.planner.inbox);

  EXPECT_EQ(both.client.move.Wait(3, kLong), Status::kDone);

  EXPECT_EQ(both.planner.moves, (std::vector<std::int32_t>{1, 2, 3}));
}

TEST(Waiting, ReturnsTheResultOfAVoidReturnCommand) {
  WaitingPair both;
  EXPECT_EQ(both.client.move(1), Status::kQueued);
  const Executor server(both.planner.inbox);
  std::int32_t count = 0;

  EXPECT_EQ(both.client.count.Wait(count, kLong), Status::kDone);

  EXPECT_EQ(count, 1);
}

TEST(Waiting, ReturnsTheDynamicResultOfAWriteReturnCommand) {
  WaitingPair both;
  EXPECT_EQ(both.client.move(5), Status::kQueued);
  const Executor server(both.planner.inbox);
  Message message;

  for (int i = 0; i < 200; ++i) {
    ASSERT_EQ(both.client.describe.Wait("moves: ", message, kLong), Status::kDone);
  }

  EXPECT_EQ(message.text, "moves: 1");
  EXPECT_EQ(message.numbers, std::vector<double>{5});
}

TEST(Waiting, ACallNotStartedByItsDeadlineIsNeverExecuted) {
  WaitingPair both;

  EXPECT_EQ(both.client.move.Wait(1, 1ms), Status::kTimeout);
  EXPECT_EQ(both.client.move(2), Status::kQueued);
  both.planner.inbox.ExecuteQueued();

  EXPECT_EQ(both.planner.moves, std::vector<std::int32_t>{2});
}

TEST(Waiting, ManyTimeoutsInARowLeaveTheConnectionUsable) {
  WaitingPair both;
  for (int round = 0; round < 3; ++round) {
    int timeouts = 0;
    while (both.client.move.Wait(1, 0ms) == Status::kTimeout) ++timeouts;
    EXPECT_EQ(timeouts, 64);
    EXPECT_EQ(both.client.move.Wait(1, 0ms), Status::kQueueFull);
    both.planner.inbox.ExecuteQueued();
  }
  EXPECT_TRUE(both.planner.moves.empty());
  const Executor server(both.planner.inbox);

  EXPECT_EQ(both.client.move.Wait(2, kLong), Status::kDone);
}

TEST(Waiting, ACallStartedByItsDeadlineHasAnUnknownOutcome) {
  WaitingPair both;
  both.planner.gate_is_open = false;
  const Executor server(both.planner.inbox);

  Status status = Status::kTimeout;
  while (status == Status::kTimeout) status = both.client.slow.Wait(20ms);

  EXPECT_EQ(status, Status::kOutcomeUnknown);
  both.planner.gate_is_open = true;
  EXPECT_EQ(both.client.move.Wait(1, kLong), Status::kDone);
}

TEST(Waiting, AThrowingCallFailsAndItsExceptionPropagates) {
  WaitingPair both;
  std::atomic<bool> is_thrown = false;
  std::jthread server([&] {
    while (!is_thrown) {
      try {
        both.planner.inbox.ExecuteQueued();
      } catch (const std::runtime_error&) {
        is_thrown = true;
      }
    }
  });

  EXPECT_EQ(both.client.fail.Wait(kLong), Status::kFailed);

  EXPECT_TRUE(EventuallyTrue([&] { return is_thrown.load(); }));
}

TEST(Waiting, ForAStoppedServerIsRefusedAtOnce) {
  WaitingPair both;
  both.planner.inbox.SetAccepting(false);
  std::int32_t count = 0;

  EXPECT_EQ(both.client.count.Wait(count, kLong), Status::kNotActive);
}

TEST(Waiting, EndsWithTheServersStopWithoutExecution) {
  WaitingPair both;
  Status status = Status::kDone;
  std::jthread client([&] { status = both.client.move.Wait(1, kLong); });
  ASSERT_TRUE(EventuallyTrue([&] { return both.connection->waiting() == 1; }));

  both.planner.inbox.SetAccepting(false);
  client.join();
  both.planner.inbox.SetAccepting(true);
  both.planner.inbox.ExecuteQueued();

  EXPECT_EQ(status, Status::kNotActive);
  EXPECT_TRUE(both.planner.moves.empty());
}

TEST(Waiting, ACallDroppedByARestartEndsWithNotActive) {
  WaitingPair both;
  Status status = Status::kDone;
  std::jthread client([&] { status = both.client.move.Wait(1, kLong); });
  ASSERT_TRUE(EventuallyTrue([&] { return both.connection->waiting() == 1; }));

  EXPECT_EQ(both.planner.inbox.DiscardQueued(), 1U);
  client.join();

  EXPECT_EQ(status, Status::kNotActive);
}

TEST(Waiting, WithoutAConnectionIsRefused) {
  Operator client;
  std::int32_t count = 0;

  EXPECT_EQ(client.count.Wait(count, kLong), Status::kNotConnected);
}

TEST(Waiting, ForTheCallersOwnThreadIsRefused) {
  WaitingPair both;
  both.planner.inbox.BindToThisThread();
  std::int32_t count = 0;

  EXPECT_EQ(both.client.count.Wait(count, kLong), Status::kWouldDeadlock);
  EXPECT_EQ(both.client.move.Wait(1, kLong), Status::kWouldDeadlock);
  EXPECT_EQ(both.client.move(1), Status::kQueued);
}

TEST(Waiting, RefusesASelfConnectionThatWouldDeadlock) {
  Planner planner;
  tendon::RequiredInterface self("Self", &planner.inbox);
  tendon::VoidReturnFunction<std::int32_t> count;
  self.AddFunction(count, "Count");

  const auto connection = Connection::Make(self, planner.plans, "planner/Self", "planner/Plans");

  ASSERT_FALSE(connection.ok());
  EXPECT_EQ(connection.error().message,
            "planner/Self would wait for its own thread: void-return command 'Count' of "
            "planner/Plans is executed by the task that calls it; call the method directly");
}

TEST(Waiting, EndsWithADisconnect) {
  WaitingPair both;
  Status status = Status::kDone;
  std::jthread client([&] { status = both.client.move.Wait(1, kLong); });
  ASSERT_TRUE(EventuallyTrue([&] { return both.connection->waiting() == 1; }));

  EXPECT_EQ(both.connection->Close(1ms), 1U);
  client.join();

  EXPECT_EQ(status, Status::kNotConnected);
  EXPECT_TRUE(both.planner.moves.empty());
}

TEST(Waiting, ADisconnectLetsAnActiveServerAnswerFirst) {
  WaitingPair both;
  Status status = Status::kTimeout;
  std::jthread client([&] { status = both.client.move.Wait(1, kLong); });
  ASSERT_TRUE(EventuallyTrue([&] { return both.connection->waiting() == 1; }));
  std::jthread manager([&] { both.connection->Close(kLong); });
  const Executor server(both.planner.inbox);
  client.join();

  EXPECT_EQ(status, Status::kDone);
}

TEST(Waiting, ForAThreadlessComponentCallsDirectly) {
  struct Plain {
    tendon::ProvidedInterface plans{"Plans", nullptr};
    Plain() { plans.AddCommandVoidReturn(&Plain::Count, this, "Count"); }
    void Count(std::int32_t& count) { count = 42; }
  } plain;
  tendon::RequiredInterface required("R", nullptr);
  tendon::VoidReturnFunction<std::int32_t> count;
  required.AddFunction(count, "Count");
  const auto connection = Connection::Make(required, plain.plans, "a/R", "b/Plans");
  std::int32_t result = 0;

  EXPECT_EQ(count.Wait(result, 0ms), Status::kDone);

  EXPECT_EQ(result, 42);
}

TEST(Waiting, ConvertsAReplyInAnotherLayout) {
  struct Server {
    tendon::Inbox inbox;
    tendon::ProvidedInterface control{"Control", &inbox};
    Server() {
      control.AddCommandWriteReturn(&Server::Turn, this, "Turn");
      inbox.SetAccepting(true);
    }
    void Turn(const JointGoal& from, JointGoal& to) { to.position[0] = -from.position[0]; }
  } server;
  tendon::RequiredInterface required("R", nullptr);
  tendon::WriteReturnFunction<PaddedJointGoal, PaddedJointGoal> turn;
  required.AddFunction(turn, "Turn");
  const auto connection = Connection::Make(required, server.control, "a/R", "b/Control");
  const Executor executor(server.inbox);
  PaddedJointGoal from;
  from.position[0] = 2.0;
  PaddedJointGoal to;

  EXPECT_EQ(turn.Wait(from, to, kLong), Status::kDone);

  EXPECT_EQ(to.position[0], -2.0);
  EXPECT_EQ((*connection)->converted(), std::vector<std::string>{"Turn"});
}

TEST(Waiting, AllocatesNothing) {
  WaitingPair both;
  const Executor server(both.planner.inbox);
  std::int32_t count = 0;

  const tendon::AllocationGuard guard;
  for (int i = 0; i < 100; ++i) {
    ASSERT_EQ(both.client.count.Wait(count, kLong), Status::kDone);
    ASSERT_EQ(both.client.slow.Wait(kLong), Status::kDone);
  }
}

}  // namespace
}  // namespace tendon_test
