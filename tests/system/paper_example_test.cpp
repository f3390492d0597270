#include <gmock/gmock.h>
#include <tendon/proxy/component_proxy.h>
#include <tendon/task/periodic_task.h>

#include "support/network_test.h"
#include "support/plant.h"

/// The example of Fig. 7 of the paper. Process P1 has C1 (required r1, r2) and C2 (provided p1,
/// required r1); process P2 has C2 (provided p1, p2, required r1) and C3 (required r1).
///
///     P1/C1/r1 -> P2/C2/p1     P1/C1/r2 -> P2/C2/p2     P1/C2/r1 -> P2/C2/p2     remote
///     P2/C3/r1 -> P2/C2/p2                                                       local
namespace {

using plant::Record;
using tendon::ComponentProxy;
using tendon::Process;
using tendon::Status;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

/// Records the numbers that it receives, and raises an event for each caller.
class Server final : public tendon::PeriodicTask {
 public:
  Server(std::string name, const std::vector<std::string>& interfaces)
      : PeriodicTask(std::move(name), std::chrono::milliseconds(1)) {
    auto& r1 = AddRequiredInterface("r1", tendon::Need::kOptional);
    r1.AddFunction(call_, "Call");
    for (const std::string& interface : interfaces) {
      auto& provided = AddProvidedInterface(interface);
      provided.AddCommandWrite(&Server::Call, this, "Call");
      provided.AddEvent(interface == "p1" ? called_by_p1_ : called_by_p2_, "Called");
    }
  }
  ~Server() override { Join(); }
  void Run() override { ProcessQueuedCommands(); }

  Record<std::uint64_t> calls;

 private:
  void Call(std::uint64_t number) {
    calls.Add(number);
    called_by_p1_(number);
    called_by_p2_(number);
  }

  tendon::WriteFunction<std::uint64_t> call_;
  tendon::WriteEvent<std::uint64_t> called_by_p1_;
  tendon::WriteEvent<std::uint64_t> called_by_p2_;
};

/// One required interface of a component without a thread: its calls, and the events that it has
/// received.
struct Port {
  void OnCalled(std::uint64_t number) { heard.push_back(number); }

  tendon::WriteFunction<std::uint64_t> call;
  std::vector<std::uint64_t> heard;
};

class Client final : public tendon::Component {
 public:
  Client(std::string name, const std::vector<std::string>& interfaces)
      : Component(std::move(name), std::make_unique<tendon::Inbox>()), ports(interfaces.size()) {
    AddProvidedInterface("p1");
    for (std::size_t i = 0; i < interfaces.size(); ++i) {
      auto& required = AddRequiredInterface(interfaces[i]);
      required.AddFunction(ports[i].call, "Call");
      required.AddEventHandlerWrite(&Port::OnCalled, &ports[i], "Called");
    }
  }
  void Process() { inbox()->ExecuteQueued(); }

  std::vector<Port> ports;
};

std::vector<std::string> Describe(const std::vector<ComponentProxy>& proxies) {
  std::vector<std::string> lines;
  for (const ComponentProxy& proxy : proxies) {
    std::string line = proxy.process + "/" + proxy.component + ":";
    for (const auto& one : proxy.provided) line += " provided " + one->interface().name();
    for (const auto& one : proxy.required) line += " required " + one->interface().name();
    lines.push_back(line);
  }
  return lines;
}

class PaperExample : public NetworkTest {
 protected:
  PaperExample() {
    EXPECT_TRUE(p1->StartAll().ok());
    EXPECT_TRUE(p2->StartAll().ok());
    Connect(*p1, {"P1", "C1", "r1"}, {"P2", "C2", "p1"});
    Connect(*p1, {"P1", "C1", "r2"}, {"P2", "C2", "p2"});
    Connect(*p1, {"P1", "C2", "r1"}, {"P2", "C2", "p2"});
    Connect(*p2, {"P2", "C3", "r1"}, {"P2", "C2", "p2"});
    EXPECT_TRUE(EventuallyActive(*p1, 3));
    EXPECT_TRUE(EventuallyActive(*p2, 1));
  }
  static void Connect(Process& process, const tendon::InterfaceName& required,
                      const tendon::InterfaceName& provided) {
    const auto id = process.Connect(required, provided);
    EXPECT_TRUE(id.ok()) << id.error().message;
  }

  std::unique_ptr<Process> p1 = Start("P1");
  std::unique_ptr<Process> p2 = Start("P2");
  Client& p1_c1 = p1->Add<Client>("C1", std::vector<std::string>{"r1", "r2"});
  Client& p1_c2 = p1->Add<Client>("C2", std::vector<std::string>{"r1"});
  Server& p2_c2 = p2->Add<Server>("C2", std::vector<std::string>{"p1", "p2"});
  Client& p2_c3 = p2->Add<Client>("C3", std::vector<std::string>{"r1"});
};

TEST_P(PaperExample, CreatesProxiesOnlyForRemoteConnections) {
  EXPECT_THAT(Describe(p1->proxies()), ElementsAre("P2/C2: provided p1 provided p2 provided p2"));
  EXPECT_THAT(Describe(p2->proxies()),
              UnorderedElementsAre("P1/C1: required r1 required r2", "P1/C2: required r1"));
  EXPECT_EQ(p1->components().size(), 2U);
  EXPECT_EQ(p2->components().size(), 2U);
}

TEST_P(PaperExample, DeliversEachCallAndEventOnce) {
  const std::vector<Port*> ports{&p1_c1.ports[0], &p1_c1.ports[1], &p1_c2.ports[0],
                                 &p2_c3.ports[0]};
  std::vector<std::uint64_t> all;
  for (std::uint64_t round = 0; round < 10; ++round) {
    for (std::uint64_t port = 0; port < ports.size(); ++port) {
      all.push_back(10 * round + port);
      ASSERT_EQ(ports[port]->call(all.back()), Status(Status::kQueued));
    }
  }

  const auto all_heard = [&] {
    for (Client* client : {&p1_c1, &p1_c2, &p2_c3}) client->Process();
    return std::all_of(ports.begin(), ports.end(),
                       [&](const Port* port) { return port->heard.size() >= all.size(); });
  };
  EXPECT_TRUE(EventuallyTrue(all_heard));
  auto executed = p2_c2.calls.values();
  const auto order = executed;
  std::sort(executed.begin(), executed.end());
  EXPECT_EQ(executed, all);
  for (const Port* port : ports) EXPECT_EQ(port->heard, order);
}

TEST_P(PaperExample, DisconnectingRemovesTheProxies) {
  ASSERT_TRUE(p1->Disconnect({"P1", "C1", "r2"}).ok());
  EXPECT_THAT(Describe(p1->proxies()), ElementsAre("P2/C2: provided p1 provided p2"));
  EXPECT_TRUE(EventuallyTrue([&] {
    return Describe(p2->proxies()) ==
           std::vector<std::string>{"P1/C1: required r1", "P1/C2: required r1"};
  }));

  ASSERT_TRUE(p1->Disconnect({"P1", "C1", "r1"}).ok());
  ASSERT_TRUE(p1->Disconnect({"P1", "C2", "r1"}).ok());
  EXPECT_TRUE(p1->proxies().empty());
  EXPECT_TRUE(EventuallyTrue([&] { return p2->proxies().empty(); }));
}

INSTANTIATE_TEST_SUITE_P(Over, PaperExample, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

}  // namespace
