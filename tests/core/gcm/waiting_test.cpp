#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/gcm/waiting.h>
#include <tests/core/gcm/system/running_catalogue.h>

namespace tendon {
namespace {

using testing::IsEmpty;

std::vector<UnsatisfiedInterface> DeskWaits(const Catalogue& catalogue) {
  return WaitsOf(*catalogue.FindProcess("desk"), *catalogue.FindComponent("desk", "teleoperation"));
}

Catalogue Desk(ComponentState state, ProcessState process = ProcessState::kAlive) {
  ComponentDescription teleoperation = test::Teleoperation();
  teleoperation.state = state;
  return test::CatalogBuilder().Process("desk", {teleoperation}, process).catalogue();
}

TEST(Waiting, ReportsARunningComponentWithoutConnections) {
  for (const auto state : {ComponentState::kActive, ComponentState::kSuspended}) {
    EXPECT_EQ(WaitingReasons(DeskWaits(Desk(state))), "waiting for Robot: not connected");
  }
}

TEST(Waiting, IgnoresComponentsThatDoNotRun) {
  for (const auto state : {ComponentState::kConstructed, ComponentState::kReady,
                           ComponentState::kFinished, ComponentState::kFaulted}) {
    EXPECT_THAT(DeskWaits(Desk(state)), IsEmpty()) << ToString(state);
  }
}

TEST(Waiting, IgnoresComponentsOfAbsentProcesses) {
  EXPECT_THAT(DeskWaits(Desk(ComponentState::kActive, ProcessState::kLost)), IsEmpty());
  EXPECT_THAT(DeskWaits(Desk(ComponentState::kActive, ProcessState::kLeft)), IsEmpty());
  EXPECT_EQ(DeskWaits(Desk(ComponentState::kActive, ProcessState::kSuspect)).size(), 1U);
}

TEST(Waiting, EndsWhenTheConnectionIsActive) {
  test::CatalogBuilder demo = test::RunningDemo();
  EXPECT_THAT(DeskWaits(demo.catalogue()), IsEmpty());

  demo.Connection(test::kNeeded, test::kOffered, ConnectionState::kPending, "arm is faulted");
  EXPECT_EQ(WaitingReasons(DeskWaits(demo.catalogue())),
            "waiting for Robot: pending: arm is faulted");
}

TEST(Waiting, IsShownNextToTheState) {
  const Catalogue waiting = Desk(ComponentState::kActive);
  const Catalogue stopped = Desk(ComponentState::kFinished);
  const auto text = [](const Catalogue& catalogue) {
    return StateText(*catalogue.FindProcess("desk"),
                     *catalogue.FindComponent("desk", "teleoperation"));
  };

  EXPECT_EQ(text(waiting), "active, waiting for Robot");
  EXPECT_EQ(text(stopped), "finished");
}

}  // namespace
}  // namespace tendon
