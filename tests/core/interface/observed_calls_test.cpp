#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/interface/observed_call.h>
#include <tendon/payload/json.h>

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "core/interface/waiting_fixture.h"
#include "support/allocation_guard.h"

namespace tendon_test {
namespace {

using tendon::CallOutcome;
using tendon::Connection;
using tendon::None;
using tendon::Schema;
using tendon::SchemaOf;
using tendon::Status;
using testing::HasSubstr;

/// Keeps the first calls that it receives, without allocating. The others are lost.
class KeptCalls final : public tendon::CommandBase {
 public:
  struct Calls {
    std::mutex mutex;
    std::array<std::array<std::byte, 256>, 64> values;
    std::array<std::size_t, 64> sizes{};
    std::size_t count = 0;
    bool is_full = false;  ///< then calls are lost
    bool is_memory_short = false;
  };

  explicit KeptCalls(Calls& calls)
      : CommandBase(tendon::layout::kNone, tendon::layout::kNone), calls_(calls) {}

  Status ExecuteEncoded(std::span<const std::byte> in, tendon::ReplySink& out) override {
    return ExecuteFrom(tendon::EncodedArgument(in), out);
  }
  Status ExecuteFrom(const tendon::ArgumentWriter& in, tendon::ReplySink& /*out*/) override {
    const std::scoped_lock lock(calls_.mutex);
    if (calls_.is_memory_short) throw std::bad_alloc();
    if (calls_.is_full || calls_.count == calls_.values.size()) return Status::kQueueFull;
    const std::span<std::byte> place(calls_.values.at(calls_.count));
    calls_.sizes.at(calls_.count) = in.size();
    EXPECT_TRUE(in.WriteTo(place.first(in.size())));
    ++calls_.count;
    return Status::kDone;
  }

 private:
  Calls& calls_;
};

class KeepingOffer final : public tendon::Offer {
 public:
  KeepingOffer(tendon::MemberDescription description, KeptCalls::Calls& calls)
      : Offer(std::move(description)), calls_(calls) {}
  [[nodiscard]] bool uses_mailbox() const override { return false; }
  [[nodiscard]] std::unique_ptr<tendon::CommandBase> Bind(
      tendon::Mailbox* /*mailbox*/) const override {
    return std::make_unique<KeptCalls>(calls_);
  }

 private:
  KeptCalls::Calls& calls_;
};

/// Observes one command of an interface.
class CallWatcher {
 public:
  CallWatcher(tendon::ProvidedInterface& provided, const std::string& command, Schema argument,
              Schema result = {})
      : type_(tendon::SchemaOfCalls(argument, result)) {
    required_.ObserveCalls();
    required_.AddOffer(std::make_unique<KeepingOffer>(
        tendon::DescribeCalls(provided.FindCommand(command)->description()), calls_));
    connection_ = ConnectionOf(required_, provided);
  }

  void Disconnect() { connection_.reset(); }
  void SetFull() { calls_.is_full = true; }
  void SetShortOfMemory() { calls_.is_memory_short = true; }
  [[nodiscard]] std::uint64_t lost() const { return required_.lost_events(); }
  [[nodiscard]] std::size_t count() const {
    const std::scoped_lock lock(calls_.mutex);
    return calls_.count;
  }
  [[nodiscard]] std::chrono::nanoseconds took(std::size_t call) const {
    return tendon::HeaderOfCall(value(call)).took;
  }
  /// As JSON, with a time of 0.
  [[nodiscard]] std::vector<std::string> texts() const {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < calls_.count; ++i) {
      const auto bytes = value(i);
      std::vector<std::byte> body(bytes.begin(), bytes.end());
      std::fill_n(body.begin(), 8, std::byte{0});
      const auto json = tendon::ToJson(type_, body);
      all.push_back(json ? *json : json.error().message);
    }
    return all;
  }
  [[nodiscard]] std::string text() const {
    EXPECT_EQ(count(), 1U);
    return count() == 0 ? "" : texts().front();
  }

