#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/manager/local_manager.h>
#include <tendon/task/main_task.h>
#include <tendon/task/periodic_task.h>

#include <atomic>
#include <chrono>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "support/leading.h"
#include "support/log/log_record.h"
#include "support/wait.h"

namespace {

using tendon::ComponentState;
using tendon::kNoWait;
using tendon::LocalManager;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using namespace std::chrono_literals;

using Task = leading::Leading<tendon::PeriodicTask>;

/// Two tasks; the first one leads the second.
class OrderlyShutdownTest : public testing::Test {
 protected:
  void Lead(const std::string& first, const std::string& second) {
    const auto connected = manager->Connect({first, "Next"}, {second, "Control"});
    ASSERT_TRUE(connected) << connected.error().message;
  }
  Task& Add(const std::string& name) { return manager->Add<Task>(name, story); }
  /// Starts both tasks, and waits until the mailbox between them was full several times.
  void Flood() {
    Lead("client", "server");
    client.floods = true;
    ASSERT_TRUE(manager->StartAll());
    ASSERT_TRUE(EventuallyTrue([this] { return client.refused > 2; }));
  }

  leading::Story story;
  std::optional<LocalManager> manager{std::in_place};
  Task& server = Add("server");
  Task& client = Add("client");
  const std::vector<std::string> in_order{"client ends", "server is stopped",
                                          "server ends, not connected"};
};

TEST_F(OrderlyShutdownTest, DestroyingAManagerExecutesTheLastCommands) {
  Lead("client", "server");
  ASSERT_TRUE(manager->StartAll());

  manager.reset();

  EXPECT_EQ(story.values(), in_order);
}

TEST_F(OrderlyShutdownTest, FollowsConnectionsNotTheOrderOfAddition) {
  Add("first");
  Lead("server", "first");
  Lead("first", "client");
  ASSERT_TRUE(manager->StartAll());

  manager.reset();

  EXPECT_THAT(story.values(), ElementsAre("server ends", "first is stopped", "first ends",
                                          "client is stopped", "client ends, not connected"));
}

TEST_F(OrderlyShutdownTest, DeliversTheLastCommandThroughAFullQueue) {
  server.work = 20ms;
  Flood();

  manager.reset();

  EXPECT_EQ(story.values(), in_order);
}

TEST_F(OrderlyShutdownTest, WaitsForABusyServer) {
  server.work = 150ms;
  Flood();

  manager.reset();

  EXPECT_EQ(story.values(), in_order);
}

TEST_F(OrderlyShutdownTest, StopsAllInOrder) {
  server.work = 20ms;
  Flood();

  EXPECT_TRUE(manager->StopAll());

  EXPECT_EQ(story.values(), in_order);
}

TEST_F(OrderlyShutdownTest, StoppingAClientExecutesItsLastCommands) {
  server.work = 20ms;
  Flood();

  ASSERT_TRUE(manager->Stop("client"));
  ASSERT_TRUE(manager->Stop("server"));

  EXPECT_EQ(story.values(), in_order);
}

TEST_F(OrderlyShutdownTest, ARemovalStopsBeforeItDisconnects) {
  server.work = 20ms;
  Flood();

  ASSERT_TRUE(manager->Remove("client"));

  EXPECT_THAT(story.values(), ElementsAre("client ends", "server is stopped"));
}

TEST_F(OrderlyShutdownTest, RemovingAServerKeepsItsClientRunning) {
  Lead("client", "server");
  ASSERT_TRUE(manager->StartAll());

  ASSERT_TRUE(manager->Remove("server"));

  EXPECT_EQ(client.state(), ComponentState::kActive);
  manager.reset();
  EXPECT_THAT(story.values(),
              ElementsAre("server ends, not connected", "client ends, not connected"));
}

TEST_F(OrderlyShutdownTest, BreaksCyclesDeterministically) {
  for (int round = 0; round < 3; ++round) {
    leading::Story told;
    {
      LocalManager circle;
      for (const char* name : {"a", "b", "c"}) circle.Add<Task>(name, told);
      ASSERT_TRUE(circle.Connect({"a", "Next"}, {"b", "Control"}));
      ASSERT_TRUE(circle.Connect({"b", "Next"}, {"c", "Control"}));
      ASSERT_TRUE(circle.Connect({"c", "Next"}, {"a", "Control"}));
      ASSERT_TRUE(circle.StartAll());
    }

    EXPECT_THAT(told.values(), ElementsAre("a ends", "b is stopped", "b ends", "c is stopped",
                                           "c ends, not active"));
  }
}

TEST_F(OrderlyShutdownTest, EndsAComponentThatLeadsItself) {
  Lead("client", "client");
  ASSERT_TRUE(manager->StartAll());

  EXPECT_TRUE(manager->StopAll());
}

TEST_F(OrderlyShutdownTest, EndsFollowersBeforeTheirLeader) {
  Lead("client", "server");
  ASSERT_TRUE(manager->RunAfter("client", "server"));
  ASSERT_TRUE(manager->StartAll());

  ASSERT_TRUE(manager->Stop("server"));

  EXPECT_EQ(story.values(), in_order);
}

TEST_F(OrderlyShutdownTest, EndsAFollowerOfAnotherManagersLeader) {
  LocalManager other;
  auto& leader = other.Add<Task>("leader", story);
  ASSERT_TRUE(client.RunAfter(leader));
  ASSERT_TRUE(other.StartAll());
  ASSERT_TRUE(manager->StartAll());

  EXPECT_TRUE(manager->StopAll());

  EXPECT_EQ(client.state(), ComponentState::kFinished);
  manager.reset();
  EXPECT_TRUE(other.StopAll());
}

TEST_F(OrderlyShutdownTest, EndsAClientThatLeadsItsServerInOneThread) {
  Lead("client", "server");
  ASSERT_TRUE(manager->RunAfter("server", "client"));
  ASSERT_TRUE(manager->StartAll());

  EXPECT_TRUE(manager->StopAll());

  EXPECT_THAT(story.values(), ElementsAre("server ends, not connected", "client ends, not active"));
}

TEST_F(OrderlyShutdownTest, DoesNotWaitForASuspendedServer) {
  Lead("client", "server");
  ASSERT_TRUE(manager->StartAll());
  ASSERT_TRUE(manager->Suspend("server"));

  manager.reset();

  EXPECT_THAT(story.values(), ElementsAre("client ends, not active", "server ends, not connected"));
}

TEST_F(OrderlyShutdownTest, ABusyComponentDelaysOnlyItsServers) {
  auto& busy = Add("busy");
  ASSERT_TRUE(manager->StartAll());
  busy.holds = true;
  ASSERT_TRUE(EventuallyTrue([&] { return busy.is_held.load(); }));
  bool is_released = false;
  std::thread releasing([&] {
    is_released = EventuallyTrue([&] { return client.state() == ComponentState::kFinished; }, 10s);
    busy.holds = false;
  });

  EXPECT_TRUE(manager->StopAll(20s));

  releasing.join();
  EXPECT_TRUE(is_released);
}

TEST_F(OrderlyShutdownTest, LogsThatTheLastCommandWasNotExecuted) {
  const tendon_test::LogRecord log("client");
  Lead("client", "server");
  server.executes = false;
  ASSERT_TRUE(manager->StartAll());

  (void)manager->StopAll(500ms);

  EXPECT_THAT(log.texts(), ElementsAre(HasSubstr("some of its last calls were not executed")));
  EXPECT_TRUE(server.WaitFor(ComponentState::kFinished, 20s));
}

TEST_F(OrderlyShutdownTest, DoesNotWaitForAServerOfThisThread) {
  const tendon_test::LogRecord log("client");
  auto& here = manager->Add<leading::Leading<tendon::MainTask>>("here", story);
  Lead("client", "here");
  ASSERT_TRUE(manager->StartAll(kNoWait));
  ASSERT_TRUE(EventuallyTrue([&] { return here.Cycle(); }));
  ASSERT_TRUE(client.WaitFor(ComponentState::kActive, 20s));

  manager.reset();

  EXPECT_THAT(log.texts(), IsEmpty());
}

}  // namespace
