#include <gtest/gtest.h>
#include <tendon/process/membership/differences.h>

namespace {

using tendon::CatalogueChange;
using tendon::ComponentDescription;
using tendon::ComponentState;
using tendon::ConnectionDescription;
using tendon::Differences;
using tendon::ProcessContent;
using Kind = tendon::CatalogueChange::Kind;

ComponentDescription Component(const std::string& name) {
  ComponentDescription component;
  component.name = name;
  return component;
}

ConnectionDescription Connection(std::uint64_t id) {
  ConnectionDescription connection;
  connection.id = id;
  return connection;
}

TEST(Differences, OfEqualContentsAreEmpty) {
  const ProcessContent content{{Component("a")}, {Connection(1)}};

  EXPECT_TRUE(Differences(content, content).empty());
}

TEST(Differences, RemoveConnectionsFirstAndAddThemLast) {
  const ProcessContent before{{Component("a"), Component("b")}, {Connection(1), Connection(2)}};
  ProcessContent after{{Component("b"), Component("c")}, {Connection(2), Connection(3)}};
  after.components[0].state = ComponentState::kActive;

  const auto changes = Differences(before, after);

  ASSERT_EQ(changes.size(), 5U);
  EXPECT_EQ(changes[0].kind, Kind::kConnectionRemoved);
  EXPECT_EQ(changes[0].connection, 1U);
  EXPECT_EQ(changes[1].kind, Kind::kComponentRemoved);
  EXPECT_EQ(changes[1].component, "a");
  EXPECT_EQ(changes[2].kind, Kind::kComponent);
  EXPECT_EQ(changes[2].components.front(), after.components[0]);
  EXPECT_EQ(changes[3].components.front().name, "c");
  EXPECT_EQ(changes[4].kind, Kind::kConnection);
  EXPECT_EQ(changes[4].connections.front().id, 3U);
}

}  // namespace