 private:
  [[nodiscard]] std::span<const std::byte> value(std::size_t call) const {
    return std::span(calls_.values.at(call)).first(calls_.sizes.at(call));
  }

  const Schema type_;
  mutable KeptCalls::Calls calls_;
  tendon::RequiredInterface required_{"Observer", nullptr};
  std::unique_ptr<Connection> connection_;
};

TEST(ObservedCalls, HaveArgumentOutcomeAndClient) {
  Arm arm;
  Teleoperation client;
  const auto connection = Connect(client, arm);
  const CallWatcher observer(arm.control, "MoveTo", SchemaOf<JointGoal>());

  EXPECT_EQ(client.move_to({{1.5, 0, 0, 0, 0, 0, 2}}), Status(Status::kQueued));
  EXPECT_EQ(observer.count(), 0U) << "it is not executed yet";
  arm.inbox.ExecuteQueued();

  EXPECT_EQ(observer.text(),
            R"({"took":0,"outcome":"executed","status":"done",)"
            R"("argument":{"position":[1.5,0,0,0,0,0,2]},"client":"teleoperation/Robot"})");
  EXPECT_EQ(arm.moves.size(), 1U);
}

TEST(ObservedCalls, HaveNoArgumentIfTheCommandHasNone) {
  Arm arm;
  Teleoperation client;
  const auto connection = Connect(client, arm);
  const CallWatcher observer(arm.control, "Stop", {});

  EXPECT_TRUE(client.stop());
  arm.inbox.ExecuteQueued();

  EXPECT_EQ(observer.text(), R"({"took":0,"outcome":"executed","status":"done",)"
                             R"("client":"teleoperation/Robot"})");
}

TEST(ObservedCalls, HaveTheResultThatTheCallerWaitsFor) {
  Planner planner;
  Operator client;
  const auto connection = Connect(client, planner);
  const CallWatcher observer(planner.plans, "Describe", SchemaOf<std::string>(),
                             SchemaOf<Message>());
  const Executor executor(planner.inbox);

  Message reply;
  ASSERT_EQ(client.describe.Wait("plan ", reply, 20s), Status(Status::kDone));

  EXPECT_EQ(observer.text(),
            R"({"took":0,"outcome":"executed","status":"done","argument":"plan ",)"
            R"("result":{"text":"plan 0","numbers":[]},"client":"operator/Planner"})");
}

/// Throws for negative numbers.
struct Doubler {
  tendon::Inbox inbox;
  tendon::ProvidedInterface desk{"Desk", &inbox};

