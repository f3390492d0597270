#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "core/task/scripted.h"
#include "support/wait.h"

namespace {

using tendon::Component;
using tendon::ComponentState;
using tendon::ErrorCode;
using tendon::kNoWait;
using tendon::kTransitions;
using tendon::LifecycleRequest;
using tendon::Result;
using tendon::Transition;
using tendon_test::Continuous;
using tendon_test::Periodic;
using tendon_test::Script;
using tendon_test::Signal;
using tendon_test::Threadless;
using testing::HasSubstr;
using testing::StartsWith;
using namespace std::chrono_literals;

static_assert(
    [] {
      for (std::size_t i = 0; i < kTransitions.size(); ++i) {
        const Transition& cell = kTransitions[i];
        if (&TransitionOf(cell.from, cell.request) != &cell) return false;
        if (!cell.refusal.empty() && cell.to != cell.from) return false;
      }
      return true;
    }(),
    "each state and request has a cell, and a refused request changes no state");

std::string NameOfRequest(LifecycleRequest request) {
  switch (request) {
    case LifecycleRequest::kStart:
      return "Start";
    case LifecycleRequest::kSuspend:
      return "Suspend";
    case LifecycleRequest::kStop:
      return "Stop";
  }
  return {};
}

Result<void> Ask(Component& component, LifecycleRequest request) {
  switch (request) {
    case LifecycleRequest::kStart:
      return component.Start();
    case LifecycleRequest::kSuspend:
      return component.Suspend();
    case LifecycleRequest::kStop:
      return component.Stop();
  }
  return {};
}

/// Brings a new component into a state.
void Bring(Component& component, Script& script, ComponentState state) {
  switch (state) {
    case ComponentState::kConstructed:
      break;
    case ComponentState::kReady:  // see AConfiguredComponentThatFailsToStartIsReady
      break;
    case ComponentState::kActive:
      ASSERT_TRUE(component.Start().ok());
      break;
    case ComponentState::kSuspended:
      ASSERT_TRUE(component.Start().ok());
      ASSERT_TRUE(component.Suspend().ok());
      break;
    case ComponentState::kFinished:
      ASSERT_TRUE(component.Start().ok());
      ASSERT_TRUE(component.Stop().ok());
      break;
    case ComponentState::kFaulted:
      script.throws = Script::kStartup;
      ASSERT_FALSE(component.Start().ok());
      script.throws = Script::kNone;
      break;
  }
  ASSERT_EQ(component.state(), state);
}

template <typename Kind, typename... Arguments>
void ExpectTheTable(const Transition& cell, Arguments... arguments) {
  tendon::LocalManager manager;
  auto& component = manager.Add<Kind>("arm", arguments...);
  Bring(component, component, cell.from);
  const int configures = component.configures;

  const auto reply = Ask(component, cell.request);

  EXPECT_EQ(component.state(), cell.to);
  EXPECT_EQ(component.configures - configures, cell.configures_first ? 1 : 0);
  if (cell.refusal.empty()) {
    EXPECT_TRUE(reply.ok()) << reply.error().message;
  } else {
    ASSERT_FALSE(reply.ok());
    EXPECT_EQ(reply.error().code, ErrorCode::kFailed);
    EXPECT_EQ(reply.error().message,
              "component 'arm' is " + std::string(ToString(cell.from)) + std::string(cell.refusal));
  }
}

std::vector<Transition> CellsButReady() {
  std::vector<Transition> cells(kTransitions.begin(), kTransitions.end());
  std::erase_if(cells, [](const auto& cell) { return cell.from == ComponentState::kReady; });
  return cells;
}

struct LifecycleTable : testing::TestWithParam<Transition> {};

TEST_P(LifecycleTable, HoldsForEveryKindOfComponent) {
  ExpectTheTable<Threadless>(GetParam());
  ExpectTheTable<Periodic>(GetParam(), 1ms);
  ExpectTheTable<Continuous>(GetParam());
  ExpectTheTable<Signal>(GetParam());
  ExpectTheTable<tendon_test::Callback>(GetParam());
  ExpectTheTable<tendon_test::Main>(GetParam(), 1ms);
}

INSTANTIATE_TEST_SUITE_P(AllCells, LifecycleTable, testing::ValuesIn(CellsButReady()),
                         [](const auto& cell) {
                           return NameOfRequest(cell.param.request) + "_when_" +
                                  std::string(ToString(cell.param.from));
                         });

TEST(Lifecycle, AConfiguredComponentThatFailsToStartIsReady) {
  tendon::LocalManager manager;
  auto& leader = manager.Add<Periodic>("leader", 1ms);
  auto& arm = manager.Add<Periodic>("arm", 1ms);
  ASSERT_TRUE(manager.RunAfter("arm", "leader").ok());
  ASSERT_FALSE(arm.Start().ok());
  ASSERT_EQ(arm.state(), ComponentState::kReady);

  for (const LifecycleRequest request : {LifecycleRequest::kSuspend, LifecycleRequest::kStop}) {
    const auto refused = Ask(arm, request);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().message,
              "component 'arm' is ready" +
                  std::string(TransitionOf(ComponentState::kReady, request).refusal));
  }
  EXPECT_EQ(arm.state(), ComponentState::kReady);
  ASSERT_TRUE(leader.Start().ok());

