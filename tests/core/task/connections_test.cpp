#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/interface/function.h>
#include <tendon/manager/local_manager.h>
#include <tendon/task/callback_task.h>
#include <tendon/task/periodic_task.h>
#include <tendon/task/signal_task.h>

#include <atomic>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "core/task/scripted.h"
#include "support/allocation_guard.h"
#include "support/record.h"
#include "support/wait.h"

// Tests the notifications of a component about its peers and clients, and their order.

namespace tendon {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;

/// Returns numbers that identify the server, and counts the clients that have left.
class Server final : public PeriodicTask {
 public:
  Server(std::string name, std::int32_t number) : PeriodicTask(std::move(name), 1ms) {
    state_table().Add(number_, "Number");
    auto& control = AddProvidedInterface("Control");
    control.AddCommandReadState(state_table(), number_, "GetNumber");
    control.AddCommandVoid(&Server::Poke, this, "Poke");
    control.AddEvent(rang, "Rang");
    number_ = number;
  }

  std::vector<std::string> gone() const { return gone_.values(); }

  VoidEvent rang;
  std::atomic<int> pokes = 0;
  std::atomic<int> pokes_when_gone = -1;
  std::atomic<bool> rings = false;

 private:
  void Run() override {
    ProcessQueuedCommands();
    if (rings) rang();
  }
  void Poke() { ++pokes; }
  void OnClientGone(ProvidedInterface& interface, const std::string& client) override {
    pokes_when_gone = pokes.load();
    gone_.Add(client + " of " + interface.name());
  }

  std::int32_t number_ = 0;
  test::Record<std::string> gone_;
};

/// Records its notifications in order.
template <std::derived_from<Component> Base>
class Witness : public tendon_test::WithRun<Base> {
 public:
  template <typename... Arguments>
  explicit Witness(std::string name, Arguments... arguments)
      : tendon_test::WithRun<Base>(std::move(name), arguments...),
        server_(this->AddRequiredInterface("Server", Need::kRequired)) {
    server_.AddFunction(get_number, "GetNumber");
    server_.AddFunction(poke, "Poke");
    server_.AddEventHandlerVoid(&Witness::OnRang, this, "Rang");
  }

  std::vector<std::string> story() const { return story_.values(); }
  void Note(const std::string& what) { story_.Add(what); }
  [[nodiscard]] RequiredInterface& server() { return server_; }

  ReadFunction<std::int32_t> get_number;
  VoidFunction poke;
  std::atomic<int> runs = 0;
  std::atomic<int> rangs = 0;
  std::atomic<std::thread::id> thread;
  std::atomic<bool> throws = false;
  std::function<void()> on_connected;  // set before the start
  std::function<void()> on_run;        // set before the start

 private:
  std::string Answer() {
    std::int32_t number = 0;
    const Status status = get_number(number);
    return status ? std::to_string(number) : std::string(ToString(status));
  }

  void Startup() override { Note("started, hears " + Answer()); }
  void Run() override {
    thread = std::this_thread::get_id();
    if (on_run) on_run();
    if constexpr (std::derived_from<Base, Task>) this->ProcessQueuedCommands();
    ++runs;
  }
  void OnConnected(RequiredInterface& interface) override {
    if (throws) throw std::runtime_error("cable cut");
    Note("connected to " + Answer() + ", generation " + std::to_string(interface.generation()));
    if (on_connected) on_connected();
  }
  void OnDisconnected(RequiredInterface& /*interface*/) override {
    Note("disconnected, hears " + Answer());
  }
  void OnResume() override { Note("resumed, hears " + Answer()); }
  void OnRang() { ++rangs; }

  RequiredInterface& server_;
  test::Record<std::string> story_;
};

using PeriodicWitness = Witness<PeriodicTask>;

struct Connections : testing::Test {
  LocalManager manager;
  Server& one = manager.Add<Server>("one", 1);
  Server& two = manager.Add<Server>("two", 2);

  void SetUp() override {
    ASSERT_TRUE(manager.StartAll());
    const auto has_row = [](const Server& server) { return server.tables()[0]->next_tick() > 0; };
    ASSERT_TRUE(EventuallyTrue([&] { return has_row(one) && has_row(two); }));
  }

