#include <gtest/gtest.h>
#include <tendon/process/description_pool.h>

#include <string>
#include <utility>

namespace {

using tendon::ComponentDescription;
using tendon::DescriptionPool;

/// Returns a component with one interface that has one command.
ComponentDescription ComponentWith(const std::string& name, const std::string& command) {
  return {.name = name, .provided = {{.name = "Control", .commands = {{.name = command}}}}};
}

TEST(DescriptionPool, StoresEqualInterfacesOnce) {
  DescriptionPool pool;
  ComponentDescription one = ComponentWith("one", "Move");
  ComponentDescription two = ComponentWith("two", "Move");
  ComponentDescription other = ComponentWith("other", "Stop");

  for (auto* component : {&one, &two, &other}) pool.Share(*component);

  EXPECT_EQ(std::as_const(one).provided.data(), std::as_const(two).provided.data());
  EXPECT_NE(std::as_const(one).provided.data(), std::as_const(other).provided.data());
  EXPECT_EQ(two, ComponentWith("two", "Move"));
  EXPECT_EQ(other, ComponentWith("other", "Stop"));
  EXPECT_EQ(pool.size(), 2U);
}

TEST(DescriptionPool, ComparesMembersCompletely) {
  DescriptionPool pool;
  ComponentDescription plain = ComponentWith("arm", "Move");
  ComponentDescription hazard = plain;
  hazard.provided[0].commands[0].hazard = "motion";
  const ComponentDescription expected = hazard;

  pool.Share(plain);
  pool.Share(hazard);

  EXPECT_EQ(hazard, expected);
  EXPECT_EQ(plain, ComponentWith("arm", "Move"));
}

TEST(DescriptionPool, ReleasesUnusedInterfaces) {
  constexpr int kMany = 1000;
  DescriptionPool pool;
  ComponentDescription kept = ComponentWith("kept", "Stay");
  pool.Share(kept);

  for (int i = 0; i < kMany; ++i) {
    ComponentDescription passing = ComponentWith("passing", "Go" + std::to_string(i));
    pool.Share(passing);
  }

  EXPECT_LT(pool.size(), 100U);
  ComponentDescription again = ComponentWith("again", "Stay");
  pool.Share(again);
  EXPECT_EQ(std::as_const(again).provided.data(), std::as_const(kept).provided.data());
}

}  // namespace