  EXPECT_TRUE(arm.Start().ok());

  EXPECT_EQ(arm.state(), ComponentState::kActive);
  EXPECT_EQ(arm.configures, 1);
}

TEST(Lifecycle, RefusesRequestsDuringAStart) {
  tendon::LocalManager manager;
  auto& arm = manager.Add<Periodic>("arm", 1ms);
  arm.blocks = Script::kStartup;
  ASSERT_TRUE(arm.Start(kNoWait).ok());

  for (const LifecycleRequest request : {LifecycleRequest::kStart, LifecycleRequest::kSuspend}) {
    const auto reply = Ask(arm, request);
    ASSERT_FALSE(reply.ok());
    EXPECT_EQ(reply.error().message,
              "component 'arm' is still starting; wait until it is active, or stop it");
  }
  EXPECT_EQ(arm.state(), ComponentState::kReady);
  arm.blocks = Script::kNone;

  EXPECT_TRUE(arm.WaitFor(ComponentState::kActive, 20s).ok());
}

TEST(Lifecycle, APendingStopIsNotReplaced) {
  tendon::LocalManager manager;
  auto& arm = manager.Add<Periodic>("arm", 1ms);
  ASSERT_TRUE(manager.Start("arm").ok());
  arm.blocks = Script::kRun;
  ASSERT_TRUE(EventuallyTrue([&] { return arm.is_blocked.load(); }));
  ASSERT_TRUE(manager.Stop("arm", kNoWait).ok());

  for (const LifecycleRequest request : {LifecycleRequest::kStart, LifecycleRequest::kSuspend}) {
    EXPECT_EQ(Ask(arm, request).error().message,
              "component 'arm' is still stopping; wait until it is finished");
  }
  EXPECT_TRUE(manager.Stop("arm", kNoWait).ok());
  arm.blocks = Script::kNone;

  EXPECT_TRUE(arm.WaitFor(ComponentState::kFinished, 20s).ok());
  EXPECT_TRUE(manager.Start("arm").ok());
}

TEST(Lifecycle, AStopDuringAStartPreventsAnyCycle) {
  tendon::LocalManager manager;
  auto& arm = manager.Add<Periodic>("arm", 1ms);
  arm.blocks = Script::kStartup;
  ASSERT_TRUE(arm.Start(kNoWait).ok());
  ASSERT_TRUE(EventuallyTrue([&] { return arm.is_blocked.load(); }));

  ASSERT_TRUE(manager.Stop("arm", kNoWait).ok());
  arm.blocks = Script::kNone;

  EXPECT_TRUE(arm.WaitFor(ComponentState::kFinished, 20s).ok());
  EXPECT_EQ(arm.runs, 0);
  EXPECT_TRUE(manager.Start("arm").ok());
}

TEST(Lifecycle, AWaitForAStateTimesOutNamingTheState) {
  tendon::LocalManager manager;
  auto& arm = manager.Add<Periodic>("arm", 1ms);
  ASSERT_TRUE(manager.Start("arm").ok());
  arm.blocks = Script::kRun;
  ASSERT_TRUE(EventuallyTrue([&] { return arm.is_blocked.load(); }));

  const auto stopped = manager.Stop("arm", 20ms);

  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.error().code, ErrorCode::kTimeout);
  EXPECT_THAT(
      stopped.error().message,
      testing::MatchesRegex("component 'arm' is still active after [0-9]+ ms, not finished; "
                            "it may be busy in one of its own functions"));
  arm.blocks = Script::kNone;
  EXPECT_TRUE(manager.WaitFor("arm", ComponentState::kFinished, 20s).ok());
}

TEST(Lifecycle, RefusesToRemoveAComponentThatDoesNotStop) {
  tendon::LocalManager manager;
  auto& arm = manager.Add<Periodic>("arm", 1ms);
  ASSERT_TRUE(manager.Start("arm").ok());
  arm.blocks = Script::kRun;
  ASSERT_TRUE(EventuallyTrue([&] { return arm.is_blocked.load(); }));

  const auto removed = manager.Remove("arm", 20ms);

  ASSERT_FALSE(removed.ok());
  EXPECT_EQ(removed.error().code, ErrorCode::kTimeout);
  EXPECT_THAT(removed.error().message,
              StartsWith("component 'arm' is not removed, because it runs: "));
  EXPECT_EQ(manager.Find("arm"), &arm);
  arm.blocks = Script::kNone;
  EXPECT_TRUE(manager.Remove("arm").ok());
  EXPECT_EQ(manager.Find("arm"), nullptr);
}