  void Connect(const std::string& client, const std::string& server) {
    const auto connected = manager.Connect({client, "Server"}, {server, "Control"});
    ASSERT_TRUE(connected) << connected.error().message;
  }
  template <typename Client>
  static bool HasRun(const Client& client) {
    const int runs = client.runs;
    return EventuallyTrue([&] { return client.runs >= runs + 3; });
  }
};

TEST_F(Connections, NotifiesATaskInItsThreadBeforeItsNextCycle) {
  auto& client = manager.Add<PeriodicWitness>("client", 1ms);
  std::atomic<std::thread::id> told_in;
  client.on_connected = [&] { told_in = std::this_thread::get_id(); };
  ASSERT_TRUE(manager.Start("client"));

  Connect("client", "one");
  ASSERT_TRUE(HasRun(client));

  EXPECT_EQ(told_in.load(), client.thread.load());
  EXPECT_THAT(client.story(),
              ElementsAre("started, hears not connected", "connected to 1, generation 1"));
}

TEST_F(Connections, NoCallReachesANewPeerBeforeTheNotification) {
  auto& client = manager.Add<PeriodicWitness>("client", 1ms);
  std::atomic<std::int32_t> known = 1;
  std::atomic<int> unknown_servers = 0;
  client.on_run = [&] {
    std::int32_t number = 0;
    if (client.get_number(number) && number != known) ++unknown_servers;
  };
  client.on_connected = [&] {
    std::int32_t number = 0;
    if (client.get_number(number)) known = number;
  };
  Connect("client", "one");
  ASSERT_TRUE(manager.Start("client"));

  for (int round = 0; round < 200; ++round) {
    ASSERT_TRUE(manager.Disconnect({"client", "Server"}));
    Connect("client", round % 2 == 0 ? "two" : "one");
  }
  ASSERT_TRUE(HasRun(client));
  ASSERT_TRUE(manager.Stop("client"));

  EXPECT_EQ(unknown_servers, 0);
}

TEST_F(Connections, AReplacementNotifiesOfBothHalvesInOrder) {
  auto& client = manager.Add<PeriodicWitness>("client", 1ms);
  Connect("client", "one");
  ASSERT_TRUE(manager.Start("client"));
  ASSERT_TRUE(HasRun(client));

  ASSERT_TRUE(manager.Disconnect({"client", "Server"}));
  Connect("client", "two");
  ASSERT_TRUE(HasRun(client));

  EXPECT_THAT(client.story(),
              ElementsAre("connected to 1, generation 1", "started, hears 1",
                          "disconnected, hears not connected", "connected to 2, generation 2"));
  EXPECT_EQ(client.server().generation(), 2U);
}

TEST_F(Connections, EventsOfANewPeerFollowTheNotification) {
  auto& client = manager.Add<PeriodicWitness>("client", 1ms);
  std::atomic<int> rangs_when_told = -1;
  client.on_connected = [&] { rangs_when_told = client.rangs.load(); };
  std::atomic<bool> holds = false;
  std::atomic<bool> is_held = false;
  client.on_run = [&] {
    while (holds) is_held = true;
  };
  ASSERT_TRUE(manager.Start("client"));
  one.rings = true;

  holds = true;
  ASSERT_TRUE(EventuallyTrue([&] { return is_held.load(); }));
  Connect("client", "one");
  ASSERT_TRUE(EventuallyTrue([&] { return client.server().inbox()->size() > 0; }));
  holds = false;

  ASSERT_TRUE(EventuallyTrue([&] { return client.rangs > 0; }));
  ASSERT_TRUE(manager.Stop("client"));
  EXPECT_EQ(rangs_when_told, 0);
}

TEST_F(Connections, NotifiesASuspendedTaskBeforeItResumes) {
  auto& client = manager.Add<PeriodicWitness>("client", 1ms);
  Connect("client", "one");
  ASSERT_TRUE(manager.Start("client"));
  ASSERT_TRUE(manager.Suspend("client"));

  ASSERT_TRUE(manager.Disconnect({"client", "Server"}));
  Connect("client", "two");
  EXPECT_EQ(client.story().size(), 2U) << "it rests";
  ASSERT_TRUE(manager.Start("client"));

  EXPECT_THAT(client.story(), ElementsAre("connected to 1, generation 1", "started, hears 1",
                                          "disconnected, hears not connected",
                                          "connected to 2, generation 2", "resumed, hears 2"));
}

TEST_F(Connections, OmitsPeersThatCameAndWentDuringSuspension) {
  auto& client = manager.Add<PeriodicWitness>("client", 1ms);
  ASSERT_TRUE(manager.Start("client"));
  ASSERT_TRUE(manager.Suspend("client"));

  Connect("client", "one");
  ASSERT_TRUE(manager.Disconnect({"client", "Server"}));
  ASSERT_TRUE(manager.Start("client"));

  EXPECT_THAT(client.story(),
              ElementsAre("started, hears not connected", "resumed, hears not connected"));
  EXPECT_EQ(client.server().generation(), 0U);
}

TEST_F(Connections, FunctionsOfAStoppedTaskWorkAtOnce) {
  auto& client = manager.Add<PeriodicWitness>("client", 1ms);

  Connect("client", "one");

  std::int32_t number = 0;
  EXPECT_TRUE(client.get_number(number));
  EXPECT_THAT(client.story(), IsEmpty());
}

TEST_F(Connections, ARestartRepeatsNoNotification) {
  auto& client = manager.Add<PeriodicWitness>("client", 1ms);
  Connect("client", "one");
  ASSERT_TRUE(manager.Start("client"));
  ASSERT_TRUE(manager.Stop("client"));
  ASSERT_TRUE(manager.Start("client"));

  EXPECT_THAT(client.story(),
              ElementsAre("connected to 1, generation 1", "started, hears 1", "started, hears 1"));
}

TEST_F(Connections, NotifiesAFollowerInItsLeadersThread) {
  auto& leader = manager.Add<PeriodicWitness>("leader", 1ms);
  auto& client = manager.Add<PeriodicWitness>("client", 1h);
  ASSERT_TRUE(manager.RunAfter("client", "leader"));
  ASSERT_TRUE(manager.Start("leader"));
  ASSERT_TRUE(manager.Start("client"));

  Connect("client", "one");
  ASSERT_TRUE(HasRun(client));

  EXPECT_EQ(client.thread.load(), leader.thread.load());
  EXPECT_THAT(client.story(),
              ElementsAre("started, hears not connected", "connected to 1, generation 1"));
}

TEST_F(Connections, NotifiesASleepingSignalTask) {
  auto& client = manager.Add<Witness<SignalTask>>("client");
  ASSERT_TRUE(manager.Start("client"));

  Connect("client", "one");

  EXPECT_TRUE(EventuallyTrue([&] { return client.story().size() == 2; }));
  EXPECT_EQ(client.runs, 0) << "nothing has arrived";
}

TEST_F(Connections, NotifiesAThreadlessComponentInTheCallersThread) {
  auto& client = manager.Add<Witness<Component>>("client");
  ASSERT_TRUE(manager.Start("client"));

  Connect("client", "one");
  ASSERT_TRUE(manager.Disconnect({"client", "Server"}));

  EXPECT_THAT(client.story(),
              ElementsAre("started, hears not connected",
                          "connected to not connected, generation 1", "disconnected, hears 1"));
}

TEST_F(Connections, AThrowingNotificationFaultsTheTask) {
  auto& client = manager.Add<PeriodicWitness>("client", 1ms);
  ASSERT_TRUE(manager.Start("client"));
  client.throws = true;

  Connect("client", "one");
  ASSERT_TRUE(manager.WaitFor("client", ComponentState::kFaulted, 20s));

  EXPECT_EQ(client.fault(), "OnConnected: cable cut");

  client.throws = false;
  ASSERT_TRUE(manager.Start("client"));
  EXPECT_THAT(client.story(), ElementsAre("started, hears not connected",
                                          "connected to 1, generation 2", "started, hears 1"));
}

TEST_F(Connections, NotifiesTheServerAfterTheClientsLastCall) {
  auto& client = manager.Add<PeriodicWitness>("client", 1ms);
  Connect("client", "one");
  client.on_run = [&] { (void)client.poke(); };
  ASSERT_TRUE(manager.Start("client"));
  ASSERT_TRUE(HasRun(client));
  ASSERT_TRUE(manager.Stop("client"));

  ASSERT_TRUE(manager.Disconnect({"client", "Server"}));
  ASSERT_TRUE(EventuallyTrue([&] { return !one.gone().empty(); }));

  EXPECT_THAT(one.gone(), ElementsAre("client/Server of Control"));
  EXPECT_EQ(one.pokes_when_gone, one.pokes);
  EXPECT_GE(one.pokes, 3);
}

TEST_F(Connections, NotifiesASuspendedServerOncePerClient) {
  manager.Add<PeriodicWitness>("client", 1ms);
  ASSERT_TRUE(manager.Suspend("one"));

  for (int round = 0; round < 50; ++round) {
    Connect("client", "one");
    ASSERT_TRUE(manager.Disconnect({"client", "Server"}));
  }
  EXPECT_THAT(one.gone(), IsEmpty());
  ASSERT_TRUE(manager.Start("one"));

  EXPECT_THAT(one.gone(), ElementsAre("client/Server of Control"));
}

TEST_F(Connections, DoesNotNotifyAStoppedServer) {
  manager.Add<PeriodicWitness>("client", 1ms);
  ASSERT_TRUE(manager.Stop("one"));

  Connect("client", "one");
  ASSERT_TRUE(manager.Disconnect({"client", "Server"}));
  ASSERT_TRUE(manager.Start("one"));

  EXPECT_THAT(one.gone(), IsEmpty());
}

/// A task whose cycles the test runs.
class Driven final : public CallbackTask {
 public:
  explicit Driven(std::string name) : CallbackTask(std::move(name)) {
    auto& server = AddRequiredInterface("Server");
    server.AddFunction(poke, "Poke");
  }

  VoidFunction poke;
  int told = 0;

 private:
  void Run() override { ProcessQueuedCommands(); }
  void OnConnected(RequiredInterface& /*interface*/) override { ++told; }
  void OnDisconnected(RequiredInterface& /*interface*/) override { ++told; }
};

TEST_F(Connections, NotifyingAllocatesNothing) {
  auto& client = manager.Add<Driven>("client");
  ASSERT_TRUE(manager.Start("client", kNoWait));
  client.Cycle();
  const auto cycle = [&client] {
    const AllocationGuard guard;
    client.Cycle();
  };

  Connect("client", "one");
  cycle();
  EXPECT_EQ(client.poke(), Status::kQueued);
  ASSERT_TRUE(manager.Disconnect({"client", "Server"}));
  cycle();

  EXPECT_EQ(client.told, 2);
}

}  // namespace
}  // namespace tendon
