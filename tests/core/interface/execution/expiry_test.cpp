#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/base/clock.h>
#include <tendon/base/error.h>
#include <tendon/interface/function.h>
#include <tendon/manager/local_manager.h>
#include <tendon/task/callback_task.h>
#include <tendon/task/signal_task.h>

#include <atomic>
#include <concepts>
#include <functional>
#include <stdexcept>
#include <string>

#include "support/allocation_guard.h"
#include "support/refusal.h"
#include "support/wait.h"

// Tests of commands that expire unless they are renewed.

namespace tendon {
namespace {

using namespace std::chrono_literals;

/// A motor that runs at the last commanded speed until the command expires.
template <std::derived_from<Task> Base>
class Motor final : public Base {
 public:
  explicit Motor(std::string name, std::chrono::nanoseconds after = 1h) : Base(std::move(name)) {
    auto& control = this->AddProvidedInterface("Control");
    control.AddCommandWrite(&Motor::Turn, this, "Turn").ExpiresAfter(after, &Motor::Brake, this);
    control.AddCommandVoid(&Motor::Brake, this, "Brake");
    control.AddCommandWrite(&Motor::Turn, this, "TurnLatest")
        .SetOverflow(Overflow::kLatestOnly)
        .ExpiresAfter(after, &Motor::Brake, this);
  }

  using Base::AddProvidedInterface;
  using Base::EndExpired;
  using Base::next_expiry;

  std::atomic<double> speed = 0.0;
  std::atomic<int> brakings = 0;
  std::atomic<bool> throws = false;

 private:
  void Run() override { this->ProcessQueuedCommands(); }
  void Turn(double wanted) { speed = wanted; }
  void Brake() {
    if (throws) throw std::runtime_error("brake worn");
    speed = 0.0;
    ++brakings;
  }
};

class Hand final : public Component {
 public:
  explicit Hand(std::string name) : Component(std::move(name)) {
    auto& motor = AddRequiredInterface("Motor");
    motor.AddFunction(turn, "Turn");
    motor.AddFunction(turn_latest, "TurnLatest");
  }

  WriteFunction<double> turn;
  WriteFunction<double> turn_latest;
};

/// A motor whose cycles the test runs.
struct Expiring : testing::Test {
  LocalManager manager;
  Hand& hand = manager.Add<Hand>("hand");
  Hand& other_hand = manager.Add<Hand>("other");

