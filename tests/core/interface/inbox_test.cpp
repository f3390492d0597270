#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <stop_token>
#include <thread>
#include <vector>

#include "core/interface/waiting_fixture.h"

namespace tendon_test {
namespace {

using tendon::Connection;
using tendon::Status;

struct Caller {
  tendon::Inbox inbox;
  tendon::RequiredInterface robot{"Robot", &inbox};
  tendon::VoidFunction stop;
  std::unique_ptr<Connection> connection;

  Caller() { robot.AddFunction(stop, "Stop"); }
  void Connect(Arm& arm) { connection = ConnectionOf(robot, arm.control); }
};

TEST(Inbox, FindsOneCallAmongHundredsOfConnections) {
  Arm arm;
  std::vector<Caller> callers(200);
  for (Caller& caller : callers) caller.Connect(arm);
  EXPECT_EQ(arm.inbox.ExecuteQueued(), 0U);

  for (const std::size_t i : {0U, 63U, 64U, 127U, 199U}) {
    EXPECT_FALSE(arm.inbox.has_queued());
    EXPECT_EQ(callers[i].stop(), Status::kQueued);
    EXPECT_TRUE(arm.inbox.has_queued());
    EXPECT_EQ(arm.inbox.ExecuteQueued(), 1U) << i;
    EXPECT_EQ(arm.inbox.ExecuteQueued(), 0U);
  }
  EXPECT_EQ(arm.stops, 5);
}

TEST(Inbox, ReusesAFreedPlaceForTheNextConnection) {
  Arm arm;
  std::vector<Caller> callers(3);
  for (Caller& caller : callers) caller.Connect(arm);
  EXPECT_EQ(callers[1].stop(), Status::kQueued);
  EXPECT_EQ(callers[1].connection->Close(0ms), 1U);
  EXPECT_FALSE(arm.inbox.has_queued());

  callers[1].Connect(arm);

  EXPECT_EQ(arm.inbox.ExecuteQueued(), 0U);
  EXPECT_EQ(callers[1].stop(), Status::kQueued);
  EXPECT_EQ(callers[2].stop(), Status::kQueued);
  EXPECT_EQ(arm.inbox.ExecuteQueued(), 2U);
}

TEST(Inbox, ExecutesCallsBeyondALimitTheNextTime) {
  Arm arm;
  std::vector<Caller> callers(2);
  for (Caller& caller : callers) {
    caller.Connect(arm);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(caller.stop(), Status::kQueued);
  }

  EXPECT_EQ(arm.inbox.ExecuteQueued(2), 2U);
  EXPECT_EQ(arm.inbox.ExecuteQueued(2), 2U);
  EXPECT_EQ(arm.inbox.ExecuteQueued(2), 2U);

  EXPECT_EQ(arm.inbox.ExecuteQueued(2), 0U);
  EXPECT_EQ(arm.stops, 6);
}

TEST(Inbox, AFastClientDoesNotStarveTheOthers) {
  struct Eager {
    tendon::Inbox inbox;
    tendon::ProvidedInterface control{"Control", &inbox};
    Caller fast;
    Caller other;
    int executed = 0;
    Eager() {
      control.AddCommandVoid(&Eager::Stop, this, "Stop");
      inbox.SetAccepting(true);
    }
    void Stop() {
      ++executed;
      EXPECT_EQ(fast.stop(), Status::kQueued);
    }
  } server;
  for (Caller* caller : {&server.fast, &server.other}) {
    caller->connection = std::move(
        *Connection::Make(caller->robot, server.control, "caller/Robot", "server/Control"));
  }
  EXPECT_EQ(server.fast.stop(), Status::kQueued);
  EXPECT_EQ(server.other.stop(), Status::kQueued);

  // Each call of the fast client posts another call. Only the calls that waited at the start are
  // executed.
  EXPECT_EQ(server.inbox.ExecuteQueued(), 2U);

  EXPECT_EQ(server.executed, 2);
}

TEST(Inbox, ChecksNoMailboxWhileIdle) {
  Arm arm;
  Caller caller;
  caller.Connect(arm);
  EXPECT_EQ(caller.stop(), Status::kQueued);
  EXPECT_EQ(arm.inbox.ExecuteQueued(), 1U);
  constexpr int kMany = 1000;  // number of passes without calls, in which the flag is not set
  for (int i = 0; i < kMany; ++i) EXPECT_EQ(arm.inbox.ExecuteQueued(), 0U);
  EXPECT_EQ(arm.inbox.size(), 0U);

  std::jthread producer([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      if (!caller.stop()) std::this_thread::yield();
    }
  });
  const bool all_arrive = EventuallyTrue([&] {
    arm.inbox.ExecuteQueued();
    return arm.stops > 20'000;
  });
  producer.request_stop();
  producer.join();

