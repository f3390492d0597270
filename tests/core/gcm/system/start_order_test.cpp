#include <gtest/gtest.h>
#include <tendon/gcm/system/start_order.h>

namespace tendon {
namespace {

/// Returns a system with components in the process p. The text "ab" means that a is a client of b.
SystemFile SystemWith(const std::vector<std::string>& connections) {
  SystemFile system{.name = "x", .processes = {{"p", {}}}};
  for (const std::string name : {"a", "b", "c"}) {
    system.processes[0].components.push_back({name, "A", "", ""});
  }
  for (const std::string& one : connections) {
    system.connections.push_back(
        {{"p", one.substr(0, 1), "R" + std::to_string(one[1])}, {"p", one.substr(1, 1), "P"}});
  }
  return system;
}

std::string OrderOf(const std::vector<std::string>& connections) {
  std::string order;
  for (const auto& [process, component] : StartOrder(SystemWith(connections))) order += component;
  return order;
}

TEST(StartOrder, KeepsTheFileOrderWithoutConnections) { EXPECT_EQ(OrderOf({}), "abc"); }

TEST(StartOrder, PutsServersBeforeTheirClients) {
  EXPECT_EQ(OrderOf({"ab", "bc"}), "cba");
  EXPECT_EQ(OrderOf({"ac"}), "cab");
  EXPECT_EQ(OrderOf({"ab", "ac", "cb"}), "bca");
}

TEST(StartOrder, ToleratesConnectionCycles) {
  EXPECT_EQ(OrderOf({"ab", "ba"}), "bac");
  EXPECT_EQ(OrderOf({"aa"}), "abc");
}

TEST(StartOrder, PutsLeadersFirstDespiteConnections) {
  const auto order = [](const std::string& leader, const std::vector<std::string>& connections) {
    SystemFile system = SystemWith(connections);
    system.processes[0].components[0].runs_after = leader;
    system.processes[0].components[1].runs_after = "a";
    std::string names;
    for (const auto& [process, component] : StartOrder(system)) names += component;
    return names;
  };

  EXPECT_EQ(order("", {}), "abc");
  EXPECT_EQ(order("c", {}), "cab");
  EXPECT_EQ(order("c", {"ab"}), "cab");
  EXPECT_EQ(order("c", {"ca"}), "cab");
  EXPECT_EQ(order("", {"bc", "ab"}), "cab");
}

TEST(StartOrder, HandlesAChainOfTenThousand) {
  constexpr std::size_t kComponents = 10'000;
  SystemFile system{.name = "x", .processes = {{"p", {}}}};
  for (std::size_t i = kComponents; i > 0; --i) {
    auto& one = system.processes[0].components.emplace_back();
    one.name = "c" + std::to_string(i);
    if (i > 1) one.runs_after = "c" + std::to_string(i - 1);
  }

  const auto order = StartOrder(system);

  ASSERT_EQ(order.size(), kComponents);
  EXPECT_EQ(order.front().second, "c1");
  EXPECT_EQ(order.back().second, "c10000");
}

std::string EndOrderOf(const SystemFile& system) {
  std::string order;
  for (const auto& [process, component] : EndOrder(system)) order += component;
  return order;
}

TEST(EndOrder, KeepsTheFileOrderWithoutConnections) {
  EXPECT_EQ(EndOrderOf(SystemWith({})), "abc");
}

TEST(EndOrder, PutsClientsBeforeTheirServers) {
  EXPECT_EQ(EndOrderOf(SystemWith({"ba", "cb"})), "cba");
  EXPECT_EQ(EndOrderOf(SystemWith({"ca"})), "cab");
}

TEST(EndOrder, ToleratesConnectionCycles) {
  EXPECT_EQ(EndOrderOf(SystemWith({"ab", "ba"})), "bac");
}

TEST(EndOrder, PutsFollowersBeforeTheirLeader) {
  SystemFile system = SystemWith({});
  system.processes[0].components[1].runs_after = "a";

  EXPECT_EQ(EndOrderOf(system), "bac");
}

TEST(ProcessEndOrder, PutsClientProcessesBeforeServerProcesses) {
  SystemFile system{.name = "x", .processes = {{"a", {}}, {"b", {}}, {"c", {}}}};
  system.connections.push_back({{"c", "client", "R"}, {"a", "server", "P"}});
  system.connections.push_back({{"c", "client", "Other"}, {"away", "server", "P"}});

  EXPECT_EQ(ProcessEndOrder(system), (std::vector<std::string>{"c", "a", "b"}));
}

TEST(StartOrder, IgnoresConnectionsToMissingComponents) { EXPECT_EQ(OrderOf({"az", "za"}), "abc"); }

}  // namespace
}  // namespace tendon