  Doubler() {
    desk.AddCommandWriteReturn(&Doubler::Double, this, "Double");
    inbox.SetAccepting(true);
  }
  void Double(std::int32_t number, std::int32_t& twice) {
    if (number < 0) throw std::invalid_argument("negative");
    twice = 2 * number;
  }
};

TEST(ObservedCalls, WithoutAResultDoNotShowThatOfAnEarlierCall) {
  Doubler server;
  tendon::RequiredInterface required("Desk", nullptr);
  tendon::WriteReturnFunction<std::int32_t, std::int32_t> twice;
  required.AddFunction(twice, "Double");
  const auto connection = ConnectionOf(required, server.desk);
  const CallWatcher observer(server.desk, "Double", SchemaOf<std::int32_t>(),
                             SchemaOf<std::int32_t>());
  std::int32_t reply = 0;

  {
    const Executor executor(server.inbox);
    ASSERT_EQ(twice.Wait(4, reply, 20s), Status(Status::kDone));
    ASSERT_EQ(twice.Wait(-1, reply, 20s), Status(Status::kFailed));
  }
  server.inbox.SetAccepting(false);
  ASSERT_EQ(twice.Wait(5, reply, 20s), Status(Status::kNotActive));

  ASSERT_EQ(observer.count(), 3U);
  EXPECT_THAT(observer.texts()[0], HasSubstr(R"("argument":4,"result":8)"));
  EXPECT_THAT(observer.texts()[1], HasSubstr(R"("failed","argument":-1,"result":0)"));
  EXPECT_THAT(observer.texts()[2], HasSubstr(R"("not_active","argument":5,"result":0)"));
}

TEST(ObservedCalls, ACallThatThrowsHasFailed) {
  Planner planner;
  Operator client;
  const auto connection = Connect(client, planner);
  const CallWatcher observer(planner.plans, "Break", {});

  EXPECT_TRUE(client.fail());
  EXPECT_THROW(planner.inbox.ExecuteQueued(), std::runtime_error);

  EXPECT_THAT(observer.text(), HasSubstr(R"("outcome":"failed","status":"failed")"));
}

TEST(ObservedCalls, ARefusedCallSaysWhy) {
  Arm arm;
  Teleoperation client;
  client.robot.SetMailboxCapacity(1);
  const auto connection = Connect(client, arm);
  const CallWatcher observer(arm.control, "Say", SchemaOf<Message>());

  EXPECT_EQ(client.say({"one", {}}), Status(Status::kQueued));
  EXPECT_EQ(client.say({"two", {}}), Status(Status::kQueueFull));
  arm.inbox.SetAccepting(false);
  EXPECT_EQ(client.say({"three", {}}), Status(Status::kNotActive));

  ASSERT_EQ(observer.count(), 2U);
  EXPECT_THAT(observer.texts()[0],
              HasSubstr(R"("refused","status":"queue_full","argument":{"text":"two")"));
  EXPECT_THAT(observer.texts()[1],
              HasSubstr(R"("refused","status":"not_active","argument":{"text":"three")"));
}

TEST(ObservedCalls, ACallThatNobodyWaitsForHasExpired) {
  Planner planner;
  Operator client;
  const auto connection = Connect(client, planner);
  const CallWatcher observer(planner.plans, "Move", SchemaOf<std::int32_t>());

  EXPECT_EQ(client.move.Wait(7, 0ns), Status(Status::kTimeout));
  planner.inbox.ExecuteQueued();

  EXPECT_THAT(observer.text(), HasSubstr(R"("expired","status":"timeout","argument":7)"));
  EXPECT_TRUE(planner.moves.empty());
}

TEST(ObservedCalls, ACallThatWouldWaitForItselfIsRefused) {
  Planner planner;
  Operator client;
  const auto connection = Connect(client, planner);
  const CallWatcher observer(planner.plans, "Move", SchemaOf<std::int32_t>());
  planner.inbox.BindToThisThread();

  EXPECT_EQ(client.move.Wait(7, 20s), Status(Status::kWouldDeadlock));

  planner.inbox.Unbind();
  EXPECT_THAT(observer.text(), HasSubstr(R"("refused","status":"would_deadlock","argument":7)"));
}

TEST(ObservedCalls, ACallThatIsLeftInTheMailboxIsDropped) {
  Arm arm;
  Teleoperation client;
  auto connection = std::move(*Connect(client, arm));
  const CallWatcher observer(arm.control, "MoveTo", SchemaOf<JointGoal>());

  EXPECT_TRUE(client.move_to({}));
  EXPECT_EQ(connection->Close(0ms), 1U);

  EXPECT_THAT(observer.text(), HasSubstr(R"("outcome":"dropped","status":"not_active")"));
}

TEST(ObservedCalls, ReplacedByNewerOnesAreNotShown) {
  struct Lamp {
    tendon::Inbox inbox;
    tendon::ProvidedInterface control{"Control", &inbox};
    std::int32_t shade = 0;
    Lamp() {
      control.AddCommandWrite(&Lamp::Set, this, "Set").SetOverflow(tendon::Overflow::kLatestOnly);
      inbox.SetAccepting(true);
    }
    void Set(std::int32_t value) { shade = value; }
  } lamp;
  tendon::RequiredInterface required("Lamp", nullptr);
  tendon::WriteFunction<std::int32_t> set;
  required.AddFunction(set, "Set");
  const auto connection = ConnectionOf(required, lamp.control);
  const CallWatcher observer(lamp.control, "Set", SchemaOf<std::int32_t>());

  EXPECT_TRUE(set(1));
  EXPECT_TRUE(set(2));
  lamp.inbox.ExecuteQueued();

  EXPECT_THAT(observer.text(), HasSubstr(R"("executed","status":"done","argument":2)"));
}

/// A component without a thread: its callers execute the commands.
struct Switch {
  tendon::ProvidedInterface control{"Control", nullptr};
  std::vector<bool> states;

