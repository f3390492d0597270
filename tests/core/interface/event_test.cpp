#include <gtest/gtest.h>
#include <tendon/interface/status_messages.h>

#include <string>
#include <thread>
#include <vector>

#include "core/interface/waiting_fixture.h"
#include "support/allocation_guard.h"
#include "support/record.h"

namespace tendon_test {
namespace {

using tendon::Connection;
using tendon::EventWaiter;
using tendon::Overflow;
using tendon::Status;

/// Handles and awaits the events of an Arm in every possible way.
struct Observer {
  tendon::Inbox inbox;
  tendon::RequiredInterface robot{"Robot", &inbox};
  EventWaiter<std::int32_t> limit;
  EventWaiter<tendon::None> stopped;
  Arm arm;
  std::unique_ptr<Connection> connection;

  void Connect() { connection = ConnectionOf(robot, arm.control); }
  void AwaitEvents() {
    robot.AddEventWaiter(limit, "LimitExceeded");
    robot.AddEventWaiter(stopped, "Stopped");
    Connect();
  }
};

struct Direct : Observer {
  std::vector<std::thread::id> threads;

  Direct() {
    robot.AddEventHandlerWrite(&Direct::OnLimit, this, "LimitExceeded", tendon::kThreadSafe);
    robot.AddEventHandlerVoid(&Direct::OnStopped, this, "Stopped", tendon::kThreadSafe);
    Connect();
  }
  void OnLimit(std::int32_t /*joint*/) { threads.push_back(std::this_thread::get_id()); }
  void OnStopped() { threads.push_back(std::this_thread::get_id()); }
};

TEST(DirectHandler, RunsInTheRaisersThread) {
  Direct client;

  std::jthread raiser([&] {
    client.arm.limit_exceeded(1);
    client.arm.stopped();
    EXPECT_EQ(client.threads, std::vector(2, std::this_thread::get_id()));
  });
}

TEST(DirectHandler, ThrowingCountsAsLostAndStopsNoOther) {
  struct Throwing {
    void OnStopped() { throw std::runtime_error("broken"); }
  } throwing;
  Arm arm;
  Teleoperation other;
  tendon::RequiredInterface robot("Robot", nullptr);
  robot.AddEventHandlerVoid(&Throwing::OnStopped, &throwing, "Stopped", tendon::kThreadSafe);
  const auto first = Connection::Make(robot, arm.control, "a/Robot", "arm/Control");
  const auto second = Connect(other, arm);

  arm.stopped();
  other.inbox.ExecuteQueued();

  EXPECT_EQ(arm.stopped.lost(), 1U);
  EXPECT_EQ(other.stops_seen, 1);
}

TEST(EventHandler, CanKeepOnlyTheLatest) {
  struct Latest : Observer {
    std::vector<std::int32_t> joints;
    Latest() {
      robot.AddEventHandlerWrite(&Latest::OnLimit, this, "LimitExceeded")
          .SetOverflow(Overflow::kLatestOnly);
      inbox.SetAccepting(true);
      Connect();
    }
    void OnLimit(std::int32_t joint) { joints.push_back(joint); }
  } client;

  for (std::int32_t joint = 0; joint < 100; ++joint) client.arm.limit_exceeded(joint);
  client.inbox.ExecuteQueued();

  EXPECT_EQ(client.joints, std::vector<std::int32_t>{99});
  EXPECT_EQ(client.arm.limit_exceeded.lost(), 0U);
}

TEST(EventHandler, IsNotCalledIfItsOptionalEventIsNotOffered) {
  struct Curious : Observer {
    int calls = 0;
    Curious() {
      robot.AddEventHandlerVoid(&Curious::Handle, this, "Danced", tendon::Need::kOptional);
      robot.AddEventHandlerVoid(&Curious::Handle, this, "Stopped", tendon::kThreadSafe,
                                tendon::Need::kOptional);
      Connect();
    }
    void Handle() { ++calls; }
  } client;

  client.arm.stopped();

  EXPECT_EQ(client.calls, 1);
}

TEST(Event, LossesAreCountedAtBothEnds) {
  Arm arm;
  Teleoperation teleoperation;
  teleoperation.robot.SetMailboxCapacity(2);
  const auto connection = Connect(teleoperation, arm);

  for (int i = 0; i < 5; ++i) arm.limit_exceeded(i);

  EXPECT_EQ(arm.limit_exceeded.lost(), 3U);
  EXPECT_EQ((*connection)->lost_events(), 3U);
}

TEST(Event, IsNotDeliveredWhileDisabled) {
  Arm arm;
  Teleoperation teleoperation;
  const auto connection = Connect(teleoperation, arm);

  arm.stopped.Disable();
  arm.stopped();
  arm.stopped.Enable();
  arm.stopped();
  teleoperation.inbox.ExecuteQueued();

  EXPECT_EQ(teleoperation.stops_seen, 1);
  EXPECT_EQ(arm.stopped.lost(), 0U);
}

TEST(EventWaiter, WaitsUntilTheEventIsRaised) {
  Observer client;
  client.AwaitEvents();
  std::jthread raiser([&] {
    client.arm.limit_exceeded(4);
    client.arm.stopped();
  });
  std::int32_t joint = 0;

  EXPECT_EQ(client.limit.Wait(joint, 60s), Status::kDone);
  EXPECT_EQ(joint, 4);
  EXPECT_EQ(client.stopped.Wait(60s), Status::kDone);
}

TEST(EventWaiter, ReturnsTheNewestQueuedEventOnce) {
  Observer client;
  client.AwaitEvents();
  client.arm.limit_exceeded(1);
  client.arm.limit_exceeded(2);
  std::int32_t joint = 0;

  EXPECT_EQ(client.limit.Wait(joint, 0ms), Status::kDone);
  EXPECT_EQ(joint, 2);
  EXPECT_EQ(client.limit.missed(), 1U);
  EXPECT_EQ(client.limit.Wait(joint, 1ms), Status::kTimeout);
}

TEST(EventWaiter, ForgetsEarlierEvents) {
  Observer client;
  client.AwaitEvents();
  client.arm.stopped();

  client.stopped.Forget();

  EXPECT_EQ(client.stopped.Wait(1ms), Status::kTimeout);
}

TEST(EventWaiter, ADisconnectEndsItsWait) {
  Observer client;
  EXPECT_EQ(client.stopped.Wait(60s), Status::kNotConnected);
  client.AwaitEvents();
  std::jthread manager([&] { client.connection->Close(0ms); });

  EXPECT_EQ(client.stopped.Wait(60s), Status::kNotConnected);
}

TEST(EventWaiter, AllocatesNothing) {
  Observer client;
  client.AwaitEvents();
  std::int32_t joint = 0;

  const tendon::AllocationGuard guard;
  client.arm.limit_exceeded(4);
  EXPECT_EQ(client.limit.Wait(joint, 60s), Status::kDone);
}

struct Heard {
  tendon::RequiredInterface messages{"Messages", nullptr};
  std::vector<std::string> texts;

