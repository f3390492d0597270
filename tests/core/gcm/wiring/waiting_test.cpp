#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/gcm/wiring/waiting.h>
#include <tests/core/gcm/system/running_catalog.h>

namespace tendon {
namespace {

using testing::IsEmpty;

std::vector<UnmetNeed> WaitsOf(const Catalog& catalog) {
  return WaitsOf(*catalog.FindProcess("desk"), *catalog.FindComponent("desk", "teleoperation"));
}

Catalog Desk(ComponentState state, ProcessState process = ProcessState::kAlive) {
  ComponentDescription teleoperation = test::Teleoperation();
  teleoperation.state = state;
  return test::CatalogBuilder().Process("desk", {teleoperation}, process).catalog();
}

TEST(Waiting, IsAComponentThatRunsWithoutWhatItNeeds) {
  for (const auto state : {ComponentState::kActive, ComponentState::kSuspended}) {
    EXPECT_EQ(WaitingReasons(WaitsOf(Desk(state))), "waiting for Robot: not connected");
  }
}

TEST(Waiting, IsNoneThatDoesNotRun) {
  for (const auto state : {ComponentState::kConstructed, ComponentState::kReady,
                           ComponentState::kFinished, ComponentState::kFaulted}) {
    EXPECT_THAT(WaitsOf(Desk(state)), IsEmpty()) << ToString(state);
  }
}

TEST(Waiting, IsNoneOfAProcessThatIsNotThere) {
  EXPECT_THAT(WaitsOf(Desk(ComponentState::kActive, ProcessState::kLost)), IsEmpty());
  EXPECT_THAT(WaitsOf(Desk(ComponentState::kActive, ProcessState::kLeft)), IsEmpty());
  EXPECT_EQ(WaitsOf(Desk(ComponentState::kActive, ProcessState::kSuspect)).size(), 1U);
}

TEST(Waiting, EndsWhenTheConnectionStands) {
  test::CatalogBuilder demo = test::RunningDemo();
  EXPECT_THAT(WaitsOf(demo.catalog()), IsEmpty());

  demo.Connection(test::kNeeded, test::kOffered, ConnectionState::kPending, "arm is faulted");
  EXPECT_EQ(WaitingReasons(WaitsOf(demo.catalog())), "waiting for Robot: pending: arm is faulted");
}

TEST(Waiting, IsSaidBesideTheState) {
  const Catalog waiting = Desk(ComponentState::kActive);
  const Catalog stopped = Desk(ComponentState::kFinished);
  const auto text = [](const Catalog& catalog) {
    return StateText(*catalog.FindProcess("desk"), *catalog.FindComponent("desk", "teleoperation"));
  };

  EXPECT_EQ(text(waiting), "active, waiting for Robot");
  EXPECT_EQ(text(stopped), "finished");
}

}  // namespace
}  // namespace tendon
