#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <thread>

#include "core/interface/arm_fixture.h"
#include "core/interface/waiting_fixture.h"
#include "support/allocation_guard.h"

namespace tendon_test {
namespace {

using tendon::Connection;
using tendon::Overflow;
using tendon::Status;

/// A component with special kinds of commands.
struct Gripper {
  tendon::Inbox inbox;
  tendon::ProvidedInterface control{"Control", &inbox};
  tendon::Offer* open = nullptr;

  std::thread::id opened_in;
  std::vector<double> widths;
  std::vector<std::string> texts;
  int pulses = 0;

  Gripper() {
    open = &control.AddCommandVoid(&Gripper::Open, this, "Open", tendon::kThreadSafe);
    control.AddCommandWrite(&Gripper::Throw, this, "Throw", tendon::kThreadSafe);
    control.AddCommandFilteredWrite(&ToMetres, &Gripper::SetWidth, this, "SetWidth");
    control.AddCommandWrite(&Gripper::SetWidth, this, "Follow").SetOverflow(Overflow::kLatestOnly);
    control.AddCommandWrite(&Gripper::Say, this, "Say").SetOverflow(Overflow::kLatestOnly);
    control.AddCommandVoid(&Gripper::Pulse, this, "Pulse");
    inbox.SetAccepting(true);
  }

  void Open() { opened_in = std::this_thread::get_id(); }
  void Throw(std::int32_t /*number*/) { throw std::runtime_error("broken"); }
  static void ToMetres(const std::int32_t& millimetres, double& metres) {
    if (millimetres < 0) throw std::invalid_argument("negative width");
    metres = millimetres / 1000.0;
  }
  void SetWidth(double metres) { widths.push_back(metres); }
  void Say(const std::string& text) { texts.push_back(text); }
  void Pulse() { ++pulses; }
};

struct Hand {
  tendon::Inbox inbox;
  tendon::RequiredInterface gripper{"Gripper", &inbox};
  tendon::VoidFunction open;
  tendon::WriteFunction<std::int32_t> fail;
  tendon::WriteFunction<std::int32_t> set_width;
  tendon::WriteFunction<double> follow;
  tendon::WriteFunction<std::string> say;
  tendon::VoidFunction pulse;