  Switch() {
    control.AddCommandWrite(&Switch::Set, this, "Set", tendon::kThreadSafe);
    control.AddCommandWrite(&Switch::Set, this, "SetNow");
    control.AddCommandFilteredWrite<std::int32_t, bool>(&Switch::IsOn, &Switch::Set, this,
                                                        "SetNumber");
    control.AddCommandFilteredWrite<std::int32_t, bool>(&Switch::IsOn, &Switch::Break, this,
                                                        "Break");
  }
  void Break(bool /*state*/) { throw std::runtime_error("broken"); }
  void Set(bool state) { states.push_back(state); }
  static void IsOn(const std::int32_t& number, bool& state) { state = number != 0; }
};

TEST(ObservedCalls, InTheCallersThreadAreShownAsWell) {
  Switch one;
  tendon::RequiredInterface required("Switch", nullptr);
  tendon::WriteFunction<bool> set;
  tendon::WriteFunction<bool> set_now;
  tendon::WriteFunction<std::int32_t> set_number;
  required.AddFunction(set, "Set");
  required.AddFunction(set_now, "SetNow");
  required.AddFunction(set_number, "SetNumber");
  const auto connection = ConnectionOf(required, one.control);
  const CallWatcher direct(one.control, "Set", SchemaOf<bool>());
  const CallWatcher now(one.control, "SetNow", SchemaOf<bool>());
  const CallWatcher filtered(one.control, "SetNumber", SchemaOf<std::int32_t>());

  EXPECT_TRUE(set(true));
  EXPECT_TRUE(set_now(false));
  EXPECT_TRUE(set_number(3));

  EXPECT_THAT(direct.text(), HasSubstr(R"("executed","status":"done","argument":true)"));
  EXPECT_THAT(now.text(), HasSubstr(R"("executed","status":"done","argument":false)"));
  EXPECT_THAT(filtered.text(), HasSubstr(R"("executed","status":"done","argument":3)"));
  EXPECT_EQ(one.states, (std::vector<bool>{true, false, true}));
}

TEST(ObservedCalls, AFilteredCallThatThrowsHasFailed) {
  Switch one;
  tendon::RequiredInterface required("Switch", nullptr);
  tendon::WriteFunction<std::int32_t> fail;
  required.AddFunction(fail, "Break");
  const auto connection = ConnectionOf(required, one.control);
  const CallWatcher observer(one.control, "Break", SchemaOf<std::int32_t>());

  EXPECT_EQ(fail(3), Status(Status::kFailed));

  EXPECT_THAT(observer.text(), HasSubstr(R"("failed","status":"failed","argument":3)"));
}

TEST(ObservedCalls, TellHowLongTheyTook) {
  Planner planner;
  planner.gate_is_open = false;
  Operator client;
  const auto connection = Connect(client, planner);
  const CallWatcher observer(planner.plans, "Slow", {});
  const Executor executor(planner.inbox);
  EXPECT_TRUE(client.slow());
  ASSERT_TRUE(EventuallyTrue([&] { return planner.slow_begun == 1; }));
  const auto begun = tendon::SteadyClock().Now();
  while (tendon::SteadyClock().Now() - begun < 2ms) std::this_thread::yield();
  planner.gate_is_open = true;

  ASSERT_TRUE(EventuallyTrue([&] { return observer.count() == 1; }));

  EXPECT_GE(observer.took(0), 2ms);
}

TEST(ObservedCalls, CallsThatTheObserverCannotTakeAreCounted) {
  Arm arm;
  Teleoperation client;
  const auto connection = Connect(client, arm);
  CallWatcher observer(arm.control, "Stop", {});
  observer.SetFull();

  for (int i = 0; i < 3; ++i) EXPECT_TRUE(client.stop());
  arm.inbox.ExecuteQueued();

  EXPECT_EQ(observer.lost(), 3U);
  EXPECT_EQ(arm.stops, 3);
}

TEST(ObservedCalls, AnObserverThatThrowsLosesTheCallAndNothingElse) {
  Arm arm;
  Teleoperation client;
  auto connection = std::move(*Connect(client, arm));
  CallWatcher observer(arm.control, "Stop", {});
  observer.SetShortOfMemory();

  EXPECT_TRUE(client.stop());
  EXPECT_NO_THROW(arm.inbox.ExecuteQueued());
  EXPECT_EQ(observer.lost(), 1U);
  EXPECT_TRUE(client.stop());
  EXPECT_EQ(connection->Close(0ms), 1U) << "the call that is dropped is lost, too";

  EXPECT_EQ(observer.lost(), 2U);
  EXPECT_EQ(arm.stops, 1);
}

/// The executor shows the executed calls, and the caller shows those that are refused.
TEST(ObservedCalls, MayBeObservedAndLeftWhileTheyRun) {
  Planner planner;
  Operator client;
  client.planner.SetMailboxCapacity(2);
  const auto connection = Connect(client, planner);
  const Executor executor(planner.inbox);
  const std::jthread caller([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) (void)client.slow();
  });