  Heard() {
    messages.AddEventHandlerWrite(&Heard::OnStatus, this, "Status");
    messages.AddEventHandlerWrite(&Heard::OnWarning, this, "Warning");
    messages.AddEventHandlerWrite(&Heard::OnError, this, "Error");
  }
  void OnStatus(const std::string& text) { texts.push_back("status: " + text); }
  void OnWarning(const std::string& text) { texts.push_back("warning: " + text); }
  void OnError(const std::string& text) { texts.push_back("error: " + text); }
};

TEST(StatusMessages, AreEventsAndLogRecords) {
  static tendon::test::Record<std::string> records;
  tendon::AddLogSink([](tendon::LogLevel, std::string_view source, std::string_view text) {
    records.Add(std::string(source) + ": " + std::string(text));
  });
  tendon::ProvidedInterface control("Control", nullptr);
  tendon::StatusMessages messages(control, "arm");
  Heard client;
  const auto connection =
      Connection::Make(client.messages, control, "desk/Messages", "arm/Control");
  ASSERT_TRUE(connection.ok());

  messages.SendStatus("homed");
  messages.SendWarning("warm");
  messages.SendError("hot");

  EXPECT_EQ(client.texts,
            (std::vector<std::string>{"status: homed", "warning: warm", "error: hot"}));
  EXPECT_EQ(records.values(), (std::vector<std::string>{"arm: homed", "arm: warm", "arm: hot"}));
}

}  // namespace
}  // namespace tendon_test