  EXPECT_TRUE(all_arrive);
  arm.inbox.ExecuteQueued();
  EXPECT_EQ(arm.inbox.size(), 0U) << "a call waits under a flag that is down";
}

/// A planner whose thread is inside a handler that does not return yet.
struct Stuck : testing::Test {
  Planner planner;
  Operator person;
  std::unique_ptr<Connection> connection = std::move(*Connect(person, planner));
  std::unique_ptr<Executor> executor = std::make_unique<Executor>(planner.inbox);

  void SetUp() override {
    planner.gate_is_open = false;
    ASSERT_EQ(person.slow(), Status::kQueued);
    ASSERT_EQ(person.move(1), Status::kQueued);
    ASSERT_TRUE(EventuallyTrue([this] { return planner.slow_begun == 1; }));
  }
  void TearDown() override {
    planner.gate_is_open = true;
    executor.reset();
  }
};

using HungHandler = Stuck;

TEST_F(HungHandler, DoesNotBlockADisconnect) {
  EXPECT_EQ(connection->Close(0ms), 2U);  // the running call and the waiting call
  connection.reset();

  EXPECT_EQ(person.move(2), Status::kNotConnected);
  planner.gate_is_open = true;
  executor.reset();
  EXPECT_TRUE(planner.moves.empty()) << "what was dropped is not executed afterwards";
}

TEST_F(HungHandler, DoesNotBlockAnotherConnection) {
  Operator other;
  const auto second = Connect(other, planner);
  ASSERT_TRUE(second.ok());
  EXPECT_EQ(other.move(7), Status::kQueued);

  planner.gate_is_open = true;

  EXPECT_EQ((*second)->Close(60s), 0U);
  EXPECT_EQ(connection->Close(60s), 0U);
  executor.reset();
  EXPECT_EQ(planner.moves.size(), 2U);
}

TEST_F(HungHandler, DoesNotConfuseConnectionsOfOnePlace) {
  Operator other;
  Operator next;
  auto before = std::move(*Connect(other, planner));
  planner.gate_is_open = true;
  ASSERT_TRUE(EventuallyTrue([this] { return planner.inbox.size() == 0; }));
  planner.gate_is_open = false;
  ASSERT_EQ(person.slow(), Status::kQueued);
  ASSERT_TRUE(EventuallyTrue([this] { return planner.slow_begun == 2; }));

  before.reset();  // the thread will still look for calls of this interface
  const auto connected = Connect(next, planner);
  EXPECT_EQ(next.move(7), Status::kQueued);
  planner.gate_is_open = true;

  EXPECT_EQ((*connected)->Close(10s), 0U);
}

TEST(EventTime, IsTheTimeTheHandledEventWasRaised) {
  Arm arm;
  Teleoperation teleoperation;
  const auto connection = Connect(teleoperation, arm);
  const tendon::SteadyTime before = tendon::SteadyClock().Now();
  arm.limit_exceeded(1);
  const tendon::SteadyTime between = tendon::SteadyClock().Now();
  arm.stopped();
  const tendon::SteadyTime after = tendon::SteadyClock().Now();

  ASSERT_EQ(teleoperation.inbox.ExecuteQueued(1), 1U);
  EXPECT_GE(teleoperation.robot.event_time(), before);
  EXPECT_LE(teleoperation.robot.event_time(), between);
  ASSERT_EQ(teleoperation.inbox.ExecuteQueued(1), 1U);
  EXPECT_GE(teleoperation.robot.event_time(), between);
  EXPECT_LE(teleoperation.robot.event_time(), after);
}

TEST(EventTime, KeepsTheArgumentIntact) {
  struct Wide {
    tendon::Inbox inbox;
    tendon::RequiredInterface source{"Source", &inbox};
    JointGoal seen;
    Wide() {
      source.AddEventHandlerWrite(&Wide::OnGoal, this, "Goal");
      inbox.SetAccepting(true);
    }
    void OnGoal(const JointGoal& goal) { seen = goal; }
  } client;
  tendon::Inbox inbox;
  tendon::ProvidedInterface control("Control", &inbox);
  tendon::WriteEvent<JointGoal> goal;
  control.AddEvent(goal, "Goal");
  const auto connection = Connection::Make(client.source, control, "wide/Source", "arm/Control");
  const JointGoal raised{{1, 2, 3, 4, 5, 6, 7}};

  goal(raised);
  client.inbox.ExecuteQueued();

  EXPECT_EQ(client.seen, raised);
}

}  // namespace
}  // namespace tendon_test