  for (int i = 0; i < 50; ++i) {
    const CallWatcher first(planner.plans, "Slow", {});
    const CallWatcher second(planner.plans, "Slow", {});
    ASSERT_TRUE(EventuallyTrue([&] { return first.count() > 0 && second.count() > 0; }));
  }

  EXPECT_FALSE(planner.plans.FindCommand("Slow")->is_observed());
}

TEST(ObservedCalls, AreShownToEachObserverUntilItIsDisconnected) {
  Arm arm;
  Teleoperation client;
  const auto connection = Connect(client, arm);
  CallWatcher first(arm.control, "Stop", {});
  const CallWatcher second(arm.control, "Stop", {});

  EXPECT_TRUE(client.stop());
  arm.inbox.ExecuteQueued();
  first.Disconnect();
  EXPECT_TRUE(client.stop());
  arm.inbox.ExecuteQueued();

  EXPECT_EQ(first.count(), 1U);
  EXPECT_EQ(second.count(), 2U);
}

TEST(ObservedCalls, AreMarkedInTheMailboxesOnlyWhileThereIsAnObserver) {
  Arm arm;
  tendon::Mailbox& early = arm.inbox.Open(4, {});
  {
    const CallWatcher first(arm.control, "Stop", {});
    const CallWatcher second(arm.control, "MoveTo", SchemaOf<JointGoal>());
    EXPECT_TRUE(early.is_observed());
    EXPECT_TRUE(arm.inbox.Open(4, {}).is_observed());
  }

  EXPECT_FALSE(early.is_observed());
  EXPECT_FALSE(arm.inbox.Open(4, {}).is_observed());
  EXPECT_FALSE(arm.control.FindCommand("Stop")->is_observed());
}

/// A caller that sees an observer must not post a call that the observer does not get.
TEST(ObservedCalls, BeginWithTheFirstCallAfterTheCommandSaysThatItIsObserved) {
  constexpr int kRounds = 1000;
  Arm arm;
  const tendon::Mailbox& mailbox = arm.inbox.Open(4, {});
  const auto* const stop = arm.control.FindCommand("Stop");
  std::atomic<int> round = -1;
  std::atomic<int> seen = -1;
  std::atomic<int> unmarked = 0;
  const std::jthread caller([&] {
    for (int i = 0; i < kRounds; ++i) {
      while (round < i || !stop->is_observed()) std::this_thread::yield();
      if (!mailbox.is_observed()) ++unmarked;
      seen = i;
    }
  });

  for (int i = 0; i < kRounds; ++i) {
    round = i;
    const CallWatcher observer(arm.control, "Stop", {});
    while (seen < i) std::this_thread::yield();
  }

  EXPECT_EQ(unmarked, 0);
}