  Hand() {
    gripper.AddFunction(open, "Open");
    gripper.AddFunction(fail, "Throw");
    gripper.AddFunction(set_width, "SetWidth");
    gripper.AddFunction(follow, "Follow");
    gripper.AddFunction(say, "Say");
    gripper.AddFunction(pulse, "Pulse");
    gripper.SetMailboxCapacity(4);
  }
};

struct Held {
  Gripper gripper;
  Hand hand;
  std::unique_ptr<Connection> connection = ConnectionOf(hand.gripper, gripper.control);
};

TEST(DirectCommand, RunsInTheCallersThread) {
  Held both;

  EXPECT_EQ(both.hand.open(), Status::kDone);
  EXPECT_EQ(both.gripper.opened_in, std::this_thread::get_id());
  EXPECT_EQ(both.hand.open.Wait(0ms), Status::kDone);
}

TEST(DirectCommand, ContainsExceptions) {
  Held both;

  EXPECT_EQ(both.hand.fail(1), Status::kFailed);
}

TEST(FilteredWrite, ConvertsInTheCallersThreadAndQueuesTheResult) {
  Held both;

  EXPECT_EQ(both.hand.set_width(250), Status::kQueued);
  EXPECT_TRUE(both.gripper.widths.empty());
  both.gripper.inbox.ExecuteQueued();

  EXPECT_EQ(both.gripper.widths, std::vector<double>{0.25});
}

TEST(FilteredWrite, RejectedByItsFilterIsNotQueued) {
  Held both;

  EXPECT_EQ(both.hand.set_width(-1), Status::kFailed);

  EXPECT_EQ(both.connection->waiting(), 0U);
}

TEST(FilteredWrite, CanBeWaitedFor) {
  Held both;
  const Executor server(both.gripper.inbox);

  EXPECT_EQ(both.hand.set_width.Wait(10, 60s), Status::kDone);

  EXPECT_EQ(both.gripper.widths, std::vector<double>{0.01});
}

TEST(LatestOnly, ANewerWriteReplacesTheQueuedOne) {
  Held both;

  for (int i = 1; i <= 100; ++i) EXPECT_EQ(both.hand.follow(i), Status::kQueued);
  EXPECT_EQ(both.connection->waiting(), 1U);
  EXPECT_EQ(both.gripper.inbox.ExecuteQueued(), 1U);

  EXPECT_EQ(both.gripper.widths, std::vector<double>{100});
  EXPECT_EQ(both.connection->replaced(), 99U);
  EXPECT_EQ(both.connection->refused(), 0U);
}

TEST(LatestOnly, AFullMailboxDoesNotRefuseIt) {
  Held both;
  for (int i = 0; i < 4; ++i) EXPECT_EQ(both.hand.pulse(), Status::kQueued);
  EXPECT_EQ(both.hand.pulse(), Status::kQueueFull);

  EXPECT_EQ(both.hand.follow(1), Status::kQueued);
  EXPECT_EQ(both.hand.say("a"), Status::kQueued);
  EXPECT_EQ(both.hand.say("b"), Status::kQueued);
  EXPECT_EQ(both.gripper.inbox.ExecuteQueued(), 6U);

  EXPECT_EQ(both.gripper.pulses, 4);
  EXPECT_EQ(both.gripper.widths, std::vector<double>{1});
  EXPECT_EQ(both.gripper.texts, std::vector<std::string>{"b"});
}

TEST(LatestOnly, KeepsAWriteDuringTheOldersExecution) {
  struct Echo {
    tendon::Inbox inbox;
    tendon::ProvidedInterface control{"Control", &inbox};
    tendon::RequiredInterface self{"Self", nullptr};
    tendon::WriteFunction<std::int32_t> follow;
    std::vector<std::int32_t> seen;
    Echo() {
      control.AddCommandWrite(&Echo::Follow, this, "Follow").SetOverflow(Overflow::kLatestOnly);
      self.AddFunction(follow, "Follow");
      self.SetMailboxCapacity(1);
      inbox.SetAccepting(true);
    }
    void Follow(std::int32_t n) {
      seen.push_back(n);
      if (n == 3) return;
      EXPECT_EQ(follow(n + 1), Status::kQueued);
    }
  } echo;
  const auto connection = Connection::Make(echo.self, echo.control, "a/Self", "a/Control");

  EXPECT_EQ(echo.follow(1), Status::kQueued);
  while (echo.inbox.ExecuteQueued() > 0) {
  }

  EXPECT_EQ(echo.seen, (std::vector<std::int32_t>{1, 2, 3}));
}

TEST(LatestOnly, StartsAfreshAfterItsTokenWasDropped) {
  Held both;
  EXPECT_EQ(both.hand.follow(1), Status::kQueued);
  EXPECT_EQ(both.gripper.inbox.DiscardQueued(), 1U);

  EXPECT_EQ(both.hand.follow(2), Status::kQueued);
  both.gripper.inbox.ExecuteQueued();

  EXPECT_EQ(both.gripper.widths, std::vector<double>{2});
}

TEST(LatestOnly, DoesNotReplaceAWaitedCall) {
  Held both;
  EXPECT_EQ(both.hand.follow(1), Status::kQueued);
  const Executor server(both.gripper.inbox);

  EXPECT_EQ(both.hand.follow.Wait(2, 60s), Status::kDone);

  EXPECT_EQ(both.gripper.widths, (std::vector<double>{1, 2}));
}

TEST(LatestOnly, AllocatesNothingOnceWarm) {
  Held both;
  both.gripper.widths.reserve(1000);
  const std::string text(100, 'x');
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(both.hand.say(text), Status::kQueued);
    both.gripper.inbox.ExecuteQueued();
  }

  const tendon::AllocationGuard guard;
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(both.hand.follow(i), Status::kQueued);
    EXPECT_EQ(both.hand.say(text), Status::kQueued);
  }
}

TEST(Offer, ReportsADisabledCommandUntilEnabled) {
  Held both;
  both.gripper.open->Disable();

  EXPECT_EQ(both.hand.open(), Status::kDisabled);
  EXPECT_EQ(both.hand.open.Wait(0ms), Status::kDisabled);
  EXPECT_EQ(both.hand.pulse(), Status::kQueued);
  both.gripper.open->Enable();

  EXPECT_EQ(both.hand.open(), Status::kDone);
}

TEST(ProvidedInterface, NamesTheTypesOfNumbersAndArrays) {
  Arm arm;
  tendon::WriteEvent<std::array<double, 7>> moved;
  arm.control.AddEvent(moved, "Moved");
  const auto description = arm.control.description();
  const auto type_of = [](const auto& members, const std::string& name) {
    return std::find_if(members.begin(), members.end(),
                        [&](const auto& one) { return one.name == name; })
        ->in_type;
  };

  EXPECT_EQ(type_of(description.commands, "GetJoint"), "int32");
  EXPECT_EQ(type_of(description.commands, "MoveTo"), "test.JointGoal");
  EXPECT_EQ(type_of(description.commands, "Stop"), "tendon.None");
  EXPECT_EQ(type_of(description.events, "Moved"), "float64[7]");
}

TEST(Connection, ListsConvertedFunctions) {
  Arm arm;
  tendon::RequiredInterface robot("Robot", nullptr);
  tendon::WriteFunction<PaddedJointGoal> move_to;
  tendon::VoidFunction stop;
  robot.AddFunction(move_to, "MoveTo");
  robot.AddFunction(stop, "Stop");

  const auto connection = Connection::Make(robot, arm.control, "desk/Robot", "arm/Control");

  EXPECT_EQ((*connection)->converted(), std::vector<std::string>{"MoveTo"});
}

}  // namespace
}  // namespace tendon_test