TEST(Lifecycle, AHungComponentIsDisconnectedButNotRemoved) {
  tendon::LocalManager manager;
  auto& arm = manager.Add<Periodic>("arm", 1ms);
  auto& client = manager.Add<tendon_test::Client>("client");
  ASSERT_TRUE(manager.Connect({"client", "Server"}, {"arm", "Control"}).ok());
  ASSERT_TRUE(manager.StartAll().ok());
  arm.blocks = Script::kHandler;
  EXPECT_EQ(client.poke(), tendon::Status::kQueued);
  ASSERT_TRUE(EventuallyTrue([&] { return arm.is_blocked.load(); }));

  const auto removed = manager.Remove("arm", 20ms);

  ASSERT_FALSE(removed.ok());
  EXPECT_EQ(removed.error().code, ErrorCode::kTimeout);
  EXPECT_EQ(client.poke(), tendon::Status::kNotConnected);
  arm.blocks = Script::kNone;
  EXPECT_TRUE(manager.Remove("arm").ok());
}

TEST(Lifecycle, AWaitForAStateEndsWithAFault) {
  tendon::LocalManager manager;
  auto& arm = manager.Add<Periodic>("arm", 1ms);
  ASSERT_TRUE(manager.Start("arm").ok());
  arm.throws = Script::kRun;

  const auto waited = manager.WaitFor("arm", ComponentState::kFinished, 20s);

  ASSERT_FALSE(waited.ok());
  EXPECT_EQ(waited.error().code, ErrorCode::kFailed);
  EXPECT_EQ(waited.error().message, "component 'arm' is faulted: Run: cable cut");
}

TEST(Lifecycle, ASuspendedTaskRunsNoCyclesOrCommands) {
  tendon::LocalManager manager;
  auto& arm = manager.Add<Periodic>("arm", 1ms);
  auto& client = manager.Add<tendon_test::Client>("client");
  ASSERT_TRUE(manager.Connect({"client", "Server"}, {"arm", "Control"}).ok());
  ASSERT_TRUE(manager.StartAll().ok());
  ASSERT_TRUE(EventuallyTrue([&] { return arm.runs > 3; }));

  ASSERT_TRUE(manager.Suspend("arm").ok());
  const std::uint64_t runs = arm.runs;
  EXPECT_EQ(client.poke(), tendon::Status::kNotActive);
  ASSERT_TRUE(manager.Start("arm").ok());
  EXPECT_EQ(client.poke(), tendon::Status::kQueued);

  EXPECT_TRUE(EventuallyTrue([&] { return arm.runs > runs && arm.pokes == 1; }));
  EXPECT_EQ(arm.startups, 1);
  EXPECT_EQ(arm.cleanups, 0);
}

TEST(Lifecycle, AllAreStartedSuspendedAndStoppedTogether) {
  tendon::LocalManager manager;
  manager.Add<Periodic>("a", 1ms);
  manager.Add<Continuous>("b");
  manager.Add<Signal>("c");
  manager.Add<Threadless>("d");

  EXPECT_TRUE(manager.StartAll(kNoWait).ok());
  EXPECT_TRUE(manager.WaitForAll(ComponentState::kActive, 20s).ok());
  EXPECT_TRUE(manager.SuspendAll(kNoWait).ok());
  EXPECT_TRUE(manager.WaitForAll(ComponentState::kSuspended, 20s).ok());
  EXPECT_TRUE(manager.StopAll(kNoWait).ok());
  EXPECT_TRUE(manager.WaitForAll(ComponentState::kFinished, 20s).ok());

  const auto never = manager.WaitForAll(ComponentState::kActive, 5ms);
  ASSERT_FALSE(never.ok());
  EXPECT_THAT(never.error().message, HasSubstr("'a' is still finished after"));
}

TEST(Lifecycle, AHungComponentDoesNotBlockStoppingOthers) {
  tendon::LocalManager manager;
  auto& good = manager.Add<Periodic>("good", 1ms);
  auto& hung = manager.Add<Periodic>("hung", 1ms);
  ASSERT_TRUE(manager.StartAll().ok());
  hung.blocks = Script::kRun;
  ASSERT_TRUE(EventuallyTrue([&] { return hung.is_blocked.load(); }));

  const auto stopped = manager.StopAll(20ms);

  EXPECT_FALSE(stopped.ok());
  EXPECT_TRUE(good.WaitFor(ComponentState::kFinished, 20s).ok());
  hung.blocks = Script::kNone;
}

}  // namespace