TEST(ObservedCalls, AllocateNothing) {
  Arm arm;
  Teleoperation client;
  const auto connection = Connect(client, arm);
  const CallWatcher observer(arm.control, "MoveTo", SchemaOf<JointGoal>());
  arm.moves.reserve(2);

  const tendon::AllocationGuard guard;
  EXPECT_TRUE(client.move_to({}));
  arm.inbox.ExecuteQueued();
  EXPECT_EQ(observer.count(), 1U);
}

TEST(ObservedCalls, AreNotThoseOfReads) {
  Arm arm;
  tendon::RequiredInterface required("Observer", nullptr);
  required.ObserveCalls();
  KeptCalls::Calls calls;
  required.AddOffer(std::make_unique<KeepingOffer>(
      tendon::DescribeCalls(arm.control.FindCommand("GetJoints")->description()), calls));

  const auto connection = Connection::Make(required, arm.control, "observer/Arm", "arm/Control");

  ASSERT_FALSE(connection);
  EXPECT_THAT(connection.error().message, HasSubstr("missing write event 'GetJoints'"));
  EXPECT_EQ(arm.control.ObserveCalls("GetJoints"), nullptr);
  EXPECT_EQ(arm.control.ObserveCalls("GetJoint"), nullptr);
}

TEST(ObservedCalls, ReachNoHandlerOfAComponent) {
  struct Eavesdropper {
    void OnMove(const JointGoal& /*goal*/) {}
  } eavesdropper;
  Arm arm;
  tendon::RequiredInterface required("Robot", nullptr);
  required.AddEventHandlerWrite(&Eavesdropper::OnMove, &eavesdropper, "MoveTo",
                                tendon::kThreadSafe);

  const auto connection = Connection::Make(required, arm.control, "desk/Robot", "arm/Control");

  ASSERT_FALSE(connection);
  EXPECT_THAT(connection.error().message, HasSubstr("missing write event 'MoveTo'"));
}

TEST(SchemaOfCalls, NamesTheTypeAfterTheArgument) {
  EXPECT_EQ(tendon::SchemaOfCalls(SchemaOf<JointGoal>(), {}).TypeName(), "test.JointGoalCall");
  EXPECT_EQ(tendon::SchemaOfCalls({}, SchemaOf<Message>()).TypeName(), "test.MessageCall");
  EXPECT_EQ(tendon::SchemaOfCalls({}, {}).TypeName(), "tendon.Call");
  EXPECT_EQ(tendon::SchemaOfCalls(SchemaOf<double>(), {}).TypeName(), "tendon.Call");
}

TEST(SchemaOfCalls, CanBeParsedAndTakenApart) {
  const Schema type = tendon::SchemaOfCalls(SchemaOf<JointGoal>(), SchemaOf<Message>());

  const auto parsed = Schema::Parse(type.TextWithHelp());

  ASSERT_TRUE(parsed) << parsed.error().message;
  EXPECT_EQ(tendon::ArgumentOfCalls(*parsed), SchemaOf<JointGoal>());
  EXPECT_EQ(tendon::ResultOfCalls(*parsed), SchemaOf<Message>());
  EXPECT_TRUE(tendon::ArgumentOfCalls(tendon::SchemaOfCalls({}, {})).is_none());
}

TEST(HeaderOfCall, OfMalformedBytesIsTheDefault) {
  const std::vector<std::byte> nonsense(64, std::byte{0xff});

  EXPECT_EQ(tendon::HeaderOfCall({}).took, 0ns);
  EXPECT_EQ(tendon::HeaderOfCall(nonsense).outcome, CallOutcome::kExecuted);
  EXPECT_EQ(tendon::HeaderOfCall(nonsense).took, 0ns);
}

}  // namespace
}  // namespace tendon_test
