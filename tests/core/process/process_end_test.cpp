#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/task/periodic_task.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "support/leading.h"
#include "support/log/log_record.h"
#include "support/network_test.h"

namespace {

using leading::Story;
using tendon::ComponentState;
using tendon::InterfaceName;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using namespace std::chrono_literals;
using Task = leading::Leading<tendon::PeriodicTask>;

const InterfaceName kClient("desk", "client", "Next");
const InterfaceName kServer("robot", "server", "Control");

/// Process desk has a client that leads a server of process robot.
class ProcessEnd : public NetworkTest {
 protected:
  void SetUp() override {
    robot = Start("robot");
    server = &robot->Add<Task>("server", story);
    ASSERT_TRUE(robot->StartAll());
    StartDesk();
  }
  void StartDesk() {
    desk = Start("desk");
    client = &desk->Add<Task>("client", story);
    const auto connected = desk->Connect(kClient, kServer);
    ASSERT_TRUE(connected) << connected.error().message;
    ASSERT_TRUE(EventuallyActive(*desk, 1)) << desk->connections().front().reason;
    ASSERT_TRUE(desk->StartAll());
  }
  /// Waits until both run and the mailbox between them was full several times.
  void Flood() {
    const std::uint64_t before = client->refused;
    client->floods = true;
    ASSERT_TRUE(EventuallyTrue([&] { return client->refused > before + 2; }));
  }

  Story story;
  std::unique_ptr<tendon::Process> robot;
  std::unique_ptr<tendon::Process> desk;
  Task* server = nullptr;
  Task* client = nullptr;
};

INSTANTIATE_TEST_SUITE_P(Over, ProcessEnd, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

TEST_P(ProcessEnd, ExecutesTheLastCommandsOfAClient) {
  desk.reset();

  EXPECT_THAT(story.values(), ElementsAre("client ends", "server is stopped"));
}

TEST_P(ProcessEnd, ExecutesTheLastCommandsBehindAFullQueue) {
  server->work = 5ms;
  for (int round = 0; round < 5; ++round) {
    Flood();
    desk.reset();
    StartDesk();
  }

  std::vector<std::string> lines;
  for (int round = 0; round < 5; ++round) {
    lines.insert(lines.end(), {"client ends", "server is stopped"});
  }
  EXPECT_EQ(story.values(), lines);
}

TEST_P(ProcessEnd, WaitsForABusyServer) {
  server->work = 150ms;
  Flood();

  desk.reset();

  EXPECT_THAT(story.values(), ElementsAre("client ends", "server is stopped"));
}

TEST_P(ProcessEnd, StoppingAClientExecutesItsLastCommands) {
  server->work = 20ms;
  Flood();

  ASSERT_TRUE(desk->Stop("client"));
  ASSERT_TRUE(robot->Stop("server"));

  EXPECT_THAT(story.values(),
              ElementsAre("client ends", "server is stopped", "server ends, not connected"));
}

TEST_P(ProcessEnd, ARemovalStopsBeforeItDisconnects) {
  server->work = 20ms;
  Flood();

  ASSERT_TRUE(desk->Remove("client"));

  EXPECT_THAT(story.values(), ElementsAre("client ends", "server is stopped"));
}

TEST_P(ProcessEnd, OfTheServersProcessKeepsTheClientRunning) {
  robot.reset();

  EXPECT_EQ(client->state(), ComponentState::kActive);
  EXPECT_TRUE(EventuallyPending(*desk));
  desk.reset();
  EXPECT_THAT(story.values(),
              ElementsAre("server ends, not connected", "client ends, not connected"));
}

TEST_P(ProcessEnd, DoesNotWaitForASuspendedServer) {
  const tendon_test::LogRecord log("client");
  ASSERT_TRUE(robot->Suspend("server"));

  desk.reset();

  EXPECT_THAT(log.texts(), testing::IsEmpty());
}

TEST_P(ProcessEnd, LogsThatTheLastCommandWasNotExecuted) {
  const tendon_test::LogRecord log("client");
  server->executes = false;

  desk.reset();

  EXPECT_THAT(log.texts(), Contains(HasSubstr("some of its last calls were not executed")));
  EXPECT_THAT(story.values(), Not(Contains("server is stopped")));
}

}  // namespace