  Motor<CallbackTask>& AddMotor(std::chrono::nanoseconds after) {
    auto& motor = manager.Add<Motor<CallbackTask>>("motor", after);
    EXPECT_TRUE(manager.Start("hand"));
    EXPECT_TRUE(manager.Start("other"));
    EXPECT_TRUE(manager.Start("motor", kNoWait));
    EXPECT_TRUE(manager.Connect({"hand", "Motor"}, {"motor", "Control"}));
    EXPECT_TRUE(manager.Connect({"other", "Motor"}, {"motor", "Control"}));
    EXPECT_TRUE(motor.Cycle());
    return motor;
  }
  /// Runs cycles until the motor stops.
  static bool EventuallyStops(Motor<CallbackTask>& motor) {
    return EventuallyTrue([&] { return motor.Cycle() && motor.speed == 0.0; });
  }
};

TEST_F(Expiring, EndsWithoutRenewal) {
  auto& motor = AddMotor(5ms);

  ASSERT_TRUE(hand.turn(2.0));
  motor.Cycle();

  EXPECT_TRUE(EventuallyStops(motor));
  EXPECT_EQ(motor.brakings, 1);
}

TEST_F(Expiring, EndsOnlyOnce) {
  auto& motor = AddMotor(1ms);
  ASSERT_TRUE(hand.turn(2.0));
  ASSERT_TRUE(EventuallyTrue([&] { return motor.Cycle() && motor.brakings > 0; }));

  for (int i = 0; i < 20; ++i) motor.Cycle();

  EXPECT_EQ(motor.brakings, 1);
}

TEST_F(Expiring, ARenewalPostponesTheEnd) {
  auto& motor = AddMotor(1h);
  ASSERT_TRUE(hand.turn(2.0));
  motor.Cycle();
  const SteadyTime first = motor.next_expiry();

  ASSERT_TRUE(hand.turn(2.0));
  motor.Cycle();

  motor.EndExpired(first);
  EXPECT_EQ(motor.speed, 2.0);
  motor.EndExpired(motor.next_expiry());
  EXPECT_EQ(motor.speed, 0.0);
}

TEST_F(Expiring, AQueuedRenewalCountsAfterTheDeadline) {
  auto& motor = AddMotor(1s);  // longer than a cycle on a busy machine
  ASSERT_TRUE(hand.turn(2.0));
  motor.Cycle();
  ASSERT_TRUE(EventuallyTrue([&] { return SteadyClock().Now() > motor.next_expiry(); }));

  ASSERT_TRUE(hand.turn(3.0));
  motor.Cycle();

  EXPECT_EQ(motor.brakings, 0);
  EXPECT_EQ(motor.speed, 3.0);
}

TEST_F(Expiring, ALatestOnlyCommandIsRenewed) {
  auto& motor = AddMotor(1h);
  ASSERT_TRUE(hand.turn_latest(2.0));
  motor.Cycle();
  const SteadyTime first = motor.next_expiry();

  ASSERT_TRUE(hand.turn_latest(3.0));
  motor.Cycle();

  motor.EndExpired(first);
  EXPECT_EQ(motor.speed, 3.0);
  motor.EndExpired(motor.next_expiry());
  EXPECT_EQ(motor.speed, 0.0);
  EXPECT_EQ(motor.brakings, 1);
}

TEST_F(Expiring, DisconnectingAClientEndsItsActionsAtOnce) {
  auto& motor = AddMotor(1h);
  ASSERT_TRUE(hand.turn(2.0));
  motor.Cycle();

  ASSERT_TRUE(manager.Disconnect({"hand", "Motor"}));
  motor.Cycle();

  EXPECT_EQ(motor.speed, 0.0);
}

TEST_F(Expiring, DisconnectingAClientKeepsActionsOfOthers) {
  auto& motor = AddMotor(1h);
  ASSERT_TRUE(hand.turn(2.0));
  motor.Cycle();
  ASSERT_TRUE(other_hand.turn(3.0));
  motor.Cycle();

  ASSERT_TRUE(manager.Disconnect({"hand", "Motor"}));
  motor.Cycle();

  EXPECT_EQ(motor.speed, 3.0);
  EXPECT_EQ(motor.brakings, 0);
}

TEST_F(Expiring, ExpiryDuringSuspensionEndsBeforeResuming) {
  auto& motor = AddMotor(1ms);
  ASSERT_TRUE(hand.turn(2.0));
  motor.Cycle();
  ASSERT_TRUE(manager.Suspend("motor"));
  const int brakings = motor.brakings;
  const double speed = motor.speed;
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_TRUE(EventuallyTrue([&] { return std::chrono::steady_clock::now() - begin > 5ms; }));

  ASSERT_TRUE(manager.Start("motor"));

  EXPECT_EQ(motor.speed, 0.0) << "before its first cycle";
  EXPECT_EQ(motor.brakings, speed == 0.0 ? brakings : brakings + 1);
}

TEST_F(Expiring, AThrowingExpiryHandlerFaultsTheComponent) {
  auto& motor = AddMotor(1ms);
  motor.throws = true;
  ASSERT_TRUE(hand.turn(2.0));

  EXPECT_TRUE(EventuallyTrue([&] { return !motor.Cycle(); }));

  EXPECT_EQ(motor.fault(), "a command or event handler: brake worn");
}

TEST_F(Expiring, RenewingAllocatesNothing) {
  auto& motor = AddMotor(1h);
  ASSERT_TRUE(hand.turn(2.0));

  const AllocationGuard guard;
  motor.Cycle();
}

TEST_F(Expiring, WakesASleepingTask) {
  auto& motor = manager.Add<Motor<SignalTask>>("motor", 5ms);
  ASSERT_TRUE(manager.StartAll());
  ASSERT_TRUE(manager.Connect({"hand", "Motor"}, {"motor", "Control"}));

  ASSERT_TRUE(hand.turn(2.0));

  EXPECT_TRUE(EventuallyTrue([&] { return motor.brakings == 1 && motor.speed == 0.0; }));
}

TEST_F(Expiring, AFollowerWakesItsSleepingLeader) {
  auto& motor = manager.Add<Motor<SignalTask>>("motor", 5ms);
  manager.Add<Motor<SignalTask>>("leader");
  ASSERT_TRUE(manager.RunAfter("motor", "leader"));
  ASSERT_TRUE(manager.StartAll());
  ASSERT_TRUE(manager.Connect({"hand", "Motor"}, {"motor", "Control"}));
  ASSERT_TRUE(manager.Connect({"other", "Motor"}, {"leader", "Control"}));

  ASSERT_TRUE(hand.turn(2.0));
  const bool has_turned = EventuallyTrue([&] {
    (void)other_hand.turn(1.0);  // both tasks run a cycle
    return motor.speed == 2.0;
  });
  EXPECT_TRUE(has_turned || motor.brakings > 0);

  EXPECT_TRUE(EventuallyTrue([&] { return motor.brakings == 1 && motor.speed == 0.0; }));
}

TEST_F(Expiring, IsPartOfTheDescription) {
  auto& motor = AddMotor(250ms);

  const ProvidedDescription control = motor.provided().front();

  EXPECT_EQ(control.commands[0].expires_after, 0.25);
  EXPECT_EQ(control.commands[1].expires_after, 0.0);
}

TEST_F(Expiring, RefusesATimeOutOfRange) {
  EXPECT_EQ(test::Refusal([] { Motor<CallbackTask>("motor", 0ms); }),
            "command 'Turn' must expire after 1 ms..3600 s, got 0 ns");
}

TEST_F(Expiring, RefusesAnEmptyFunction) {
  Motor<CallbackTask> motor("motor");
  auto& more = motor.AddProvidedInterface("More");

  EXPECT_EQ(test::Refusal([&] {
              more.AddCommandVoid([] {}, "Glow").ExpiresAfter(1s, std::function<void()>());
            }),
            "command 'Glow' needs a function that ends its effect; this one is empty");
}

/// A component without a thread.
class Lamp final : public Component {
 public:
  explicit Lamp(std::string name) : Component(std::move(name)) {
    auto& control = AddProvidedInterface("Control");
    control.AddCommandVoid(&Lamp::Glow, this, "Glow").ExpiresAfter(1s, &Lamp::Glow, this);
  }

 private:
  void Glow() {}
};

TEST_F(Expiring, RefusesAComponentWithoutAThread) {
  EXPECT_EQ(test::Refusal([this] { manager.Add<Lamp>("lamp"); }),
            "command 'Glow' of 'lamp' cannot expire, because a component without a thread cannot "
            "end the action of the command. Derive the component from a task");
}

}  // namespace
}  // namespace tendon
